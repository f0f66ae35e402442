# SPDX-License-Identifier: BSD-3-Clause
"""The same file, byte for byte, with one thread, two, all, and on a second run; in units that are
powers of two the same mesh."""
import os

from commandline import DATA, SPHERE, content, folder, read_medit, succeed

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

    def mesh_of_blob(exponent):
        path, out = os.path.join(place, "blob.obj"), os.path.join(place, "blob.mesh")
        with open(os.path.join(DATA, "blob.obj"), encoding="ascii") as file:
            lines = file.read().splitlines()
        with open(path, "w", encoding="ascii") as file:
            for line in lines:
                words = line.split()
                if words and words[0] == "v":
                    words[1:] = [repr(float(word) * 2.0 ** exponent) for word in words[1:4]]
                file.write(" ".join(words) + "\n")
        succeed("mesh", path, "-o", out, "--tolerance", "0.02")
        points, hexes = read_medit(out)
        return [[x * 2.0 ** -exponent for x in point] for point in points], hexes

    original = mesh_of_blob(0)
    for exponent in (-40, 50):
        assert mesh_of_blob(exponent) == original, exponent
