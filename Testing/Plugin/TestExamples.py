# SPDX-License-Identifier: BSD-3-Clause
"""The pvpython examples run: the composite, and stage by stage, also with sharp edges; all give a
valid mesh."""
import os
import runpy
import sys
import tempfile

from paraview.simple import OpenDataFile

source = os.environ["FEATUREHEX_SOURCE_DIR"]
data = os.path.join(source, "Data")
with tempfile.TemporaryDirectory() as folder:
    for name, surface in (("composite", "sphere.stl"), ("stages", "sphere.stl"),
                          ("stages", os.path.join("rotation", "bracket.obj"))):
        surface = os.path.join(data, surface)
        mesh = os.path.join(folder, name + ".vtu")
        script = os.path.join(source, "Wrapping", "Python", "examples", name + ".py")
        sys.argv = [script, os.environ["FEATUREHEX_PLUGIN"], surface, mesh]
        runpy.run_path(script, run_name="__main__")
        reader = OpenDataFile(mesh)
        reader.UpdatePipeline()
        assert reader.GetDataInformation().GetNumberOfCells() > 100, name
