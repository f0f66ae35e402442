# SPDX-License-Identifier: BSD-3-Clause
"""The steps of Filters/Documentation/tutorial-paraview.md, done in ParaView's window; the pictures
of the page are what the window shows. With FEATUREHEX_UPDATE_PICTURES=1 in the environment they are
written anew."""
import os

import interface
import numpy
from interface import Interface

SOURCE = os.environ["FEATUREHEX_SOURCE_DIR"]
PICTURES = os.path.join(SOURCE, "Filters", "Documentation", "Pictures")
NAMES = ("surface", "panel", "mesh", "quality", "inside", "report")

# Each by hand: closing the chart; Filters > Alphabetical > Clip; a click on the eye; Split
# Horizontal and SpreadSheet View.
INSIDE = """
chart = simple.GetActiveView()
layout = simple.GetLayout(chart)
place = layout.GetViewLocation(chart)
simple.Delete(chart)
layout.Collapse(place)
view = simple.FindViewOrCreate("RenderView1", "RenderView")
simple.SetActiveView(view)
mesh = simple.FindSource("FeatureHexMesher1")
clip = simple.Clip(Input=mesh, ClipType="Plane", Crinkleclip=1)
simple.Hide(mesh, view)
simple.Hide3DWidgets(proxy=clip.ClipType)
display = simple.Show(clip, view)
display.SetRepresentationType("Surface With Edges")
display.SetScalarBarVisibility(view, True)
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
    window.filter("HexQuality")
    window.apply()
    window.screenshot("quality")
    for name, step in (("inside", INSIDE), ("report", REPORT)):
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
        window.document(name, "tutorial-" + name)
        wanted = interface.read_png(path)
        assert wanted.shape == image.shape, name
        # Lists, buttons and numbers are drawn with the fonts of the machine; the view is not.
        shape, colour = differences(interface.view_of(image), interface.view_of(wanted))
        print(f"{name}: shape {100 * shape:.1f} %, colours {100 * colour:.1f} %")
        assert shape < 0.03 and colour < 0.3, name


reason = interface.missing()
if reason:
    print("Not tested:", reason)
else:
    main()
