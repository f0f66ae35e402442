# SPDX-License-Identifier: BSD-3-Clause
"""Surface to hex mesh with NumPy arrays, in python3 with plain VTK or in pvpython:

    python3 arrays.py surface.stl mesh.vtu

PYTHONPATH as for classes.py.
"""
import sys

import featurehex
import numpy


def main(surface_file, mesh_file, **options):
    points, triangles = featurehex.read_surface(surface_file)
    try:
        mesh = featurehex.mesh(points, triangles, **options)
    except featurehex.MeshingError as error:
        raise RuntimeError("%s: %s" % (error.code, error)) from error

    quality = mesh.cell_data["ScaledJacobian"]
    worst = quality.argmin()
    print("%d points, %d hexes, scaled Jacobian %.3f to %.3f; the worst at %s" % (
        len(mesh.points), len(mesh.hexes), quality.min(), quality.max(),
        numpy.round(mesh.points[mesh.hexes[worst]].mean(axis=0), 3)))
    checked = featurehex.check(mesh, points, triangles, tolerance=options.get("tolerance"))
    print("%s; no point of the boundary is farther than %.3f %% of the diagonal from the part" % (
        checked.verdict, 100 * checked.figures["HausdorffUpper"]))
    mesh.save(mesh_file)
    return mesh


if __name__ == "__main__":
    main(*sys.argv[1:3])
