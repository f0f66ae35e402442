# SPDX-License-Identifier: BSD-3-Clause
"""Surface to hex mesh stage by stage, through ParaView's proxies:

    pvpython stages.py FeatureHex.so surface.stl mesh.vtu

Each stage is a filter of the pipeline, to look at or to replace. Where the cells are too coarse, a
stage has refinement points on its port 1, and the next round starts from an octree with them.
"""
import sys

from paraview.simple import *
from paraview import servermanager
from vtkmodules.vtkCommonCore import vtkSMPTools

TOLERANCE = 0.01
ROUNDS = 8


def data_of(port):
    port.UpdatePipeline()
    return servermanager.Fetch(port, idx=port.Port)


def has_points(port):
    return data_of(port).GetNumberOfPoints() > 0


def round_of_stages(surface, refinement):
    """(mesh, None), or (None, refinement points for the next round)."""
    octree = SurfaceOctree(Input=surface, Tolerance=TOLERANCE)
    if refinement:
        octree.RefinementPoints = refinement
    dual = OctreeDualHex(Input=octree)
    domain = HexDomain(Input=dual, Surface=surface, Tolerance=TOLERANCE)
    if has_points(OutputPort(domain, 1)):
        return None, OutputPort(domain, 1)
    padded = HexPadding(Input=domain)
    untangled = HexUntangle(Input=padded, Surface=surface)
    fitted = HexFitting(Input=untangled, Surface=surface, Tolerance=TOLERANCE)
    if has_points(OutputPort(fitted, 1)):
        return None, OutputPort(fitted, 1)
    return OutputPort(fitted, 0), None


plugin, surface_file, mesh_file = sys.argv[1:4]
LoadPlugin(plugin, ns=globals())
# ParaView's default is one thread.
vtkSMPTools.SetBackend("STDThread")

surface = OutputPort(SurfaceFeature(Input=OpenDataFile(surface_file)), 0)
mesh = None
refinement = []
while mesh is None and len(refinement) < ROUNDS:
    mesh, points = round_of_stages(surface, refinement)
    if points is not None:
        refinement.append(points)
        print("round %d: %d places need finer cells" % (
            len(refinement), data_of(points).GetNumberOfPoints()))
if mesh is None:
    raise RuntimeError("not within the tolerance after %d rounds" % ROUNDS)

validated = HexValidation(Input=mesh, Surface=surface, Tolerance=TOLERANCE)
figures = data_of(OutputPort(validated, 1))
if figures.GetColumnByName("Valid").GetComponent(0, 0) != 1:
    raise RuntimeError(figures.GetColumnByName("Verdict").GetValue(0))
print("%d hexes, valid" % figures.GetColumnByName("NumberOfHexes").GetComponent(0, 0))

# ParaView of Debian 12 can't read its own appended data.
SaveData(mesh_file, OutputPort(validated, 0), DataMode="Binary")
