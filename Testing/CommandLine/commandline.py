# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the command line share."""
import json
import os
import re
import subprocess
import tempfile

FEATUREHEX = os.environ["FEATUREHEX_EXECUTABLE"]
SOURCE = os.environ["FEATUREHEX_SOURCE_DIR"]
SHARED = os.environ.get(
    "FEATUREHEX_SHARED", os.path.join(os.path.dirname(os.path.abspath(SOURCE)), "shared"))
DATA = os.path.join(SOURCE, "Data")
SPHERE = os.path.join(DATA, "sphere.stl")
# Coarse, so that a test takes a second.
FAST = ["--edge-length", "0.25", "--tolerance", "0.02"]

SUCCESS, FAILED, BAD_ARGUMENTS, UNREADABLE, REJECTED = 0, 1, 2, 3, 4
TIME_LIMIT, CELL_LIMIT, ABORTED, UNWRITABLE = 5, 6, 7, 8


class Result:
    def __init__(self, code, out, errors):
        self.code = code
        self.out = out
        self.errors = errors

    def __repr__(self):
        return "exit code %s\n%s%s" % (self.code, self.out, self.errors)


def run(*arguments, timeout=280, cwd=None):
    done = subprocess.run([FEATUREHEX, *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, timeout=timeout, cwd=cwd)
    return Result(done.returncode, done.stdout.decode(), done.stderr.decode())


def succeed(*arguments, **options):
    result = run(*arguments, **options)
    assert result.code == SUCCESS, (arguments, result)
    return result


def fail(code, name, *arguments, words="", **options):
    """It ends with this code and exactly one line, which starts with the name and has the words."""
    result = run(*arguments, **options)
    check_error(result, code, name, words)
    return result


def check_error(result, code, name, words=""):
    assert result.code == code, result
    lines = result.errors.splitlines()
    assert len(lines) == 1, result
    assert re.match(r"featurehex: (%s): \S" % name, lines[0]), result
    for word in words.split():
        assert word.lower() in lines[0].lower(), (word, result)


def report(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def content(path):
    with open(path, "rb") as file:
        return file.read()


def folder():
    return tempfile.TemporaryDirectory(prefix="featurehex-")


def read_medit(path):
    """(points, hexes with 1-based ids)"""
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    points, hexes = [], []
    at = words.index("Vertices")
    count = int(words[at + 1])
    for i in range(count):
        points.append([float(word) for word in words[at + 2 + 4 * i:at + 5 + 4 * i]])
    at = words.index("Hexahedra")
    for i in range(int(words[at + 1])):
        hexes.append([int(word) for word in words[at + 2 + 9 * i:at + 10 + 9 * i]])
    return points, hexes


def write_medit(path, points, hexes):
    with open(path, "w", encoding="ascii") as file:
        file.write("MeshVersionFormatted 2\nDimension 3\nVertices\n%d\n" % len(points))
        file.writelines("%r %r %r 0\n" % tuple(p) for p in points)
        file.write("Hexahedra\n%d\n" % len(hexes))
        file.writelines(" ".join(map(str, h)) + " 1\n" for h in hexes)
        file.write("End\n")
