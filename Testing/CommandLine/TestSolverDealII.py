# SPDX-License-Identifier: BSD-3-Clause
"""deal.II reads our .ucd files and solves Poisson's equation on them: second-order convergence.

Three resolutions of a bracket with sharp features; boundary ids are patch + 1.
Needs deal.II (Debian: libdeal.ii-dev, large) and CMake; the program is in Testing/Solvers.
"""
import math
import os
import shutil
import subprocess
import sys

from commandline import DATA, SOURCE, folder, succeed

TOLERANCE = 0.01  # of the diagonal
DIAGONAL = 5.767  # of the bracket

if not shutil.which("cmake"):
    print("Skipped: cmake isn't installed.")
    sys.exit(77)


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=500,
                          check=False)
    output = done.stdout.decode(errors="replace")
    assert done.returncode == 0, output[-3000:]
    return output


def build(place):
    """The program, or None without deal.II."""
    binary = os.path.join(place, "build")
    run("cmake", "-S", os.path.join(SOURCE, "Testing", "Solvers"), "-B", binary,
        "-DCMAKE_BUILD_TYPE=Release")
    if not os.path.exists(os.path.join(binary, "Makefile")):
        return None
    with open(os.path.join(binary, "Makefile"), encoding="utf-8") as file:
        if "Poisson" not in file.read():
            return None
    run("cmake", "--build", binary)
    return os.path.join(binary, "Poisson")


def solve(program, place, length):
    """(cells, errors by norm, {boundary id: (area, x, y, z)})"""
    bracket = os.path.join(DATA, "rotation", "bracket")
    mesh = os.path.join(place, "mesh.ucd")
    succeed("mesh", bracket + ".obj", "-o", mesh, "--features", bracket + ".fgraph",
            "--edge-length", length, "--tolerance", TOLERANCE)
    cells, errors, sides = 0, {}, {}
    for line in run(program, mesh).splitlines():
        words = line.split()
        if words[0] == "boundary":
            sides[int(words[1])] = tuple(map(float, words[2:]))
        elif words[0] == "cells":
            cells = int(words[1])
        elif words[0] in ("L2", "H1"):
            errors[words[0]] = float(words[1])
    return cells, errors, sides


with folder() as place:
    program = build(place)
    if not program:
        print("Skipped: deal.II isn't installed (apt-get install libdeal.ii-dev).")
        sys.exit(77)
    results = [solve(program, place, length) for length in (0.3, 0.15, 0.1)]
    for cells, errors, sides in results:
        print(cells, errors)
        assert sorted(sides) == list(range(1, 13)), sorted(sides)
    # Each mesh has the same patches, within the tolerance.
    for _, _, sides in results[1:]:
        for side, values in sides.items():
            for a, b in zip(values, results[0][2][side]):
                assert abs(a - b) < TOLERANCE * DIAGONAL, (side, values, results[0][2][side])
    for norm, order in (("L2", 2.0), ("H1", 1.0)):
        (first, coarse, _), _, (last, fine, _) = results
        rate = math.log(coarse[norm] / fine[norm]) / math.log((last / first) ** (1.0 / 3.0))
        print("%s: order %.2f" % (norm, rate))
        assert rate > order - 0.3, (norm, rate)
