# SPDX-License-Identifier: BSD-3-Clause
"""Files that can't be read or written, and that nothing is ever left half done."""
import os
import shutil

from commandline import (
    BAD_ARGUMENTS, FAST, REJECTED, SPHERE, SUCCESS, UNREADABLE, UNWRITABLE, content, fail, folder,
    report, run, succeed)

with folder() as place:
    def path(name):
        return os.path.join(place, name)

    # Unwritable names are found before the surface is even read.
    nowhere = path("no/such/folder/out.vtu")
    fail(UNWRITABLE, "UnwritableFile", "mesh", path("missing.stl"), "-o", nowhere, words="folder")
    fail(UNWRITABLE, "UnwritableFile", "mesh", path("missing.stl"), "-o", path("out.vtu"),
         "--report", path("no/such/folder/report.json"), words="folder")
    os.mkdir(path("folder.vtu"))
    fail(UNWRITABLE, "UnwritableFile", "mesh", SPHERE, "-o", path("folder.vtu"))
    os.rmdir(path("folder.vtu"))
    assert os.listdir(place) == []

    # The input is never overwritten.
    with open(path("surface.vtk"), "w", encoding="ascii") as file:
        file.write("# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 0 float\n")
    before = content(path("surface.vtk"))
    os.symlink(path("surface.vtk"), path("link.vtk"))
    for name in ("surface.vtk", "link.vtk"):
        fail(BAD_ARGUMENTS, "InvalidOption", "mesh", path("surface.vtk"), "-o", path(name))
    assert content(path("surface.vtk")) == before
    os.remove(path("link.vtk"))
    os.remove(path("surface.vtk"))

    # Unreadable input.
    fail(UNREADABLE, "UnreadableFile", "mesh", path("missing.stl"), "-o", path("out.vtu"),
         words="missing.stl")
    fail(UNREADABLE, "UnreadableFile", "mesh", place, "-o", path("out.vtu"))
    fail(UNREADABLE, "UnreadableFile", "check", path("missing.vtu"), words="missing.vtu")
    with open(path("noise.xyz"), "w", encoding="ascii") as file:
        file.write("neither this nor that\n")
    fail(UNREADABLE, "UnreadableFile", "mesh", path("noise.xyz"), "-o", path("out.vtu"))
    fail(UNREADABLE, "UnreadableFile", "check", path("noise.xyz"))
    os.remove(path("noise.xyz"))
    assert os.listdir(place) == []

    # A failure leaves an older result as it was, and writes the report.
    with open(path("out.vtu"), "w", encoding="ascii") as file:
        file.write("older")
    with open(path("open.obj"), "w", encoding="ascii") as file:
        file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    fail(REJECTED, "OpenBoundary", "mesh", path("open.obj"), "-o", path("out.vtu"),
         "--report", path("report.json"))
    assert content(path("out.vtu")) == b"older"
    status = report(path("report.json"))["status"]
    assert status["code"] == "OpenBoundary" and status["exit-code"] == REJECTED, status
    assert "3" in status["message"], status
    assert sorted(os.listdir(place)) == ["open.obj", "out.vtu", "report.json"]

    # Edge lengths by point.
    ids = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3),
           (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]
    with open(path("cube.vtk"), "w", encoding="ascii") as file:
        file.write("# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n")
        file.writelines("%d %d %d\n" % (i & 1, i >> 1 & 1, i >> 2) for i in range(8))
        file.write("POLYGONS 12 48\n")
        file.writelines("3 %d %d %d\n" % triangle for triangle in ids)
        file.write("POINT_DATA 8\nSCALARS Size float\nLOOKUP_TABLE default\n0.05\n" + 7 * "0\n")
    cells = []
    for arguments in ([], ["--edge-length-array", "Size"]):
        succeed("mesh", path("cube.vtk"), "-o", path("cube.vtu"), "--report", path("cube.json"),
                "--edge-length", "0.25", "--tolerance", "0.05", *arguments)
        cells.append(report(path("cube.json"))["figures"]["NumberOfHexes"])
    assert cells[1] > 1.5 * cells[0], cells
    fail(BAD_ARGUMENTS, "InvalidOption", "mesh", path("cube.vtk"), "-o", path("cube.vtu"),
         "--edge-length-array", "size", words='no point array "size"')
    for name in ("cube.vtk", "cube.vtu", "cube.json"):
        os.remove(path(name))

    # Success replaces it; names with spaces and other letters; a relative name.
    succeed("mesh", SPHERE, "-o", path("out.vtu"), *FAST)
    assert content(path("out.vtu")).startswith(b"<?xml")
    shutil.copy(SPHERE, path("Kugel ä 1.STL"))
    assert run("mesh", "Kugel ä 1.STL", "-o", "Ergebnis ö.VTU", *FAST, cwd=place).code == SUCCESS
    assert content(path("Ergebnis ö.VTU")) == content(path("out.vtu"))
    assert not [name for name in os.listdir(place) if "tmp" in name or "part" in name]
