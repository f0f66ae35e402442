# SPDX-License-Identifier: BSD-3-Clause
"""What Testing/Benchmark/run does once: build a revision, run its programs, read what they measured."""
import collections
import json
import math
import os
import statistics
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(HERE), "Corpus"))
import corpus  # noqa: E402

# Where a build of one revision has its programs; micro is None where the benchmarks don't fit it.
Revision = collections.namedtuple("Revision", "name featurehex micro")
Model = collections.namedtuple("Model", "name surface options")


#--- building -------------------------------------------------------------------------------------
def build(name, source, folder, jobs):
    """The programs of the sources in a folder of their own, with the benchmarks of this folder."""
    corpus.say("Building %s in %s" % (name, folder))
    # Each time: what was missing may have been installed since.
    subprocess.run(
        ["cmake", "--preset", "vtk", "-B", folder, "-Wno-dev", "--log-level=WARNING",
         "-DFEATUREHEX_WITH_PYTHON=OFF", "-DFEATUREHEX_WITH_CORE_TESTS=OFF", "-DBUILD_TESTING=OFF",
         "-DCMAKE_PROJECT_FeatureHex_INCLUDE=" + os.path.join(HERE, "AddBenchmarks.cmake")],
        check=True, cwd=source, stdout=sys.stderr)
    make = ["cmake", "--build", folder, "--parallel", str(jobs), "--target"]
    subprocess.run([*make, "featurehex", "--", "--quiet"], check=True, stdout=sys.stderr)
    micro = subprocess.run([*make, "MicroBenchmarks", "--", "--quiet"], stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT, text=True)
    programs = os.path.join(folder, "bin")
    if micro.returncode != 0:
        corpus.say(micro.stdout[-2000:])
        corpus.say("No micro-benchmarks of %s: Google Benchmark is missing (Wrapping/setup benchmark), "
                   "or they don't fit this revision's headers." % name)
    return Revision(name, os.path.join(programs, "featurehex"),
                    os.path.join(programs, "MicroBenchmarks") if micro.returncode == 0 else None)


def git(*arguments):
    return subprocess.run(["git", "-C", corpus.TOP, *arguments], check=True, text=True,
                          stdout=subprocess.PIPE).stdout.strip()


def check_out(revision, folder):
    """(hash, folder with the sources) of a git revision."""
    commit = git("rev-parse", "--verify", "--short", revision + "^{commit}")
    source = os.path.join(folder, commit, "source")
    if not os.path.exists(source):
        git("worktree", "prune")
        git("worktree", "add", "--detach", source, commit)
    return commit, source


#--- inputs ---------------------------------------------------------------------------------------
def data(shared, own):
    """A file of ../shared/data, or of Data/ where that is missing."""
    path = os.path.join(corpus.SHARED, "data", shared)
    return path if os.path.exists(path) else os.path.join(corpus.TOP, "Data", own)


def write_cube(path):
    """The unit cube of 12 triangles."""
    with open(path, "w", encoding="utf-8") as file:
        for i in range(8):
            file.write("v %d %d %d\n" % (i & 1, i >> 1 & 1, i >> 2))
        for a, b, c, d in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7),
                           (2, 0, 4, 6)):
            file.write("f %d %d %d\nf %d %d %d\n" % (a + 1, b + 1, c + 1, a + 1, c + 1, d + 1))


def models(folder):
    """One organic surface, one CAD part with its features, one cube."""
    organic = data("surfaces/organic/bunny.obj", "blob.obj")
    cad = data("surfaces/cad/fandisk.obj", "rotation/cylinder.obj")
    features = data("features/fandisk.fgraph", "rotation/cylinder.fgraph")
    cube = os.path.join(folder, "cube.obj")
    write_cube(cube)
    return [Model(name_of(organic), organic, []), Model(name_of(cad), cad, ["--features", features]),
            Model("cube", cube, ["--feature-angle", "140"])]


def name_of(path):
    return os.path.splitext(os.path.basename(path))[0]


#--- measuring ------------------------------------------------------------------------------------
def mesh(featurehex, surface, output, time_limit, options):
    """The report of one run; ends the program when there is no mesh."""
    report = corpus.mesh(featurehex, surface, output, time_limit, options)
    if report["run"]["code"] != 0:
        sys.exit("FAILED %s: %s" % (name_of(surface), report["run"]["error"] or report["run"]["code"]))
    return report


def pipeline_once(revision, model, folder, options):
    """One whole run: {column: figure}, stages by name."""
    output = os.path.join(folder, "%s-%s.vtk" % (model.name, revision.name))
    report = mesh(revision.featurehex, model.surface, output, 3600, [*model.options, *options])
    figures = report["figures"]
    stages = {entry["stage"]: entry["seconds"] for entry in report["stages"]}
    return {
        "name": model.name, "threads": report["threads"], "hexes": figures["NumberOfHexes"],
        "msj": figures["MinimumScaledJacobian"], "hausdorff_percent": 100 * figures["HausdorffUpper"],
        "seconds": report["run"]["seconds"], "cpu_seconds": report["processor-seconds"],
        "peak_mb": report["peak-memory-bytes"] / 1e6, "rounds": report["rounds"]["count"],
        "stages": stages}


def micro_once(revision, surface, hexes, seconds, wanted):
    """One run of the micro-benchmarks: {(name, threads): figures}."""
    done = subprocess.run(
        [revision.micro, surface, hexes, "--benchmark_format=json", "--benchmark_min_time=%g" % seconds,
         "--benchmark_filter=" + wanted], stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit("FAILED MicroBenchmarks of " + revision.name)
    results = {}
    for entry in json.loads(done.stdout)["benchmarks"]:
        if entry.get("error_occurred"):
            sys.exit("FAILED %s: %s" % (entry["name"], entry["error_message"]))
        parts = entry["name"].split("/")
        threads = next(int(part.split(":")[1]) for part in parts if part.startswith("threads:"))
        # Times are in milliseconds.
        results[parts[0], threads] = {
            "name": parts[0], "threads": threads, "unit": entry["label"], "items": int(entry["items"]),
            "seconds": entry["real_time"] / 1000, "cpu_seconds": entry["cpu_time"] / 1000}
    return results


#--- figures --------------------------------------------------------------------------------------
def middle(runs, key):
    return statistics.median(run[key] for run in runs)


def spread(runs, key):
    """(least, largest)"""
    values = [run[key] for run in runs]
    return min(values), max(values)


def ratios(these, others, key):
    """Median, least and largest of the ratios of runs that were made one after the other."""
    values = [this[key] / max(other[key], 1e-9) for this, other in zip(these, others)]
    return statistics.median(values), min(values), max(values)


def exponent(rows, key):
    """Slope of log(key) over log(hexes), least squares: 1 is linear."""
    points = [(math.log(row["hexes"]), math.log(row[key])) for row in rows]
    mean_x = sum(x for x, _ in points) / len(points)
    mean_y = sum(y for _, y in points) / len(points)
    square = sum((x - mean_x) ** 2 for x, _ in points)
    return sum((x - mean_x) * (y - mean_y) for x, y in points) / square if square > 0 else 1.0
