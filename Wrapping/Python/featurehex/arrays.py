# SPDX-License-Identifier: BSD-3-Clause
"""Meshing with NumPy arrays: points and triangles in, points and hexahedra out."""

from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy
from numpy.typing import ArrayLike, NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, vtkCellArray, vtkPolyData, vtkUnstructuredGrid)

from .update import MeshingError, Progress, update
from .vtkFeatureHexIO import (
    vtkFeatureGraphReader, vtkHexMeshReader, vtkHexMeshWriter, vtkSurfaceFileReader)
from .vtkFeatureHexPipeline import (
    vtkFeatureHexMesher, vtkHexValidationFilter, vtkSurfaceFeatureFilter)

__all__ = ["Features", "Finding", "HexMesh", "MeshCheck", "check", "mesh", "read_features",
           "read_mesh", "read_surface"]

Floats = NDArray[numpy.float64]
Ids = NDArray[numpy.int64]
Arrays = Dict[str, NDArray[Any]]


@dataclass
class Features:
    """Sharp edges and corners of a surface, as ids of its points."""

    #: (e, 2): the two points of each sharp edge.
    edges: Ids = field(default_factory=lambda: numpy.empty((0, 2), numpy.int64))
    #: (c,): corners that the edges alone don't tell.
    corners: Ids = field(default_factory=lambda: numpy.empty(0, numpy.int64))


@dataclass
class Finding:
    """Whether the mesh has one corner, curve or patch of the surface."""

    kind: str  #: "corner", "curve" or "patch"
    id: int
    outcome: str  #: "Captured", "NotEnforced", or what went wrong
    reason: str  #: in words; empty when captured
    deviation: float  #: model units
    where: Tuple[float, float, float]


@dataclass
class HexMesh:
    """A mesh of hexahedra with all that is known about it."""

    #: (n, 3), model units.
    points: Floats
    #: (k, 8): ids of the points of each hexahedron, in VTK's order.
    hexes: Ids
    #: FeatureKind (0 interior, 1 surface, 2 curve, 3 corner), FeatureId (of patch, curve, corner).
    point_data: Arrays = field(default_factory=dict)
    #: Region (body, 1 and up), Level (halvings of the edge length), ScaledJacobian.
    cell_data: Arrays = field(default_factory=dict)
    #: With features: FeatureQuads (q, 5): four points and the patch of each boundary quad;
    #: FeatureEdges (e, 3): two points and the curve.
    field_data: Arrays = field(default_factory=dict)
    #: NumberOfHexes, MinimumScaledJacobian, HausdorffUpper (fraction of the diagonal) and so on.
    figures: Dict[str, float] = field(default_factory=dict)
    #: One for each corner, curve and patch of the surface.
    features: List[Finding] = field(default_factory=list)
    #: In words.
    warnings: List[str] = field(default_factory=list)

    def to_vtk(self) -> vtkUnstructuredGrid:
        """The mesh with its arrays, as the filters take it."""
        grid = vtkUnstructuredGrid()
        grid.SetPoints(_points_of(self.points))
        grid.SetCells(VTK_HEXAHEDRON, _cells_of(self.hexes, 8))
        for data, arrays in ((grid.GetPointData(), self.point_data),
                             (grid.GetCellData(), self.cell_data),
                             (grid.GetFieldData(), self.field_data)):
            for name, values in arrays.items():
                array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
                array.SetName(name)
                data.AddArray(array)
        return grid

    def save(self, path: str) -> None:
        """Writes .vtu, .vtk, .mesh, .inp, .msh, .msh2, .exo, .e or .ucd. Raises MeshingError."""
        writer = vtkHexMeshWriter()
        writer.SetInputDataObject(self.to_vtk())
        writer.SetFileName(path)
        update(writer)


@dataclass
class MeshCheck:
    """What was measured of a mesh."""

    #: Whether every promise that could be checked is kept; features are no part of it.
    valid: bool
    #: What is wrong, in words.
    verdict: str
    #: PureConforming, CertifiedPositive, MinimumScaledJacobian, HausdorffUpper and so on.
    figures: Dict[str, float]
    #: Smallest scaled Jacobian of each hexahedron, -1 for a broken one.
    scaled_jacobian: Floats
    #: One for each corner, curve and patch of the surface.
    features: List[Finding]


