# SPDX-License-Identifier: BSD-3-Clause
"""Meshes all surfaces of a folder with their sharp edges, through ParaView's proxies:

    pvpython folder.py parts meshes
"""
import pathlib
import sys

from paraview import servermanager
from paraview.simple import *

parts, meshes = map(pathlib.Path, sys.argv[1:3])
meshes.mkdir(exist_ok=True)
for path in sorted(parts.iterdir()):
    if path.suffix not in (".stl", ".obj", ".ply"):
        continue
    surface = OpenDataFile(str(path))
    mesher = FeatureHexMesher(Input=surface, FeatureMode="Angle", FeatureAngle=140, TimeLimit=300)
    mesher.UpdatePipeline()

    # Output 3 is a table with one row of figures; without a mesh it is empty.
    report = servermanager.Fetch(mesher, idx=3)
    if report.GetNumberOfRows() == 0:
        reason = report.GetFieldData().GetAbstractArray("FeatureHexError").GetValue(0)
        print(f"{path.name}: no mesh. {reason}")
    else:
        hexes, quality = (report.GetValueByName(0, name).ToDouble()
                          for name in ("NumberOfHexes", "MinimumScaledJacobian"))
        print(f"{path.name}: {hexes:.0f} hexes, scaled Jacobian {quality:.2f} and up")
        SaveData(str(meshes / (path.stem + ".vtu")), OutputPort(mesher, 0), DataMode="Binary")
    Delete(mesher)
    Delete(surface)
