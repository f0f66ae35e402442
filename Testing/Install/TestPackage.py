# SPDX-License-Identifier: BSD-3-Clause
"""The Debian package: its name, dependencies and content, and that its links lead somewhere."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BINARY = os.environ["FEATUREHEX_BINARY_DIR"]
WITH_PARAVIEW = os.environ["FEATUREHEX_WITH_PARAVIEW"].upper() in ("ON", "1", "TRUE")
CPACK = os.path.join(os.path.dirname(os.environ["FEATUREHEX_CMAKE"]), "cpack")
CONFIG = os.path.join(BINARY, "CPackConfig.cmake")


def output(*command):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout


if not os.path.exists(CONFIG) or not shutil.which("dpkg-deb"):
    print("Not tested: dpkg-dev is missing, or VTK and ParaView are not Debian's.")
    sys.exit(77)

name = "featurehex-paraview" if WITH_PARAVIEW else "featurehex"
with tempfile.TemporaryDirectory() as folder:
    output(CPACK, "--config", CONFIG, "-B", folder)
    packages = list(pathlib.Path(folder).glob("*.deb"))
    assert len(packages) == 1 and re.fullmatch(
        name + r"_[0-9.]+_[a-z0-9]+\.deb", packages[0].name), packages
    package = str(packages[0])
    print(packages[0].name, os.path.getsize(package) // 1024, "kB")

    assert output("dpkg-deb", "--field", package, "Package").strip() == name
    depends = output("dpkg-deb", "--field", package, "Depends")
    print(depends)
    assert "libembree3-3" in depends and "libc6 (>=" in depends, depends
    if WITH_PARAVIEW:
        version = output("dpkg-query", "--show", "--showformat=${Version}", "paraview")
        for exact in ("paraview", "python3-paraview"):
            assert f"{exact} (= {version})" in depends, depends
        assert "libvtk9" not in depends, depends
    else:
        assert "libvtk9.1" in depends and "paraview" not in depends, depends
    assert output("dpkg-deb", "--field", package, "Conflicts").strip() == (
        "featurehex" if WITH_PARAVIEW else "featurehex-paraview")

    root = pathlib.Path(folder, "root")
    output("dpkg-deb", "--extract", package, str(root))
    tree = root / "usr" / "lib" / name
    links = [path for path in root.rglob("*") if path.is_symlink()]
    for link in links:
        assert link.exists() and root in link.resolve().parents, link
    for path in ("usr/bin/featurehex", "usr/lib/python3/dist-packages/featurehex/__init__.py",
                 "usr/lib/cmake/FeatureHex/FeatureHexConfig.cmake",
                 f"usr/share/doc/{name}/copyright"):
        assert (root / path).exists(), path
    # ParaView looks for plugins and macros beside its programs.
    for path in ("plugins/FeatureHex/FeatureHex.so", "Macros/HexCutView.py"):
        assert (root / "usr" / "bin" / path).exists() == WITH_PARAVIEW, path
    # Nothing of the package remembers where it was built.
    for path in tree.rglob("*"):
        if path.is_file() and path.suffix == ".so":
            dynamic = output("readelf", "-d", str(path))
            for line in dynamic.splitlines():
                assert "PATH" not in line or "/opt/" not in line and BINARY not in line, line
    assert "featurehex" in output(str(root / "usr" / "bin" / "featurehex"), "--version").lower()
