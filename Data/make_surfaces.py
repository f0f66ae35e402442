#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the surfaces of this folder: make_surfaces.py [FOLDER], default: this one.

Needs nothing but Python; the files are the same, byte for byte, on each run.
"""
import math
import os
import struct
import sys


def geodesic_sphere(frequency):
    """Unit sphere: the icosahedron with each triangle cut into frequency^2."""
    golden = (1 + math.sqrt(5)) / 2
    corners = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0),
               (0, -1, golden), (0, 1, golden), (0, -1, -golden), (0, 1, -golden),
               (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11),
             (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9),
             (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    points, triangles, ids = [], [], {}

    def point(weights):
        # The same weights of the same corners: the same point, whichever face asks.
        key = tuple(sorted((corner, weight) for corner, weight in weights if weight))
        if key not in ids:
            p = [sum(weight * corners[corner][axis] for corner, weight in key)
                 for axis in range(3)]
            length = math.sqrt(sum(x * x for x in p))
            ids[key] = len(points)
            points.append(tuple(x / length for x in p))
        return ids[key]

    for a, b, c in faces:
        row = {}
        for i in range(frequency + 1):
            for j in range(frequency + 1 - i):
                row[i, j] = point([(a, frequency - i - j), (b, i), (c, j)])
        for i in range(frequency):
            for j in range(frequency - i):
                triangles.append((row[i, j], row[i + 1, j], row[i, j + 1]))
                if i + j < frequency - 1:
                    triangles.append((row[i + 1, j], row[i + 1, j + 1], row[i, j + 1]))
    return points, triangles


def torus(major, minor, around, across):
    """Torus around the z axis: genus 1."""
    points = []
    for i in range(around):
        u = 2 * math.pi * i / around
        for j in range(across):
            v = 2 * math.pi * j / across
            distance = major + minor * math.cos(v)
            points.append((distance * math.cos(u), distance * math.sin(u), minor * math.sin(v)))
    triangles = []
    for i in range(around):
        for j in range(across):
            a, b = i * across + j, (i + 1) % around * across + j
            c = (i + 1) % around * across + (j + 1) % across
            d = i * across + (j + 1) % across
            triangles += [(a, b, c), (a, c, d)]
    return points, triangles


def blob():
    """A bumpy organic body: a sphere with smooth bumps and dents in fixed directions."""
    bumps = [((1, 0.2, 0.1), 0.55, 6), ((-0.7, 0.7, 0.2), 0.40, 9), ((-0.4, -0.8, 0.5), 0.45, 7),
             ((0.1, 0.3, -1), 0.35, 8), ((0.3, -0.7, -0.6), -0.20, 6), ((0, 0.6, 0.8), -0.22, 7)]
    points, triangles = geodesic_sphere(10)
    result = []
    for p in points:
        radius = 1.0
        for direction, height, sharpness in bumps:
            length = math.sqrt(sum(x * x for x in direction))
            cosine = sum(x * y for x, y in zip(p, direction)) / length
            radius += height * math.exp(sharpness * (cosine - 1))
        result.append(tuple(radius * x for x in p))
    return result, triangles


def moved(surface, scale, offset):
    points, triangles = surface
    return [tuple(scale * x + o for x, o in zip(p, offset)) for p in points], triangles


def reversed_surface(surface):
    points, triangles = surface
    return points, [(a, c, b) for a, b, c in triangles]


def joined(surfaces):
    points, triangles = [], []
    for more_points, more_triangles in surfaces:
        shift = len(points)
        points += more_points
        triangles += [tuple(shift + i for i in triangle) for triangle in more_triangles]
    return points, triangles


def write_obj(path, comment, surface):
    points, triangles = surface
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(f"# {comment}\n")
        for p in points:
            # Adding zero turns -0 into 0.
            file.write("v " + " ".join(f"{round(x, 6) + 0.0:.6f}" for x in p) + "\n")
        for triangle in triangles:
            file.write("f " + " ".join(str(i + 1) for i in triangle) + "\n")


def write_stl(path, comment, surface):
    """Binary STL; the normals are left to the reader, as the format allows."""
    points, triangles = surface
    with open(path, "wb") as file:
        file.write(comment.encode("ascii").ljust(80)[:80])
        file.write(struct.pack("<I", len(triangles)))
        for triangle in triangles:
            file.write(struct.pack("<3f", 0, 0, 0))
            for i in triangle:
                file.write(struct.pack("<3f", *(round(x, 6) + 0.0 for x in points[i])))
            file.write(struct.pack("<H", 0))


def main(folder):
    sphere = geodesic_sphere(6)
    write_stl(os.path.join(folder, "sphere.stl"), "unit sphere", sphere)
    write_obj(os.path.join(folder, "torus.obj"), "torus, genus 1", torus(1.0, 0.4, 48, 20))
    write_obj(os.path.join(folder, "bodies.obj"), "a ball with a cavity, and a torus beside it",
              joined([sphere,
                      moved(reversed_surface(geodesic_sphere(4)), 0.5, (0.1, 0, 0)),
                      moved(torus(0.8, 0.3, 32, 14), 1, (0, 2.6, 0))]))
    write_obj(os.path.join(folder, "blob.obj"), "bumpy organic body", blob())


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
