# SPDX-License-Identifier: BSD-3-Clause
"""Each input format gives the same mesh, each output format holds it."""
import os

from commandline import DATA, FAST, content, folder, read_medit, report, succeed


def read_obj(path):
    points, triangles = [], []
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words and words[0] == "v":
                points.append(tuple(float(word) for word in words[1:4]))
            elif words and words[0] == "f":
                triangles.append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    return points, triangles


def write_surfaces(place, points, triangles):
    lines = ["%r %r %r" % point for point in points]
    faces = ["3 %d %d %d" % tuple(triangle) for triangle in triangles]
    flat = " ".join(str(i) for triangle in triangles for i in triangle)
    offsets = " ".join(str(3 * (i + 1)) for i in range(len(triangles)))
    texts = {
        "off": "OFF\n%d %d 0\n" % (len(lines), len(faces)) + "\n".join(lines + faces) + "\n",
        "ply": "ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
               "property double z\nelement face %d\nproperty list uchar int vertex_indices\n"
               "end_header\n" % (len(lines), len(faces)) + "\n".join(lines + faces) + "\n",
        "vtk": "# vtk DataFile Version 3.0\ntorus\nASCII\nDATASET POLYDATA\nPOINTS %d double\n"
               % len(lines) + "\n".join(lines) + "\nPOLYGONS %d %d\n" % (len(faces), 4 * len(faces))
               + "\n".join(faces) + "\n",
        "vtp": '<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
               'header_type="UInt64"><PolyData><Piece NumberOfPoints="%d" NumberOfVerts="0" '
               'NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="%d"><Points><DataArray '
               'type="Float64" Name="Points" NumberOfComponents="3" format="ascii">%s</DataArray>'
               '</Points><Polys><DataArray type="Int64" Name="connectivity" format="ascii">%s'
               '</DataArray><DataArray type="Int64" Name="offsets" format="ascii">%s</DataArray>'
               '</Polys></Piece></PolyData></VTKFile>\n'
               % (len(lines), len(faces), "\n".join(lines), flat, offsets),
        "stl": "solid torus\n" + "".join(
            "facet normal 0 0 0\nouter loop\n%s\nendloop\nendfacet\n"
            % "\n".join("vertex " + lines[i] for i in triangle) for triangle in triangles)
               + "endsolid torus\n"}
    for extension, text in texts.items():
        with open(os.path.join(place, "torus." + extension), "w", encoding="ascii") as file:
            file.write(text)
    return sorted(texts)


torus = os.path.join(DATA, "torus.obj")
with folder() as place:
    def path(name):
        return os.path.join(place, name)

    options = [*FAST, "--no-features", "--time-limit", "100"]
    succeed("mesh", torus, "-o", path("torus.mesh"), *options)
    expected = content(path("torus.mesh"))
    assert len(read_medit(path("torus.mesh"))[1]) > 100
    for extension in write_surfaces(place, *read_obj(torus)):
        succeed("mesh", path("torus." + extension), "-o", path("out.mesh"), *options)
        same = content(path("out.mesh")) == expected
        # The reader of STL has points of its own for each triangle: merged in another order.
        assert same or extension == "stl", extension

    hexes = len(read_medit(path("torus.mesh"))[1])
    for extension in ("vtu", "vtk", "mesh"):
        succeed("mesh", torus, "-o", path("out." + extension), *options,
                "--report", path("mesh.json"))
        assert report(path("mesh.json"))["figures"]["NumberOfHexes"] == hexes
        # Same points to the last bit: the same figures as after meshing.
        succeed("check", path("out." + extension), "--surface", torus, "--tolerance", "0.02",
                "--report", path("check.json"))
        meshed = report(path("mesh.json"))["figures"]
        for name, value in report(path("check.json"))["figures"].items():
            assert meshed.get(name, value) == value, (extension, name, value, meshed[name])
    assert b'format="binary"' in content(path("out.vtu"))
    assert b"appended" not in content(path("out.vtu"))