def mesh(points: ArrayLike, triangles: ArrayLike, *, tolerance: Optional[float] = None,
         edge_length: Optional[float] = None, edge_lengths: Optional[ArrayLike] = None,
         features: Optional[Features] = None, feature_angle: Optional[float] = None,
         enforce_all_features: bool = False,
         minimum_scaled_jacobian: Optional[float] = None, maximum_level: Optional[int] = None,
         maximum_cells: Optional[int] = None, maximum_rounds: Optional[int] = None,
         align: bool = False, time_limit: Optional[float] = None,
         progress: Optional[Progress] = None) -> HexMesh:
    """A valid hex mesh of the inside of a closed triangle surface.

    points: (n, 3) coordinates; triangles: (m, 3) ids of points. Other options as on the command
    line (featurehex mesh --help), None is the default there:

    tolerance: largest distance between mesh and surface, fraction of the diagonal of the box.
    edge_length: of the hexahedra at the surface, model units; 0: by the size of the surface.
    edge_lengths: (n,), the largest ones wanted at the points; 0: no wish.
    features: sharp edges to reproduce; feature_angle: find them, degrees (140 is usual). Without
    both there are none.
    time_limit: seconds; 0: none.
    progress: is called with the share that is done and the phase; returns True to stop.

    Other Python threads run meanwhile, and Ctrl-C stops it.

    Raises MeshingError when the surface is rejected or no valid mesh can be made, ValueError for
    arrays of another form or options out of their range.
    """
    surface = _surface_of(points, triangles)
    mesher = vtkFeatureHexMesher()
    mesher.SetInputDataObject(0, surface)
    _set(mesher, Tolerance=tolerance, TargetEdgeLength=edge_length, MaximumLevel=maximum_level,
         MaximumNumberOfCells=maximum_cells, MaximumRounds=maximum_rounds, TimeLimit=time_limit,
         MinimumScaledJacobian=minimum_scaled_jacobian, FeatureAngle=feature_angle)
    if edge_lengths is not None:
        mesher.SetEdgeLengthArray(_add_edge_lengths(surface, edge_lengths))
    mesher.SetAlignToPrincipalAxes(align)
    mesher.SetEnforceAllFeatures(enforce_all_features)
    if feature_angle is not None:
        mesher.SetFeatureModeToAngle()
    if features is not None:
        mesher.SetInputDataObject(1, _annotation_of(surface, features))
    warnings = update(mesher, progress)
    result = _mesh_of(mesher.GetOutputDataObject(0))
    # The grid repeats the figures in its field data.
    result.field_data = {name: result.field_data[name] for name in ("FeatureQuads", "FeatureEdges")
                         if name in result.field_data}
    result.figures = _figures_of(mesher.GetOutputDataObject(3))
    result.features = _findings_of(mesher.GetOutputDataObject(4))
    result.warnings = warnings
    return result


def check(hex_mesh: HexMesh, points: Optional[ArrayLike] = None,
          triangles: Optional[ArrayLike] = None, *, tolerance: Optional[float] = None,
          features: Optional[Features] = None, feature_angle: Optional[float] = None,
          enforce_all_features: bool = False, progress: Optional[Progress] = None) -> MeshCheck:
    """Measures every promise about a hex mesh, whoever made it: HexMesh(points, hexes) is enough.

    points, triangles: the surface it was made from; without it, distance and topology aren't
    compared. features, feature_angle: what of the surface is sharp; the mesh's point_data tell
    where it has that. Other options as for mesh(). An invalid mesh is a result, no error.

    Raises MeshingError when mesh or surface can't be measured, ValueError as mesh().
    """
    if (points is None) != (triangles is None):
        raise ValueError("A surface has points and triangles: give both or none.")
    validation = vtkHexValidationFilter()
    validation.SetInputDataObject(0, hex_mesh.to_vtk())
    _set(validation, Tolerance=tolerance)
    wanted = features is not None or feature_angle is not None
    if points is not None and triangles is not None:
        surface = _surface_of(points, triangles)
        validation.SetInputDataObject(1, surface)
        if wanted:
            graph = _graph_of(surface, features, feature_angle, enforce_all_features)
            validation.SetInputDataObject(2, graph)
            validation.SetEnforceAllFeatures(enforce_all_features)
    elif wanted:
        raise ValueError("Features are those of a surface: give its points and triangles.")
    update(validation, progress)
    table = validation.GetOutputDataObject(1)
    figures = _figures_of(table)
    quality = validation.GetOutputDataObject(0).GetCellData().GetArray("ScaledJacobian")
    return MeshCheck(
        valid=figures["Valid"] == 1, verdict=table.GetValueByName(0, "Verdict").ToString(),
        figures=figures, scaled_jacobian=vtk_to_numpy(quality),
        features=_findings_of(validation.GetOutputDataObject(3)))


