# SPDX-License-Identifier: BSD-3-Clause
"""State files, Python states and traces make the same bits again, in processes of their own.

The others find the plugin through PV_PLUGIN_PATH in the build tree; one of them is pvbatch.
"""
import os

from paraview import simple, smstate, smtrace
from pipelines import SURFACE, bits, composite, fetch, run_script, stages

FIND = """
from paraview import simple
from pipelines import bits, fetch
mesher = simple.FindSource("Mesher")
last = simple.FindSource("Last")
assert (mesher.Tolerance, mesher.TargetEdgeLength) == (0.02, 0.3)
print("bits", bits(fetch(mesher)), bits(fetch(last)))
"""
folder = os.environ["FEATUREHEX_TEMPORARY_DIR"]
plugin = os.environ["FEATUREHEX_PLUGIN"]
pvpython = os.environ["FEATUREHEX_PVPYTHON"]
variables = {"PV_PLUGIN_PATH": os.path.dirname(plugin)}

simple.LoadPlugin(plugin)
trace = smtrace.start_trace()
surface = simple.OpenDataFile(SURFACE)
mesher = composite(surface)
chain = stages(surface)
trace_text = smtrace.stop_trace()
simple.RenameSource("Last", chain[-1])
wanted = f"bits {bits(fetch(mesher))} {bits(fetch(chain[-1]))}"

state_file = os.path.join(folder, "state.pvsm")
simple.SaveState(state_file)
python_state = smstate.get_state()

batch = os.path.join(os.path.dirname(pvpython), "pvbatch")
output = run_script(
    f"from paraview import simple\nsimple.LoadState({state_file!r})\n" + FIND,
    batch, "--force-offscreen-rendering", **variables)
assert wanted in output, f"state file in pvbatch: {output}"
output = run_script(python_state + FIND, **variables)
assert wanted in output, f"Python state: {output}"

assert "FeatureHexMesher(" in trace_text and "HexUntangle(" in trace_text, trace_text
last = trace_text.rstrip().splitlines()
name = [line.split(" = ")[0] for line in last if " = HexValidation(" in line][0]
output = run_script(trace_text + f"\nRenameSource('Last', {name})\n" + FIND, **variables)
assert wanted in output, f"trace: {output}"
