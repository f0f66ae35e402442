# SPDX-License-Identifier: BSD-3-Clause
"""A CAD part with its sharp edges to a hex mesh that has them, in python3 or pvpython:

    python3 features.py part.obj part.fgraph mesh.vtu

Without a feature file ("" instead of its name) sharp edges are found by angle. PYTHONPATH as for
classes.py.
"""
import sys

import featurehex


def main(surface_file, feature_file, mesh_file, tolerance=0.005, edge_length=0.0):
    surface = featurehex.vtkSurfaceFileReader()
    surface.SetFileName(surface_file)
    mesher = featurehex.vtkFeatureHexMesher()
    mesher.SetInputConnection(0, surface.GetOutputPort())
    mesher.SetTolerance(tolerance)
    mesher.SetTargetEdgeLength(edge_length)
    if feature_file:
        features = featurehex.vtkFeatureGraphReader()
        features.SetInputConnection(surface.GetOutputPort())
        features.SetFileName(feature_file)
        mesher.SetInputConnection(1, features.GetOutputPort())
    else:
        mesher.SetFeatureModeToAngle()
    mesher.Update()
    mesh = mesher.GetOutputDataObject(0)
    if mesh.GetNumberOfCells() == 0:
        raise RuntimeError("no mesh; the reason is in the error above")

    # A row for each corner, curve and patch of the surface.
    findings = mesher.GetOutputDataObject(4)
    for row in range(findings.GetNumberOfRows()):
        kind, number, outcome, reason = (
            findings.GetValueByName(row, name).ToString()
            for name in ("Kind", "Id", "Outcome", "Reason"))
        if outcome != "Captured":
            print("%s %s %s: %s" % (kind, number, outcome, reason))
    figures = mesher.GetOutputDataObject(3)
    for kind in ("Corners", "Curves", "Patches"):
        print("%s: %d of %d captured" % (kind, *(
            figures.GetColumnByName(kind + what).GetValue(0) for what in ("Captured", "Enforced"))))

    writer = featurehex.vtkHexMeshWriter()
    writer.SetInputDataObject(mesh)
    writer.SetFileName(mesh_file)
    if not writer.Write():
        raise RuntimeError("can't write " + mesh_file)
    return mesher


if __name__ == "__main__":
    main(*sys.argv[1:4])
