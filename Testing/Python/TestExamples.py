# SPDX-License-Identifier: BSD-3-Clause
"""The examples arrays.py, classes.py and features.py run; importing the package selects the
threads."""
import importlib.util
import os
import tempfile

import featurehex
from vtkmodules.vtkCommonCore import vtkSMPTools

assert vtkSMPTools.GetBackend() == os.environ.get("VTK_SMP_BACKEND_IN_USE", "STDThread")

source = os.environ["FEATUREHEX_SOURCE_DIR"]


def load(name):
    spec = importlib.util.spec_from_file_location(
        name, os.path.join(source, "Wrapping", "Python", "examples", name + ".py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def write_cube(place):
    """The unit cube, and its twelve edges as features."""
    points = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    edges = [(a, b) for a in range(8) for b in range(a + 1, 8)
             if sum(p != q for p, q in zip(points[a], points[b])) == 1]
    with open(os.path.join(place, "cube.obj"), "w", encoding="ascii") as file:
        file.writelines("v %g %g %g\n" % point for point in points)
        file.writelines("f %d %d %d %d\n" % tuple(i + 1 for i in quad) for quad in quads)
    with open(os.path.join(place, "cube.fgraph"), "w", encoding="ascii") as file:
        file.write("140 1 1\n0 12\n")
        file.writelines("%d %d\n" % edge for edge in edges)
    return [os.path.join(place, name) for name in ("cube.obj", "cube.fgraph")]



with tempfile.TemporaryDirectory() as folder:
    mesh = os.path.join(folder, "mesh.vtu")
    load("classes").main(os.path.join(source, "Data", "sphere.stl"), mesh)
    reader = featurehex.vtkHexMeshReader()
    reader.SetFileName(mesh)
    reader.Update()
    assert reader.GetOutput().GetNumberOfCells() > 100

    made = load("arrays").main(os.path.join(source, "Data", "sphere.stl"), mesh,
                               tolerance=0.02, edge_length=0.25)
    reader.Modified()
    reader.Update()
    assert reader.GetOutput().GetNumberOfCells() == len(made.hexes)

    surface, features = write_cube(folder)
    for feature_file in (features, ""):
        mesher = load("features").main(surface, feature_file, mesh, 0.02, 0.2)
        outcomes = mesher.GetOutputDataObject(4).GetColumnByName("Outcome")
        assert [outcomes.GetValue(i) for i in range(outcomes.GetNumberOfValues())] == (
            26 * ["Captured"])
        assert mesher.GetOutputDataObject(0).GetPointData().HasArray("FeatureKind")
