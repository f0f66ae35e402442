# SPDX-License-Identifier: BSD-3-Clause
"""Selections of edges, curves and points, extracted as a user does it, change the features."""
import os

from paraview import servermanager, simple

import pipelines

simple.LoadPlugin(os.environ["FEATUREHEX_PLUGIN"])


def select(proxy, port, query, cells):
    """Extract Selection of what a query finds."""
    source = servermanager.ProxyManager().NewProxy("sources", "SelectionQuerySource")
    source = servermanager._getPyProxy(source)
    source.QueryString = query
    source.ElementType = "Cell Data" if cells else "Point Data"
    picked = simple.ExtractSelection(Input=simple.OutputPort(proxy, port), Selection=source)
    assert pipelines.fetch(picked).GetNumberOfCells() > 0, query
    return picked


def counts(proxy):
    """Corners, curves, patches."""
    data = pipelines.fetch(proxy).GetFieldData()
    return [int(data.GetArray(name).GetTuple1(0))
            for name in ("NumberOfCorners", "NumberOfCurves", "NumberOfPatches")]


def changed(picked, mode):
    return counts(simple.SurfaceFeature(Input=cube, Annotation=picked, AnnotationMode=mode))


cube = simple.Box()  # each corner three times: the check merges them
found = simple.SurfaceFeature(Input=cube)
assert counts(found) == [8, 12, 6], counts(found)

curve = select(found, 1, "CurveId == 0", cells=True)
assert changed(curve, "Remove") == [8, 11, 5]
assert changed(curve, "Replace") == [2, 1, 1]

# Edges of the surface: all, so the diagonals of the faces too.
edges = simple.ExtractEdges(Input=simple.OutputPort(found, 0))
everything = select(edges, 0, "id >= 0", cells=True)
assert changed(everything, "Add") == [8, 18, 12]
assert changed(everything, "Remove") == [0, 0, 1]

# The result of a change is the annotation of the next: a point that lost an edge is a kink.
without = simple.SurfaceFeature(Input=cube, Annotation=curve, AnnotationMode="Remove")
graph = simple.OutputPort(without, 1)
assert changed(graph, "Replace") == [8, 11, 5]
corner = select(found, 1, "CornerId == 0", cells=True)
assert changed(corner, "Remove") == [8, 12, 6]
points = select(found, 1, "id < 2", cells=False)
assert changed(points, "Replace") == [2, 0, 1]

# The file of the result says the same again.
path = os.path.join(os.environ["FEATUREHEX_TEMPORARY_DIR"], "TestFeaturePicking.fgraph")
simple.SaveData(path, proxy=graph)
read = simple.FeatureGraphReader(FileName=path, Surface=simple.OutputPort(without, 0))
assert changed(read, "Replace") == [8, 11, 5]
