# SPDX-License-Identifier: BSD-3-Clause
"""A batch over a folder with good, bad and damaged surfaces: all are tried, none stops it; table,
reports and page say what became of them; it goes on where it was stopped and repeats nothing."""
import base64
import json
import os
import shutil
import signal
import struct
import tempfile
import time
from urllib.parse import unquote

from batches import (
    CAN_DRAW, FAST, GOOD, NAMES, ODD, SOURCE, SPHERE, Page, made, make_models, python, run, start,
    table)


def check_page(out):
    page = Page(os.path.join(out, "index.html"))
    assert page.tags.count("h1") == 1 and "3 of 6 models have a valid mesh" in page.words
    # Nothing from elsewhere, nothing that runs.
    assert "script" not in page.tags and "link" not in page.tags
    assert not [key for key, _ in page.attributes if key.startswith("on")]
    assert "url(" not in page.source and "@import" not in page.source
    for name in NAMES:
        assert name in page.words, name
    for words in ("OpenBoundary", "EmptySurface", "UnreadableFile", "Close the holes", "MSJ", "ASJ",
                  "HR %", "Hexes", "Time s"):
        assert words in page.words, words
    # Four histograms, in which each good model is counted once.
    titles = ["Minimum scaled Jacobian", "Mean scaled Jacobian",
              "Hausdorff ratio, % of the diagonal", "Hexes"]
    assert page.values("aria-label") == [
        title + " of 3 models" for title in titles]
    for chart in page.source.split("<svg")[1:]:
        counts = [int(part.split("</title>")[0].rsplit(": ", 1)[1])
                  for part in chart.split("</svg>")[0].split("<title>")[1:]]
        assert sum(counts) == len(GOOD), counts
    anchors = page.values("id")
    assert len(anchors) == len(set(anchors))
    for link in page.values("href"):
        if link.startswith("#"):
            assert link[1:] in anchors, link
        else:
            assert os.path.exists(os.path.join(out, unquote(link))), link
    pictures = page.values("src")
    # Also of an open surface; one of an empty file can't be.
    assert len(pictures) == (len(GOOD) + 1 if CAN_DRAW else 0), len(pictures)
    for picture in pictures:
        start_of, data = picture.split(",", 1)
        assert start_of == "data:image/png;base64"
        data = base64.b64decode(data, validate=True)
        assert data[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">II", data[16:24]) == (320, 320)


def check_results(out):
    rows = table(out)
    assert sorted(rows) == NAMES, rows
    for name in NAMES:
        row = rows[name]
        with open(os.path.join(out, "reports", name + ".json"), encoding="utf-8") as file:
            report = json.load(file)
        assert report["status"]["code"] == row["status"]
        mesh = os.path.join(out, "meshes", name + ".vtu")
        assert os.path.exists(mesh) == (name in GOOD) == (row["status"] == "Ok"), row
        assert (row["valid"] == "yes") == (name in GOOD) == (row["error"] == "")
        assert float(row["seconds"]) > 0
    for name in GOOD:
        assert float(rows[name]["msj"]) > 0.4 and float(rows[name]["hausdorff_percent"]) <= 2
        assert int(rows[name]["hexes"]) > 100
    assert rows[ODD]["status"] == "OpenBoundary"
    for folder, _, files in os.walk(out):
        assert not [name for name in files if ".part" in name], (folder, files)


