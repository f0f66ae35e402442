# SPDX-License-Identifier: BSD-3-Clause
"""The steps of Filters/Documentation/tutorial-paraview.md, done in ParaView's window; the pictures
of the page are what the window shows. With FEATUREHEX_UPDATE=1 in the environment they are written
anew."""
import os
import struct
import zlib

import interface
import numpy
from interface import Interface
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SOURCE = os.environ["FEATUREHEX_SOURCE_DIR"]
PICTURES = os.path.join(SOURCE, "Filters", "Documentation", "Pictures")
NAMES = ("surface", "panel", "mesh", "quality", "inside", "report")

# Each by hand: Coloring; Filters > Alphabetical > Clip; a click on the eye; Split Horizontal and
# SpreadSheet View.
QUALITY = """
view = simple.GetActiveView()
mesh = simple.FindSource("FeatureHexMesher1")
display = simple.GetDisplayProperties(mesh, view)
simple.ColorBy(display, ("CELLS", "ScaledJacobian"))
display.SetScalarBarVisibility(view, True)
simple.Render()
"""
INSIDE = """
view = simple.GetActiveView()
mesh = simple.FindSource("FeatureHexMesher1")
clip = simple.Clip(Input=mesh, ClipType="Plane", Crinkleclip=1)
simple.Hide(mesh, view)
simple.Hide3DWidgets(proxy=clip.ClipType)
display = simple.Show(clip, view)
display.SetRepresentationType("Surface With Edges")
simple.ColorBy(display, ("CELLS", "ScaledJacobian"))
camera = view.GetActiveCamera()
camera.Azimuth(60)
camera.Elevation(20)
simple.Render()
"""
REPORT = """
mesh = simple.FindSource("FeatureHexMesher1")
view = simple.GetActiveView()
layout = simple.GetLayout()
sheet = simple.CreateView("SpreadSheetView")
simple.AssignViewToLayout(view=sheet, layout=layout)
simple.Show(simple.OutputPort(mesh, 3), sheet)
simple.SetActiveSource(simple.OutputPort(mesh, 3))
simple.Render(sheet)
"""


def few_colours(image):
    """The image in at most 256 colours, the background exactly: indices and palette."""
    background = (image == interface.BACKGROUND).all(axis=2, keepdims=True)
    rough = numpy.where(background, image, image // 8 * 8 + 4).astype(int)
    codes = rough[:, :, 0] << 16 | rough[:, :, 1] << 8 | rough[:, :, 2]
    found, inverse, counts = numpy.unique(codes, return_inverse=True, return_counts=True)
    kept = numpy.argsort(-counts, kind="stable")[:256]
    colours = numpy.stack([found >> 16, found >> 8 & 255, found & 255], axis=1)
    nearest = ((colours[:, None] - colours[kept][None]) ** 2).sum(axis=2).argmin(axis=1)
    indices = nearest[inverse].reshape(codes.shape)
    # A colour is the mean of what it stands for.
    palette = numpy.array([image[indices == i].mean(axis=0).round() for i in range(len(kept))])
    return indices.astype(numpy.uint8), palette.astype(numpy.uint8)


def write_png(path, image):
    def chunk(name, content):
        body = name + content
        return struct.pack(">I", len(content)) + body + struct.pack(">I", zlib.crc32(body))

    indices, palette = few_colours(image)
    rows = b"".join(b"\0" + row.tobytes() for row in indices)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n"
                   + chunk(b"IHDR", struct.pack(">IIBBBBB", *image.shape[1::-1], 8, 3, 0, 0, 0))
                   + chunk(b"PLTE", palette.tobytes())
                   + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def read_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    columns, rows, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(rows, columns, -1)[::-1, :, :3]


def view_of(image):
    """The part of a screenshot that is the view; few pixels elsewhere have its colour, too."""
    background = (image == interface.BACKGROUND).all(axis=2)
    rows = numpy.flatnonzero(background.sum(axis=1) > 100)
    columns = numpy.flatnonzero(background.sum(axis=0) > 100)
    return image[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1]


def differences(image, wanted):
    """Of two views: share of pixels that only one draws on, and of those drawn on how many have
    another colour as a whole. The edges of the mesh may lie elsewhere, fonts change sizes a bit."""
    rows = numpy.arange(wanted.shape[0]) * image.shape[0] // wanted.shape[0]
    columns = numpy.arange(wanted.shape[1]) * image.shape[1] // wanted.shape[1]
    drawn = [(view != interface.BACKGROUND).any(axis=2)
             for view in (image[rows][:, columns], wanted)]
    shares = [numpy.bincount((view[mask] // 64 @ (16, 4, 1)).astype(int), minlength=64) / mask.sum()
              for view, mask in zip((image[rows][:, columns], wanted), drawn)]
    return (drawn[0] != drawn[1]).mean(), abs(shares[0] - shares[1]).sum() / 2


def main():
    window = Interface("TestTutorial")
    window.open(os.path.join(SOURCE, "Data", "rotation", "bracket.obj"))
    window.screenshot("surface")
    window.filter("FeatureHexMesher")
    window.choose("FeatureMode", "Angle")
    window.screenshot("panel")
    window.apply()
    window.screenshot("mesh")
    for name, step in (("quality", QUALITY), ("inside", INSIDE), ("report", REPORT)):
        window.python(step)
        window.screenshot(name)
    saved = os.path.join(window.folder, "part.vtu")
    window.python(f"simple.SaveData({saved!r}, simple.FindSource('FeatureHexMesher1'), "
                  "DataMode='Binary')")
    window.run()

    assert os.path.getsize(saved) > 1000
    for name in NAMES:
        image = window.image(name)
        path = os.path.join(PICTURES, f"tutorial-{name}.png")
        if os.environ.get("FEATUREHEX_UPDATE"):
            write_png(path, image)
        wanted = read_png(path)
        assert wanted.shape == image.shape, name
        # Lists, buttons and numbers are drawn with the fonts of the machine; the view is not.
        shape, colour = differences(view_of(image), view_of(wanted))
        print(f"{name}: shape {100 * shape:.1f} %, colours {100 * colour:.1f} %")
        assert shape < 0.03 and colour < 0.3, name


reason = interface.missing()
if reason:
    print("Not tested:", reason)
else:
    main()
