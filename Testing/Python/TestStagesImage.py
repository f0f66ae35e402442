# SPDX-License-Identifier: BSD-3-Clause
"""Octree, dual mesh and result of a small organic shape, cut open; a number beside each picture."""
import os

import featurehex
import numpy
from baseline import centers, compare, part, render
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_INT
from vtkmodules.vtkFiltersCore import vtkArrayCalculator
from vtkmodules.vtkFiltersSources import vtkPointSource

EDGE = 0.22
TOLERANCE = 0.02
# Onto the cut, from a side and from above.
DIRECTION = (1.2, -3, 1)

reader = featurehex.vtkSurfaceFileReader()
reader.SetFileName(os.path.join(os.environ["FEATUREHEX_SOURCE_DIR"], "Data", "blob.obj"))
octree_filter = featurehex.vtkSurfaceOctreeFilter()
octree_filter.SetInputConnection(0, reader.GetOutputPort())
octree_filter.SetTargetEdgeLength(EDGE)
# Two more levels at one place, on the cut.
finer = vtkPointSource()
finer.SetNumberOfPoints(1)
finer.SetRadius(0)
finer.SetCenter(0.9, 0.05, 0.4)
levels = vtkArrayCalculator()
levels.SetInputConnection(finer.GetOutputPort())
levels.SetAttributeTypeToPointData()
levels.SetFunction("2")
levels.SetResultArrayName("Level")
levels.SetResultArrayType(VTK_INT)
octree_filter.SetInputConnection(2, levels.GetOutputPort())
dual_filter = featurehex.vtkOctreeDualHexFilter()
dual_filter.SetInputConnection(octree_filter.GetOutputPort())
dual_filter.Update()
mesher = featurehex.vtkFeatureHexMesher()
mesher.SetInputConnection(0, reader.GetOutputPort())
mesher.SetTargetEdgeLength(EDGE)
mesher.SetTolerance(TOLERANCE)
mesher.Update()


def cells(mesh, name):
    return vtk_to_numpy(mesh.GetCellData().GetArray(name))


def picture(mesh, numbers, height, name):
    """The half of the mesh behind the plane y = 0."""
    kept = centers(mesh)[:, 1] > 0
    assert 0.3 < kept.mean() < 0.7
    camera = ((0, 0, 0), DIRECTION, height)
    compare(render(part(mesh, kept), numpy.asarray(numbers)[kept], camera), name)


# The leaves fill the root cube.
octree = octree_filter.GetOutputDataObject(0)
field = octree.GetFieldData()
level = cells(octree, "Level")
finest = field.GetArray("OctreeFinestCellSize").GetValue(0)
size = finest * 2.0 ** (field.GetArray("OctreeDepth").GetValue(0)
                        - field.GetArray("OctreeBaseLevel").GetValue(0) - level)
bounds = numpy.reshape(octree.GetBounds(), (3, 2))
box = numpy.prod(bounds[:, 1] - bounds[:, 0])
assert abs((size ** 3).sum() / box - 1) < 1e-9, ((size ** 3).sum(), box)
picture(octree, level - level.min(), 1.45 * (bounds[2, 1] - bounds[2, 0]), "octree")

# No hex of the dual is worse than the enumeration of all neighbourhoods says.
dual = dual_filter.GetOutputDataObject(0)
validation = featurehex.vtkHexValidationFilter()
validation.SetInputDataObject(0, dual)
validation.Update()
worst = cells(validation.GetOutputDataObject(0), "ScaledJacobian").min()
assert 0.4386 <= worst + 5e-5 <= 1, worst
picture(dual, 2 * cells(dual, "DualHexKind"), 1.45 * (bounds[2, 1] - bounds[2, 0]), "dual")

# The result is valid. Violet is bad, blue is good.
mesh = mesher.GetOutputDataObject(0)
report = mesher.GetOutputDataObject(3)
assert report.GetColumnByName("Valid").GetValue(0) == 1
quality = cells(mesh, "ScaledJacobian")
assert quality.min() > 0.3 and quality.mean() > 0.7, (quality.min(), quality.mean())
picture(mesh, numpy.clip(quality * 7, 0, 6).astype(int), 3.0, "result")
