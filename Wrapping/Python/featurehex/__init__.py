# SPDX-License-Identifier: BSD-3-Clause
"""All-hex meshes from closed surfaces: functions for NumPy arrays, and the FeatureHex filters.

    import featurehex
    points, triangles = featurehex.read_surface("part.stl")
    result = featurehex.mesh(points, triangles, feature_angle=140)
    result.points, result.hexes, result.figures["MinimumScaledJacobian"]
    result.save("part.vtu")

    mesher = featurehex.vtkFeatureHexMesher()    # the same as a filter of VTK

"python -m featurehex mesh|check|batch" is the command line.

In pvpython the classes belong to ParaView's VTK, in python3 to plain VTK: the build decides, and
two VTKs in one process do not work.

ParaView's VTK runs everything on one thread unless told otherwise: importing this package selects
VTK's backend STDThread, with all cores, where the environment variable VTK_SMP_BACKEND_IN_USE
doesn't choose another. Results are the same bits for any backend and number of threads.
"""

import os

from vtkmodules.vtkCommonCore import vtkSMPTools

from .vtkFeatureHexIO import *
from .vtkFeatureHexPipeline import *

# After the classes, because they are made of them.
from .arrays import (
    Features, Finding, HexMesh, MeshCheck, check, mesh, read_features, read_mesh, read_surface)
from .update import MeshingError, update

if not os.environ.get("VTK_SMP_BACKEND_IN_USE"):
    vtkSMPTools.SetBackend("STDThread")

__version__: str = vtkFeatureHexVersion.GetVersion()