def main(folder):
    models, out = os.path.join(folder, "models"), os.path.join(folder, "out")
    make_models(models)
    assert made(run(1, models, out, *FAST)) == NAMES
    check_results(out)
    check_page(out)

    # Again: nothing. A changed file, a changed option: again what they concern.
    assert made(run(1, models, out, *FAST)) == []
    with open(os.path.join(models, "ball.stl"), "ab") as file:
        file.write(b"\n")
    os.remove(os.path.join(out, "meshes", "sub", "ball.vtu"))
    assert made(run(1, models, out, "--no-pictures", *FAST)) == ["ball", "sub/ball"]
    bad = [name for name in NAMES if name not in GOOD]
    assert made(run(1, models, out, "--no-pictures", "--retry-failed", *FAST)) == bad

    # Other limits: again what has reached one.
    only = os.path.join(folder, "only")
    os.makedirs(only)
    shutil.copy(SPHERE, only)
    out = os.path.join(folder, "limits")
    for expected, words, arguments in (
            ("TimeLimit", "time limit", ["--time-limit", "0.01"]),
            ("OutOfMemory", "Memory limit of 5 MB", ["--memory-limit", "5"]),
            (None, "", ["--memory-limit", "5"]),
            ("Ok", "", [])):
        output = run(0 if expected == "Ok" else 1, only, out, "--no-pictures", *arguments, *FAST)
        assert made(output) == (["sphere"] if expected else []), output
        row = table(out)["sphere"]
        assert row["status"] == (expected or "OutOfMemory") and words in row["error"], row

    # Features of a folder, by the name alone.
    cubes = os.path.join(folder, "cubes", "sub")
    os.makedirs(cubes)
    shutil.copy(os.path.join(SOURCE, "Data", "rotation", "cube_mixed.obj"), cubes)
    out = os.path.join(folder, "featured")
    run(0, os.path.dirname(cubes), out, "--no-pictures", "--features",
        os.path.join(SOURCE, "Data", "rotation"), "--edge-length", "0.2", "--tolerance", "0.02")
    row = table(out)["sub/cube_mixed"]
    assert [row[kind + "_captured"] for kind in ("corners", "curves", "patches")] == [
        "8", "12", "6"], row
    assert "12 / 12" in Page(os.path.join(out, "index.html")).words


def interruptions(folder):
    """Told to stop, and killed: the next batch does the rest."""
    models, out = os.path.join(folder, "models"), os.path.join(folder, "stopped")
    names = ["a", "b", "c"]
    for name in names:
        os.makedirs(models, exist_ok=True)
        shutil.copy(SPHERE, os.path.join(models, name + ".stl"))
    arguments = [models, out, "--no-pictures", "--edge-length", "0.08"]
    seen = []
    for number, code in ((signal.SIGTERM, 7), (signal.SIGKILL, -signal.SIGKILL)):
        process = start(*arguments)
        lines = []
        # In the midst of the second of those that are left.
        lines.append(process.stdout.readline())
        time.sleep(0.2)
        process.send_signal(number)
        begun = time.monotonic()
        rest, _ = process.communicate(timeout=60)
        assert process.returncode == code, (process.returncode, lines, rest)
        assert time.monotonic() - begun < 10
        seen += made("".join(lines) + rest)
        if number == signal.SIGTERM:
            assert "Aborted" in rest, rest
            assert sorted(table(out)) == seen
    seen += made(run(0, *arguments))
    assert sorted(seen) == names, seen


def together(folder):
    """Two processes with two jobs each share the models; both end when all are finished."""
    models, out = os.path.join(folder, "models"), os.path.join(folder, "out")
    make_models(models)
    processes = [start(models, out, "--no-pictures", "--jobs", "2", *FAST) for _ in range(2)]
    outputs = [process.communicate(timeout=200)[0] for process in processes]
    assert [process.returncode for process in processes] == [1, 1], outputs
    assert sorted(made("".join(outputs))) == NAMES, outputs
    check_results(out)


def bad_arguments(folder):
    out = os.path.join(folder, "out")
    for words, arguments in (
            ("no folder", [os.path.join(folder, "none"), out]),
            ("no surfaces", [folder, out]),
            ("--edge-lenth", [os.path.dirname(SPHERE), out, "--edge-lenth", "1"]),
            ("tolerance", [os.path.dirname(SPHERE), out, "--tolerance", "7"]),
            ("--jobs", [os.path.dirname(SPHERE), out, "--jobs", "0"]),
            ("--report", [os.path.dirname(SPHERE), out, "--report", "x.json"])):
        output = run(2, *arguments)
        assert words in output and output.count("\n") == 1, output


print("with", python())
for test in (main, interruptions, together, bad_arguments):
    with tempfile.TemporaryDirectory() as place:
        began = time.monotonic()
        test(place)
        print("%s: %.1f s" % (test.__name__, time.monotonic() - began), flush=True)
