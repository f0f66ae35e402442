# SPDX-License-Identifier: BSD-3-Clause
"""A batch under mpirun pvbatch --sym: the ranks share the models, each is meshed once, with
the results of a batch without MPI."""
import os
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.environ["FEATUREHEX_SOURCE_DIR"], "Testing", "Python"))
from batches import FAST, NAMES, Page, made, make_models, run, table  # noqa: E402
from featurehex import programs  # noqa: E402


def mpi(ranks, *arguments):
    batch = os.path.join(os.path.dirname(os.environ["FEATUREHEX_PVPYTHON"]), "pvbatch")
    done = subprocess.run(
        [mpirun, "--oversubscribe", "-np", str(ranks), batch, "--sym", "-m", "featurehex", "batch",
         *arguments],
        env={**programs.environment(), "OMPI_ALLOW_RUN_AS_ROOT": "1",
             "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"},
        text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=250, check=False)
    return done.returncode, done.stdout


mpirun = shutil.which("mpirun")
if mpirun:
    with tempfile.TemporaryDirectory() as folder:
        models = os.path.join(folder, "models")
        make_models(models)
        parallel, alone = (os.path.join(folder, name) for name in ("parallel", "alone"))
        code, output = mpi(2, models, parallel, *FAST)
        print(output)
        assert code == 1 and made(output) == NAMES, code
        assert "3 of 6" in Page(os.path.join(parallel, "index.html")).words
        # Without MPI the same, one after another.
        assert made(run(1, models, alone, "--no-pictures", *FAST)) == NAMES
        for name in NAMES:
            one, other = (table(place)[name] for place in (parallel, alone))
            for column in ("status", "hexes", "msj", "asj", "hausdorff_percent", "error"):
                assert one[column] == other[column], (name, column)
        # Nothing is left, with or without MPI.
        assert made(run(1, models, parallel, "--no-pictures", *FAST)) == []
        shutil.rmtree(os.path.join(models, "sub"))
        for name in ("broken.stl", "torus.off"):
            os.remove(os.path.join(models, name))
        code, output = mpi(3, models, os.path.join(folder, "good"), "--no-pictures", *FAST)
        assert code == 0 and made(output) == ["ball", "torus"], (code, output)
else:
    print("Not tested: there is no mpirun.")