def read_surface(path: str) -> Tuple[Floats, Ids]:
    """Points (n, 3) and triangles (m, 3) of STL, OBJ, PLY, OFF, VTP or legacy VTK.

    Raises MeshingError.
    """
    surface = _read(vtkSurfaceFileReader(), path)
    ids = _polygon_ids(surface)
    return _coordinates_of(surface), ids


def read_features(path: str, points: ArrayLike, triangles: ArrayLike) -> Features:
    """The features of a .fgraph file for this surface. Raises MeshingError."""
    reader = vtkFeatureGraphReader()
    reader.SetInputDataObject(_surface_of(points, triangles))
    graph = _read(reader, path)
    ids = _integers(graph.GetPointData().GetArray("SurfacePointId"))
    edges = [(line[i], line[i + 1]) for line in _cells(graph.GetLines())
             for i in range(len(line) - 1)]
    corners = [vertex for cell in _cells(graph.GetVerts()) for vertex in cell]
    return Features(ids[numpy.array(edges, numpy.int64).reshape(-1, 2)],
                    ids[numpy.array(corners, numpy.int64)])


def read_mesh(path: str) -> HexMesh:
    """A hex mesh with its arrays from .vtu, legacy .vtk or Medit .mesh. Raises MeshingError."""
    return _mesh_of(_read(vtkHexMeshReader(), path))


def _set(algorithm, **options: Union[float, int, None]) -> None:
    """Sets what is given. Setters clamp in silence: what isn't taken as it is was out of range."""
    for name, value in options.items():
        if value is None:
            continue
        getattr(algorithm, "Set" + name)(value)
        if getattr(algorithm, "Get" + name)() != value:
            low, high = (getattr(algorithm, "Get" + name + bound + "Value")()
                         for bound in ("Min", "Max"))
            raise ValueError("%s: %r is not between %.10g and %.10g" % (name, value, low, high))


def _table(values: ArrayLike, width: int, kind: type, name: str) -> NDArray[Any]:
    """The values as a table of that many columns."""
    array = numpy.asarray(values)
    if array.size == 0:
        array = array.reshape(0, width)
    if array.ndim != 2 or array.shape[1] != width:
        raise ValueError("%s: the shape is %s instead of (n, %d)" % (name, array.shape, width))
    if kind is numpy.int64 and array.size and not numpy.issubdtype(array.dtype, numpy.integer):
        raise ValueError("%s: ids are integers, not %s" % (name, array.dtype))
    return numpy.ascontiguousarray(array, kind)


def _check_ids(ids: Ids, count: int, name: str) -> None:
    if ids.size and (ids.min() < 0 or ids.max() >= count):
        raise ValueError("%s: ids from %d to %d, but there are %d points" % (
            name, ids.min(), ids.max(), count))


def _points_of(coordinates: Floats) -> vtkPoints:
    points = vtkPoints()
    points.SetData(numpy_to_vtk(_table(coordinates, 3, numpy.float64, "points"), deep=True))
    return points


def _cells_of(ids: Ids, size: int) -> vtkCellArray:
    ids = _table(ids, size, numpy.int64, "hexes" if size == 8 else "triangles")
    cells = vtkCellArray()
    offsets = numpy.arange(0, ids.size + 1, size, dtype=numpy.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(ids.ravel(), deep=True))
    return cells


def _surface_of(points: ArrayLike, triangles: ArrayLike) -> vtkPolyData:
    surface = vtkPolyData()
    surface.SetPoints(_points_of(points))
    ids = _table(triangles, 3, numpy.int64, "triangles")
    _check_ids(ids, surface.GetNumberOfPoints(), "triangles")
    surface.SetPolys(_cells_of(ids, 3))
    return surface


def _add_edge_lengths(surface: vtkPolyData, edge_lengths: ArrayLike) -> str:
    """Adds the point array and returns its name."""
    values = _table(numpy.reshape(edge_lengths, (-1, 1)), 1, numpy.float64, "edge_lengths")
    if len(values) != surface.GetNumberOfPoints():
        raise ValueError("edge_lengths: %d values for %d points" % (
            len(values), surface.GetNumberOfPoints()))
    lengths = numpy_to_vtk(values, deep=True)
    lengths.SetName("EdgeLength")
    surface.GetPointData().AddArray(lengths)
    return "EdgeLength"


