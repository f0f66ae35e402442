# SPDX-License-Identifier: BSD-3-Clause
"""The page of a batch in a browser, where there is Chromium: everything is seen, nothing is asked
from elsewhere, and a narrow window needs no scrolling sideways."""
import os
import tempfile

import browser
import numpy
from batches import CAN_DRAW, FAST, GOOD, NAMES, make_models, run
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

QUESTION = """{
  mode: document.compatMode,
  images: [...document.images].map(image => [image.complete, image.naturalWidth, image.width]),
  charts: [...document.querySelectorAll("svg")].map(chart => [
    chart.getBoundingClientRect().width, chart.querySelectorAll("rect").length,
    [...chart.querySelectorAll("text")].every(text => {
      const inner = text.getBoundingClientRect(), outer = chart.getBoundingClientRect();
      return inner.left >= outer.left - 1 && inner.right <= outer.right + 1 &&
        inner.top >= outer.top - 1 && inner.bottom <= outer.bottom + 1; })]),
  rows: [...document.querySelectorAll("div table tbody tr")].map(row => row.cells.length),
  heads: [...document.querySelectorAll("div table thead th")].length,
  wide: document.documentElement.scrollWidth, window: innerWidth,
  loaded: performance.getEntriesByType("resource").filter(
    entry => !entry.name.startsWith("data:")).length,
  text: document.body.innerText }"""


def check(seen):
    assert seen["mode"] == "CSS1Compat" and seen["loaded"] == 0, seen
    assert len(seen["images"]) == (len(GOOD) + 1 if CAN_DRAW else 0)
    assert all(image == [True, 320, 160] for image in seen["images"]), seen["images"]
    assert len(seen["charts"]) == 4
    assert all(width > 200 and bars >= 1 and inside for width, bars, inside in seen["charts"]), seen
    assert len(seen["rows"]) == len(NAMES)
    # One cell of a failed model is four wide.
    assert set(seen["rows"]) == {seen["heads"], seen["heads"] - 3}, seen
    for words in (*NAMES, "3 of 6 models have a valid mesh", "Close the holes"):
        assert words in seen["text"], words


def check_screenshot(path):
    """The blue of the bars, and the colours of the pictures where there are some."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    bars = (abs(pixels - [0x3b, 0x6e, 0xa5]).max(axis=1) < 8).sum()
    colours = len(numpy.unique(pixels // 32, axis=0))
    assert bars > 1000 and colours > (30 if CAN_DRAW else 5), (bars, colours)


if browser.find():
    with tempfile.TemporaryDirectory() as place:
        models, out = os.path.join(place, "models"), os.path.join(place, "out")
        make_models(models)
        run(1, models, out, *FAST)
        page = os.path.join(out, "index.html")
        for width in (1280, 800):
            seen = browser.ask(page, width, QUESTION)
            check(seen)
            assert seen["wide"] <= seen["window"] == width, (seen["wide"], seen["window"], width)
        picture = os.path.join(os.environ["FEATUREHEX_TEMPORARY_DIR"], "batch-page.png")
        browser.screenshot(page, picture, 1280, 2400)
        check_screenshot(picture)
        print("seen by", browser.find())
else:
    print("Not tested:", browser.MISSING)
