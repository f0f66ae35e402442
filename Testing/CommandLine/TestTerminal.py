# SPDX-License-Identifier: BSD-3-Clause
"""On a terminal a bar shows the phases and goes away in the end."""
import os
import pty
import subprocess

from commandline import FAST, FEATUREHEX, SPHERE, folder


def on_terminal(terminal_type, *arguments):
    """(exit code, what the terminal got)"""
    ours, theirs = pty.openpty()
    process = subprocess.Popen([FEATUREHEX, *arguments], stdout=subprocess.DEVNULL, stderr=theirs,
                               env={**os.environ, "TERM": terminal_type})
    os.close(theirs)
    shown = b""
    while True:
        try:
            piece = os.read(ours, 4096)
        except OSError:  # the other side is closed
            break
        if not piece:
            break
        shown += piece
    os.close(ours)
    return process.wait(), shown.decode()


with folder() as place:
    mesh = ["mesh", SPHERE, "-o", os.path.join(place, "out.vtu"), *FAST]
    code, shown = on_terminal("xterm", *mesh)
    assert code == 0, shown
    assert "[" in shown and "%" in shown and "fitting" in shown and "validating" in shown, shown
    # Nothing is left on the line.
    assert shown.endswith("\r\033[K"), repr(shown[-80:])
    for line in shown.split("\r"):
        assert len(line) <= 80 + len("\033[K"), line

    assert on_terminal("dumb", *mesh) == (0, "")
