# SPDX-License-Identifier: BSD-3-Clause
"""The package featurehex imports, names its version, and holds each class of the wrapped modules."""
import glob
import os
import re

import featurehex

source = os.environ["FEATUREHEX_SOURCE_DIR"]
with open(os.path.join(source, "CMakeLists.txt"), encoding="utf-8") as file:
    version = re.search(r"project\(FeatureHex\s+VERSION (\S+)", file.read()).group(1)
assert featurehex.__version__ == version, featurehex.__version__

classes = []
for path in sorted(glob.glob(os.path.join(source, "Filters", "*", "vtk*.cxx"))):
    with open(path, encoding="utf-8") as file:
        classes += re.findall(r"vtkStandardNewMacro\((\w+)\)", file.read())
assert classes
for name in classes:
    instance = getattr(featurehex, name)()
    assert instance.IsA(name) and name in str(instance), name
