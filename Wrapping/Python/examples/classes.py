# SPDX-License-Identifier: BSD-3-Clause
"""Surface to hex mesh with the classes, in python3 with plain VTK or in pvpython:

    python3 classes.py surface.stl mesh.vtu

First all in one, then the same stage by stage. PYTHONPATH holds the package featurehex of that
build and, for python3, the vtkmodules it was built for.
"""
import sys

import featurehex

TOLERANCE = 0.01
ROUNDS = 8


def read(path):
    reader = featurehex.vtkSurfaceFileReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def write(mesh, path):
    writer = featurehex.vtkHexMeshWriter()
    writer.SetInputDataObject(mesh)
    writer.SetFileName(path)
    if not writer.Write():
        raise RuntimeError("can't write " + path)


def in_one(surface):
    mesher = featurehex.vtkFeatureHexMesher()
    mesher.SetInputDataObject(surface)
    mesher.SetTolerance(TOLERANCE)
    mesher.AddObserver("ProgressEvent", lambda caller, event: print(
        "\r%3.0f %% %-50s" % (100 * caller.GetProgress(), caller.GetProgressText()), end=""))
    mesher.Update()
    print()
    return mesher.GetOutputDataObject(0)


def run(stage, *inputs):
    """Runs a filter on data objects; the objects of its ports."""
    for port, data in enumerate(inputs):
        stage.SetInputDataObject(port, data)
    stage.Update()
    return [stage.GetOutputDataObject(port) for port in range(stage.GetNumberOfOutputPorts())]


def by_stages(surface):
    surface = run(featurehex.vtkSurfaceFeatureFilter(), surface)[0]
    refinement = []
    for _ in range(ROUNDS):
        octree_filter = featurehex.vtkSurfaceOctreeFilter()
        octree_filter.SetTolerance(TOLERANCE)
        for points in refinement:
            octree_filter.AddInputDataObject(2, points)
        octree, = run(octree_filter, surface)
        dual, = run(featurehex.vtkOctreeDualHexFilter(), octree)
        domain_filter = featurehex.vtkHexDomainFilter()
        domain_filter.SetTolerance(TOLERANCE)
        domain, points = run(domain_filter, dual, surface)
        if points.GetNumberOfPoints() > 0:
            refinement.append(points)
            continue
        padded, = run(featurehex.vtkHexPaddingFilter(), domain)
        untangled, = run(featurehex.vtkHexUntangleFilter(), padded, surface)
        fitting_filter = featurehex.vtkHexFittingFilter()
        fitting_filter.SetTolerance(TOLERANCE)
        fitted, points = run(fitting_filter, untangled, surface)
        if points.GetNumberOfPoints() > 0:
            refinement.append(points)
            continue
        return fitted
    raise RuntimeError("not within the tolerance after %d rounds" % ROUNDS)


def report(title, mesh, surface):
    validation = featurehex.vtkHexValidationFilter()
    validation.SetTolerance(TOLERANCE)
    figures = run(validation, mesh, surface)[1]
    print("%s: %s, %d hexes, scaled Jacobian %.3f and up" % (
        title, figures.GetColumnByName("Verdict").GetValue(0),
        figures.GetColumnByName("NumberOfHexes").GetComponent(0, 0),
        figures.GetColumnByName("MinimumScaledJacobian").GetComponent(0, 0)))
    return figures.GetColumnByName("Valid").GetComponent(0, 0) == 1


def main(surface_file, mesh_file):
    surface = read(surface_file)
    mesh = in_one(surface)
    if not report("in one", mesh, surface) or not report("by stages", by_stages(surface), surface):
        raise RuntimeError("the mesh is not valid")
    write(mesh, mesh_file)


if __name__ == "__main__":
    main(*sys.argv[1:3])
