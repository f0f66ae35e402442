# SPDX-License-Identifier: BSD-3-Clause
"""The target uninstall removes what was installed last, and nothing else."""
import os
import pathlib
import subprocess
import tempfile

CMAKE = os.environ["FEATUREHEX_CMAKE"]
BINARY = os.environ["FEATUREHEX_BINARY_DIR"]

with tempfile.TemporaryDirectory() as folder:
    prefix = pathlib.Path(folder, "prefix")
    subprocess.run([CMAKE, "--install", BINARY, "--prefix", prefix], check=True,
                   stdout=subprocess.DEVNULL)
    foreign = prefix / "lib" / "foreign.txt"
    foreign.write_text("of somebody else", encoding="utf-8")
    for package in prefix.glob("lib/python3*/**/featurehex"):
        (package / "__pycache__").mkdir()
        (package / "__pycache__" / "update.pyc").write_bytes(b"")

    subprocess.run([CMAKE, "--build", BINARY, "--target", "uninstall"], check=True)
    left = sorted(prefix.rglob("*"))
    assert left == [prefix / "lib", foreign], left

    # Once more: there is nothing to remove, and the message says so.
    again = subprocess.run([CMAKE, "--build", BINARY, "--target", "uninstall"], check=False,
                           text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert again.returncode != 0 and "Nothing was installed" in again.stdout, again.stdout