def _annotation_of(surface: vtkPolyData, features: Features) -> vtkPolyData:
    """The features as the filters take them: lines and vertices on the points of the surface."""
    count = surface.GetNumberOfPoints()
    edges = _table(features.edges, 2, numpy.int64, "features.edges")
    corners = _table(numpy.reshape(features.corners, (-1, 1)), 1, numpy.int64, "features.corners")
    _check_ids(edges, count, "features.edges")
    _check_ids(corners, count, "features.corners")
    annotation = vtkPolyData()
    annotation.SetPoints(surface.GetPoints())
    annotation.SetLines(_cells_of(edges, 2))
    annotation.SetVerts(_cells_of(corners, 1))
    ids = numpy_to_vtkIdTypeArray(numpy.arange(count, dtype=numpy.int64), deep=True)
    ids.SetName("SurfacePointId")
    annotation.GetPointData().AddArray(ids)
    return annotation


def _graph_of(surface: vtkPolyData, features: Optional[Features], angle: Optional[float],
              enforce_all: bool) -> vtkPolyData:
    """The feature graph, as vtkHexValidationFilter takes it."""
    finder = vtkSurfaceFeatureFilter()
    finder.SetInputDataObject(0, surface)
    finder.SetEnforceAllFeatures(enforce_all)
    _set(finder, FeatureAngle=angle)
    if features is not None:
        finder.SetInputDataObject(1, _annotation_of(surface, features))
        if angle is None:
            finder.SetAnnotationModeToReplace()
        else:
            finder.SetAnnotationModeToAdd()
    update(finder)
    return finder.GetOutputDataObject(1)


def _read(reader, path: str):
    reader.SetFileName(path)
    update(reader)
    return reader.GetOutput()


def _coordinates_of(data) -> Floats:
    points = data.GetPoints()
    if points is None:
        return numpy.empty((0, 3))
    return numpy.asarray(vtk_to_numpy(points.GetData()), numpy.float64)


def _integers(array) -> Ids:
    return numpy.asarray(vtk_to_numpy(array), numpy.int64)


def _cells(cells: vtkCellArray) -> List[Ids]:
    if cells.GetNumberOfCells() == 0:
        return []
    offsets = _integers(cells.GetOffsetsArray())
    return numpy.split(_integers(cells.GetConnectivityArray()), offsets[1:-1])


def _polygon_ids(surface: vtkPolyData) -> Ids:
    """Triangles; polygons and strips are cut as the filters do: fans around the first point."""
    triangles: List[Sequence[int]] = []
    polygons = surface.GetPolys()
    if polygons.GetNumberOfCells() and polygons.IsHomogeneous() == 3:
        found = _integers(polygons.GetConnectivityArray()).reshape(-1, 3)
    else:
        for cell in _cells(polygons):
            triangles += [(cell[0], cell[i], cell[i + 1]) for i in range(1, len(cell) - 1)]
        found = numpy.array(triangles, numpy.int64).reshape(-1, 3)
    strips = [(strip[i + i % 2], strip[i + 1 - i % 2], strip[i + 2])
              for strip in _cells(surface.GetStrips()) for i in range(len(strip) - 2)]
    return numpy.concatenate([found, numpy.array(strips, numpy.int64).reshape(-1, 3)])


def _arrays_of(data) -> Arrays:
    arrays: Arrays = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        if array is not None and array.GetName():
            arrays[array.GetName()] = vtk_to_numpy(array)
    return arrays


def _mesh_of(grid: vtkUnstructuredGrid) -> HexMesh:
    hexes = _integers(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)
    return HexMesh(_coordinates_of(grid), hexes, _arrays_of(grid.GetPointData()),
                   _arrays_of(grid.GetCellData()), _arrays_of(grid.GetFieldData()))


def _figures_of(table) -> Dict[str, float]:
    figures: Dict[str, float] = {}
    for i in range(table.GetNumberOfColumns()):
        column = table.GetColumn(i)
        if table.GetNumberOfRows() and hasattr(column, "GetComponent"):
            figures[column.GetName()] = column.GetComponent(0, 0)
    return figures


def _findings_of(table) -> List[Finding]:
    def value(row: int, name: str):
        return table.GetValueByName(row, name)

    return [Finding(
        kind=value(row, "Kind").ToString(), id=value(row, "Id").ToInt(),
        outcome=value(row, "Outcome").ToString(), reason=value(row, "Reason").ToString(),
        deviation=value(row, "Deviation").ToDouble(),
        where=(value(row, "X").ToDouble(), value(row, "Y").ToDouble(), value(row, "Z").ToDouble()))
            for row in range(table.GetNumberOfRows())]
