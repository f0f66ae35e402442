# SPDX-License-Identifier: BSD-3-Clause
"""Features are edited in ParaView's window as features.md says: detect, look, select, remove, mesh.
"""
import os

import interface
from interface import Interface

source = os.environ["FEATUREHEX_SOURCE_DIR"]

# Each by hand: the eye of Surface, Coloring and Line Width of Features.
LOOK = """
found = simple.GetActiveSource()
view = simple.GetActiveView()
surface = simple.GetDisplayProperties(simple.OutputPort(found, 0), view)
surface.SetScalarColoring(None, 0)
lines = simple.GetDisplayProperties(simple.OutputPort(found, 1), view)
lines.SetScalarColoring("CurveId", 1)
lines.RescaleTransferFunctionToDataRange()
lines.LineWidth = 5
lines.PointSize = 10
lines.SetScalarBarVisibility(view, True)
camera = view.GetActiveCamera()
camera.Azimuth(-35)
camera.Elevation(20)
view.ResetCamera(False)
simple.Render()
"""
# By hand: View > Find Data, or a click on the curve with "Select Cells On".
SELECT = """
found = simple.FindSource("SurfaceFeature1")
lines = simple.OutputPort(found, 1)
simple.QuerySelect(QueryString="(CurveId == 29)", FieldType="CELL", Source=lines)
simple.Render()
"""
WIDE = """
assert simple.GetActiveSource().GetXMLName() == "ExtractSelection"
assert simple.GetActiveSource().GetDataInformation().GetNumberOfCells() == 1
display = simple.GetDisplayProperties()
display.SetScalarColoring(None, 0)
display.LineWidth = 8
display.DiffuseColor = display.AmbientColor = [1, 0, 1]
simple.Render()
"""
# By hand: Change Input of the new filter, and the eye of the old one.
REMOVE = """
view = simple.GetActiveView()
edited = simple.GetActiveSource()
assert edited.GetXMLName() == "SurfaceFeature" and edited is not simple.FindSource("SurfaceFeature1")
edited.Annotation = simple.FindSource("ExtractSelection1")
edited.AnnotationMode = "Remove"
"""
CHECK = """
from paraview import servermanager
edited = simple.GetActiveSource()
counts = []
for name in ("SurfaceFeature1", "SurfaceFeature2"):
    data = servermanager.Fetch(simple.FindSource(name), idx=0).GetFieldData()
    counts.append(int(data.GetArray("NumberOfCurves").GetTuple1(0)))
assert counts[1] == counts[0] - 1, counts
simple.ClearSelection(simple.OutputPort(simple.FindSource("SurfaceFeature1"), 1))
view = simple.GetActiveView()
simple.HideAll(view)
for port in (0, 1):
    display = simple.Show(simple.OutputPort(edited, port), view)
    display.SetScalarColoring(None if port == 0 else "CurveId", 1 if port else 0)
display.LineWidth = 5
display.PointSize = 10
simple.Render()
"""
# The mesher has taken both outputs of the edited one.
MESH = """
edited = simple.FindSource("SurfaceFeature2")
mesher = simple.GetActiveSource()
assert mesher.GetXMLName() == "FeatureHexMesher"
assert mesher.Features.SMProxy is edited.SMProxy and mesher.Features.Port == 1
"""
DONE = """
from paraview import servermanager
mesher = simple.GetActiveSource()
table = servermanager.Fetch(mesher, idx=3)
wanted = servermanager.Fetch(simple.FindSource("SurfaceFeature2"), idx=0).GetFieldData()
figure = lambda name: int(table.GetColumnByName(name).GetTuple1(0))
assert figure("Valid") == 1
assert figure("CurvesFound") == int(wanted.GetArray("NumberOfCurves").GetTuple1(0))
"""


def main():
    window = Interface("TestInterfaceFeatures")
    window.open(os.path.join(source, "Data", "rotation", "bracket.obj"))
    window.filter("SurfaceFeature")
    window.apply()
    window.python(LOOK)
    window.select(0, 0, 1)  # the output Features: the second one of the filter
    window.screenshot("found")
    window.python(SELECT)
    window.menu("menuFilters/Alphabetical", "ExtractSelection")
    window.apply()
    window.python(WIDE)
    window.screenshot("selected")
    window.python("simple.SetActiveSource(simple.FindSource('bracket.obj'))")
    window.filter("SurfaceFeature")
    window.python(REMOVE)
    window.apply()
    window.python(CHECK)
    window.screenshot("removed")
    window.filter("FeatureHexMesher")
    window.python(MESH)
    window.apply()
    window.python(DONE)
    window.screenshot("meshed")
    print(window.run())
    for name in ("found", "selected", "removed", "meshed"):
        image = window.image(name)
        window.document(name, "features-" + name)
        assert (interface.view_of(image) != interface.BACKGROUND).any(axis=2).mean() > 0.05, name


reason = interface.missing()
if reason:
    print("Not tested:", reason)
else:
    main()
