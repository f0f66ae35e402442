# SPDX-License-Identifier: BSD-3-Clause
"""The report holds every figure, option, time and warning; standard output one line."""
import os
import re

from commandline import DATA, FAST, REJECTED, SPHERE, SOURCE, fail, folder, report, succeed

with open(os.path.join(SOURCE, "Filters", "Core", "HexValidation.cxx"), encoding="utf-8") as file:
    figures = set(re.findall(r'^    \{ "(\w+)", ', file.read(), re.MULTILINE))
assert len(figures) > 50, figures

with folder() as place:
    out = os.path.join(place, "out.vtu")
    path = os.path.join(place, "report.json")
    result = succeed("mesh", SPHERE, "-o", out, "--report", path, "--threads", "1",
                     "--time-limit", "250", "--max-level", "3", "--max-cells", "1000000",
                     "--max-rounds", "7", "--min-scaled-jacobian", "0.4", "--align", *FAST)
    content = report(path)
    assert content["program"] == "featurehex" and content["command"] == "mesh"
    assert re.match(r"\d+\.\d+\.\d+$", content["version"])
    assert content["status"] == {"code": "Ok", "message": "", "exit-code": 0}
    assert content["input"] == {"file": SPHERE, "points": 2160, "faces": 720}, content["input"]
    assert content["output"] == {"file": out}
    assert content["options"] == {
        "tolerance": 0.02, "edge-length": 0.25,
        "edge-length-array": "", "features": "", "feature-angle": 0, "enforce-all-features": False, "max-level": 3,
        "max-cells": 1000000, "max-rounds": 7, "min-scaled-jacobian": 0.4, "align": True,
        "time-limit": 250, "nodes-per-hex": 8, "threads": 1}, content["options"]
    missing = figures - set(content["figures"])
    assert not missing, missing
    assert content["figures"]["Valid"] == 1
    assert content["figures"]["TargetEdgeLength"] == 0.25
    stages = {stage["stage"]: stage["seconds"] for stage in content["stages"]}
    assert {"Reading", "SurfaceCheck", "Octree", "Fitting", "Validation", "Writing"} <= set(stages)
    assert all(seconds >= 0 for seconds in stages.values())
    assert sum(stages.values()) <= 1.01 * content["seconds"], content["seconds"]
    assert len(content["phases"]) >= 8
    assert content["rounds"]["count"] >= 1
    assert content["threads"] == 1 and content["host-threads"] == os.cpu_count()
    assert content["thread-backend"] == "STDThread"
    assert 10e6 < content["peak-memory-bytes"] < 2e9
    assert content["warnings"] == []

    # Quiet, but for one line.
    assert result.errors == ""
    assert re.match(r"out\.vtu: %d hexes, .*\n$" % content["figures"]["NumberOfHexes"], result.out)

    # Repairs are warnings.
    with open(os.path.join(DATA, "torus.obj"), encoding="ascii") as file:
        lines = file.read().splitlines()
    faces = [i for i, line in enumerate(lines) if line.startswith("f ")]
    words = lines[faces[0]].split()
    lines[faces[0]] = " ".join([words[0], words[2], words[1], *words[3:]])
    flipped = os.path.join(place, "flipped.obj")
    with open(flipped, "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")
    result = succeed("mesh", flipped, "-o", out, "--report", path, *FAST)
    assert result.errors.startswith("featurehex: warning: "), result
    assert len(report(path)["warnings"]) == 1, report(path)["warnings"]

    # When it fails, the report says what is known.
    lines.pop(faces[1])
    with open(flipped, "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")
    fail(REJECTED, "OpenBoundary", "mesh", flipped, "-o", out, "--report", path)
    content = report(path)
    assert content["status"]["code"] == "OpenBoundary" and content["status"]["message"]
    assert content["options"]["tolerance"] == 0.005
    assert content["seconds"] > 0 and content["peak-memory-bytes"] > 0
