# SPDX-License-Identifier: BSD-3-Clause
"""The same file, byte for byte, with one thread, two, all, and on a second run."""
import os

from commandline import DATA, SPHERE, content, folder, succeed

bodies = os.path.join(DATA, "bodies.obj")
with folder() as place:
    for surface, options in ((SPHERE, ["--edge-length", "0.15"]),
                             (bodies, ["--edge-length", "0.2", "--tolerance", "0.01"])):
        for extension in ("vtu", "vtk", "mesh"):
            expected = None
            for threads in (("1", "2", "0", "1") if extension == "vtu" else ("1", "2")):
                out = os.path.join(place, "out." + extension)
                succeed("mesh", surface, "-o", out, "--threads", threads, *options)
                expected = expected or content(out)
                assert content(out) == expected, (surface, extension, threads)
                os.remove(out)
