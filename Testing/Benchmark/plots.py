# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of Testing/Benchmark/run. Without python3-matplotlib there are none, and that is said."""
import corpus

BLUE, GREY = "#2b6cb0", "#888888"
COLOURS = ["#1f77b4", "#ff7f0e", "#2ca02c", "#d62728", "#9467bd", "#8c564b", "#e377c2", "#7f7f7f",
           "#bcbd22", "#17becf", "#393b79", "#637939", "#8c6d31", "#843c39"]


def figure(**arguments):
    """(figure, axes), or (None, None)."""
    try:
        import matplotlib
    except ImportError:
        corpus.say("No picture: python3-matplotlib is missing (Wrapping/setup benchmark)")
        return None, None
    matplotlib.use("Agg")
    from matplotlib import pyplot
    return pyplot.subplots(**arguments)


def save(picture, path):
    picture.tight_layout()
    # Without the date and version of matplotlib: the same figures, the same file.
    picture.savefig(path, dpi=90, metadata={"Software": None})
    print("Picture: " + path)


def scaling(rows, name, path):
    """Time and memory against the number of hexes, both logarithmic."""
    picture, axes = figure(nrows=1, ncols=2, figsize=(9, 3.6))
    if not picture:
        return
    from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator
    hexes = [row["hexes"] for row in rows]
    for axis, key, title in zip(axes, ("seconds", "peak_mb"), ("wall time, s", "peak memory, MB")):
        values = [row[key] for row in rows]
        axis.loglog(hexes, values, "o-", color=BLUE, label=name)
        axis.loglog(hexes, [values[0] * h / hexes[0] for h in hexes], "--", color=GREY, label="linear")
        axis.set_xlabel("hexes, thousands")
        axis.set_ylabel(title)
        axis.xaxis.set_major_locator(FixedLocator(hexes))
        axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: "%.0f" % (value / 1000)))
        for locate in (axis.xaxis.set_minor_locator, axis.yaxis.set_major_locator,
                       axis.yaxis.set_minor_locator):
            locate(NullLocator())
        for count, value in zip(hexes, values):
            axis.annotate(format(value, ".3g"), (count, value), (0, -14), ha="center",
                          textcoords="offset points")
        axis.margins(y=0.15)
        axis.grid(True, color="#e5e5e5", linewidth=0.5)
        axis.legend(frameon=False)
    save(picture, path)


def stages(rows, path):
    """Share of each stage in the wall time, one bar for each model."""
    picture, axis = figure(figsize=(8, 3.0))
    if not picture:
        return
    left = {row["name"]: 0.0 for row in rows}
    # Those with features have the most stages, the others a part of them.
    order = max(([row["stage"] for row in rows if row["name"] == name] for name in left), key=len)
    for stage, colour in zip(order, COLOURS):
        percent = {row["name"]: row["percent"] for row in rows if row["stage"] == stage}
        axis.barh(list(percent), list(percent.values()), left=[left[name] for name in percent],
                  color=colour, label=stage)
        for name, value in percent.items():
            left[name] += value
    axis.set_xlabel("share of the wall time, %")
    axis.set_xlim(0, 100)
    axis.invert_yaxis()
    axis.legend(frameon=False, bbox_to_anchor=(1.0, 1.05), fontsize=8)
    save(picture, path)


def comparison(rows, title, path):
    """Ratios of wall times with their range and of processor times, one line for each thing measured."""
    picture, axis = figure(figsize=(7, 1.2 + 0.28 * len(rows)))
    if not picture:
        return
    for i, row in enumerate(rows):
        axis.plot([row["least"], row["largest"]], [i, i], color=GREY)
    lines = range(len(rows))
    axis.plot([row["ratio"] for row in rows], lines, "o", color=BLUE, label="wall time")
    axis.plot([row["cpu_ratio"] for row in rows], lines, "x", color="#000000", label="processor time")
    axis.axvline(1, color="#000000", linewidth=0.5)
    axis.legend(frameon=False, fontsize=8)
    axis.set_yticks(lines, [row["name"] for row in rows])
    axis.invert_yaxis()
    axis.set_xlabel(title)
    axis.grid(True, axis="x", color="#e5e5e5", linewidth=0.5)
    save(picture, path)
