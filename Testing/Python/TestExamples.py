# SPDX-License-Identifier: BSD-3-Clause
"""Wrapping/Python/examples/classes.py runs, and importing the package selects the threads."""
import importlib.util
import os
import tempfile

import featurehex
from vtkmodules.vtkCommonCore import vtkSMPTools

assert vtkSMPTools.GetBackend() == os.environ.get("VTK_SMP_BACKEND_IN_USE", "STDThread")

source = os.environ["FEATUREHEX_SOURCE_DIR"]
spec = importlib.util.spec_from_file_location(
    "classes", os.path.join(source, "Wrapping", "Python", "examples", "classes.py"))
example = importlib.util.module_from_spec(spec)
spec.loader.exec_module(example)

with tempfile.TemporaryDirectory() as folder:
    mesh = os.path.join(folder, "mesh.vtu")
    example.main(os.path.join(source, "Data", "sphere.stl"), mesh)
    reader = featurehex.vtkHexMeshReader()
    reader.SetFileName(mesh)
    reader.Update()
    assert reader.GetOutput().GetNumberOfCells() > 100
