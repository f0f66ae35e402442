# SPDX-License-Identifier: BSD-3-Clause
"""All-hex meshes from closed surfaces: the FeatureHex filters as Python classes.

    import featurehex
    mesher = featurehex.vtkFeatureHexMesher()

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

if not os.environ.get("VTK_SMP_BACKEND_IN_USE"):
    vtkSMPTools.SetBackend("STDThread")

__version__ = vtkFeatureHexVersion.GetVersion()
