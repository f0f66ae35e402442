# SPDX-License-Identifier: BSD-3-Clause
"""All-hex meshes from closed surfaces: the FeatureHex filters as Python classes.

    import featurehex
    mesher = featurehex.vtkFeatureHexMesher()

In pvpython the classes belong to ParaView's VTK, in python3 to plain VTK: the build decides, and
two VTKs in one process do not work.
"""

from .vtkFeatureHexIO import *
from .vtkFeatureHexPipeline import *

__version__ = vtkFeatureHexVersion.GetVersion()
