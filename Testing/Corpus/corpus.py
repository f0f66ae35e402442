# SPDX-License-Identifier: BSD-3-Clause
"""What the corpus scripts share: the executables, one run with its report, small tables."""
import json
import os
import signal
import subprocess
import sys
import time

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SHARED = os.environ.get("FEATUREHEX_SHARED", os.path.join(os.path.dirname(TOP), "shared"))
WORK = os.path.join(TOP, "build", "corpus")
EXTENSIONS = (".obj", ".stl", ".ply", ".off", ".vtp", ".vtk")


def say(text=""):
    print(text, file=sys.stderr, flush=True)


# Of the build: the Python package.
PACKAGE_TARGETS = ("vtkFeatureHexIOPython", "vtkFeatureHexPipelinePython",
                   "FeatureHexPythonFiles", "FeatureHexUpdateAlgorithm")


def build_featurehex(*further_targets):
    """The executable of the plain VTK build; builds what changed."""
    folder = os.path.join(TOP, "build", "vtk")
    subprocess.run([os.path.join(TOP, "Wrapping", "setup"), "mesh"], check=True, stdout=sys.stderr)
    if not os.path.exists(os.path.join(folder, "build.ninja")):
        subprocess.run(["cmake", "--preset", "vtk", "-Wno-dev", "--log-level=WARNING"], check=True,
                       cwd=TOP, stdout=sys.stderr)
    subprocess.run(["cmake", "--build", "--preset", "vtk", "--target", "featurehex",
                    *further_targets, "--", "--quiet"], check=True, cwd=TOP,
                   stdout=sys.stderr)
    return os.path.join(folder, "bin", "featurehex")


def build_judge():
    """The independent judge, None where it isn't or can't be built."""
    source = os.path.join(SHARED, "judge")
    if not os.path.isdir(source):
        return None
    folder = os.path.join(TOP, "build", "judge")
    judge = os.path.join(folder, "judge")
    if os.path.exists(judge):
        return judge
    say("Building the judge")
    configure = ["cmake", "-S", source, "-B", folder, "-DCMAKE_BUILD_TYPE=Release"]
    for command in (configure, ["cmake", "--build", folder]):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            say(done.stdout)
            say("No judge: it needs libcgal-dev and libeigen3-dev.")
            return None
    return judge


def call(command, time_limit):
    """(exit code, last line of standard error, seconds); ends the process when it hangs."""
    start = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                               text=True, errors="replace")
    try:
        _, errors = process.communicate(timeout=time_limit)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        return None, "no end within %g s" % time_limit, time.monotonic() - start
    except BaseException:
        process.send_signal(signal.SIGTERM)
        process.wait()
        raise
    lines = errors.strip().splitlines()
    return process.returncode, lines[-1] if lines else "", time.monotonic() - start


def load(path):
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return {}


def mesh(featurehex, surface, output, time_limit, options):
    """Meshes one surface. The report, with exit code, last error line and seconds as "run"."""
    report_path = os.path.splitext(output)[0] + ".json"
    for path in (output, report_path):
        if os.path.exists(path):
            os.remove(path)
    command = [featurehex, "mesh", surface, "-o", output, "--report", report_path,
               "--time-limit", "%g" % time_limit, *options]
    # Twice the limit and a minute: it never reacts, so that is an error of its own.
    code, error, seconds = call(command, 2 * time_limit + 60)
    report = load(report_path)
    report["run"] = {"code": code, "error": error, "seconds": seconds}
    return report


def text(value):
    """Of a table cell."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return "%.4g" % value if abs(value) < 1e4 else "%.0f" % value
    return str(value)


def read_table(path):
    """{first column: {column: text}}"""
    with open(path, encoding="utf-8") as file:
        lines = [line.rstrip("\n").split("\t") for line in file
                 if line.strip() and not line.startswith("#")]
    return {row[0]: dict(zip(lines[0], row)) for row in lines[1:]}


def write_table(path, columns, rows, comment=""):
    temporary = path + ".part"
    with open(temporary, "w", encoding="utf-8") as file:
        file.writelines("# " + line + "\n" for line in comment.splitlines())
        file.write("\t".join(columns) + "\n")
        for row in rows:
            file.write("\t".join(text(row.get(column)) for column in columns) + "\n")
    os.replace(temporary, path)


def print_table(columns, rows):
    cells = [[title for title, _ in columns]]
    cells += [[text(row.get(key)) for _, key in columns] for row in rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(columns))]
    for row in cells:
        first = row[0].ljust(widths[0])
        print("  ".join([first] + [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])]),
              flush=True)
