# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's graphical interface, driven by the events a user makes, on a display of its own.

A fresh ParaView: a home folder without settings, the plugin found through PV_PLUGIN_PATH in an
install tree. Steps are collected, then played one after another by ParaView's own test player:

    window = Interface("TestMine")
    window.open(path)
    window.filter("FeatureHexMesher")
    window.apply()
    window.screenshot("meshed")
    window.python("assert simple.GetActiveSource().GetDataInformation().GetNumberOfCells() > 9")
    output = window.run()
    image = window.image("meshed")

Names of widgets: Tools > Record Test in ParaView writes the events of what one does.
"""
import os
import shutil
import signal
import struct
import subprocess
import tempfile
import zlib
from xml.sax.saxutils import quoteattr

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

WIDTH, HEIGHT = 1400, 900
WINDOW = "pqClientMainWindow"
CONSOLE = WINDOW + "/pythonShellDock/pythonShell/consoleWidget"
PANEL = WINDOW + "/propertiesDock/propertiesPanel"
# Seconds for one start of ParaView; 20 are needed on a machine that is not busy.
TIME_LIMIT = 240
# Of the view, where nothing is drawn.
BACKGROUND = (82, 87, 110)

# Runs a step inside ParaView; the console would keep what goes wrong to itself.
STEP = """
def featurehex_step(path, failures):
    import traceback
    from paraview import servermanager, simple
    try:
        with open(path, encoding="utf-8") as file:
            exec(compile(file.read(), path, "exec"), {"simple": simple, "servermanager": servermanager})
    except BaseException:
        with open(failures, "a", encoding="utf-8") as file:
            traceback.print_exc(file=file)
"""


def missing():
    """What these tests need and isn't there, or None."""
    for program in ("xvfb-run", "paraview"):
        if not shutil.which(program):
            return f"there is no {program}."
    return None


def install(prefix):
    """Installs the build tree."""
    subprocess.run([os.environ["FEATUREHEX_CMAKE"], "--install",
                    os.environ["FEATUREHEX_BINARY_DIR"], "--prefix", prefix],
                   check=True, stdout=subprocess.DEVNULL)


def read_dump(path):
    """Pixels (rows from above, RGB) of a dump of the X server, format XWD, 32 bits a pixel."""
    with open(path, "rb") as file:
        data = file.read()
    header = struct.unpack(">25I", data[:100])
    size, width, height, bits, stride = header[0], header[4], header[5], header[11], header[12]
    assert bits == 32 and header[7] == 0, header
    start = size + 12 * header[19]
    rows = numpy.frombuffer(data, numpy.uint8, height * stride, start).reshape(height, stride)
    return rows[:, :4 * width].reshape(height, width, 4)[:, :, 2::-1].copy()


