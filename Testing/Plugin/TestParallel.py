# SPDX-License-Identifier: BSD-3-Clause
"""With two processes, the first has the whole mesh and the second an empty one."""
import os
import shutil

from paraview import simple
from pipelines import SURFACE, bits, composite, fetch, run_script, stages

SCRIPT = """
import featurehex
from paraview import simple
from paraview.modules.vtkRemotingCore import vtkProcessModule
from pipelines import SURFACE, bits, composite, stages
mesher = composite(simple.OpenDataFile(SURFACE))
last = stages(mesher.Input)[-1]
rank = vtkProcessModule.GetProcessModule().GetPartitionId()
assert vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions() == 2
for proxy in (mesher, last):
    proxy.UpdatePipeline()
    mesh = proxy.GetClientSideObject().GetOutputDataObject(0)
    if rank == 0:
        print("bits", bits(mesh))
    else:
        assert mesh.GetNumberOfCells() == 0, mesh.GetNumberOfCells()
        print("second process is empty")
"""

plugin = os.environ["FEATUREHEX_PLUGIN"]
mpirun = shutil.which("mpirun")
batch = os.path.join(os.path.dirname(os.environ["FEATUREHEX_PVPYTHON"]), "pvbatch")
if mpirun:
    simple.LoadPlugin(plugin)
    # Left by MPI in this process, they keep another mpirun from starting.
    for name in [n for n in os.environ if n.startswith(("OMPI_", "PMIX_", "PRTE_", "ORTE_"))]:
        del os.environ[name]
    surface = simple.OpenDataFile(SURFACE)
    wanted = [bits(fetch(composite(surface))), bits(fetch(stages(surface)[-1]))]
    output = run_script(
        SCRIPT, mpirun, "--oversubscribe", "-np", "2", batch, "--force-offscreen-rendering", "--sym",
        PV_PLUGIN_PATH=os.path.dirname(plugin), OMPI_ALLOW_RUN_AS_ROOT="1",
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    assert [line[5:] for line in output.splitlines() if line.startswith("bits ")] == wanted, output
    assert output.count("second process is empty") == 2, output
    print(output)
else:
    print("Not tested: there is no mpirun.")
