# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's help has a page for each proxy of the plugin, under the address that it asks for."""
import base64
import glob
import os
import sqlite3
import xml.etree.ElementTree as ElementTree
import zlib

SOURCE = os.environ["FEATUREHEX_SOURCE_DIR"]
HELP = os.path.join(os.environ["FEATUREHEX_BINARY_DIR"], "Plugin", "paraview_help", "FeatureHex.qch")


def check_pages():
    database = sqlite3.connect(HELP)
    # pqHelpReaction: qthelp://<namespace>/<namespace up to its dot>/<group>.<proxy>.html
    assert list(database.execute("SELECT Name FROM NamespaceTable")) == [("FeatureHex.org",)]
    assert list(database.execute("SELECT Name FROM FolderTable")) == [("FeatureHex",)]
    pages = {}
    for name, data in database.execute("SELECT Name, Data FROM FileNameTable "
                                       "JOIN FileDataTable ON FileId = Id WHERE Name != ''"):
        # Qt's compression: four bytes with the size, then zlib.
        pages[name] = " ".join(zlib.decompress(data[4:]).decode().split())
    number = 0
    for path in glob.glob(os.path.join(SOURCE, "Plugin", "Resources", "*.xml")):
        for group in ElementTree.parse(path).iter("ProxyGroup"):
            for proxy in group:
                name = f"{group.get('name')}.{proxy.get('name')}.html"
                if group.get("name") not in ("filters", "sources", "writers"):
                    continue
                assert name in pages, f"{name}: no page"
                number += 1
                for element in proxy:
                    text = element.findtext("Documentation")
                    if "Property" in element.tag and text and element.get(
                            "panel_visibility") != "never":
                        words = " ".join(text.split()[:5])
                        assert words in pages[name], f"{name}: {words}"
    assert number >= 18, number
    print(number, "pages")


def check_plugin():
    """The file is in the plugin, as text."""
    with open(HELP, "rb") as file:
        start = base64.b64encode(file.read(48))
    with open(os.environ["FEATUREHEX_PLUGIN"], "rb") as file:
        assert start in file.read(), "the plugin doesn't hold its help"


if os.path.exists(HELP):
    check_pages()
    check_plugin()
else:
    print("Not tested: qttools5-dev or qtxmlpatterns5-dev-tools is missing.")
