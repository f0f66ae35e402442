# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a hex mesh cut open, with visible cell edges, coloured by the scaled Jacobian; sharp
features of the mesh are lines. Or of a surface with its feature graph."""
import argparse
import os

import vtkmodules.vtkInteractionStyle  # noqa: F401  registers the factories of the renderer
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonCore import vtkIdList, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkMapper, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

# From violet (0) through red and yellow to green and blue (1): bad cells stand out.
COLORS = [(0.40, 0.00, 0.40), (0.75, 0.05, 0.15), (0.90, 0.40, 0.10), (0.98, 0.80, 0.25),
          (0.75, 0.88, 0.45), (0.40, 0.76, 0.60), (0.25, 0.60, 0.80), (0.20, 0.40, 0.75)]

try:
    from vtkmodules.vtkFiltersExtraction import vtkExtractCells
except ImportError:
    # Where ParaView's VTK has it.
    from vtkmodules.vtkFiltersCore import vtkExtractCells

SURFACE_READERS = {".obj": vtkOBJReader, ".stl": vtkSTLReader, ".ply": vtkPLYReader,
                   ".vtp": vtkXMLPolyDataReader, ".vtk": vtkPolyDataReader}


def color_table(low, high):
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetRange(low, high)
    for i in range(256):
        at = i / 255 * (len(COLORS) - 1)
        k = min(int(at), len(COLORS) - 2)
        rgb = [a + (at - k) * (b - a) for a, b in zip(COLORS[k], COLORS[k + 1])]
        table.SetTableValue(i, *rgb, 1)
    table.Build()
    return table


def with_quality(mesh):
    if mesh.GetCellData().HasArray("ScaledJacobian"):
        return mesh
    quality = vtkMeshQuality()
    quality.SetInputData(mesh)
    quality.SetHexQualityMeasureToScaledJacobian()
    quality.Update()
    result = quality.GetOutput()
    result.GetCellData().GetArray("Quality").SetName("ScaledJacobian")
    return result


def extension_of(path):
    return os.path.splitext(path)[1].lower()


def axis_of(text):
    return text if text == "auto" else int(text)


def size_of(text):
    width, height = text.split("x")
    return int(width), int(height)


def turn(options, bounds):
    """Decides --axis auto: the cut that shows most."""
    if options.axis == "auto":
        sides = [bounds[2 * i + 1] - bounds[2 * i] for i in range(3)]
        # The second for equal ones, the default.
        options.axis = min((1, 0, 2), key=lambda i: sides[i])
        if options.up == options.axis:
            options.up = 1 if options.axis == 2 else 2


def crowded(faces, size):
    """Whether edges would leave nothing of the faces: about half of them are seen."""
    return 0.4 * size[0] * size[1] < 16 * 0.5 * faces


def cut_open(mesh, axis, position, sign):
    """The whole cells whose boxes have their centres on one side of a plane.

    position: a fraction of the box; sign: -1 keeps what is below, 1 what is above.
    """
    bounds = mesh.GetBounds()
    plane = bounds[2 * axis] + position * (bounds[2 * axis + 1] - bounds[2 * axis])
    kept = vtkIdList()
    box = [0.0] * 6
    for cell in range(mesh.GetNumberOfCells()):
        mesh.GetCellBounds(cell, box)
        if sign * (0.5 * (box[2 * axis] + box[2 * axis + 1]) - plane) >= 0:
            kept.InsertNextId(cell)
    extract = vtkExtractCells()
    extract.SetInputData(mesh)
    extract.SetCellList(kept)
    extract.Update()
    return extract.GetOutput()


def feature_lines(points, edges, corners):
    """Polydata of lines and vertices. edges: pairs of point ids; corners: point ids."""
    lines, vertices = vtkCellArray(), vtkCellArray()
    for edge in edges:
        lines.InsertNextCell(2, edge)
    for corner in corners:
        vertices.InsertNextCell(1, [corner])
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetLines(lines)
    result.SetVerts(vertices)
    return result


def features_of(mesh, part):
    """Feature edges and corners of the mesh that are in the part of it."""
    edges = mesh.GetFieldData().GetArray("FeatureEdges")
    if not edges:
        return feature_lines(mesh.GetPoints(), [], [])
    kinds = mesh.GetPointData().GetArray("FeatureKind")
    # A part has copies of the points.
    kept = {part.GetPoint(i) for i in range(part.GetNumberOfPoints())}
    pairs = [[int(id) for id in edges.GetTuple(i)[:2]] for i in range(edges.GetNumberOfTuples())]
    pairs = [pair for pair in pairs if all(mesh.GetPoint(id) in kept for id in pair)]
    corners = [i for i in range(mesh.GetNumberOfPoints())
               if kinds.GetValue(i) == 3 and mesh.GetPoint(i) in kept]
    return feature_lines(mesh.GetPoints(), pairs, corners)


def read_features(path, surface):
    """A .fgraph file: Filters/Documentation/formats.md."""
    with open(path, encoding="utf-8") as file:
        numbers = [int(word) for line in file.readlines()[1:] for word in line.split()]
    corners, edges = numbers[0], numbers[1]
    ends = numbers[2 + corners:2 + corners + 2 * edges]
    return feature_lines(surface.GetPoints(), list(zip(ends[::2], ends[1::2])),
                         numbers[2:2 + corners])


def read(path, reader):
    reader.SetFileName(path)
    reader.Update()
    if reader.GetOutput().GetNumberOfCells() == 0:
        raise RuntimeError(f"{path}: no cells")
    return reader.GetOutput()


def actor_of(data):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetEdgeColor(0.15, 0.15, 0.15)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.7)
    return actor


def feature_actor(lines, pixels):
    actor = actor_of(lines)
    # In front of the faces beside them, but behind those farther in front.
    actor.GetMapper().SetRelativeCoincidentTopologyLineOffsetParameters(-4, -4)
    actor.GetMapper().SetRelativeCoincidentTopologyPointOffsetParameter(-8)
    appearance = actor.GetProperty()
    appearance.SetColor(0.85, 0.0, 0.45)
    appearance.LightingOff()
    appearance.SetLineWidth(max(2, pixels / 200))
    appearance.SetPointSize(max(5, pixels / 65))
    appearance.RenderPointsAsSpheresOn()
    return actor


def color_bar(table, pixels):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle("scaled\nJacobian")
    bar.SetNumberOfLabels(6)
    bar.SetLabelFormat("%.1f")
    bar.SetVerticalTitleSeparation(8)
    bar.SetPosition(0.87, 0.05)
    bar.SetWidth(0.12)
    bar.SetHeight(0.4)
    bar.UnconstrainedFontSizeOn()
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0, 0, 0)
        text.SetFontSize(max(8, pixels // 50))
        text.BoldOff()
        text.ShadowOff()
        text.ItalicOff()
    return bar


def add_mesh(renderer, options, sign):
    """Returns what is shown of the mesh, and the box of all of it."""
    mesh = with_quality(read(options.mesh, vtkXMLUnstructuredGridReader()))
    turn(options, mesh.GetBounds())
    part = cut_open(mesh, options.axis, options.position, sign)
    if part.GetNumberOfCells() == 0:
        raise RuntimeError("no cells on this side of the cut")
    # The producer is kept alive by this name: a pipeline of temporaries crashes.
    producer = vtkTrivialProducer()
    producer.SetOutput(part)
    surface = vtkGeometryFilter()
    surface.SetInputConnection(producer.GetOutputPort())
    surface.Update()
    actor = actor_of(surface.GetOutput())
    if not crowded(surface.GetOutput().GetNumberOfCells(), options.size):
        actor.GetProperty().EdgeVisibilityOn()
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("ScaledJacobian")
    mapper.SetLookupTable(color_table(0, 1))
    mapper.UseLookupTableScalarRangeOn()
    renderer.AddActor(actor)
    if options.legend:
        renderer.AddViewProp(color_bar(mapper.GetLookupTable(), min(options.size)))
    renderer.AddActor(feature_actor(features_of(mesh, part), min(options.size)))
    return part, mesh.GetBounds()


def add_surface(renderer, options):
    surface = read(options.mesh, SURFACE_READERS[extension_of(options.mesh)]())
    turn(options, surface.GetBounds())
    actor = actor_of(surface)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetAmbient(0.5)
    actor.GetProperty().SetColor(0.82, 0.85, 0.88)
    renderer.AddActor(actor)
    if options.features:
        lines = read_features(options.features, surface)
        renderer.AddActor(feature_actor(lines, min(options.size)))
    return surface, surface.GetBounds()


def fit(renderer, part, right):
    """Fills the picture with the points up to the right; behind that is room for the colours."""
    camera = renderer.GetActiveCamera()
    matrix = camera.GetCompositeProjectionTransformMatrix(renderer.GetTiledAspectRatio(), -1, 1)
    seen = []
    for i in range(part.GetNumberOfPoints()):
        x, y, _, w = matrix.MultiplyPoint((*part.GetPoint(i), 1))
        seen.append((x / w, y / w))
    low, high = ([f(p[k] for p in seen) for k in (0, 1)] for f in (min, max))
    # The picture is -1 to 1 both ways.
    left, top = -0.95, 0.95
    factor = min((right - left) / (high[0] - low[0]), 2 * top / (high[1] - low[1]))
    camera.Zoom(factor)
    camera.SetWindowCenter(0.5 * factor * (low[0] + high[0]) - 0.5 * (left + right),
                           0.5 * factor * (low[1] + high[1]))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesh", help="hex mesh, .vtu, or surface, .obj, .stl, .ply, .vtp or .vtk")
    parser.add_argument("picture", help="result, .png")
    parser.add_argument("--size", type=size_of, default="900x900", help="in pixels, WIDTHxHEIGHT")
    parser.add_argument("--axis", type=axis_of, default=1, choices=(0, 1, 2, "auto"),
                        help="normal of the cut; auto: along the shortest side")
    parser.add_argument("--position", type=float, default=0.5,
                        help="of the cut, as a fraction of the box; 1: not cut")
    parser.add_argument("--other-side", action="store_true",
                        help="keep and look at the other side of the cut")
    parser.add_argument("--up", type=int, default=2, choices=(0, 1, 2), help="axis that points up")
    parser.add_argument("--features", metavar="FILE", help="of a surface .obj: .fgraph")
    parser.add_argument("--no-legend", dest="legend", action="store_false",
                        help="without the scale of the colours")
    options = parser.parse_args()
    if options.up == options.axis:
        parser.error("--up must not be the axis of the cut")

    # So that lines on faces aren't hidden by them.
    vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    sign = 1 if options.other_side else -1
    if extension_of(options.mesh) in SURFACE_READERS:
        part, bounds = add_surface(renderer, options)
    else:
        part, bounds = add_mesh(renderer, options, sign)
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(*options.size)
    window.AddRenderer(renderer)

    # Onto the cut, a little from the side and from above.
    center = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    side = 3 - options.axis - options.up
    direction = [0.0, 0.0, 0.0]
    direction[options.axis] = -sign * 1.0
    direction[side] = 0.45
    direction[options.up] = 0.3
    up = [0.0, 0.0, 0.0]
    up[options.up] = 1.0
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(center)
    camera.SetPosition([c + d for c, d in zip(center, direction)])
    camera.SetViewUp(up)
    renderer.ResetCamera()
    fit(renderer, part, 0.72 if options.legend else 0.95)
    renderer.ResetCameraClippingRange()
    window.Render()

    capture = vtkWindowToImageFilter()
    capture.SetInput(window)
    capture.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(capture.GetOutputPort())
    writer.SetFileName(options.picture)
    writer.Write()


main()
