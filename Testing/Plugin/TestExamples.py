# SPDX-License-Identifier: BSD-3-Clause
"""The pvpython examples run: the composite, and stage by stage, also with sharp edges; all give a
valid mesh. In a folder one part fails and the others are meshed."""
import os
import pathlib
import runpy
import shutil
import sys
import tempfile

from paraview.simple import OpenDataFile
from pipelines import run

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

    parts = pathlib.Path(folder, "parts")
    meshes = pathlib.Path(folder, "meshes")
    parts.mkdir()
    shutil.copy(os.path.join(data, "sphere.stl"), parts)
    (parts / "open.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="ascii")
    output = run(os.environ["FEATUREHEX_PVPYTHON"], "--force-offscreen-rendering",
                 os.path.join(source, "Wrapping", "Python", "examples", "folder.py"),
                 str(parts), str(meshes),
                 PV_PLUGIN_PATH=os.path.dirname(os.environ["FEATUREHEX_PLUGIN"]))
    assert "open.obj: no mesh. " in output and "sphere.stl: " in output, output
    assert [path.name for path in meshes.iterdir()] == ["sphere.vtu"]
