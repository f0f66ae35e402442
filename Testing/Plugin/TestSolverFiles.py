# SPDX-License-Identifier: BSD-3-Clause
"""Save Data writes solver files, of quadratic hexes too; VTK's readers read them."""
import os

from paraview import simple
from pipelines import fetch
from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOGeometry import vtkAVSucdReader

folder = os.environ["FEATUREHEX_TEMPORARY_DIR"]
bracket = os.path.join(os.environ["FEATUREHEX_SOURCE_DIR"], "Data", "rotation", "bracket")
simple.LoadPlugin(os.environ["FEATUREHEX_PLUGIN"], ns=globals())


def path(name):
    return os.path.join(folder, name)


def text(name):
    with open(path(name), encoding="ascii") as file:
        return file.read()


def read_exodus(name):
    """{kind: {name: (cells, type of the first)}}"""
    reader = vtkExodusIIReader()
    reader.SetFileName(path(name))
    reader.UpdateInformation()
    kinds = {"block": (reader.ELEM_BLOCK, 0), "side": (reader.SIDE_SET, 4),
             "node": (reader.NODE_SET, 7)}
    for kind, _ in kinds.values():
        for i in range(reader.GetNumberOfObjects(kind)):
            reader.SetObjectStatus(kind, i, 1)
    reader.Update()
    result = {}
    for key, (kind, block) in kinds.items():
        result[key] = {}
        for i in range(reader.GetNumberOfObjects(kind)):
            grid = reader.GetOutput().GetBlock(block).GetBlock(i)
            result[key][reader.GetObjectName(kind, i)] = (
                grid.GetNumberOfCells(), grid.GetCellType(0), grid.GetNumberOfPoints())
            if key == "block":
                volumes = [corner_volume(grid, c) for c in range(grid.GetNumberOfCells())]
                assert min(volumes) > 0.0, min(volumes)
    return result


def corner_volume(grid, cell):
    """Determinant of the edges at corner 0: positive when the order of the nodes is understood."""
    ids = [grid.GetCell(cell).GetPointId(k) for k in (0, 1, 3, 4)]
    p, a, b, c = (grid.GetPoint(i) for i in ids)
    a, b, c = ([x - y for x, y in zip(q, p)] for q in (a, b, c))
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
            a[2] * (b[0] * c[1] - b[1] * c[0]))


surface = simple.OpenDataFile(bracket + ".obj")
found = SurfaceFeature(Input=surface, FeatureAngle=140)
mesher = FeatureHexMesher(Input=simple.OutputPort(found, 0), Features=simple.OutputPort(found, 1),
                          TargetEdgeLength=0.3)
mesh = fetch(mesher)
hexes, points = mesh.GetNumberOfCells(), mesh.GetNumberOfPoints()
patches = 12

for name, words in (("x.inp", ("*SURFACE, NAME=patch_11", "*NSET, NSET=curve_29")),
                    ("x.msh", ("4.1 0 8", '"patch_11"', '"curve_29"', '"corner_19"')),
                    ("x.ucd", (" quad ", " line "))):
    simple.SaveData(path(name), simple.OutputPort(mesher, 0))
    for word in words:
        assert word in text(name), (name, word)
simple.SaveData(path("x.msh"), simple.OutputPort(mesher, 0), FormatVersion="Version22")
assert "2.2 0 8" in text("x.msh")

simple.SaveData(path("x.exo"), simple.OutputPort(mesher, 0))
groups = read_exodus("x.exo")
assert groups["block"] == {"body_1": (hexes, 12, points)}, groups["block"]
assert sorted(groups["side"]) == sorted("patch_%d" % i for i in range(patches))
assert sum(cells for cells, _, _ in groups["side"].values()) == fetch(
    mesher, 1).GetNumberOfCells()
assert sorted(groups["node"]) == sorted(
    ["curve_%d" % i for i in range(30)] + ["corner_%d" % i for i in range(20)])

reader = vtkAVSucdReader()
reader.SetFileName(path("x.ucd"))
reader.Update()
assert reader.GetOutput().GetNumberOfPoints() == points

for kind, nodes, cell_type in (("Nodes20", 20, 25), ("Nodes27", 27, 29)):
    quadratic = QuadraticHex(Input=simple.OutputPort(mesher, 0), Surface=simple.OutputPort(found, 0),
                             Features=simple.OutputPort(found, 1), HexType=kind)
    grid = fetch(quadratic)
    assert grid.GetNumberOfCells() == hexes and grid.GetCellType(0) == cell_type
    assert grid.GetFieldData().GetArray("SmallestJacobianRatio").GetValue(0) > 0.0
    simple.SaveData(path("q.exo"), quadratic)
    groups = read_exodus("q.exo")
    assert groups["block"] == {"body_1": (hexes, cell_type, grid.GetNumberOfPoints())}, groups
    assert len(groups["side"]) == patches
    # The nodes are where VTK has them: as in the mesh that was written, hex by hex. This reader
    # gives single precision.
    reader = vtkExodusIIReader()
    reader.SetFileName(path("q.exo"))
    reader.Update()
    again = reader.GetOutput().GetBlock(0).GetBlock(0)
    for cell in range(0, hexes, 50):
        for k in range(nodes):
            a = grid.GetPoint(grid.GetCell(cell).GetPointId(k))
            b = again.GetPoint(again.GetCell(cell).GetPointId(k))
            assert max(abs(x - y) for x, y in zip(a, b)) < 1e-6, (kind, cell, k, a, b)
