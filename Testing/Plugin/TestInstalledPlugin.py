# SPDX-License-Identifier: BSD-3-Clause
"""The installed plugin loads in each way ParaView knows, and brings its Python package.

Each way needs a process of its own: PV_PLUGIN_PATH and PV_PLUGIN_CONFIG_FILE are read at start.
"""
import os
import subprocess
import tempfile

CHECK = """
from paraview import servermanager
information = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager().\
GetLocalInformation()
loaded = [information.GetPluginName(i) for i in range(information.GetNumberOfPlugins())
          if information.GetPluginLoaded(i)]
assert "FeatureHex" in loaded, loaded
import featurehex
assert featurehex.__file__.startswith(PREFIX), featurehex.__file__
print("loaded", featurehex.__version__)
"""


def run(folder, way, before, variables):
    script = os.path.join(folder, "check.py")
    with open(script, "w", encoding="utf-8") as file:
        file.write(f"PREFIX = {folder!r}\n{before}\n{CHECK}")
    environment = dict(os.environ)
    environment.update(variables)
    environment["PYTHONPATH"] = os.path.join(folder, os.environ["FEATUREHEX_PYTHON_SUBDIR"])
    result = subprocess.run(
        [os.environ["FEATUREHEX_PVPYTHON"], "--force-offscreen-rendering", script],
        env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print(way, result.stdout)
    assert result.returncode == 0 and "loaded" in result.stdout, way


with tempfile.TemporaryDirectory() as prefix:
    subprocess.run([os.environ["FEATUREHEX_CMAKE"], "--install",
                    os.environ["FEATUREHEX_BINARY_DIR"], "--prefix", prefix],
                   check=True, stdout=subprocess.DEVNULL)
    plugins = os.path.join(prefix, os.environ["FEATUREHEX_PLUGIN_SUBDIR"])
    library = os.path.join(plugins, "FeatureHex", "FeatureHex.so")
    run(prefix, "LoadPlugin:",
        f"from paraview.simple import LoadPlugin\nLoadPlugin({library!r}, ns=globals())", {})
    run(prefix, "PV_PLUGIN_PATH:", "", {"PV_PLUGIN_PATH": plugins})
    run(prefix, "PV_PLUGIN_CONFIG_FILE:", "",
        {"PV_PLUGIN_CONFIG_FILE": os.path.join(plugins, "featurehex.xml")})
