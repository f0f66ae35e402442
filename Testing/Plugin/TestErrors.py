# SPDX-License-Identifier: BSD-3-Clause
"""What can't be meshed gives one error in ParaView, empty outputs, and no crash."""
import os

from paraview import simple  # noqa: F401  starts the session before the other process does
from pipelines import run_script

SCRIPT = """
from paraview import simple
from pipelines import SURFACE, fetch, stages
surface = simple.OpenDataFile(SURFACE)
opened = simple.Clip(Input=surface, ClipType="Plane")
opened.ClipType.Origin = [0.1, 0, 0]
half = simple.ExtractSurface(Input=opened)
assert fetch(half).GetNumberOfCells() > 100
mesher = simple.FeatureHexMesher(Input=half)
sizes = [fetch(mesher).GetNumberOfCells()]
# The stages after the one that fails are silent.
last = stages(half)[-1]
sizes.append(fetch(last).GetNumberOfCells())
print("sizes", sizes)
# Another input, and it works.
mesher.Input = surface
mesher.TargetEdgeLength = 0.3
mesher.Tolerance = 0.02
assert fetch(mesher).GetNumberOfCells() > 100
print("works again")
"""

output = run_script(SCRIPT, PV_PLUGIN_PATH=os.path.dirname(os.environ["FEATUREHEX_PLUGIN"]))
assert "sizes [0, 0]" in output and "works again" in output, output
messages = output.split("ERR|")[1:]
# One of the composite, one of the first stage.
assert len(messages) == 2, output
for message in messages:
    assert "Open boundary" in message and "vtkPVSessionCore" not in message, message
print(len(messages), "errors, as there must be")
