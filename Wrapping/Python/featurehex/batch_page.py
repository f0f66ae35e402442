# SPDX-License-Identifier: BSD-3-Clause
"""Table and page of a batch: batch.tsv and index.html.

The page needs nothing but itself: pictures and charts are inside, and there are no scripts.
"""

import base64
import html
import math
import os
import statistics
import time
from typing import Any, Dict, List, Optional, Sequence, Tuple
from urllib.parse import quote

from .batch_model import Report, Settings, write

__all__ = ["row_of", "write_page", "write_table"]

Row = Dict[str, Any]

KINDS = ("corners", "curves", "patches")
COLUMNS = ["name", "status", "hexes", "msj", "asj", "hausdorff_percent", "valid", "seconds",
           "ms_per_hex", "peak_mb", "rounds"]
COLUMNS += [kind + suffix for kind in KINDS for suffix in ("", "_captured")] + ["error"]

_BAR, _AXIS = "#3b6ea5", "#555"
_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; color: #222; margin: 2em auto; max-width: 80em;
  padding: 0 1em; }
h1 { font-size: 1.6em; margin-bottom: 0; } h2 { font-size: 1.2em; margin-top: 2em; }
.charts { display: grid; gap: 1.5em; margin-top: 1.5em;
  grid-template-columns: repeat(auto-fit, minmax(min(30em, 100%), 1fr)); }
