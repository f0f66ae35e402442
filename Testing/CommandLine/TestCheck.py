# SPDX-License-Identifier: BSD-3-Clause
"""featurehex check: a valid mesh, and one mesh for each broken promise."""
import os

from commandline import (
    DATA, FAILED, FAST, SPHERE, check_error, folder, read_medit, report, run, succeed, write_medit)

with folder() as place:
    def path(name):
        return os.path.join(place, name)

    succeed("mesh", SPHERE, "-o", path("good.mesh"), *FAST)
    good = ["check", path("good.mesh")]
    table = succeed(*good, "--surface", SPHERE, "--tolerance", "0.02").out
    assert "NO" not in table and "Hausdorff" in table, table
    assert table.count("yes") == 8, table
    # Without the surface: what can be told.
    table = succeed(*good, "--report", path("report.json")).out
    assert "Hausdorff" not in table and table.count("yes") == 5, table
    assert report(path("report.json"))["figures"]["Valid"] == 1
    assert "HausdorffUpper" not in report(path("report.json"))["figures"]

    def broken(row, *arguments):
        result = run("check", *arguments, "--report", path("report.json"))
        check_error(result, FAILED, "Validation")
        assert any(line.startswith(row) and "NO" in line for line in result.out.splitlines()), result
        assert report(path("report.json"))["status"]["exit-code"] == FAILED
        assert report(path("report.json"))["figures"]["Valid"] == 0

    broken("within the tolerance", path("good.mesh"), "--surface", SPHERE, "--tolerance", "0.0005")
    broken("topology of the surface", path("good.mesh"), "--surface",
           os.path.join(DATA, "torus.obj"), "--tolerance", "0.02")

    points, hexes = read_medit(path("good.mesh"))
    count = [0] * len(points)
    for ids in hexes:
        for i in ids:
            count[i - 1] += 1
    inner = count.index(8)
    moved = [list(p) for p in points]
    moved[inner] = [4.0, 4.0, 4.0]
    write_medit(path("bad.mesh"), moved, hexes)
    broken("every corner positive", path("bad.mesh"), "--surface", SPHERE, "--tolerance", "0.02")
    write_medit(path("bad.mesh"), points, hexes + hexes[:1])
    broken("all hexes, conforming", path("bad.mesh"))
    write_medit(path("bad.mesh"), points + [points[0]],
                [[len(points) + 1 if i == 1 else i for i in hexes[0]]] + hexes[1:]
                if 1 in hexes[0] else hexes)
    broken("all hexes, conforming", path("bad.mesh"))
