# SPDX-License-Identifier: BSD-3-Clause
"""Surface to hex mesh stage by stage, through ParaView's proxies:

    pvpython stages.py FeatureHex.so surface.stl mesh.vtu

Sharp edges of the surface, where it has some, become edges of the mesh (Surface Feature finds them
by angle: --no-features at the end for organic shapes). Each stage is a filter of the pipeline, to look at or to replace. Where the cells are too coarse, a
stage has refinement points on its port 1, and the next round starts from an octree with them.
"""
import sys

from paraview.simple import *
from paraview import servermanager

TOLERANCE = 0.01
ROUNDS = 8


def data_of(port):
    port.UpdatePipeline()
    return servermanager.Fetch(port, idx=port.Port)


def has_points(port):
    return data_of(port).GetNumberOfPoints() > 0


def round_of_stages(surface, features, refinement):
    """(mesh, None), or (None, refinement points for the next round)."""
    octree = SurfaceOctree(Input=surface, Features=features, Tolerance=TOLERANCE)
    if refinement:
        octree.RefinementPoints = refinement
    dual = OctreeDualHex(Input=octree)
    domain = HexDomain(Input=dual, Surface=surface, Tolerance=TOLERANCE)
    if has_points(OutputPort(domain, 1)):
        return None, OutputPort(domain, 1)
    mapped = HexFeatureMapping(Input=domain, Surface=surface, Features=features)
    if has_points(OutputPort(mapped, 1)):
        return None, OutputPort(mapped, 1)
    if data_of(OutputPort(mapped, 0)).GetFieldData().GetArray("FeaturesMapped").GetTuple1(0) != 1:
        raise RuntimeError("features can't be mapped with cells at the maximum level")
    padded = HexPadding(Input=mapped, Surface=surface, Features=features)
    untangled = HexUntangle(Input=padded, Surface=surface, Features=features)
    fitted = HexFitting(
        Input=untangled, Surface=surface, Features=features, Tolerance=TOLERANCE)
    if has_points(OutputPort(fitted, 1)):
        return None, OutputPort(fitted, 1)
    return OutputPort(fitted, 0), None


plugin, surface_file, mesh_file = sys.argv[1:4]
LoadPlugin(plugin, ns=globals())

checked = SurfaceFeature(
    Input=OpenDataFile(surface_file), PreserveFeatures="--no-features" not in sys.argv)
surface, features = OutputPort(checked, 0), OutputPort(checked, 1)
mesh = None
refinement = []
while mesh is None and len(refinement) < ROUNDS:
    mesh, points = round_of_stages(surface, features, refinement)
    if points is not None:
        refinement.append(points)
        print("round %d: %d places need finer cells" % (
            len(refinement), data_of(points).GetNumberOfPoints()))
if mesh is None:
    raise RuntimeError("not within the tolerance after %d rounds" % ROUNDS)

has_features = data_of(features).GetNumberOfCells() > 0
validated = HexValidation(Input=mesh, Surface=surface, Tolerance=TOLERANCE,
                          Features=features if has_features else None)
figures = data_of(OutputPort(validated, 1))
if figures.GetColumnByName("Valid").GetComponent(0, 0) != 1:
    raise RuntimeError(figures.GetColumnByName("Verdict").GetValue(0))
for kind in ("Corners", "Curves", "Patches") if has_features else ():
    captured, enforced = (figures.GetColumnByName(kind + word).GetComponent(0, 0)
                          for word in ("Captured", "Enforced"))
    print("%s: %d of %d captured" % (kind, captured, enforced))
print("%d hexes, valid" % figures.GetColumnByName("NumberOfHexes").GetComponent(0, 0))

# ParaView of Debian 12 can't read its own appended data.
SaveData(mesh_file, OutputPort(validated, 0), DataMode="Binary")
