# SPDX-License-Identifier: BSD-3-Clause
"""NumPy arrays in and out: meshes, checks, features, files, errors; and while it meshes, other
Python threads run, the caller can stop it, and two meshes can be made at once."""
import os
import tempfile
import threading
import time

import featurehex
import numpy

FAST = {"edge_length": 0.25, "tolerance": 0.02}
SPHERE = os.path.join(os.environ["FEATUREHEX_SOURCE_DIR"], "Data", "sphere.stl")

CORNERS = numpy.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = numpy.array([t for a, b, c, d in QUADS for t in ((a, b, c), (a, c, d))])
EDGES = numpy.array([(a, b) for a in range(8) for b in range(a + 1, 8)
                     if abs(CORNERS[a] - CORNERS[b]).sum() == 1])


def fails(kind, words, function, *arguments, **options):
    try:
        function(*arguments, **options)
    except kind as error:
        for word in words.split():
            assert word in str(error), (word, error)
        return error
    raise AssertionError("no %s: %s" % (kind.__name__, words))


def same(a, b):
    return numpy.array_equal(a.points, b.points) and numpy.array_equal(a.hexes, b.hexes)


points, triangles = featurehex.read_surface(SPHERE)
assert points.shape[1] == triangles.shape[1] == 3 and triangles.max() < len(points)
sphere = featurehex.mesh(points, triangles, **FAST)
assert sphere.points.dtype == numpy.float64 and sphere.points.shape[1] == 3
assert sphere.hexes.shape == (sphere.figures["NumberOfHexes"], 8)
assert sphere.hexes.max() == len(sphere.points) - 1
assert sphere.cell_data["ScaledJacobian"].min() == sphere.figures["MinimumScaledJacobian"] > 0
assert set(sphere.point_data) == {"FeatureKind", "FeatureId"} and not sphere.features
# STL holds single precision. Lists and other types of numbers are as good.
assert same(sphere, featurehex.mesh(points.astype("f4"), triangles.astype("u2"), **FAST))
assert same(sphere, featurehex.mesh(points.tolist(), triangles.tolist(), **FAST))

checked = featurehex.check(sphere, points, triangles, tolerance=0.02)
assert checked.valid and checked.verdict == "valid", checked.verdict
assert numpy.array_equal(checked.scaled_jacobian, sphere.cell_data["ScaledJacobian"])
assert checked.figures["HausdorffUpper"] <= 0.02
# Without a surface less is measured; a hex turned inside out is found.
assert "HausdorffUpper" not in featurehex.check(sphere).figures
broken = sphere.hexes.copy()
broken[7] = broken[7][[4, 5, 6, 7, 0, 1, 2, 3]]
broken = featurehex.check(featurehex.HexMesh(sphere.points, broken), points, triangles)
assert not broken.valid and broken.verdict and broken.scaled_jacobian[7] < 0

# Smaller where wanted.
finer = featurehex.mesh(points, triangles, edge_lengths=0.1 * (points[:, 0] > 0), **FAST)
assert len(finer.hexes) > 1.5 * len(sphere.hexes)
fails(ValueError, "5 values for", featurehex.mesh, points, triangles, edge_lengths=[0.1] * 5)
fails(featurehex.MeshingError, "point 0 edge length", featurehex.mesh, points, triangles,
      edge_lengths=numpy.full(len(points), numpy.nan))

#--- features: given and by angle ------------------------------------------------------------------
given = featurehex.Features(EDGES)
cube = featurehex.mesh(CORNERS, TRIANGLES, features=given, edge_length=0.2, tolerance=0.02)
found = featurehex.mesh(CORNERS, TRIANGLES, feature_angle=140, edge_length=0.2, tolerance=0.02)
assert same(cube, found)
assert [f.outcome for f in cube.features] == 26 * ["Captured"], cube.features
assert sorted({f.kind for f in cube.features}) == ["corner", "curve", "patch"]
assert cube.field_data["FeatureEdges"].shape[1] == 3
for options in ({"features": given}, {"feature_angle": 140}):
    checked = featurehex.check(cube, CORNERS, TRIANGLES, **options)
    assert checked.valid and [f.outcome for f in checked.features] == 26 * ["Captured"]

