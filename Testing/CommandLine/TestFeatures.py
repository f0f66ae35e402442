# SPDX-License-Identifier: BSD-3-Clause
"""Sharp features by file and by angle: in the mesh, in the report, in every format, and checked."""
import os

from commandline import (
    BAD_ARGUMENTS, FAILED, FAST, SPHERE, UNREADABLE, check_error, fail, folder, report, run, succeed)

POINTS = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
EDGES = [(a, b) for a in range(8) for b in range(a + 1, 8)
         if sum(p != q for p, q in zip(POINTS[a], POINTS[b])) == 1]


def write_cube(place):
    surface = os.path.join(place, "cube.obj")
    with open(surface, "w", encoding="ascii") as file:
        file.writelines("v %g %g %g\n" % point for point in POINTS)
        file.writelines("f %d %d %d %d\n" % tuple(i + 1 for i in quad) for quad in QUADS)
    features = os.path.join(place, "cube.fgraph")
    with open(features, "w", encoding="ascii") as file:
        file.write("140 1 1\n%d %d\n" % (len(POINTS), len(EDGES)))
        file.writelines("%d\n" % i for i in range(len(POINTS)))
        file.writelines("%d %d\n" % edge for edge in EDGES)
    return surface, features


def expect_captured(content):
    figures = content["figures"]
    for kind, count in (("Corners", 8), ("Curves", 12), ("Patches", 6)):
        assert figures[kind + "Enforced"] == figures[kind + "Captured"] == count, figures
    assert figures["FeaturesCaptured"] == 1
    assert figures["CornerDeviationMaximum"] <= 1e-9
    assert figures["CurveVertexDeviationMaximum"] <= 1e-6
    assert [f["kind"] for f in content["features"]] == ["corner"] * 8 + ["curve"] * 12 + ["patch"] * 6
    assert {f["outcome"] for f in content["features"]} == {"Captured"}


with folder() as place:
    surface, features = write_cube(place)
    path = os.path.join(place, "report.json")
    for extension in (".vtu", ".mesh", ".vtk"):
        mesh = os.path.join(place, "cube" + extension)
        result = succeed("mesh", surface, "--features", features, "-o", mesh, "--report", path, *FAST)
        assert "8 of 8 corners, 12 of 12 curves, 6 of 6 patches" in result.out, result
        assert result.errors == "", result
        expect_captured(report(path))
        assert report(path)["options"]["features"] == features
        for by in (["--features", features], ["--feature-angle", "140"]):
            result = succeed("check", mesh, "--surface", surface, *by, "--report", path,
                             "--tolerance", "0.02")
            assert result.out.count("yes") == 9 and "one to one" in result.out, result
            expect_captured(report(path))

    # The .mesh file has quads, edges and corners of its own.
    with open(os.path.join(place, "cube.mesh"), encoding="ascii") as file:
        words = file.read().split()
    assert words[words.index("Corners") + 1] == "8"
    assert int(words[words.index("Ridges") + 1]) >= 12
    assert words[words.index("Edges") + 1] == words[words.index("Ridges") + 1]
    assert "Quadrilaterals" in words

    mesh = os.path.join(place, "angle.vtu")
    succeed("mesh", surface, "--feature-angle", "140", "-o", mesh, "--report", path, *FAST)
    expect_captured(report(path))

    # Without features there are none, and the check says what is missed.
    succeed("mesh", surface, "--no-features", "-o", mesh, "--report", path, *FAST)
    assert "features" not in report(path) and "FeaturesCaptured" not in report(path)["figures"]
    result = run("check", mesh, "--surface", surface, "--features", features, "--report", path,
                 "--tolerance", "0.02")
    check_error(result, FAILED, "Features", "8 of 8 corners missed")
    assert "one to one      NO" in result.out, result
    assert report(path)["status"]["code"] == "Features"
    assert report(path)["features"][0]["outcome"] == "NotMapped"
    assert report(path)["features"][0]["reason"]

    fail(BAD_ARGUMENTS, "InvalidOption", "check", mesh, "--features", features, words="--surface")
    fail(BAD_ARGUMENTS, "InvalidOption", "mesh", surface, "-o", mesh, "--no-features", "--features",
         features)
    fail(BAD_ARGUMENTS, "InvalidOption", "mesh", surface, "-o", mesh, "--feature-angle", "200")
    fail(BAD_ARGUMENTS, "InvalidOption", "mesh", surface, "--features", features, "-o", mesh,
         "--report", features)
    fail(UNREADABLE, r"\w+", "mesh", surface, "--features", SPHERE, "-o", mesh)
    fail(UNREADABLE, r"\w+", "mesh", surface, "--features", features + "x", "-o", mesh)
