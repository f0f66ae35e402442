#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the surfaces of this folder: make_surfaces.py [FOLDER], default: this one.

The rotation series goes to its subfolder "rotation", each surface with its sharp features as
.fgraph beside it. Needs nothing but Python; the files are the same, byte for byte, on each run.
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


#--- shapes with sharp edges -----------------------------------------------------------------------
def cut_polygon(polygon):
    """Triangles of a simple polygon (2D points, counter-clockwise) by cutting ears."""

    def area(a, b, c):
        (ax, ay), (bx, by), (cx, cy) = polygon[a], polygon[b], polygon[c]
        return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

    left, triangles = list(range(len(polygon))), []
    while len(left) > 3:
        for i in range(len(left)):
            a, b, c = left[i - 1], left[i], left[(i + 1) % len(left)]
            others = [p for p in left if p not in (a, b, c)]
            if area(a, b, c) > 1e-12 and not any(
                    area(a, b, p) >= 0 and area(b, c, p) >= 0 and area(c, a, p) >= 0
                    for p in others):
                triangles.append((a, b, c))
                del left[i]
                break
    return triangles + [tuple(left)]


def prism(polygon, height):
    """The polygon (counter-clockwise) from z = -height / 2 to height / 2."""
    n = len(polygon)
    points = [(x, y, z) for z in (-height / 2, height / 2) for x, y in polygon]
    triangles = []
    for a, b, c in cut_polygon(polygon):
        triangles += [(a, c, b), (n + a, n + b, n + c)]
    for i in range(n):
        j = (i + 1) % n
        triangles += [(i, j, n + j), (i, n + j, n + i)]
    return points, triangles


def pyramid(polygon, height):
    """The polygon (counter-clockwise) at z = 0, all its points joined with one above the origin."""
    n = len(polygon)
    points = [(x, y, 0.0) for x, y in polygon] + [(0.0, 0.0, height)]
    triangles = [(a, c, b) for a, b, c in cut_polygon(polygon)]
    return points, triangles + [(i, (i + 1) % n, n) for i in range(n)]


def regular_polygon(sides, radii=(1.0,)):
    """Points round the origin at these radii in turn: with two of them a star."""
    return [(radii[i % len(radii)] * math.cos(2 * math.pi * i / sides),
             radii[i % len(radii)] * math.sin(2 * math.pi * i / sides)) for i in range(sides)]


def turned(surface, axis, degrees):
    """Rotated about an axis through the origin (Rodrigues)."""
    length = math.sqrt(sum(x * x for x in axis))
    k = [x / length for x in axis]
    sine, cosine = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))

    def turn(p):
        along = sum(a * b for a, b in zip(k, p))
        cross = (k[1] * p[2] - k[2] * p[1], k[2] * p[0] - k[0] * p[2], k[0] * p[1] - k[1] * p[0])
        return tuple(p[i] * cosine + cross[i] * sine + k[i] * along * (1 - cosine)
                     for i in range(3))

    points, triangles = surface
    return [turn(p) for p in points], triangles


def sharp_features(surface, smooth=30.0, kink=40.0):
    """Corners and edges by the angles between triangles and between edges, degrees."""
    points, triangles = surface

    def difference(a, b):
        return tuple(points[a][i] - points[b][i] for i in range(3))

    def angle(u, v):
        cosine = sum(a * b for a, b in zip(u, v)) / math.sqrt(
            sum(a * a for a in u) * sum(b * b for b in v))
        return math.degrees(math.acos(max(-1.0, min(1.0, cosine))))

    normals = {}
    for a, b, c in triangles:
        u, v = difference(b, a), difference(c, a)
        normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        for edge in ((a, b), (b, c), (c, a)):
            normals[edge] = normal
    edges = sorted((a, b) for a, b in normals
                   if a < b and angle(normals[a, b], normals[b, a]) > smooth)
    neighbors = {}
    for a, b in edges:
        neighbors.setdefault(a, []).append(b)
        neighbors.setdefault(b, []).append(a)
    corners = sorted(
        p for p, others in neighbors.items() if len(others) != 2 or
        angle(difference(p, others[0]), difference(others[1], p)) > kink)
    return corners, edges


