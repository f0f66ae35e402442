# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView says of a property is what its class says: the first sentences are the same."""
import glob
import os
import re
import xml.etree.ElementTree as ElementTree

SOURCE = os.environ["FEATUREHEX_SOURCE_DIR"]


def first_sentence(text: str) -> str:
    """Without blanks: "FeatureAngle" of C++ is "Feature Angle" in the panel."""
    sentence = re.match(r"(.*?)([.:;]\s|$)", " ".join(text.split()) + " ")
    return sentence.group(1).replace(" ", "").rstrip(".")


def comments_of(cls: str) -> dict[str, str]:
    """The doc comment of each property of a class and of the classes above it."""
    text = headers[cls]
    found: dict[str, str] = {}
    for comment, code in re.findall(r"/\*\*(.*?)\*/(.*?)(?=/\*\*|\Z)", text, re.DOTALL):
        comment = re.sub(r"^\s*\* ?", "", comment, flags=re.MULTILINE)
        names = re.findall(r"vtk(?:Set|Get)\w*Macro\((\w+)|void Set(\w+)\(", code)
        for name in names:
            found.setdefault(name[0] or name[1], comment)
    above = re.search(r"class \S+ \w+ : public (\w+)", text)
    if above and above.group(1) in headers:
        found = {**comments_of(above.group(1)), **found}
    return found


headers = {}
for path in glob.glob(os.path.join(SOURCE, "Filters", "*", "vtk*.h")):
    with open(path, encoding="utf-8") as file:
        headers[os.path.basename(path)[:-2]] = file.read()

compared = 0
different = []
for path in sorted(glob.glob(os.path.join(SOURCE, "Plugin", "Resources", "*.xml"))):
    for proxy in ElementTree.parse(path).iter():
        if proxy.get("class") not in headers or "Proxy" not in proxy.tag:
            continue
        comments = comments_of(proxy.get("class"))
        for element in proxy:
            text = element.findtext("Documentation")
            if "VectorProperty" not in element.tag or not text:
                continue
            name = element.get("name")
            compared += 1
            if first_sentence(comments.get(name, "")) != first_sentence(text):
                different.append(f"{proxy.get('class')}::{name}: C++ {comments.get(name)!r}, "
                                 f"ParaView {' '.join(text.split())!r}")
assert not different, "\n".join(different)
assert compared >= 50, compared
print(compared, "properties")
