# SPDX-License-Identifier: BSD-3-Clause
"""Views of a hex mesh in ParaView: cut open, its quality, its features beside those of the surface.

For ParaView's window and for pvpython; the macros of the plugin call these functions. Where nothing
is given they take the active source, or the newest one that fits.
"""

from __future__ import annotations

import math
from typing import Any, Callable

from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkDataObject

WHITE = [1.0, 1.0, 1.0]
FEATURE_COLOR = [0.85, 0.0, 0.45]


def cut_view(mesh: Any = None, axis: int | None = None, position: float = 0.5,
             view: Any = None) -> Any:
    """Shows the whole hexes on one side of a plane, with their edges, coloured by scaled Jacobian.

    axis: normal of the plane; without it that of the shortest side. position: of the plane, as a
    fraction of the bounding box. Returns the clip, whose plane can be moved.
    """
    mesh = _find(mesh, _is_hex_mesh, "hex mesh: the output Mesh of Feature Hex Mesher, for example")
    view = view or simple.GetActiveViewOrCreate("RenderView")
    bounds = mesh.GetDataInformation().GetBounds()
    sides = [bounds[2 * i + 1] - bounds[2 * i] for i in range(3)]
    center = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    if axis is None:
        axis = min((1, 0, 2), key=lambda i: sides[i])
    up = 2 if axis != 2 else 1

    clip = simple.Clip(registrationName="HexCut", Input=_with_quality(mesh), ClipType="Plane")
    clip.ClipType.Normal = [float(i == axis) for i in range(3)]
    clip.ClipType.Origin = [bounds[2 * i] + position * sides[i] if i == axis else center[i]
                            for i in range(3)]
    # Hexes stay whole; those that the plane meets stay.
    clip.Crinkleclip = 1
    simple.HideAll(view)
    _show(clip, view, "ScaledJacobian", "Scaled Jacobian")
    _white(view)
    # Onto the cut, a little from the side and from above.
    direction = [0.0, 0.0, 0.0]
    direction[axis], direction[3 - axis - up], direction[up] = 1.0, 0.45, 0.3
    view.CameraFocalPoint = center
    view.CameraPosition = [c + max(sides) * d for c, d in zip(center, direction)]
    view.CameraViewUp = [float(i == up) for i in range(3)]
    simple.SetActiveSource(clip)
    simple.Hide3DWidgets(proxy=clip.ClipType)
    view.ResetCamera(False)
    simple.Render(view)
    return clip


def quality_view(mesh: Any = None, surface: Any = None) -> Any:
    """A layout with the histograms of scaled Jacobian and deviation, the worst hexes in the mesh, and
    the boundary coloured by deviation. Returns the filter Hex Quality.

    surface: without it that of the FeatureHex filter that made the mesh, else the newest surface
    with the bounding box of the mesh.
    """
    mesh = _find(mesh, _is_hex_mesh, "hex mesh: the output Mesh of Feature Hex Mesher, for example")
    # It finds its surface where filters of ours made the mesh.
    quality = simple.HexQuality(registrationName="HexQuality", Input=mesh)
    if surface is None:
        surface = quality.Surface if quality.Surface is not None else _surface_around(mesh)
    quality.Surface = surface
    quality.UpdatePipeline()
    quality.UpdatePropertyInformation()

    layout = simple.CreateLayout("Hex Quality")
    top = _chart(quality, 0, "Scaled Jacobian", "hexes")
    simple.AssignViewToLayout(view=top, layout=layout, hint=0)
    if surface is not None:
        layout.SplitVertical(0, 0.5)
        simple.AssignViewToLayout(
            view=_chart(quality, 1, "Deviation / tolerance", "boundary quads"), layout=layout, hint=2)
    worst = simple.CreateRenderView()
    simple.AssignViewToLayout(view=worst, layout=layout,
                              hint=layout.SplitHorizontal(1 if surface is not None else 0, 0.5) + 1)
    _white(worst)
    around = simple.Show(mesh, worst)
    around.SetRepresentationType("Surface")
    around.SetScalarColoring(None, 0)
    around.DiffuseColor = around.AmbientColor = [0.6, 0.65, 0.7]
    around.Opacity = 0.12
    _show(simple.OutputPort(quality, 2), worst, "ScaledJacobian", "Scaled Jacobian")
    _camera(worst, mesh)
    if surface is not None:
        deviation = simple.CreateRenderView()
        simple.AssignViewToLayout(view=deviation, layout=layout,
                                  hint=layout.SplitHorizontal(2, 0.5) + 1)
        _white(deviation)
        _show(simple.OutputPort(quality, 3), deviation, "DeviationOfTolerance",
              "Deviation / tolerance")
        _camera(deviation, mesh)
        simple.AddCameraLink(worst, deviation, "hex quality")
    simple.SetActiveSource(quality)
    simple.RenderAllViews()
    return quality


