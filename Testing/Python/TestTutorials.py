# SPDX-License-Identifier: BSD-3-Clause
"""Code in the tutorials is that of files which other tests run: a line <!-- from FILE --> before a
block says of which. With FEATUREHEX_UPDATE=1 in the environment the pages are written anew."""
import glob
import os
import re

SOURCE = os.environ["FEATUREHEX_SOURCE_DIR"]
BLOCK = re.compile(r"(<!-- from (\S+) -->\n```\w+\n)(.*?)(```)", re.DOTALL)


def code(match: re.Match) -> str:
    """The block as it should be: the file without the line of its license."""
    with open(os.path.join(SOURCE, match.group(2)), encoding="utf-8") as source:
        text = re.sub(r"\A\S+ SPDX-License-Identifier: .*\n", "", source.read())
    return match.group(1) + text + match.group(4)


blocks = 0
for path in glob.glob(os.path.join(SOURCE, "Filters", "Documentation", "*.md")):
    with open(path, encoding="utf-8") as file:
        page = file.read()
    blocks += len(BLOCK.findall(page))
    wanted = BLOCK.sub(code, page)
    if wanted != page and os.environ.get("FEATUREHEX_UPDATE"):
        with open(path, "w", encoding="utf-8") as file:
            file.write(wanted)
    elif wanted != page:
        raise AssertionError(f"{path}: a block of code differs from its file; write it anew with "
                             "FEATUREHEX_UPDATE=1 python3 Testing/Python/TestTutorials.py")
assert blocks >= 3, blocks
