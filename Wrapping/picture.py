# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a hex mesh cut open, with visible cell edges, coloured by the scaled Jacobian."""
import argparse

import vtkmodules.vtkInteractionStyle  # noqa: F401  registers the factories of the renderer
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonCore import vtkIdList, vtkLookupTable
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersExtraction import vtkExtractCells
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

# From violet (0) through red and yellow to green and blue (1): bad cells stand out.
COLORS = [(0.40, 0.00, 0.40), (0.75, 0.05, 0.15), (0.90, 0.40, 0.10), (0.98, 0.80, 0.25),
          (0.75, 0.88, 0.45), (0.40, 0.76, 0.60), (0.25, 0.60, 0.80), (0.20, 0.40, 0.75)]


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


def size_of(text):
    width, height = text.split("x")
    return int(width), int(height)


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


def fit(renderer, part):
    """Fills the picture with the points, but for room for the colours on the right."""
    camera = renderer.GetActiveCamera()
    matrix = camera.GetCompositeProjectionTransformMatrix(renderer.GetTiledAspectRatio(), -1, 1)
    seen = []
    for i in range(part.GetNumberOfPoints()):
        x, y, _, w = matrix.MultiplyPoint((*part.GetPoint(i), 1))
        seen.append((x / w, y / w))
    low, high = ([f(p[k] for p in seen) for k in (0, 1)] for f in (min, max))
    # The picture is -1 to 1 both ways.
    left, right, top = -0.95, 0.72, 0.95
    factor = min((right - left) / (high[0] - low[0]), 2 * top / (high[1] - low[1]))
    camera.Zoom(factor)
    camera.SetWindowCenter(0.5 * factor * (low[0] + high[0]) - 0.5 * (left + right),
                           0.5 * factor * (low[1] + high[1]))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesh", help="hex mesh, .vtu")
    parser.add_argument("picture", help="result, .png")
    parser.add_argument("--size", type=size_of, default="900x900", help="in pixels, WIDTHxHEIGHT")
    parser.add_argument("--axis", type=int, default=1, choices=(0, 1, 2), help="normal of the cut")
    parser.add_argument("--position", type=float, default=0.5,
                        help="of the cut, as a fraction of the box; 1: not cut")
    parser.add_argument("--other-side", action="store_true",
                        help="keep and look at the other side of the cut")
    parser.add_argument("--up", type=int, default=2, choices=(0, 1, 2), help="axis that points up")
    options = parser.parse_args()
    if options.up == options.axis:
        parser.error("--up must not be the axis of the cut")

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(options.mesh)
    reader.Update()
    mesh = reader.GetOutput()
    if mesh.GetNumberOfCells() == 0:
        raise RuntimeError(f"{options.mesh}: no cells")
    mesh = with_quality(mesh)
    bounds = mesh.GetBounds()
    sign = 1 if options.other_side else -1
    part = cut_open(mesh, options.axis, options.position, sign)
    if part.GetNumberOfCells() == 0:
        raise RuntimeError("no cells on this side of the cut")

    # The producer is kept alive by this name: a pipeline of temporaries crashes.
    producer = vtkTrivialProducer()
    producer.SetOutput(part)
    surface = vtkGeometryFilter()
    surface.SetInputConnection(producer.GetOutputPort())
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("ScaledJacobian")
    mapper.SetLookupTable(color_table(0, 1))
    mapper.UseLookupTableScalarRangeOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.15, 0.15, 0.15)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.7)

    bar = vtkScalarBarActor()
    bar.SetLookupTable(mapper.GetLookupTable())
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
        text.SetFontSize(max(8, min(options.size) // 50))
        text.BoldOff()
        text.ShadowOff()
        text.ItalicOff()

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    renderer.AddViewProp(bar)
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
    fit(renderer, part)
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
