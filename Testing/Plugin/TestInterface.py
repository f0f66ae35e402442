# SPDX-License-Identifier: BSD-3-Clause
"""ParaView as its user sees it: open a surface, Filters > FeatureHex, Apply, look; the state file
and the trace of that session give the same mesh in pvbatch; an error comes into Output Messages."""
import os
import sys

import interface
from interface import WINDOW, Interface
from pipelines import run_script

source = os.environ["FEATUREHEX_SOURCE_DIR"]
sys.path.insert(0, os.path.join(source, "Testing", "Python"))

BITS = f"""
import sys
sys.path.insert(0, {os.path.dirname(os.path.abspath(__file__))!r})
from paraview import simple
from pipelines import bits, fetch
mesher = simple.FindSource("FeatureHexMesher1")
line = "bits " + bits(fetch(mesher))
"""
# A square picture of the view, whatever fonts make of the size of the window.
PICTURE = """
view = simple.GetActiveView()
view.OrientationAxesVisibility = 0
display = simple.GetDisplayProperties()
display.Ambient, display.Diffuse = 1, 0
display.SetScalarBarVisibility(view, False)
simple.SaveScreenshot({!r}, view, ImageResolution=[300, 300])
"""
# A cube without its last face.
OPEN = """v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
"""


def shown(view):
    """Share of the pixels of a view that aren't background."""
    return (view != interface.BACKGROUND).any(axis=2).mean()


def mesh_a_surface():
    window = Interface("TestInterface")
    state, picture, digest, trace = (
        os.path.join(window.folder, name)
        for name in ("state.pvsm", "picture.png", "bits.txt", "trace.txt"))
    window.menu("menuTools", "actionToolsStartStopTrace")
    window.event("TraceOptionsDialog/widget/OKButton", "activate")
    window.open(os.path.join(source, "Data", "sphere.stl"))
    window.screenshot("surface")
    window.filter("FeatureHexMesher")
    window.screenshot("panel")
    window.apply()
    window.screenshot("mesh")
    window.python(f"from paraview import smtrace\n"
                  f"open({trace!r}, 'w').write(smtrace.get_current_trace_output())")
    window.menu("menu_File", "actionFileSaveServerState")
    window.event(WINDOW + "/FileSaveServerStateDialog", "filesSelected", state)
    window.python(PICTURE.format(picture))
    window.python(BITS + f"open({digest!r}, 'w').write(line)")
    print(window.run())

    # The triangles of the surface make way for the hexes and their edges.
    surface, panel, mesh = (
        interface.view_of(window.image(name)) for name in ("surface", "panel", "mesh"))
    assert 0.05 < shown(surface) < 0.5 and abs(shown(mesh) - shown(surface)) < 0.02
    assert (surface == panel).all(), "Apply was not waited for"
    changed = (surface != mesh).any(axis=2).mean() / shown(surface)
    assert changed > 0.3, changed
    interface.compare_png(picture, "interface")

    with open(digest, encoding="utf-8") as file:
        wanted = file.read()
    batch = (os.path.join(os.path.dirname(os.environ["FEATUREHEX_PVPYTHON"]), "pvbatch"),
             "--force-offscreen-rendering")
    variables = {"PV_PLUGIN_PATH": os.path.dirname(os.environ["FEATUREHEX_PLUGIN"])}
    output = run_script(f"from paraview import simple\nsimple.LoadState({state!r})\n{BITS}print(line)",
                        *batch, **variables)
    assert wanted in output, f"state file: {wanted} {output}"
    with open(trace, encoding="utf-8") as file:
        output = run_script(file.read() + BITS + "print(line)", *batch, **variables)
    assert wanted in output, f"trace: {wanted} {output}"


def refuse_an_open_surface():
    window = Interface("TestInterfaceError")
    path = os.path.join(window.folder, "open.obj")
    with open(path, "w", encoding="utf-8") as file:
        file.write(OPEN)
    window.open(path)
    window.filter("FeatureHexMesher")
    window.apply()
    window.screenshot("messages")
    # ParaView lives on: the right surface, and it works.
    window.open(os.path.join(source, "Data", "sphere.stl"))
    window.filter("FeatureHexMesher")
    window.apply()
    window.python("mesh = simple.GetActiveSource()\n"
                  "assert mesh.GetDataInformation().GetNumberOfCells() > 100")
    output = window.run(errors=1)
    assert "Open boundary" in output, output
    window.image("messages")


reason = interface.missing()
if reason:
    print("Not tested:", reason)
else:
    mesh_a_surface()
    refuse_an_open_surface()