figure { margin: 0; } figcaption { color: #555; text-align: center; }
svg { width: 100%; height: auto; }
table { border-collapse: collapse; width: 100%; }
th, td { padding: .3em .5em; border-bottom: 1px solid #ddd; text-align: right; }
thead th { vertical-align: bottom; border-bottom: 2px solid #888; }
th:first-child, td:first-child, th.words, td.words { text-align: left; }
tbody th { font-weight: normal; } td { white-space: nowrap; } td.words { white-space: normal; }
.wide { overflow-x: auto; } .wide tbody th { overflow-wrap: anywhere; min-width: 9em; }
td img { display: block; }
.bad { color: #a01020; } .note { color: #555; }
.scale { display: inline-block; width: 12em; height: .8em; vertical-align: middle;
  background: linear-gradient(to right, #660066, #bf0d26, #e6661a, #facc40,
  #bfe073, #66c299, #4099cc, #3366bf); }
@media print { tr, figure { break-inside: avoid; } }
"""


def row_of(name: str, report: Report) -> Row:
    """A row of the table, by its columns."""
    status, figures = report["status"], report.get("figures", {})
    made = report.get("batch", {})
    row: Row = {"name": name, "status": status["code"], "valid": False,
                "seconds": made.get("seconds", report.get("seconds"))}
    if report.get("peak-memory-bytes"):
        row["peak_mb"] = round(report["peak-memory-bytes"] / 1e6)
    row["rounds"] = report.get("rounds", {}).get("count") or None
    if status["code"] != "Ok":
        row["error"] = status["message"]
        return row
    row["hexes"] = figures["NumberOfHexes"]
    row["msj"] = figures["MinimumScaledJacobian"]
    row["asj"] = figures["MeanScaledJacobian"]
    row["hausdorff_percent"] = 100 * figures["HausdorffUpper"]
    row["valid"] = figures["Valid"] == 1
    row["ms_per_hex"] = 1000 * row["seconds"] / row["hexes"]
    if "FeaturesCaptured" in figures:
        for kind in KINDS:
            row[kind] = figures[kind.capitalize() + "Enforced"]
            row[kind + "_captured"] = figures[kind.capitalize() + "Captured"]
        missed = ["%s %d %s" % (feature["kind"], feature["id"], feature["outcome"])
                  for feature in report.get("features", [])
                  if feature["outcome"] not in ("Captured", "NotEnforced")]
        if missed:
            row["error"] = "missed: " + ", ".join(missed[:5]) + (" ..." if missed[5:] else "")
    return row


def write_table(path: str, reports: Dict[str, Report]) -> None:
    """One line for each finished model. Tabs part the columns, the first line names them."""
    lines = ["\t".join(COLUMNS)]
    for name, report in reports.items():
        row = row_of(name, report)
        lines.append("\t".join(" ".join(_text(row.get(column)).split()) for column in COLUMNS))
    write(path, "\n".join(lines) + "\n")


def write_page(settings: Settings, names: Sequence[str], reports: Dict[str, Report]) -> None:
    """index.html of all models, also of those that aren't finished yet."""
    rows = [row_of(name, report) for name, report in reports.items()]
    good = [row for row in rows if row["status"] == "Ok"]
    failed = [row for row in rows if row["status"] != "Ok"]
    parts = ["<!DOCTYPE html>", "<html lang=\"en\">", "<head>", "<meta charset=\"utf-8\">",
             "<meta name=\"viewport\" content=\"width=device-width\">",
             "<title>FeatureHex batch: %d of %d models meshed</title>" % (len(good), len(names)),
             "<style>%s</style>" % _STYLE, "</head>", "<body>",
             "<h1>%d of %d models have a valid mesh</h1>" % (len(good), len(names)),
             "<p class=\"note\">%s</p>" % _escape(_subtitle(settings, len(names) - len(rows)))]
    if failed:
        parts += ["<h2 id=\"failed\">Without a mesh</h2>", _reasons(failed)]
    missed = [row for row in good if row.get("error")]
    if missed:
        parts += ["<h2 id=\"missed\">Sharp features missed</h2>", _reasons(missed)]
    if good:
        parts += ["<h2>Quality</h2>", _summary(good), _histograms(good)]
    if rows:
        parts += ["<h2 id=\"models\">All models</h2>", _models(settings, rows)]
    parts += ["</body>", "</html>"]
    write(os.path.join(settings.output, "index.html"), "\n".join(parts) + "\n")


def _subtitle(settings: Settings, missing: int) -> str:
    words = [settings.version, time.strftime("%Y-%m-%d %H:%M"),
             "options: " + (" ".join(settings.options) or "defaults"),
             "time limit %g s" % settings.time_limit if settings.time_limit else "no time limit",
             "memory limit %d MB" % (settings.memory_limit // 10**6) if settings.memory_limit
             else "no memory limit"]
    if missing:
        words.append("%d models are not finished yet" % missing)
    return ", ".join(words) + "."


def _summary(good: List[Row]) -> str:
    lines = []
    for title, key in (("Hexes", "hexes"), ("Minimum scaled Jacobian", "msj"),
                       ("Mean scaled Jacobian", "asj"),
                       ("Hausdorff ratio, % of the diagonal", "hausdorff_percent"),
                       ("Seconds", "seconds"), ("Milliseconds per hex", "ms_per_hex"),
                       ("Peak memory, MB", "peak_mb")):
        values = [row[key] for row in good if row.get(key) is not None]
        if values:
            lines.append(_cells([title, statistics.median(values), min(values), max(values)]))
    for kind in KINDS:
        wanted = sum(row.get(kind) or 0 for row in good)
        if wanted:
            met = sum(row[kind + "_captured"] for row in good if row.get(kind) is not None)
            lines.append("<tr><th scope=\"row\">%s captured</th><td colspan=\"3\">%d of %d, %.1f %%"
                         "</td></tr>" % (kind.capitalize(), met, wanted, 100 * met / wanted))
    return ("<table style=\"width: auto\"><thead><tr><th></th><th scope=\"col\">Median</th>"
            "<th scope=\"col\">Least</th><th scope=\"col\">Most</th></tr></thead>\n"
            "<tbody>%s</tbody></table>" % "\n".join(lines))


def _reasons(rows: List[Row]) -> str:
    """Why models have no mesh, or which sharp features theirs miss."""
    lines = ["<tr><th scope=\"row\"><a href=\"#%s\">%s</a></th><td class=\"words\">%s</td>"
             "<td class=\"words\">%s</td></tr>" % (
                 _anchor(row["name"]), _escape(row["name"]), _escape(_outcome(row)),
                 _escape(row["error"].replace("missed: ", ""))) for row in rows]
    heads = ("Captured", "Which") if rows[0]["status"] == "Ok" else ("Code", "Why, and what to do")
    return ("<table><thead><tr><th scope=\"col\">Model</th>%s</tr></thead>\n"
            "<tbody>%s</tbody></table>" % (
                "".join("<th scope=\"col\" class=\"words\">%s</th>" % head for head in heads),
                "\n".join(lines)))


def _outcome(row: Row) -> str:
    """In a word: the code of an error, or how many features are captured."""
    if row["status"] != "Ok":
        return str(row["status"])
    return "%d of %d" % (sum(row[kind + "_captured"] for kind in KINDS),
                         sum(row[kind] for kind in KINDS))


def _models(settings: Settings, rows: List[Row]) -> str:
    with_features = any("corners" in row for row in rows)
    heads = ["Picture", "Model", "Hexes", "MSJ", "ASJ", "HR %", "Time s", "ms / hex", "MB"]
    heads += [kind.capitalize() for kind in KINDS] if with_features else []
    lines = [_model(settings, row, with_features) for row in rows]
    return (
        "<p>MSJ, ASJ: least and mean of the hexes' scaled Jacobians, each the least of its 8 "
        "corners. HR: Hausdorff distance between mesh and surface, both ways, proven upper bound, "
        "in percent of the diagonal of the bounding box. Pictures: the mesh cut open, a hex "
        "coloured by its scaled Jacobian, 0 <span class=\"scale\"></span> 1; without a mesh, the "
        "surface."
        "%s"
        "</p>\n<div class=\"wide\"><table><thead><tr>%s</tr></thead>\n"
        "<tbody>%s</tbody></table></div>" % (
            " Corners, curves, patches: captured one to one / asked for."
            if with_features else "",
            "".join("<th scope=\"col\"%s>%s</th>" % (
                " class=\"words\"" if head == "Model" else "", head) for head in heads),
            "\n".join(lines)))


def _model(settings: Settings, row: Row, with_features: bool) -> str:
    name = row["name"]
    links = [(kind, path) for kind, path in (
        ("mesh", "meshes/%s.vtu" % name), ("report", "reports/%s.json" % name))
        if os.path.exists(os.path.join(settings.output, path))]
    title = "%s<br><small>%s</small>" % (
        _escape(name), " ".join("<a href=\"%s\">%s</a>" % (quote(path), kind)
                                for kind, path in links))
    cells = ["<td>%s</td>" % _picture(settings, name),
             "<th scope=\"row\" class=\"words\">%s</th>" % title]
    if row["status"] != "Ok":
        cells.append("<td class=\"words bad\" colspan=\"4\">%s</td>" % _escape(row["status"]))
    else:
        cells += ["<td>%s</td>" % _number(row[key])
                  for key in ("hexes", "msj", "asj", "hausdorff_percent")]
    cells += ["<td>%s</td>" % _number(row.get(key)) for key in ("seconds", "ms_per_hex", "peak_mb")]
    for kind in KINDS if with_features else ():
        wanted, met = row.get(kind), row.get(kind + "_captured")
        cells.append("<td%s>%s</td>" % (
            " class=\"bad\"" if met != wanted else "",
            "" if wanted is None else "%d / %d" % (met, wanted)))
    return "<tr id=\"%s\">%s</tr>" % (_anchor(name), "".join(cells))


def _picture(settings: Settings, name: str) -> str:
    try:
        with open(os.path.join(settings.output, "pictures", name + ".png"), "rb") as file:
            data = base64.b64encode(file.read()).decode("ascii")
    except OSError:
        return "no picture"
    return ("<img width=\"160\" height=\"160\" alt=\"Picture of %s\" "
            "src=\"data:image/png;base64,%s\">" % (_escape(name), data))


def _histograms(good: List[Row]) -> str:
    fractions = [i / 20 for i in range(21)]
    ratios = [row["hausdorff_percent"] for row in good]
    hexes = [row["hexes"] for row in good]
    low = math.floor(4 * math.log10(min(hexes)))
    high = math.floor(4 * math.log10(max(hexes))) + 1
    # Whole decades.
    low, high = 4 * math.floor(low / 4), 4 * math.ceil(high / 4)
    charts = (
        ("Minimum scaled Jacobian", [row["msj"] for row in good], fractions),
        ("Mean scaled Jacobian", [row["asj"] for row in good], fractions),
        ("Hausdorff ratio, % of the diagonal", ratios,
         [_ceiling(max(ratios)) * i / 20 for i in range(21)]),
        ("Hexes", hexes, [10 ** (i / 4) for i in range(low, high + 1)]))
    return "<div class=\"charts\">%s</div>" % "\n".join(
        "<figure>%s<figcaption>%s</figcaption></figure>" % (
            _histogram(title, values, edges), _escape(title)) for title, values, edges in charts)


def _ceiling(value: float) -> float:
    """The next of 1, 2, 5, 10, 20 ... times a power of ten."""
    power = 10.0 ** math.floor(math.log10(value)) if value > 0 else 1.0
    return next(step * power for step in (1, 2, 5, 10, 20) if step * power >= value * (1 - 1e-12))


def _counts(values: Sequence[float], edges: Sequence[float]) -> List[int]:
    """How many are in each bin, which has its lower edge; the last one has both."""
    counts = [0] * (len(edges) - 1)
    for value in values:
        place = sum(edge <= value for edge in edges) - 1
        counts[min(max(place, 0), len(counts) - 1)] += 1
    return counts


def _histogram(title: str, values: Sequence[float], edges: Sequence[float]) -> str:
    """An SVG picture; how many models are in each bin."""
    width, height, side, bottom, top = 360, 200, 28, 24, 14
    counts = _counts(values, edges)
    step = (width - 2 * side) / len(counts)
    unit = (height - bottom - top) / max(counts)
    base = height - bottom
    parts = ["<svg viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"%s of %d models\" "
             "font-family=\"sans-serif\" font-size=\"11\">" % (
                 width, height, _escape(title), len(values))]
    for i, count in enumerate(counts):
        if count:
            x, y = side + i * step, base - count * unit
            parts.append(
                "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"><title>"
                "%s to %s: %d</title></rect>" % (x + 0.5, y, max(1, step - 1), count * unit, _BAR,
                                                 _short(edges[i]), _short(edges[i + 1]), count))
            parts.append("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" font-size=\"9\">%d"
                         "</text>" % (x + step / 2, y - 2, count))
    parts.append("<path d=\"M%d %d H%d\" stroke=\"%s\"/>" % (side, base, width - side, _AXIS))
    for i in range(0, len(edges), 4):
        x = side + i * step
        parts.append("<path d=\"M%.1f %d v4\" stroke=\"%s\"/><text x=\"%.1f\" y=\"%d\" "
                     "text-anchor=\"middle\">%s</text>" % (x, base, _AXIS, x, base + 16,
                                                           _short(edges[i])))
    return "".join(parts) + "</svg>"


def _cells(values: Sequence[Any]) -> str:
    return "<tr><th scope=\"row\">%s</th>%s</tr>" % (
        _escape(values[0]), "".join("<td>%s</td>" % _number(value) for value in values[1:]))


def _number(value: Optional[float]) -> str:
    """For people: three decimals, or thousands with commas."""
    if value is None:
        return ""
    if isinstance(value, int) or abs(value) >= 1000:
        return "{:,.0f}".format(value)
    return "%.3f" % value if abs(value) < 10 else "%.1f" % value


def _short(value: float) -> str:
    if value >= 1000:
        return "{:,.0f}".format(value)
    return "%.2g" % value if value < 10 else "%.0f" % value


def _text(value: Any) -> str:
    """Of a cell of the table."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return "%.4g" % value if abs(value) < 1e4 else "%.0f" % value
    return str(value)


def _anchor(name: str) -> str:
    return "model-" + quote(name, safe="")


def _escape(text: str) -> str:
    return html.escape(str(text))
