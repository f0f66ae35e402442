# SPDX-License-Identifier: BSD-3-Clause
"""The programs that the package starts: featurehex, and a Python that draws."""

import os
import shutil
import sys
from typing import Dict, List

import vtkmodules

__all__ = ["drawing_python", "environment", "featurehex"]

PACKAGE = os.path.dirname(os.path.abspath(__file__))


def featurehex() -> str:
    """Path of the command line program of this installation. Raises FileNotFoundError."""
    named = os.environ.get("FEATUREHEX_EXECUTABLE")
    # The package is PREFIX/lib/python.../...-packages/featurehex.
    beside = os.path.normpath(os.path.join(PACKAGE, *4 * [".."], "bin", "featurehex"))
    for path in (named, beside, shutil.which("featurehex")):
        if path and os.access(path, os.X_OK):
            return path
    raise FileNotFoundError(
        "The program featurehex is neither %s nor in PATH. Build and install it "
        "(FEATUREHEX_WITH_COMMAND_LINE=ON), or set FEATUREHEX_EXECUTABLE." % beside)


def environment() -> Dict[str, str]:
    """For processes started here. What MPI left would make them take part in it."""
    result = {name: value for name, value in os.environ.items()
              if not name.startswith(("OMPI_", "PMIX_", "PRTE_", "ORTE_", "PMI_"))}
    paths = [os.path.dirname(PACKAGE), os.path.dirname(os.path.dirname(vtkmodules.__file__))]
    paths += [path for path in result.get("PYTHONPATH", "").split(":") if path]
    result["PYTHONPATH"] = ":".join(dict.fromkeys(paths))
    return result


def drawing_python() -> List[str]:
    """The command of a Python with this one's VTK, on a display that exists or is made for it."""
    program = os.path.realpath("/proc/self/exe")
    if os.path.basename(program).startswith("pv"):
        # sys.executable of pvpython and pvbatch can't be started.
        command = [os.path.join(os.path.dirname(program), "pvpython")]
    else:
        command = [sys.executable]
    if shutil.which("xvfb-run"):
        # Without -noreset the server goes away with its first client.
        return ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset", *command]
    return command