def rotation_series():
    """Name, comment, surface of each shape of the folder "rotation"."""
    square = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]
    axes = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    cases = [("x" + "yz"[:count - 1], [degrees] * count)
             for count in (1, 2, 3) for degrees in (5, 10, 15, 20, 25)]
    for letters, angles in cases + [("mixed", [25, 10, 15])]:
        cube = prism(square, 1.0)
        for axis, degrees in zip(axes, angles):
            cube = turned(cube, axis, degrees)
        yield (f"cube_{letters}" + (f"_{angles[0]:02d}" if letters != "mixed" else ""),
               "unit cube turned about x, y, z by " + ", ".join(map(str, angles)) + " degrees", cube)

    skew = (3, 2, 1)
    bracket = [(0, 0), (3, 0), (3, 1), (2.2, 1), (2.2, 0.6), (1.7, 0.6), (1.7, 1), (1, 1), (1, 3),
               (0, 3)]
    yield "bracket", "L-bracket with a notch, turned by 25 degrees", turned(
        prism(bracket, 1.5), skew, 25)
    yield "cylinder", "cylinder of 48 sides, turned by 25 degrees", turned(
        prism(regular_polygon(48), 2.0), skew, 25)

    for degrees in (12, 20, 25):
        tip = math.radians(degrees)
        yield f"wedge_{degrees}", f"two faces meet at {degrees} degrees", prism(
            [(0.0, 0.0), (2.0, 0.0), (2 * math.cos(tip), 2 * math.sin(tip))], 1.0)
    # A regular pyramid of more sides has no sharp edges any more: these have star bases.
    for valence in (7, 8, 10, 12):
        radii = (1.0,) if valence == 7 else (1.0, 0.45)
        yield f"apex_{valence:02d}", f"pyramid, {valence} edges meet at the apex", pyramid(
            regular_polygon(valence, radii), 1.6)


def write_obj(path, comment, surface, digits=6):
    points, triangles = surface
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(f"# {comment}\n")
        for p in points:
            # Adding zero turns -0 into 0.
            file.write("v " + " ".join(f"{round(x, digits) + 0.0:.{digits}f}" for x in p) + "\n")
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


def write_fgraph(path, features):
    """Flags: curves that bound no patch on both sides are kept."""
    corners, edges = features
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(f"140 1 1\n{len(corners)} {len(edges)}\n")
        for corner in corners:
            file.write(f"{corner}\n")
        for a, b in edges:
            file.write(f"{a} {b}\n")


def main(folder):
    sphere = geodesic_sphere(6)
    write_stl(os.path.join(folder, "sphere.stl"), "unit sphere", sphere)
    write_obj(os.path.join(folder, "torus.obj"), "torus, genus 1", torus(1.0, 0.4, 48, 20))
    write_obj(os.path.join(folder, "bodies.obj"), "a ball with a cavity, and a torus beside it",
              joined([sphere,
                      moved(reversed_surface(geodesic_sphere(4)), 0.5, (0.1, 0, 0)),
                      moved(torus(0.8, 0.3, 32, 14), 1, (0, 2.6, 0))]))
    write_obj(os.path.join(folder, "blob.obj"), "bumpy organic body", blob())

    rotation = os.path.join(folder, "rotation")
    os.makedirs(rotation, exist_ok=True)
    for name, comment, surface in rotation_series():
        # More digits: faces of turned shapes are flat.
        write_obj(os.path.join(rotation, name + ".obj"), comment, surface, 9)
        write_fgraph(os.path.join(rotation, name + ".fgraph"), sharp_features(surface))


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
