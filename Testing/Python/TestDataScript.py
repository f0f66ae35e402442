# SPDX-License-Identifier: BSD-3-Clause
"""Data/make_surfaces.py makes exactly the files that are in Data/."""
import filecmp
import importlib.util
import os
import tempfile

data = os.path.join(os.environ["FEATUREHEX_SOURCE_DIR"], "Data")
spec = importlib.util.spec_from_file_location(
    "make_surfaces", os.path.join(data, "make_surfaces.py"))
make_surfaces = importlib.util.module_from_spec(spec)
spec.loader.exec_module(make_surfaces)

with tempfile.TemporaryDirectory() as folder:
    make_surfaces.main(folder)
    made = sorted(os.listdir(folder))
    kept = sorted(name for name in os.listdir(data) if name.endswith((".obj", ".stl")))
    assert made == kept, (made, kept)
    _, different, unreadable = filecmp.cmpfiles(folder, data, made, shallow=False)
    assert not different and not unreadable, (different, unreadable)