with tempfile.TemporaryDirectory() as folder:
    for name in ("cube.vtu", "cube.vtk", "cube.mesh"):
        path = os.path.join(folder, name)
        cube.save(path)
        read = featurehex.read_mesh(path)
        assert same(cube, read), name
    path = os.path.join(folder, "cube.fgraph")
    with open(path, "w", encoding="ascii") as file:
        file.write("140 1 1\n1 12\n5\n")
        file.writelines("%d %d\n" % tuple(edge) for edge in EDGES)
    features = featurehex.read_features(path, CORNERS, TRIANGLES)
    assert sorted(map(sorted, features.edges.tolist())) == EDGES.tolist()
    assert 5 in features.corners
    path = os.path.join(folder, "quads.off")
    with open(path, "w", encoding="ascii") as file:
        file.write("OFF\n8 6 0\n")
        file.writelines("%g %g %g\n" % tuple(point) for point in CORNERS)
        file.writelines("4 %d %d %d %d\n" % quad for quad in QUADS)
    assert numpy.array_equal(featurehex.read_surface(path)[1], TRIANGLES)
    for words, code, function, *arguments in (
            ("nothing", "UnreadableFile", featurehex.read_mesh, os.path.join(folder, "nothing")),
            ("nothing", "UnreadableFile", featurehex.read_surface, os.path.join(folder, "nothing")),
            ("nothing", "UnreadableFile", featurehex.read_features,
             os.path.join(folder, "nothing"), CORNERS, TRIANGLES),
            ("nowhere", "UnwritableFile", cube.save, os.path.join(folder, "nowhere", "out.vtu")),
            (".vtu .mesh", "UnwritableFile", cube.save, os.path.join(folder, "out.xyz"))):
        error = fails(featurehex.MeshingError, words, function, *arguments)
        assert error.code == code, (error.code, error)

#--- errors ----------------------------------------------------------------------------------------
error = fails(featurehex.MeshingError, "Open boundary triangle", featurehex.mesh,
              CORNERS, TRIANGLES[1:])
assert error.code == "OpenBoundary"
error = fails(featurehex.MeshingError, "MaximumNumberOfCells", featurehex.mesh, points, triangles,
              maximum_cells=100)
assert error.code == "CellLimit"
for words, surface, options in (
        ("Tolerance 1e-05 0.1", (CORNERS, TRIANGLES), {"tolerance": 3}),
        ("points (n, 3)", (CORNERS[:, :2], TRIANGLES), {}),
        ("triangles (n, 3)", (CORNERS, TRIANGLES.ravel()), {}),
        ("integers float64", (CORNERS, TRIANGLES.astype(float)), {}),
        ("1 to 8, 8 points", (CORNERS, TRIANGLES + 1), {}),
        ("features.edges 8 points", (CORNERS, TRIANGLES),
         {"features": featurehex.Features(EDGES + 1)})):
    fails(ValueError, words, featurehex.mesh, *surface, **options)
fails(ValueError, "both", featurehex.check, sphere, points)
fails(ValueError, "surface", featurehex.check, sphere, feature_angle=140)

#--- progress, stopping, threads -------------------------------------------------------------------
heard = []
featurehex.mesh(points, triangles, progress=lambda *what: heard.append(what), **FAST)
assert [share for share, _ in heard] == sorted(share for share, _ in heard)
assert len({phase for _, phase in heard}) > 3, heard
error = fails(featurehex.MeshingError, "", featurehex.mesh, points, triangles,
              progress=lambda share, phase: share > 0.2, **FAST)
assert error.code == "Aborted"


def interrupt(share, phase):
    if share > 0.2:
        raise KeyboardInterrupt


fails(KeyboardInterrupt, "", featurehex.mesh, points, triangles, progress=interrupt, **FAST)

# The other thread counts while this one is inside one call; with the lock it would get nowhere.
count = 0
done = False


def run():
    global count
    while not done:
        count += 1
        time.sleep(0.001)


other = threading.Thread(target=run)
other.start()
before, start = count, time.monotonic()
featurehex.mesh(points, triangles, **FAST)
seconds = time.monotonic() - start
counted = count - before
done = True
other.join()
print("%d steps of another thread in %.2f s of meshing" % (counted, seconds))
assert counted > 50 * seconds, (counted, seconds)

results = []
threads = [threading.Thread(
    target=lambda: results.append(featurehex.mesh(points, triangles, **FAST))) for _ in range(2)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
assert len(results) == 2 and all(same(result, sphere) for result in results)
