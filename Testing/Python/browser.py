# SPDX-License-Identifier: BSD-3-Clause
"""A browser without a window: what it makes of a page, and pictures of it."""
import html
import json
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any

NAMES = ("chromium", "chromium-browser", "google-chrome")
MISSING = "there is no browser: Wrapping/setup browser installs Chromium (400 MB)."


def find() -> str:
    """Path of a browser, "" where there is none."""
    return next(filter(None, map(shutil.which, NAMES)), "")


def _start(*arguments: str) -> str:
    with tempfile.TemporaryDirectory() as home:
        done = subprocess.run(
            [find(), "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
             "--user-data-dir=" + os.path.join(home, "profile"), *arguments],
            env={**os.environ, "HOME": home}, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            timeout=120, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:].replace("ERROR:", "error ")
    return done.stdout


def ask(page: str, width: int, question: str) -> Any:
    """The value of an expression of JavaScript when the page is loaded in a window of this width."""
    script = ("<pre id=\"answer\"></pre><script>addEventListener(\"load\", () => { "
              "document.getElementById(\"answer\").textContent = JSON.stringify(%s); });</script>"
              "</body>" % question)
    copy = Path(page).absolute().with_name("question.html")
    copy.write_text(Path(page).read_text(encoding="utf-8").replace("</body>", script),
                    encoding="utf-8")
    try:
        dom = _start("--window-size=%d,900" % width, "--virtual-time-budget=5000", "--dump-dom",
                     copy.as_uri())
    finally:
        copy.unlink()
    answer = re.search(r'<pre id="answer">(.*?)</pre>', dom, re.DOTALL)
    assert answer, dom[-2000:]
    return json.loads(html.unescape(answer.group(1)))


def screenshot(page: str, picture: str, width: int, height: int) -> None:
    """PNG of the top of a page."""
    _start("--window-size=%d,%d" % (width, height), "--screenshot=" + picture,
           Path(page).absolute().as_uri())
