# SPDX-License-Identifier: BSD-3-Clause
"""Every text with which something fails is in why-did-it-fail.md, and nothing else is.

The texts are the string literals of the sources: words between which values are put together.
"""
import ast
import glob
import os
import re

SOURCE = os.environ.get("FEATUREHEX_SOURCE_DIR") or os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__))))
PAGE = os.path.join(SOURCE, "Filters", "Documentation", "why-did-it-fail.md")
FOLDERS = ["Filters/Core", "Filters/Pipeline", "Filters/IO", "Wrapping/CommandLine",
           "Wrapping/Python"]

# Statements whose texts are no reason for a failure, by what is in their code, and why.
EXCEPTED_CODE = [
    (r"BeginPhase|StageClock|StagePromise", "names of phases and stages"),
    (r"add_option|add_flag|add_subcommand|AddNumber|CLI::App |->check\(Within|->footer|"
     r"ToleranceHelp|ExitCodeHelp", "text of --help"),
    (r"report\.Notes|notes\.push_back", "what the clean-up of features did: no failure"),
    (r"this->Out\b", "what writers write"),
]
EXCEPTED_FILES = {
    "Filters/Core/ShellTopology.cxx": "its report, which only tests print",
    "Filters/Core/Tables/DualTemplates.h": "names of templates",
    "Wrapping/CommandLine/Figures.cxx": "the table of figures that check prints",
    "Wrapping/CommandLine/ExitCode.cxx": "text of --help",
    "Wrapping/Python/featurehex/batch_page.py": "the page of a batch; its reasons are from reports",
    "Wrapping/Python/featurehex/picture.py": "a program of its own that draws",
}
EXCEPTED_TEXTS = {
    "*SURFACE, NAME=": "what a writer writes",
    "$EndNodes $Elements": "what a writer writes",
    "missing surface": "a reason of refinement points: no failure",
    "models have a valid mesh:": "the end of a batch",
    "hexes, scaled Jacobian >=": "a model of a batch that went well",
    "featurehex: InvalidOption:": "the beginning of another text, taken off",
    "-screen 0 1280x1024x24 -noreset": "an option of Xvfb",
    "Deviation / tolerance": "a title of a view",
    "Scaled Jacobian": "a title of a view",
    "Hex Quality": "a title of a view",
    "boundary quads": "a title of an axis",
    "hex quality": "a name of a link of cameras",
    "Surface With Edges": "a value of a property of ParaView",
    "Single Color": "a value of a property of ParaView",
    "Feature Hex Mesher": "what nothing was found of, in another text",
}
# Of Python calls: text of --help.
EXCEPTED_CALLS = {"add_argument", "_Parser", "ArgumentParser"}

CPP_TOKEN = re.compile(
    r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)\'|[;{}]|[^"\'/;{}]+|[/\']', re.S)
FORMAT = re.compile(r"%[-+.0-9]*z?[dfgrsu](?![A-Za-z])|%%")


def words(text):
    """How many words between spaces."""
    return sum(re.search("[A-Za-z]", word) is not None for word in text.split())


def normal(text):
    return " ".join(text.split())


def cpp_statements(text):
    """(line, code, [literals]) of each statement; literals side by side are one."""
    text = re.sub(r"^[ \t]*#(?:[^\n\\]|\\.)*", "", text, flags=re.M | re.S)
    text = re.sub(r"(?<=[0-9])'(?=[0-9])", "", text)
    code, literals, line, start, joined = "", [], 1, 1, False
    for token in CPP_TOKEN.findall(text):
        if token[0] == '"':
            start = start if literals else line
            value = token[1:-1].replace('\\"', '"').replace("\\n", "\n")
            if joined:
                literals[-1] += value
            else:
                literals.append(value)
            joined = True
        elif token in (";", "{", "}"):
            if literals:
                yield start, code, literals
            code, literals, joined = "", [], False
        elif not token.startswith(("//", "/*")):
            code += token
            joined = joined and not token.strip()
        line += token.count("\n")


def cpp_texts(path, name):
    with open(path, encoding="utf-8") as file:
        for line, code, literals in cpp_statements(file.read()):
            if not any(re.search(pattern, code) for pattern, _ in EXCEPTED_CODE):
                yield "%s:%d" % (name, line), [
                    piece for literal in literals for piece in FORMAT.split(literal)]


