# SPDX-License-Identifier: BSD-3-Clause
"""What is seen of the quality of a mesh in ParaView's window: colours, menu with icons, the chart of
Hex Quality by Apply, and the macros, imported as a user does it."""
import os

import interface
from interface import Interface

source = os.environ["FEATUREHEX_SOURCE_DIR"]


def look_at_quality():
    window = Interface("TestInterfaceQuality")
    window.open(os.path.join(source, "Data", "rotation", "bracket.obj"))
    window.filter("FeatureHexMesher")
    window.choose("FeatureMode", "Angle")
    window.apply()
    window.screenshot("mesh")
    window.python("""
mesher = simple.GetActiveSource()
assert 100 < mesher.NumberOfHexes == mesher.GetDataInformation().GetNumberOfCells()
assert 0.3 < mesher.SmallestScaledJacobian < mesher.MeanScaledJacobian < 1
assert 0 < mesher.HausdorffBound <= mesher.Tolerance
display = simple.GetDisplayProperties()
assert display.ColorArrayName[:] == ["CELLS", "ScaledJacobian"], display.ColorArrayName[:]
points = display.LookupTable.RGBPoints
assert (points[0], points[-4]) == (0, 1), points[:]
assert display.Representation == "Surface With Edges"
""")
    window.menu("menuFilters", "FeatureHex")
    window.screenshot("menu")
    # The chart is there by Apply.
    window.filter("HexQuality")
    window.apply()
    window.screenshot("chart")
    window.python("""
view = simple.GetActiveView()
assert view.GetXMLName() == "XYBarChartView"
chart = simple.GetDisplayProperties()
assert chart.XArrayName == "bin_extents" and chart.SeriesVisibility[:] == ["Hexes"], (
    chart.XArrayName, chart.SeriesVisibility[:])
# The surface is that of the mesh.
quality = simple.GetActiveSource()
assert quality.Surface is not None and 0 < quality.LargestDeviation <= 1, quality.LargestDeviation
""")
    for macro, picture in (("HexCutView", "cut"), ("HexQualityView", "quality"),
                           ("HexFeatureView", "features")):
        window.import_macro(macro)
        window.macro(macro)
        window.screenshot(picture)
    window.python("""
names = [name for name, _ in simple.GetSources()]
assert "HexCut" in names and "HexQuality" in names, names
points = simple.GetColorTransferFunction("ScaledJacobian").RGBPoints
assert (points[0], points[-4]) == (0, 1), points[:]
""")
    window.run()
    images = {name: window.image(name)
              for name in ("mesh", "menu", "chart", "cut", "quality", "features")}
    for name in ("menu", "chart", "cut", "quality", "features"):
        window.document(name, "paraview-" + name)
    # Good hexes are blue and green, those between yellow; a chart has red bars on white.
    view = interface.view_of(images["mesh"]).astype(int)
    red, green, blue = (view[:, :, i] for i in range(3))
    assert ((blue > red + 30) & (view != interface.BACKGROUND).any(axis=2)).mean() > 0.05
    assert ((red > blue + 40) & (green > blue + 40)).mean() > 0.003
    for name in ("chart", "quality"):
        bars = (abs(images[name].astype(int) - (228, 26, 28)) < 9).all(axis=2).mean()
        assert bars > 0.01, (name, bars)
    for name in ("cut", "quality", "features"):
        assert (images[name] == 255).all(axis=2).mean() > 0.2, name


reason = interface.missing()
if reason:
    print("Not tested:", reason)
else:
    look_at_quality()