def feature_view(mesher: Any = None) -> Any:
    """A layout with the surface and its sharp features on the left, and the mesh with the chains of
    edges that stand for them on the right: captured ones are green, missed ones red. The cameras are
    linked. Returns the layout.

    mesher: a Feature Hex Mesher.
    """
    mesher = _proxy_of(_find(mesher, _is_mesher, "Feature Hex Mesher"))
    given = mesher.Features
    if mesher.FeatureMode == "Angle" and given is None:
        found = simple.SurfaceFeature(registrationName="FeaturesByAngle", Input=mesher.Input,
                                      FeatureAngle=mesher.FeatureAngle)
        given = simple.OutputPort(found, 1)
    result = simple.OutputPort(mesher, 2)
    if given is None or result.GetDataInformation().GetNumberOfCells() == 0:
        raise RuntimeError("The mesh was made without sharp features: give Feature Hex Mesher some, "
                           "or set its Feature Mode to Angle.")

    layout = simple.CreateLayout("Features")
    left, right = simple.CreateRenderView(), simple.CreateRenderView()
    simple.AssignViewToLayout(view=left, layout=layout, hint=0)
    simple.AssignViewToLayout(view=right, layout=layout, hint=layout.SplitHorizontal(0, 0.5) + 1)
    for view in (left, right):
        _white(view)
    _plain(simple.Show(mesher.Input, left), "Surface")
    lines = simple.Show(given, left)
    _plain(lines, "Surface")
    lines.DiffuseColor = lines.AmbientColor = FEATURE_COLOR
    _plain(simple.Show(mesher, right), "Surface With Edges")
    captured = simple.Show(result, right)
    captured.SetRepresentationType("Surface")
    colors = simple.GetColorTransferFunction("Captured")
    colors.RGBPoints = [0, 0.85, 0.1, 0.1, 1, 0.05, 0.55, 0.2]
    colors.ColorSpace = "RGB"
    colors.AutomaticRescaleRangeMode = "Never"
    _color(captured, "Captured")
    captured.SetScalarBarVisibility(right, False)
    for display in (lines, captured):
        display.LineWidth = 4
        display.PointSize = 9
        display.RenderLinesAsTubes = display.RenderPointsAsSpheres = 1
    _camera(left, mesher)
    _camera(right, mesher)
    simple.AddCameraLink(left, right, "features")
    simple.RenderAllViews()
    return layout


# What the views share.


def _proxy_of(source: Any) -> Any:
    return simple.OutputPort(source, 0)


def _is_hex_mesh(source: Any) -> bool:
    information = source.GetDataInformation()
    # A part of a mesh is none.
    return (source.GetXMLName() not in ("Clip", "HexQuality")
            and information.GetDataSetTypeAsString() == "vtkUnstructuredGrid"
            and information.GetNumberOfCells() > 0)


def _is_mesher(source: Any) -> bool:
    return source.GetXMLName() == "FeatureHexMesher"


def _newest_first() -> list[Any]:
    sources = simple.GetSources()
    return [sources[name] for name in sorted(sources, key=lambda name: int(name[1]), reverse=True)]


def _find(given: Any, fits: Callable[[Any], bool], what: str) -> Any:
    """What is given, else the active source, else the newest source that fits."""
    if given is not None:
        candidates = [given]
    else:
        active = simple.GetActiveSource()
        candidates = ([active] if active else []) + _newest_first()
    for source in candidates:
        source.UpdatePipeline()
        if fits(source):
            return source
    raise RuntimeError("There is nothing to show. Needed is a " + what + ".")


def _surface_around(mesh: Any) -> Any:
    """The newest surface whose bounding box is that of the mesh, within 2 % of its diagonal; None."""

    def box(source: Any) -> list[float]:
        return list(source.GetDataInformation().GetBounds())

    wanted = box(mesh)
    allowed = 0.02 * math.dist(wanted[::2], wanted[1::2])
    for source in _newest_first():
        source.UpdatePipeline()
        # Lines are polydata, too: nothing but the data says that there are triangles.
        if (source.GetDataInformation().GetDataSetTypeAsString() == "vtkPolyData"
                and all(abs(a - b) <= allowed for a, b in zip(box(source), wanted))
                and servermanager.Fetch(source).GetNumberOfPolys() > 0):
            return source
    return None


def _with_quality(mesh: Any) -> Any:
    """The mesh with the cell array ScaledJacobian."""
    if mesh.CellData.GetArray("ScaledJacobian"):
        return mesh
    return simple.HexValidation(registrationName="HexValidation", Input=mesh)


def _white(view: Any) -> None:
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = WHITE


def _plain(display: Any, representation: str) -> None:
    display.SetRepresentationType(representation)
    display.SetScalarColoring(None, 0)


def _color(display: Any, array: str) -> None:
    """By a cell array; ColorBy() would fit the range of its colour map to the data."""
    display.SetScalarColoring(array, vtkDataObject.FIELD_ASSOCIATION_CELLS)


def _show(source: Any, view: Any, array: str, title: str) -> None:
    """With edges, coloured by a cell array that has a colour map of ours."""
    display = simple.Show(source, view)
    display.SetRepresentationType("Surface With Edges")
    display.EdgeColor = [0.15, 0.15, 0.15]
    _color(display, array)
    display.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(simple.GetColorTransferFunction(array), view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]


def _camera(view: Any, mesh: Any) -> None:
    """From the front, a little from the side and from above, onto the whole mesh."""
    bounds = mesh.GetDataInformation().GetBounds()
    view.CameraFocalPoint = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    view.CameraPosition = [f + d for f, d in zip(view.CameraFocalPoint, (0.45, -1.0, 0.35))]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.ResetCamera(False)


def _chart(quality: Any, port: int, title: str, counted: str) -> Any:
    """A bar chart of a histogram of Hex Quality."""
    view = simple.CreateView("XYBarChartView")
    simple.Show(simple.OutputPort(quality, port), view, "XYBarChartRepresentation")
    view.ChartTitle = title
    view.LeftAxisTitle = counted
    view.ShowLegend = 0
    return view