def python_texts(path, name):
    """Each text that is no docstring and no help."""
    with open(path, encoding="utf-8") as file:
        tree = ast.parse(file.read())

    def visit(node):
        if isinstance(node, ast.Call):
            function = node.func
            if getattr(function, "id", getattr(function, "attr", "")) in EXCEPTED_CALLS:
                return
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            return
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield "%s:%d" % (name, node.lineno), FORMAT.split(node.value)
        for child in ast.iter_child_nodes(node):
            yield from visit(child)

    yield from visit(tree)


def source_texts():
    """(place, pieces) of each text, in the order of files."""
    for folder in FOLDERS:
        for path in sorted(glob.glob(os.path.join(SOURCE, folder, "**"), recursive=True)):
            name = os.path.relpath(path, SOURCE)
            if name in EXCEPTED_FILES or "/examples/" in name:
                continue
            if path.endswith((".cxx", ".h")):
                yield from cpp_texts(path, name)
            elif path.endswith(".py"):
                yield from python_texts(path, name)


def required(pieces):
    """Pieces of three words and more, and the longest one of two."""
    pieces = [normal(piece) for piece in pieces]
    longest = max(pieces, key=len, default="")
    return [piece for piece in pieces
            if words(piece) >= 3 or piece is longest and words(piece) == 2]


def page_texts(page):
    """The pieces of texts on the page: code of four words and more, between <values>."""
    for span in re.findall(r"`([^`]+)`", page):
        if words(span) >= 4:
            for piece in re.split(r"<[^<>]*>", span):
                if words(piece) >= 3:
                    yield normal(piece)


def exit_codes():
    """{name of a StatusCode: exit code}"""
    folder = os.path.join(SOURCE, "Wrapping", "CommandLine")
    with open(os.path.join(folder, "ExitCode.h"), encoding="utf-8") as file:
        text = re.sub(r"//[^\n]*", "", file.read())
    body = re.search(r"enum class ExitCode[^{]*\{(.*?)\}", text, re.S).group(1)
    numbers, value = {}, -1
    for entry in body.split(","):
        match = re.match(r"\s*(\w+)\s*(?:=\s*(\d+))?", entry)
        if match:
            value = int(match.group(2)) if match.group(2) else value + 1
            numbers[match.group(1)] = value
    with open(os.path.join(folder, "ExitCode.cxx"), encoding="utf-8") as file:
        text = file.read()
    result, waiting = {}, []
    for code, exit_name in re.findall(r"case StatusCode::(\w+):|return ExitCode::(\w+);", text):
        if code:
            waiting.append(code)
        else:
            result.update((code, numbers[exit_name]) for code in waiting)
            waiting = []
    return result


def status_codes():
    with open(os.path.join(SOURCE, "Filters/Core/Status.h"), encoding="utf-8") as file:
        body = re.search(r"names\[\] = \{(.*?)\}", file.read(), re.S).group(1)
    return re.findall(r'"(\w+)"', body)


def main():
    with open(PAGE, encoding="utf-8") as file:
        page = file.read()
    plain = normal(page)
    texts = list(source_texts())
    problems = []

    checked = 0
    for place, pieces in texts:
        for piece in required(pieces):
            checked += 1
            if piece not in plain and piece not in EXCEPTED_TEXTS:
                problems.append('%s: not in why-did-it-fail.md: "%s"' % (place, piece))
    # The sources are there, and the literals were found.
    assert checked > 300, "Only %d texts found under %s" % (checked, SOURCE)

    known = "\n".join(normal(piece) for _, pieces in texts for piece in pieces)
    problems += ['why-did-it-fail.md: no source says "%s"' % piece
                 for piece in page_texts(page) if piece not in known]

    exits = exit_codes()
    for code in status_codes():
        if code != "Ok" and not re.search(
                r"^\| `%s` \| %d \|" % (code, exits[code]), page, re.M):
            problems.append("why-did-it-fail.md: no row | `%s` | %d |" % (code, exits[code]))
        if code != "Ok" and not re.search(r"^## .*\b%s\b" % code, page, re.M):
            problems.append("why-did-it-fail.md: no section for " + code)
    if problems:
        raise AssertionError("%d problems:\n%s" % (len(problems), "\n".join(problems)))
    print("%d texts are documented." % checked)


if __name__ == "__main__":
    main()
