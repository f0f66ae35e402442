# SPDX-License-Identifier: BSD-3-Clause
"""CalculiX solves a loaded bracket from our .inp: one side fixed, pressure on another.

The reaction force is the load, the loaded end moves along it, and the surface is as large as its
faces. Needs ccx (Debian: calculix-ccx).
"""
import os
import re
import shutil
import subprocess
import sys

from commandline import DATA, folder, succeed

CCX = shutil.which("ccx")
if not CCX:
    print("Skipped: ccx isn't installed (apt-get install calculix-ccx).")
    sys.exit(77)

PRESSURE = 2.5
FACES = ((1, 2, 3, 4), (5, 8, 7, 6), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 8, 4), (4, 8, 5, 1))
EDGES = ((1, 2), (2, 3), (3, 4), (1, 4), (5, 6), (6, 7), (7, 8), (5, 8),
         (1, 5), (2, 6), (3, 7), (4, 8))
DECK = """*INCLUDE, INPUT=mesh.inp
*MATERIAL, NAME=steel
*ELASTIC
210000., .3
*SOLID SECTION, ELSET=body_1, MATERIAL=steel
*BOUNDARY
{fixed}, 1, 3
*STEP
*STATIC
*DLOAD
{loads}
*NODE PRINT, NSET={fixed}, TOTALS=ONLY
RF
*NODE PRINT, NSET={loaded}
U
*SECTION PRINT, SURFACE={fixed}, NAME=held
SOF
*END STEP
"""


def read_inp(path):
    """(nodes, elements, surfaces: list of element and face)"""
    nodes, elements, sets, surfaces = {}, {}, {}, {}
    with open(path, encoding="ascii") as file:
        text = file.read().replace(",\n", ", ")
    keyword, name = "", ""
    for line in text.splitlines():
        words = [word.strip() for word in line.split(",")]
        if line.startswith("*"):
            keyword = words[0]
            name = words[1].split("=")[1] if len(words) > 1 else ""
        elif keyword == "*NODE":
            nodes[int(words[0])] = tuple(map(float, words[1:]))
        elif keyword == "*ELEMENT":
            elements[int(words[0])] = tuple(map(int, words[1:]))
        elif keyword == "*ELSET":
            sets.setdefault(name, []).extend(map(int, words))
        elif keyword == "*SURFACE":
            surfaces.setdefault(name, []).extend(
                (element, int(words[1][1])) for element in sets[words[0]])
    return nodes, elements, surfaces


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3] for k in range(3)]


def area_vector(nodes, element, face):
    """Half the integral of x cross dx round the face; edges are straight or parabolas."""
    area = [0.0] * 3
    corners = FACES[face - 1]
    for i, j in zip(corners, corners[1:] + corners[:1]):
        a, b = nodes[element[i - 1]], nodes[element[j - 1]]
        parts = [(0.5, a, b)]
        if len(element) == 20:
            middle = nodes[element[8 + EDGES.index((min(i, j), max(i, j)))]]
            parts = [(2 / 3, a, middle), (2 / 3, middle, b), (-1 / 6, a, b)]
        for factor, p, q in parts:
            area = [x + factor * y for x, y in zip(area, cross(p, q))]
    return area


def patches(nodes, elements, surfaces):
    """name: (area vector, outward; mean of the corners)"""
    result = {}
    for name, faces in surfaces.items():
        area, mean, count = [0.0] * 3, [0.0] * 3, 0
        for element, face in faces:
            corners = [nodes[elements[element][k - 1]] for k in FACES[face - 1]]
            # Seen from outside these faces go round clockwise.
            area = minus(area, area_vector(nodes, elements[element], face))
            for corner in corners:
                mean = [x + y for x, y in zip(mean, corner)]
            count += 4
        result[name] = area, [x / count for x in mean]
    return result


def solve(place, deck):
    with open(os.path.join(place, "deck.inp"), "w", encoding="ascii") as file:
        file.write(deck)
    done = subprocess.run([CCX, "-i", "deck"], cwd=place, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=280, check=False)
    output = done.stdout.decode(errors="replace")
    assert done.returncode == 0 and "*ERROR" not in output, output[-3000:]
    with open(os.path.join(place, "deck.dat"), encoding="ascii") as file:
        data = file.read()
    force = re.search(r"total force .*\n\s*\n((?:\s+\S+){3})", data)
    moved = re.search(r"displacements .*\n\s*\n((?:.*\S.*\n)+)", data)
    rows = [list(map(float, line.split()[1:])) for line in moved.group(1).splitlines()]
    area = re.search(r"area, +normal force.*\n\s*\n\s*(\S+)", data)
    return ([float(word) for word in force.group(1).split()],
            [sum(column) / len(rows) for column in zip(*rows)], float(area.group(1)))


def check(place, *options):
    bracket = os.path.join(DATA, "rotation", "bracket")
    succeed("mesh", bracket + ".obj", "-o", os.path.join(place, "mesh.inp"),
            "--features", bracket + ".fgraph", "--edge-length", "0.3", *options)
    nodes, elements, surfaces = read_inp(os.path.join(place, "mesh.inp"))
    sides = patches(nodes, elements, surfaces)
    assert len(sides) == 12, sorted(sides)

    # The end of the upright arm is held, the far end of the other pressed.
    fixed = max(sides, key=lambda name: sides[name][1][1])
    loaded = max(sides, key=lambda name: sum(
        x * x for x in minus(sides[name][1], sides[fixed][1])))
    load = [-PRESSURE * x for x in sides[loaded][0]]
    # CalculiX ignores *DSLOAD with P: the sets of elements by face are for *DLOAD.
    loads = "\n".join("%s_S%d, P%d, %g" % (loaded, face, face, PRESSURE)
                      for face in sorted({face for _, face in surfaces[loaded]}))
    reaction, moved, area = solve(place, DECK.format(fixed=fixed, loaded=loaded, loads=loads))
    size = sum(x * x for x in load) ** 0.5
    missing = max(abs(x + y) for x, y in zip(reaction, load))
    work = sum(x * y for x, y in zip(moved, load))
    print("%s: %d elements, load %s on %s, reaction %s on %s, mean displacement %s" % (
        options, len(elements), load, loaded, reaction, fixed, moved))
    assert size > 0.5 and missing < 1e-5 * size, (load, reaction)
    assert work > 0.0, (load, moved)
    # The patch is plane.
    assert abs(area - sum(x * x for x in sides[fixed][0]) ** 0.5) < 1e-4 * area, area
    return work


with folder() as place:
    linear = check(place)
    quadratic = check(place, "--nodes-per-hex", "20")
    # Quadratic hexes bend more easily; the truth is close above.
    assert linear < quadratic < 1.5 * linear, (linear, quadratic)
