# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the plugin share: pipelines of proxies, their bits, and other processes."""
import hashlib
import os
import subprocess
import tempfile

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

TOLERANCE = 0.02
EDGE = 0.3
SURFACE = os.path.join(os.environ["FEATUREHEX_SOURCE_DIR"], "Data", "sphere.stl")


def composite(surface):
    return simple.FeatureHexMesher(
        registrationName="Mesher", Input=surface, Tolerance=TOLERANCE, TargetEdgeLength=EDGE)


def stages(surface, refinement=None):
    """Proxies of all stages, in order."""
    checked = simple.SurfaceFeature(Input=surface)
    octree = simple.SurfaceOctree(Input=checked, TargetEdgeLength=EDGE, Tolerance=TOLERANCE)
    if refinement:
        octree.RefinementPoints = refinement
    dual = simple.OctreeDualHex(Input=octree)
    domain = simple.HexDomain(Input=dual, Surface=checked, Tolerance=TOLERANCE)
    padding = simple.HexPadding(Input=domain)
    untangle = simple.HexUntangle(Input=padding, Surface=checked)
    fitting = simple.HexFitting(Input=untangle, Surface=checked, Tolerance=TOLERANCE)
    validation = simple.HexValidation(Input=fitting, Surface=checked, Tolerance=TOLERANCE)
    return [checked, octree, dual, domain, padding, untangle, fitting, validation]


def fetch(proxy, port=0):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy, idx=port)


def figure(table, name):
    return table.GetColumnByName(name).GetComponent(0, 0)


def bits(mesh):
    """Digest of points, cells and cell arrays."""
    digest = hashlib.sha256(vtk_to_numpy(mesh.GetPoints().GetData()).tobytes())
    digest.update(vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).astype("int64").tobytes())
    for name in ("Region", "Level", "ScaledJacobian"):
        digest.update(vtk_to_numpy(mesh.GetCellData().GetArray(name)).tobytes())
    return digest.hexdigest()


def run(*command, **variables):
    """Output of another process, which must succeed."""
    result = subprocess.run(command, env=dict(os.environ, **variables), text=True, check=False,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert result.returncode == 0 and "Traceback" not in result.stdout, result.stdout
    return result.stdout


def run_script(text, *program, **variables):
    """Output of a Python script in a ParaView process of its own."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "script.py")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        program = program or (os.environ["FEATUREHEX_PVPYTHON"], "--force-offscreen-rendering")
        variables["PYTHONPATH"] = os.path.dirname(__file__) + ":" + os.environ["PYTHONPATH"]
        return run(*program, path, **variables)
