# SPDX-License-Identifier: BSD-3-Clause
"""Histograms of scaled Jacobian and deviation, the worst hexes, and where the deviation is.

A macro for ParaView: Macros > Import New Macro, then one click.
"""
import glob
import os
import sys

from paraview import servermanager

# The package featurehex is installed beside the plugin, wherever that is.
manager = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
plugins = manager.GetLocalInformation()
for i in range(plugins.GetNumberOfPlugins()):
    if plugins.GetPluginName(i) == "FeatureHex":
        folder = os.path.dirname(os.path.realpath(plugins.GetPluginFileName(i)))
        sys.path += glob.glob(os.path.join(folder, "../../../python3*/*-packages"))

from featurehex import views  # noqa: E402  after its folder is known

views.quality_view()
