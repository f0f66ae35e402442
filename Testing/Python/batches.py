# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of "python -m featurehex batch" share: a folder of models, runs, the page."""
import os
import shutil
import subprocess
import sys
from html.parser import HTMLParser

from featurehex import programs

SOURCE = os.environ["FEATUREHEX_SOURCE_DIR"]
SPHERE = os.path.join(SOURCE, "Data", "sphere.stl")
FAST = ["--edge-length", "0.25", "--tolerance", "0.02"]
CAN_DRAW = shutil.which("xvfb-run") is not None
# One that HTML, shells and URLs each read in their own way.
ODD = "sub/open & <b>100%<"
NAMES = ["ball", "broken", "sub/ball", ODD, "torus.obj", "torus.off"]
GOOD = ["ball", "sub/ball", "torus.obj"]


def python():
    """The command of the Python that runs this test."""
    named = os.environ.get("FEATUREHEX_PVPYTHON")
    return [named, "--force-offscreen-rendering"] if named else [sys.executable]


def make_models(folder):
    """Two good surfaces in two places, one of a name that comes twice; an open one, two damaged."""
    os.makedirs(os.path.join(folder, "sub"))
    shutil.copy(SPHERE, os.path.join(folder, "ball.stl"))
    shutil.copy(SPHERE, os.path.join(folder, "sub", "ball.stl"))
    shutil.copy(os.path.join(SOURCE, "Data", "torus.obj"), folder)
    with open(os.path.join(SOURCE, "Data", "torus.obj"), encoding="ascii") as file:
        lines = file.readlines()
    lines.remove([line for line in lines if line.startswith("f ")][5])
    for name, text in ((ODD + ".obj", "".join(lines)), ("torus.off", "OFF\n3 1 0\n0 0 0\n"),
                       ("broken.stl", "solid x\nendsolid x\n"), ("notes.txt", "no surface")):
        with open(os.path.join(folder, name), "w", encoding="ascii") as file:
            file.write(text)


def start(*arguments, before=(), **variables):
    environment = {**programs.environment(), **variables}
    environment.pop("PYTHONUNBUFFERED", None)  # users see each line at once without it, too
    return subprocess.Popen(
        [*before, *python(), "-m", "featurehex", "batch", *map(str, arguments)],
        env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def run(code, *arguments):
    """Its output; it must end with this code."""
    process = start(*arguments)
    output, _ = process.communicate(timeout=280)
    assert process.returncode == code, (process.returncode, output)
    return output


def made(output):
    """Names of the models that were meshed, or tried, by their lines "[1/6] name: ..."."""
    return sorted(line.split("] ", 1)[1].split(": ")[0] for line in output.splitlines()
                  if line.startswith("["))


def table(folder):
    """{name: {column: text}}"""
    with open(os.path.join(folder, "batch.tsv"), encoding="utf-8") as file:
        lines = [line.rstrip("\n").split("\t") for line in file]
    assert all(len(line) == len(lines[0]) for line in lines), lines
    return {line[0]: dict(zip(lines[0], line)) for line in lines[1:]}


class Page(HTMLParser):
    """Fails where tags don't match."""

    VOID = ("meta", "img", "br")

    def __init__(self, path):
        super().__init__()
        self.tags = []
        self.attributes = []
        self.text = []
        self._open = []
        with open(path, encoding="utf-8") as file:
            self.source = file.read()
        self.feed(self.source)
        self.close()
        assert not self._open, self._open
        self.words = " ".join(" ".join(self.text).split())

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += attrs
        if tag not in self.VOID:
            self._open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += attrs

    def handle_endtag(self, tag):
        assert self._open and self._open.pop() == tag, (tag, self.getpos())

    def handle_data(self, data):
        if self._open and self._open[-1] != "style":
            self.text.append(data)

    def values(self, name):
        return [value for key, value in self.attributes if key == name]
