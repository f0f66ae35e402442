# SPDX-License-Identifier: BSD-3-Clause
"""The pages comparison.md and choosing-parameters.md have the figures of today's tables."""
import os
import runpy
import sys

SOURCE = os.environ.get("FEATUREHEX_SOURCE_DIR") or os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__))))

if __name__ == "__main__":
    sys.argv = ["compare", "--check"]
    runpy.run_path(os.path.join(SOURCE, "Testing", "Corpus", "compare"), run_name="__main__")
