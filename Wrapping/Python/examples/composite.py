# SPDX-License-Identifier: BSD-3-Clause
"""Surface to hex mesh in one step, through ParaView's proxies:

    pvpython composite.py FeatureHex.so surface.stl mesh.vtu

FeatureHex.so is the plugin: <prefix>/lib/paraview-5.11/plugins/FeatureHex/FeatureHex.so.
"""
import sys

from paraview.simple import *
from paraview import servermanager

plugin, surface_file, mesh_file = sys.argv[1:4]
LoadPlugin(plugin, ns=globals())

surface = OpenDataFile(surface_file)
mesher = FeatureHexMesher(Input=surface)
mesher.Tolerance = 0.01
mesher.UpdatePipeline()

# One row of figures comes with the mesh.
statistics = servermanager.Fetch(mesher, idx=3)


def figure(name):
    return statistics.GetColumnByName(name).GetComponent(0, 0)


if statistics.GetNumberOfRows() == 0:
    raise RuntimeError("no mesh; the reason is in the error above")
print("%d hexes, scaled Jacobian %.3f and up, Hausdorff distance at most %.3f %% of the diagonal" % (
    figure("NumberOfHexes"), figure("MinimumScaledJacobian"), 100 * figure("HausdorffUpper")))

# ParaView of Debian 12 can't read its own appended data.
SaveData(mesh_file, OutputPort(mesher, 0), DataMode="Binary")
