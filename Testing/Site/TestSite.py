# SPDX-License-Identifier: BSD-3-Clause
"""The documentation site: Doxygen builds it without a warning, all pages are in it, and no link
inside it leads nowhere."""
import html.parser
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

SOURCE = pathlib.Path(os.environ["FEATUREHEX_SOURCE_DIR"])


class Page(html.parser.HTMLParser):
    """Anchors and links of a page."""

    def __init__(self, text: str):
        super().__init__()
        self.anchors: set[str] = set()
        self.links: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for key, value in attrs:
            if key in ("id", "name") and value:
                self.anchors.add(value)
            elif key in ("href", "src") and value:
                self.links.append(value)


def check_links(site: pathlib.Path, written: set[str]) -> int:
    """Files of all links; anchors of those in pages that people wrote."""
    pages = {path.name: Page(path.read_text(encoding="utf-8")) for path in site.glob("*.html")}
    number = 0
    for name, page in pages.items():
        for link in page.links:
            address = urllib.parse.urlsplit(link)
            if address.scheme or link.startswith("//"):
                continue
            target = urllib.parse.unquote(address.path) or name
            assert (site / target).exists(), f"{name}: {link}"
            if address.fragment and name in written:
                anchor = urllib.parse.unquote(address.fragment)
                assert anchor in pages[target].anchors, f"{name}: {link}"
            number += 1
    return number


if not shutil.which("doxygen"):
    print("Not tested: doxygen is missing.")
    sys.exit(77)

with tempfile.TemporaryDirectory() as folder:
    result = subprocess.run([SOURCE / "Wrapping" / "site", folder], check=False, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert result.returncode == 0, result.stdout
    site = pathlib.Path(folder)
    made = {path.name for path in site.glob("*.html")}
    written = {"index.html"}
    for page in (SOURCE / "Filters" / "Documentation").glob("*.md"):
        assert page.stem + ".html" in made, page
        written.add(page.stem + ".html")
        if page.stem != "contents":
            contents = (page.parent / "contents.md").read_text(encoding="utf-8")
            assert f"({page.name})" in contents, f"{page.name} is not in contents.md"
    for header in (SOURCE / "Filters").glob("*/vtk*.h"):
        assert f"class{header.stem}.html" in made, header
    print(len(made), "pages,", check_links(site, written), "links")
