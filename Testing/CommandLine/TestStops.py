# SPDX-License-Identifier: BSD-3-Clause
"""Time limit, limit of cells, Ctrl-C and SIGTERM: own exit codes, soon, and no output."""
import os
import signal
import subprocess
import time

from commandline import (
    ABORTED, CELL_LIMIT, DATA, FEATUREHEX, SPHERE, TIME_LIMIT, Result, check_error, fail, folder,
    report)

LONG = ["--edge-length", "0.02"]


def start(place, *options):
    return subprocess.Popen(
        [FEATUREHEX, "mesh", os.path.join(DATA, "blob.obj"), "-o", os.path.join(place, "out.vtu"),
         *LONG, *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=place)


with folder() as place:
    out = os.path.join(place, "out.vtu")
    path = os.path.join(place, "report.json")
    began = time.monotonic()
    fail(TIME_LIMIT, "TimeLimit", "mesh", os.path.join(DATA, "blob.obj"), "-o", out, *LONG,
         "--time-limit", "1", "--report", path, words="time limit")
    assert time.monotonic() - began < 10
    assert report(path)["status"]["code"] == "TimeLimit"
    assert report(path)["phases"], "the phases until then"
    os.remove(path)

    fail(CELL_LIMIT, "CellLimit", "mesh", SPHERE, "-o", out, "--max-cells", "100",
         words="MaximumNumberOfCells")
    assert os.listdir(place) == []

    for number in (signal.SIGINT, signal.SIGTERM):
        process = start(place, "--report", path)
        time.sleep(1.5)
        assert process.poll() is None, "ended before it could be stopped"
        began = time.monotonic()
        process.send_signal(number)
        out_text, errors = process.communicate(timeout=60)
        assert time.monotonic() - began < 5
        check_error(Result(process.returncode, out_text.decode(), errors.decode()), ABORTED, "Aborted")
        assert report(path)["status"]["exit-code"] == ABORTED
        os.remove(path)
        assert os.listdir(place) == []
