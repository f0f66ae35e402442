# SPDX-License-Identifier: BSD-3-Clause
"""All-hex meshes from closed surfaces.

    python -m featurehex mesh IN -o OUT [options]      make a hex mesh from a closed surface
    python -m featurehex check MESH [options]          measure every promise about a hex mesh
    python -m featurehex batch FOLDER OUT [options]    mesh all surfaces of a folder

COMMAND --help shows the options of a command. mesh and check are the program featurehex.
"""

import os
import sys
from typing import List

import featurehex

from . import batch, programs

_BAD_ARGUMENTS = 2


def main(arguments: List[str]) -> int:
    """The exit code; mesh and check don't come back."""
    if not arguments or arguments[0] in ("-h", "--help"):
        print(__doc__.strip())
        return 0 if arguments else _BAD_ARGUMENTS
    if arguments == ["--version"]:
        print("featurehex " + featurehex.__version__)
        return 0
    if arguments[0] == "batch":
        return batch.main(arguments[1:])
    if arguments[0] in ("mesh", "check"):
        program = programs.featurehex()
        os.execve(program, [program, *arguments], programs.environment())
    print("featurehex: InvalidOption: \"%s\" is none of mesh, check, batch." % arguments[0],
          file=sys.stderr)
    return _BAD_ARGUMENTS


if __name__ == "__main__":
    try:
        CODE = main(sys.argv[1:])
    except FileNotFoundError as error:
        print("featurehex: %s" % error, file=sys.stderr)
        CODE = _BAD_ARGUMENTS
    if CODE:
        sys.exit(CODE)
