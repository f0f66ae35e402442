# SPDX-License-Identifier: BSD-3-Clause
"""State files, Python states and traces make the same bits again in pvbatch.

pvbatch finds the plugin through PV_PLUGIN_PATH in the build tree.
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
batch = os.path.join(os.path.dirname(os.environ["FEATUREHEX_PVPYTHON"]), "pvbatch")
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



def check(text, what):
    output = run_script(text, batch, "--force-offscreen-rendering", **variables)
    assert wanted in output, f"{what}: {output}"


check(f"from paraview import simple\nsimple.LoadState({state_file!r})\n" + FIND, "state file")
check(python_state + FIND, "Python state")
assert "FeatureHexMesher(" in trace_text and "HexUntangle(" in trace_text, trace_text
last = trace_text.rstrip().splitlines()
name = [line.split(" = ")[0] for line in last if " = HexValidation(" in line][0]
check(trace_text + f"\nRenameSource('Last', {name})\n" + FIND, "trace")
