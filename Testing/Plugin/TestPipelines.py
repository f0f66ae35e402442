# SPDX-License-Identifier: BSD-3-Clause
"""Composite and stages give valid meshes through their proxies; files, domains and hints work."""
import os

from paraview import servermanager, simple
from pipelines import SURFACE, bits, composite, fetch, figure, stages

simple.LoadPlugin(os.environ["FEATUREHEX_PLUGIN"])
surface = simple.OpenDataFile(SURFACE)
mesher = composite(surface)
mesh, boundary, features, report = (fetch(mesher, port) for port in range(4))
assert report.GetNumberOfRows() == 1 and figure(report, "Valid") == 1
assert figure(report, "NumberOfHexes") == mesh.GetNumberOfCells() > 100
assert figure(report, "MinimumScaledJacobian") > 0.3
assert boundary.GetNumberOfCells() > 0 and boundary.GetCellData().HasArray("PatchId")
assert features.GetNumberOfCells() == 0
assert [simple.OutputPort(mesher, name).Port for name in (
    "Mesh", "Boundary", "Features", "Report", "Feature Report")] == [0, 1, 2, 3, 4]

chain = stages(surface)
checked, octree, dual, domain, padding, untangle, fitting, validation = chain
staged = fetch(validation)
assert figure(fetch(validation, 1), "Valid") == 1
assert fetch(validation, 2).GetNumberOfCells() == 0
assert staged.GetNumberOfCells() > 100
for stage, port in ((domain, 1), (fitting, 1)):
    assert fetch(stage, port).GetNumberOfPoints() == 0
cells = fetch(octree).GetNumberOfCells()
octree.UpdatePropertyInformation()
assert octree.PredictedNumberOfCells == cells

# Refinement points from several sources add up, and disconnecting them takes them back.
coarse = fetch(octree).GetNumberOfCells()
first = simple.PointSource(Center=[1, 0, 0], NumberOfPoints=1, Radius=0)
second = simple.PointSource(Center=[-1, 0, 0], NumberOfPoints=1, Radius=0)
octree.RefinementPoints = [first]
finer = fetch(octree).GetNumberOfCells()
octree.RefinementPoints = [first, second]
finest = fetch(octree).GetNumberOfCells()
assert coarse < finer < finest, (coarse, finer, finest)
octree.RefinementPoints = []
assert fetch(octree).GetNumberOfCells() == coarse

# Stitching, by the text of the drop-down.
untangle.Method = "Stitching"
assert fetch(untangle).GetNumberOfCells() == staged.GetNumberOfCells()
untangle.Method = "Regularized"
assert bits(fetch(validation)) == bits(staged)

# Inputs are greyed out on wrong data.
prototype = servermanager.ProxyManager().GetPrototypeProxy("filters", "HexPadding")
inputs = prototype.GetProperty("Input")
inputs.RemoveAllUncheckedProxies()
inputs.AddUncheckedInputConnection(checked.SMProxy, 0)
assert not inputs.IsInDomains()
inputs.RemoveAllUncheckedProxies()
inputs.AddUncheckedInputConnection(domain.SMProxy, 0)
assert inputs.IsInDomains()
inputs.RemoveAllUncheckedProxies()

# The automatic edge length stays, and the reset button offers its value.
automatic = simple.FeatureHexMesher(Input=surface)
assert automatic.TargetEdgeLength == 0
hint = automatic.SMProxy.GetProperty("TargetEdgeLength")
assert hint.ResetToDomainDefaults()
assert abs(hint.GetElement(0) - 2 / 20) < 0.01, hint.GetElement(0)

# Edge lengths by a point array.
sized = simple.Calculator(Input=surface, ResultArrayName="Size", Function="0.1 * (coordsX > 0)")
finer = composite(sized)
assert finer.EdgeLengthArray == "None"
assert fetch(finer).GetNumberOfCells() == mesh.GetNumberOfCells()
finer.EdgeLengthArray = "Size"
assert fetch(finer).GetNumberOfCells() > 1.2 * mesh.GetNumberOfCells()

# Files: what the writers write the readers read.
folder = os.environ["FEATUREHEX_TEMPORARY_DIR"]
path = os.path.join(folder, "proxies.mesh")
simple.SaveData(path, simple.OutputPort(mesher, 0))
reader = simple.OpenDataFile(path)
assert reader.GetXMLName() == "MeditMeshReader"
assert fetch(reader).GetNumberOfCells() == mesh.GetNumberOfCells()
assert fetch(reader).GetPoint(7) == mesh.GetPoint(7)
path = os.path.join(folder, "proxies.off")
with open(path, "w", encoding="utf-8") as file:
    file.write("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
tetrahedron = simple.OpenDataFile(path)
assert tetrahedron.GetXMLName() == "SurfaceFileReader"
assert fetch(tetrahedron).GetNumberOfCells() == 4
path = os.path.join(folder, "proxies.fgraph")
with open(path, "w", encoding="utf-8") as file:
    file.write("120 1 1\n2 1\n0\n1\n0 1\n")
graph = simple.OpenDataFile(path)
assert graph.GetXMLName() == "FeatureGraphReader"
graph.Surface = tetrahedron
features = fetch(graph)
assert features.GetNumberOfCells() == 3 and features.GetPoint(1) == (1, 0, 0)
copy = os.path.join(folder, "copy.fgraph")
simple.SaveData(copy, graph)
again = simple.OpenDataFile(copy)
again.Surface = tetrahedron
assert fetch(again).GetNumberOfCells() == 3
print(mesh.GetNumberOfCells(), "hexes")