def few_colours(image):
    """The image in at most 256 colours, the background exactly: indices and palette."""
    background = (image == BACKGROUND).all(axis=2, keepdims=True)
    rough = numpy.where(background, image, image // 8 * 8 + 4).astype(int)
    codes = rough[:, :, 0] << 16 | rough[:, :, 1] << 8 | rough[:, :, 2]
    found, inverse, counts = numpy.unique(codes, return_inverse=True, return_counts=True)
    kept = numpy.argsort(-counts, kind="stable")[:256]
    colours = numpy.stack([found >> 16, found >> 8 & 255, found & 255], axis=1)

    def distance(place):
        return ((colours - colours[place]) ** 2).sum(axis=1)

    # The most frequent, then those that the ones before stand for worst.
    kept = list(numpy.argsort(-counts, kind="stable")[:160])
    distances = numpy.min([distance(place) for place in kept], axis=0)
    while len(kept) < 256 and distances.any():
        kept.append(int((distances * numpy.sqrt(counts)).argmax()))
        distances = numpy.minimum(distances, distance(kept[-1]))
    nearest = ((colours[:, None] - colours[kept][None]) ** 2).sum(axis=2).argmin(axis=1)
    indices = nearest[inverse].reshape(codes.shape)
    # A colour is the mean of what it stands for.
    palette = numpy.array([image[indices == i].mean(axis=0).round() for i in range(len(kept))])
    return indices.astype(numpy.uint8), palette.astype(numpy.uint8)


def write_png(path, image):
    """PNG of rows from above, RGB, with a palette."""
    def chunk(name, content):
        body = name + content
        return struct.pack(">I", len(content)) + body + struct.pack(">I", zlib.crc32(body))

    indices, palette = few_colours(image)
    rows = b"".join(b"\0" + row.tobytes() for row in indices)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n"
                   + chunk(b"IHDR", struct.pack(">IIBBBBB", *image.shape[1::-1], 8, 3, 0, 0, 0))
                   + chunk(b"PLTE", palette.tobytes())
                   + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def read_png(path):
    """Pixels of a PNG, rows from above, RGB."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    columns, rows, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(rows, columns, -1)[::-1, :, :3]


def view_of(image):
    """The part of a screenshot that is the view; few pixels elsewhere have its colour, too."""
    background = (image == BACKGROUND).all(axis=2)
    rows = numpy.flatnonzero(background.sum(axis=1) > 100)
    columns = numpy.flatnonzero(background.sum(axis=0) > 100)
    return image[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1]


def play(command, variables):
    """Exit code and output of a program, which is ended together with its display when it hangs: a
    dialog that a step doesn't close does that."""
    with subprocess.Popen(command, env=variables, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, start_new_session=True) as process:
        try:
            output = process.communicate(timeout=TIME_LIMIT)[0]
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            output = process.communicate()[0] + f"Stopped after {TIME_LIMIT} s."
    return process.returncode, output


def compare_png(path, name):
    """Compares a picture of a view with Testing/Baseline, as the tests of Testing/Python do."""
    from baseline import compare, pixels
    from vtkmodules.vtkIOImage import vtkPNGReader
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    compare((pixels(reader.GetOutput()).astype(int) + 25) // 51 * 51, name)


class Interface:
    """Steps for one start of ParaView."""

    def __init__(self, name, **variables):
        self.folder = os.path.join(os.environ["FEATUREHEX_TEMPORARY_DIR"], name)
        shutil.rmtree(self.folder, ignore_errors=True)
        self.home = os.path.join(self.folder, "home")
        self.settings = os.path.join(self.home, ".config", "ParaView")
        self.macros = os.path.join(self.folder, "macros")
        os.makedirs(self.settings)
        self.failures = os.path.join(self.folder, "failures.txt")
        self.variables = variables
        self.events = []
        self.steps = 0
        with open(os.path.join(self.settings, "ParaView5.11.0.ini"), "w", encoding="utf-8") as file:
            # The welcome would hide everything.
            file.write("[General]\nGeneralSettings.ShowWelcomeDialog=false\n")
        self.event(CONSOLE, "executeCommand", self.step_file(STEP, "exec(open({0!r}).read())"))

    def step_file(self, text, command):
        path = os.path.join(self.folder, f"step{self.steps}.py")
        self.steps += 1
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return command.format(path)

    def event(self, widget, command, arguments=""):
        """Any event of ParaView's test player; widget: names from the main window on."""
        self.events.append((widget, command, arguments))

    def menu(self, path, action):
        """path: of the menu, such as menuFilters/FeatureHex; action: its name or text."""
        self.event(f"{WINDOW}/menubar/{path}", "activate", action)

    def open(self, path):
        """File > Open, and Apply."""
        self.menu("menu_File", "actionFileOpen")
        self.event(WINDOW + "/FileOpenDialog", "filesSelected", path)
        self.apply()

    def filter(self, name):
        """Filters > FeatureHex."""
        self.menu("menuFilters/FeatureHex", name)

    def select(self, *rows):
        """A click in the Pipeline Browser; rows: of the source, below it of the filter, ..."""
        path = "".join(f"/{row}:0" for row in (0, *rows))
        for command, buttons in (("mousePress", 1), ("mouseRelease", 0)):
            self.event(WINDOW + "/pipelineBrowserDock/pipelineBrowser", command,
                       f"1,{buttons},0,50,5,{path}")

    def import_macro(self, name):
        """Macros > Import New Macro; name: of a macro of the plugin."""
        self.menu("menu_Macros", "actionMacroCreate")
        self.event(WINDOW + "/FileOpenDialog", "filesSelected",
                   os.path.join(self.macros, name + ".py"))

    def macro(self, name):
        """A macro that was imported."""
        self.menu("menu_Macros", name)

    def apply(self):
        self.event(PANEL + "/Accept", "activate")

    def choose(self, name, text):
        """In a drop-down list of the panel; name: of the property."""
        self.event(f"{PANEL}/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/"
                   f"PropertiesFrame/ProxyPanel/{name}/ComboBox", "set_string", text)

    def python(self, text):
        """Python inside ParaView, with paraview.simple as simple; it fails by an exception."""
        self.event(CONSOLE, "executeCommand",
                   self.step_file(text, "featurehex_step({0!r}, %r)" % self.failures))

    def screenshot(self, name):
        """Of the whole window, for image(name)."""
        # The X server may still be drawing what ParaView has sent.
        self.python(f"import shutil, time\ntime.sleep(0.3)\n"
                    f"shutil.copy({self.folder!r} + '/Xvfb_screen0', {self.dump(name)!r})")

    def dump(self, name):
        return os.path.join(self.folder, name + ".xwd")

    def image(self, name):
        """A screenshot; writes it as PNG, too."""
        image = read_dump(self.dump(name))
        write_png(os.path.join(self.folder, name + ".png"), image)
        return image

    def document(self, name, picture):
        """With FEATUREHEX_UPDATE_PICTURES=1 the screenshot becomes a picture of the documentation."""
        if os.environ.get("FEATUREHEX_UPDATE_PICTURES"):
            write_png(os.path.join(os.environ["FEATUREHEX_SOURCE_DIR"], "Filters", "Documentation",
                                   "Pictures", picture + ".png"), self.image(name))

    def run(self, errors=0):
        """Plays the steps; what ParaView printed. errors: as many are expected in its messages."""
        script = os.path.join(self.folder, "events.xml")
        with open(script, "w", encoding="utf-8") as file:
            file.write('<?xml version="1.0" ?>\n<pqevents>\n')
            for widget, command, arguments in self.events:
                file.write(f"  <pqevent object={quoteattr(widget)} command={quoteattr(command)} "
                           f"arguments={quoteattr(arguments)}/>\n")
            file.write("</pqevents>\n")
        variables = {key: value for key, value in os.environ.items()
                     if key not in ("PYTHONPATH", "XDG_CONFIG_HOME", "DISPLAY")}
        with tempfile.TemporaryDirectory() as prefix:
            install(prefix)
            shutil.copytree(os.path.join(prefix, "share", "featurehex", "macros"), self.macros)
            variables.update(
                HOME=self.home,
                PV_PLUGIN_PATH=os.path.join(prefix, os.environ["FEATUREHEX_PLUGIN_SUBDIR"]),
                **self.variables)
            # Without -noreset the server goes away with its first client.
            code, output = play(
                ["xvfb-run", "-a", "-s",
                 f"-screen 0 {WIDTH}x{HEIGHT}x24 -noreset -fbdir {self.folder}",
                 "paraview", "-qwindowgeometry", f"{WIDTH}x{HEIGHT}+0+0",
                 "--test-directory=" + self.folder, "--test-script=" + script, "--exit"],
                variables)
        if os.path.exists(self.failures):
            with open(self.failures, encoding="utf-8") as file:
                output += file.read()
        assert code == 0 and not os.path.exists(self.failures), output
        assert output.count("ERR|") == errors, output
        return output
