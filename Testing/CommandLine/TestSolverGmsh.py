# SPDX-License-Identifier: BSD-3-Clause
"""Gmsh opens our .msh files, finds the groups by name with their elements, and writes them again.

A process of its own, never linked. Needs gmsh (Debian: gmsh).
"""
import os
import shutil
import subprocess
import sys

from commandline import DATA, folder, succeed

GMSH = shutil.which("gmsh")
if not GMSH:
    print("Skipped: gmsh isn't installed (apt-get install gmsh).")
    sys.exit(77)

# Names of Gmsh's types of elements by dimension and nodes.
LENGTHS = {1: 2, 3: 4, 5: 8, 8: 3, 10: 9, 12: 27, 15: 1, 16: 8, 17: 20}


def gmsh(*arguments, cwd):
    done = subprocess.run([GMSH, *arguments], cwd=cwd, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=280, check=False)
    output = done.stdout.decode(errors="replace")
    assert done.returncode == 0 and "Error" not in output and "Warning" not in output, output
    return output


def read_msh2(path):
    """names {(dimension, tag): name}, elements {(type, physical tag): count}, nodes"""
    with open(path, encoding="ascii") as file:
        lines = file.read().splitlines()
    at = lines.index("$PhysicalNames")
    names = {}
    for line in lines[at + 2:at + 2 + int(lines[at + 1])]:
        dimension, tag, name = line.split()
        names[int(dimension), int(tag)] = name.strip('"')
    nodes = int(lines[lines.index("$Nodes") + 1])
    at = lines.index("$Elements")
    elements = {}
    for line in lines[at + 2:at + 2 + int(lines[at + 1])]:
        words = list(map(int, line.split()))
        assert len(words) == 3 + words[2] + LENGTHS[words[1]], line
        key = words[1], words[3]
        elements[key] = elements.get(key, 0) + 1
    return names, elements, nodes


def check(place, *options):
    bracket = os.path.join(DATA, "rotation", "bracket")
    succeed("mesh", bracket + ".obj", "-o", os.path.join(place, "v2.msh2"),
            "--features", bracket + ".fgraph", "--edge-length", "0.3", *options)
    succeed("mesh", bracket + ".obj", "-o", os.path.join(place, "v4.msh"),
            "--features", bracket + ".fgraph", "--edge-length", "0.3", *options)
    ours = read_msh2(os.path.join(place, "v2.msh2"))
    names = sorted(ours[0].values())
    wanted = (["body_1"] + ["corner_%d" % i for i in range(20)] +
              ["curve_%d" % i for i in range(30)] + ["patch_%d" % i for i in range(12)])
    assert names == sorted(wanted), names
    for name in ("v2.msh2", "v4.msh"):
        gmsh("-0", name, "-format", "msh2", "-o", "again.msh", cwd=place)
        again = read_msh2(os.path.join(place, "again.msh"))
        assert again == ours, (name, again, ours)
    print(options, ours[2], "nodes", len(names), "groups", sum(ours[1].values()), "elements")


with folder() as place:
    for number in ("8", "20", "27"):
        check(place, "--nodes-per-hex", number)
