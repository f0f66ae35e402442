# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of hex meshes cut open, compared with those in Testing/Baseline.

A baseline is made, or made anew, by running its test with FEATUREHEX_UPDATE_BASELINE=1. Look at it
before it is committed.
"""
import os
import struct
import zlib

import numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers the factories of the renderer
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

SIZE = 300
FOLDER = os.path.join(os.environ["FEATUREHEX_SOURCE_DIR"], "Testing", "Baseline")
# For 0, 1, 2 ...: flat colours that also differ in grey.
COLORS = [(0.36, 0.12, 0.45), (0.80, 0.15, 0.20), (0.95, 0.55, 0.15), (0.98, 0.85, 0.35),
          (0.70, 0.85, 0.45), (0.35, 0.72, 0.65), (0.25, 0.50, 0.80), (0.85, 0.88, 0.92)]


def centers(mesh):
    """Mean of the corners of each cell, all of which have eight."""
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    cells = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 8)
    return points[cells].mean(axis=1)


def part(mesh, kept):
    """The cells of a mask, all of one type with eight corners, without arrays."""
    cells = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 8)[kept]
    array = vtkCellArray()
    array.SetData(8, numpy_to_vtk(cells.ravel().astype(numpy.int64), deep=True))
    result = vtkUnstructuredGrid()
    result.SetPoints(mesh.GetPoints())
    result.SetCells(mesh.GetCellType(0), array)
    return result


def render(mesh, numbers, camera):
    """Pixels of a mesh with visible edges, coloured by an integer for each cell.

    camera: focal point, direction to the camera, height of the view.
    """
    array = numpy_to_vtk(numpy.asarray(numbers, dtype=numpy.int32), deep=True)
    array.SetName("Numbers")
    mesh.GetCellData().AddArray(array)
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(COLORS))
    table.SetTableRange(-0.5, len(COLORS) - 0.5)
    for i, color in enumerate(COLORS):
        table.SetTableValue(i, *color, 1)

    surface = vtkGeometryFilter()
    surface.SetInputData(mesh)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("Numbers")
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.1, 0.1, 0.1)

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    focus, direction, height = camera
    view = renderer.GetActiveCamera()
    view.ParallelProjectionOn()
    view.SetFocalPoint(focus)
    view.SetPosition([f + d for f, d in zip(focus, direction)])
    view.SetViewUp(0, 0, 1)
    view.SetParallelScale(height / 2)
    renderer.ResetCameraClippingRange()
    window.Render()
    capture = vtkWindowToImageFilter()
    capture.SetInput(window)
    capture.ReadFrontBufferOff()
    capture.Update()
    # Edges are drawn with blends of the colours: few of them make a small file.
    return (pixels(capture.GetOutput()).astype(int) + 25) // 51 * 51


def pixels(image):
    width, height = image.GetDimensions()[:2]
    scalars = vtk_to_numpy(image.GetPointData().GetScalars())
    return scalars.reshape(height, width, -1)[:, :, :3].copy()


def write_png(path, image):
    """PNG with a palette: VTK's writer has none."""
    flat = image[::-1].reshape(-1, 3)
    palette, index = numpy.unique(flat, axis=0, return_inverse=True)
    assert len(palette) <= 256, f"{len(palette)} colours"
    rows = index.reshape(image.shape[:2]).astype(numpy.uint8)
    data = b"".join(b"\0" + row.tobytes() for row in rows)

    def chunk(name, content):
        body = name + content
        return struct.pack(">I", len(content)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", image.shape[1], image.shape[0], 8, 3, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                   + chunk(b"PLTE", palette.astype(numpy.uint8).tobytes())
                   + chunk(b"IDAT", zlib.compress(data, 9)) + chunk(b"IEND", b""))


def compare(image, name):
    """Fails when more than 0.5 % of the pixels have another colour."""
    path = os.path.join(FOLDER, name + ".png")
    if os.environ.get("FEATUREHEX_UPDATE_BASELINE"):
        write_png(path, image)
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    wanted = pixels(reader.GetOutput())
    assert wanted.shape == image.shape, f"{path} has another size: {wanted.shape}"
    other = (abs(wanted.astype(int) - image.astype(int)).max(axis=2) > 51).mean()
    if other > 0.005:
        seen = os.path.join(os.environ["FEATUREHEX_TEMPORARY_DIR"], name + ".png")
        write_png(seen, image)
        raise AssertionError(f"{seen} differs from {path} in {100 * other:.2f} % of the pixels")
    print(f"{name}: {100 * other:.3f} % of the pixels differ")
