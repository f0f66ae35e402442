# SPDX-License-Identifier: BSD-3-Clause
"""Filter of Doxygen: a Markdown page of the repository as Doxygen 1.9.4 understands it.

On GitHub a heading has an anchor made from its words, and links name files. Here each heading gets
the same anchor explicitly, behind the name of its page, and links name anchors. Links of
contents.md make the tree of pages.
"""
import os
import re
import sys


def slug(heading: str) -> str:
    """The anchor that GitHub makes of a heading."""
    kept = re.sub(r"[^\w\- ]", "", heading.strip().lower())
    return kept.replace(" ", "-")


def anchor(page: str, section: str) -> str:
    if section:
        return f"{page}-{section}"
    return "mainpage" if page == "README" else page


def convert_link(match: re.Match, page: str) -> str:
    text, target = match.groups()
    path, _, section = target.partition("#")
    if path and not path.endswith(".md"):
        return match.group(0)
    name = os.path.basename(path)[:-3] if path else page
    command = "@subpage" if page == "contents" and not section else "@ref"
    words = " ".join(text.split())
    return f'{command} {anchor(name, section)} "{words}"'


def convert_code(match: re.Match) -> str:
    """A span of code in one line; Doxygen takes <name> in it for HTML."""
    code = match.group(1).replace("\n", " ")
    if "<" in code:
        return "<code>" + code.replace("&", "&amp;").replace("<", "&lt;") + "</code>"
    return f"`{code}`"


def fence_code(text: str) -> str:
    """Indented code, which Doxygen misses after a heading, between fences."""
    lines = []
    inside = False
    blank = True
    for line in text.split("\n"):
        indented = line.startswith("    ")
        if indented and blank and not inside:
            lines.append("```")
            inside = True
        elif inside and line and not indented:
            # The blank line before this one is not code.
            lines.insert(-1, "```")
            inside = False
        lines.append(line[4:] if inside and indented else line)
        blank = not line
    if inside:
        lines.append("```")
    return "\n".join(lines)


def convert(text: str, page: str) -> str:
    fences = re.compile(r"(^```.*?^```$)", re.MULTILINE | re.DOTALL)
    parts = fences.split(text)
    parts[::2] = [fence_code(part) for part in parts[::2]]
    parts = fences.split("".join(parts))
    for i in range(0, len(parts), 2):
        part = parts[i]
        part = re.sub(r"`([^`]+)`", convert_code, part)
        # A blank line or a picture in an item would end the list.
        part = re.sub(r"\n\n( {3,})(?=[^\s*\d-])", r"\n\1<br>", part)
        part = re.sub(r"^( +(?:<br>)?)!\[([^\]]+)\]\((?:\S*/)?(\S+)\)$",
                      r'\1@image{inline} html \3 "\2"', part, flags=re.MULTILINE)
        part = re.sub(r"(?<!!)\[([^\]]+)\]\(([^)\s]+)\)",
                      lambda match: convert_link(match, page), part)
        part = re.sub(r"^(##+) (.*)$",
                      lambda match: f"{match.group(0)} {{#{anchor(page, slug(match.group(2)))}}}",
                      part, flags=re.MULTILINE)
        part = re.sub(r"^(# .*)$", lambda match: f"{match.group(1)} {{#{anchor(page, '')}}}", part,
                      flags=re.MULTILINE)
        parts[i] = part
    return "".join(parts)


with open(sys.argv[1], encoding="utf-8") as file:
    sys.stdout.write(convert(file.read(), os.path.basename(sys.argv[1])[:-3]))
