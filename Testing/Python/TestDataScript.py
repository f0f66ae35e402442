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
    for sub in ("", "rotation"):
        one, other = os.path.join(folder, sub), os.path.join(data, sub)
        made, kept = (sorted(name for name in os.listdir(where)
                             if name.endswith((".obj", ".stl", ".fgraph")))
                      for where in (one, other))
        assert made == kept and made, (made, kept)
        _, different, unreadable = filecmp.cmpfiles(one, other, made, shallow=False)
        assert not different and not unreadable, (different, unreadable)
