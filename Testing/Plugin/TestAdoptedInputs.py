# SPDX-License-Identifier: BSD-3-Clause
"""Filters find what was said before: those that measure a mesh its surface, the mesher the features
of its surface, the quality view of a mesh from a file the surface that is as large."""
import os
import tempfile

from paraview import simple

SPHERE = os.path.join(os.environ["FEATUREHEX_SOURCE_DIR"], "Data", "sphere.stl")
TOLERANCE = 0.02

simple.LoadPlugin(os.environ["FEATUREHEX_PLUGIN"])
sphere = simple.STLReader(FileNames=[SPHERE])
mesher = simple.FeatureHexMesher(Input=sphere, Tolerance=TOLERANCE, TargetEdgeLength=0.25)

quality = simple.HexQuality(Input=mesher)
assert quality.Surface is not None and quality.Surface.SMProxy is sphere.SMProxy
assert quality.Tolerance == TOLERANCE
quality.UpdatePipeline()
quality.UpdatePropertyInformation()
assert 0 < quality.LargestDeviation <= 1, quality.LargestDeviation
assert simple.OutputPort(quality, 1).GetDataInformation().GetNumberOfRows() > 1

# Through another filter of ours, and not through one that changes the mesh.
validation = simple.HexValidation(Input=mesher)
assert validation.Surface.SMProxy is sphere.SMProxy and validation.Tolerance == TOLERANCE
validation.UpdatePipeline()
validation.UpdatePropertyInformation()
assert validation.Valid == 1 and 0 < validation.HausdorffBound <= TOLERANCE
assert simple.HexQuality(Input=validation).Surface.SMProxy is sphere.SMProxy
clip = simple.Clip(Input=mesher, ClipType="Plane", Crinkleclip=1)
assert simple.HexQuality(Input=clip).Surface is None

# Features of a surface whose features were looked for.
bracket = simple.OpenDataFile(os.path.join(
    os.environ["FEATUREHEX_SOURCE_DIR"], "Data", "rotation", "bracket.obj"))
found = simple.SurfaceFeature(Input=bracket)
edged = simple.FeatureHexMesher(Input=found)
assert edged.Features.SMProxy is found.SMProxy and edged.Features.Port == 1, edged.Features
assert simple.FeatureHexMesher(Input=bracket).Features is None
edges = simple.ExtractEdges(Input=bracket)
assert simple.FeatureHexMesher(Input=found, Features=edges).Features.SMProxy is edges.SMProxy
edged.Features = None
assert edged.Features is None

# What is given stays.
other = simple.STLReader(FileNames=[SPHERE])
given = simple.HexQuality(Input=mesher, Surface=other, Tolerance=0.05)
assert given.Surface.SMProxy is other.SMProxy and given.Tolerance == 0.05
given.Surface = None
assert given.Surface is None

with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "ball.vtu")
    simple.SaveData(path, mesher, DataMode="Binary")
    from featurehex import views  # after the plugin, which is linked with it
    for source in list(simple.GetSources().values()):
        simple.Delete(source)
    simple.Sphere(Center=[50, 0, 0])
    surface = simple.STLReader(FileNames=[SPHERE])
    simple.Sphere(Radius=9)
    simple.ExtractEdges(Input=surface)
    mesh = simple.OpenDataFile(path)
    mesh.UpdatePipeline()
    assert views._surface_around(mesh).SMProxy is surface.SMProxy
    simple.Delete(surface)
    assert views._surface_around(mesh) is None
print("surfaces found")
