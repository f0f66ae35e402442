# SPDX-License-Identifier: BSD-3-Clause
"""Help, version, and every kind of bad argument: exit code 2 and one line, before anything is read."""
import os
import re

from commandline import BAD_ARGUMENTS, SOURCE, SPHERE, fail, folder, succeed

with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="utf-8") as file:
    version = re.search(r"project\(FeatureHex\s+VERSION (\S+)", file.read()).group(1)
assert succeed("--version").out == "featurehex %s\n" % version

for arguments in (["--help"], ["mesh", "--help"], ["check", "--help"]):
    text = succeed(*arguments).out
    for code in range(10):
        assert re.search(r"^ *%d  \S" % code, text, re.MULTILINE), (code, text)
for option in ("--output", "--tolerance", "--edge-length", "--no-features", "--report", "--threads",
               "--time-limit", "--max-level", "--max-cells", "--max-rounds",
               "--min-scaled-jacobian", "--align", "--nodes-per-hex"):
    assert option in succeed("mesh", "--help").out, option

with folder() as place:
    out = os.path.join(place, "out.vtu")
    mesh = ["mesh", SPHERE, "-o", out]
    for arguments, words in (
            ([], "subcommand"),
            (["melt"], "subcommand"),
            (["mesh"], "surface required"),
            (["mesh", SPHERE], "--output required"),
            (mesh + ["--colour", "red"], "--colour"),
            (mesh + ["--tolerance", "0"], "--tolerance from"),
            (mesh + ["--tolerance", "-1"], "--tolerance"),
            (mesh + ["--tolerance", "nan"], "--tolerance nan"),
            (mesh + ["--tolerance", "inf"], "--tolerance inf"),
            (mesh + ["--tolerance", "0,005"], "--tolerance 0,005"),
            (mesh + ["--tolerance", ""], "--tolerance"),
            (mesh + ["--edge-length", "-2"], "--edge-length"),
            (mesh + ["--threads", "-1"], "--threads"),
            (mesh + ["--threads", "two"], "--threads two"),
            (mesh + ["--threads", "1.5"], "--threads 1.5"),
            (mesh + ["--time-limit", "-3"], "--time-limit"),
            (mesh + ["--max-level", "99"], "--max-level 99"),
            (mesh + ["--max-cells", "0"], "--max-cells"),
            (mesh + ["--max-rounds", "0"], "--max-rounds"),
            (mesh + ["--min-scaled-jacobian", "2"], "--min-scaled-jacobian"),
            (mesh + ["--nodes-per-hex", "9"], "--nodes-per-hex 9"),
            (["mesh", SPHERE, "-o", os.path.join(place, "out.mesh"), "--nodes-per-hex", "20"],
             "out.mesh at most 8 nodes"),
            (["mesh", SPHERE, "-o", os.path.join(place, "out.inp"), "--nodes-per-hex", "27"],
             "out.inp at most 20 nodes"),
            (mesh + ["--report"], "--report"),
            (["check"], "mesh required"),
            (["check", out, "--tolerance", "7"], "--tolerance"),
            (["mesh", SPHERE, "-o", os.path.join(place, "out.xyz")], "out.xyz .vtu"),
            (["mesh", SPHERE, "-o", os.path.join(place, "out")], ".vtu .vtk .mesh .inp .msh .msh2 .exo .ucd"),
            (mesh + ["--report", out], "out.vtu names")):
        fail(BAD_ARGUMENTS, "InvalidOption", *arguments, words=words)
    assert os.listdir(place) == []
