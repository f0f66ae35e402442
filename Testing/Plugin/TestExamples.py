# SPDX-License-Identifier: BSD-3-Clause
"""The pvpython examples run: the composite, and stage by stage; both give a valid mesh."""
import os
import runpy
import sys
import tempfile

from paraview.simple import OpenDataFile

source = os.environ["FEATUREHEX_SOURCE_DIR"]
surface = os.path.join(source, "Data", "sphere.stl")
with tempfile.TemporaryDirectory() as folder:
    for name in ("composite", "stages"):
        mesh = os.path.join(folder, name + ".vtu")
        script = os.path.join(source, "Wrapping", "Python", "examples", name + ".py")
        sys.argv = [script, os.environ["FEATUREHEX_PLUGIN"], surface, mesh]
        runpy.run_path(script, run_name="__main__")
        reader = OpenDataFile(mesh)
        reader.UpdatePipeline()
        assert reader.GetDataInformation().GetNumberOfCells() > 100, name
