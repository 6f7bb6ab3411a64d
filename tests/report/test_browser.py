"""The page in a browser: nothing is wider than the screen, nothing is cut off."""

import html
import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from kowalevski_cas.report import render_html
from tests.report.fixtures import document

BROWSER = shutil.which("chromium") or shutil.which("google-chrome")
OPTIONS = """--headless --no-sandbox --disable-gpu --disable-quic --no-first-run
--disable-background-networking --disable-component-update --disable-sync
--virtual-time-budget=5000 --dump-dom""".split()
FRAME = """<!DOCTYPE html><title></title><iframe id="page" style="border:0" srcdoc="{page}"></iframe>
<script>
const page = document.getElementById("page");
page.onload = () => {{
  const inner = page.contentDocument, found = {{}};
  inner.querySelectorAll("details").forEach(one => one.open = true);
  for (const width of [380, 800, 1280]) {{
    page.style.width = width + "px";
    const wide = [...inner.querySelectorAll("body *")].filter(
      one => one.getBoundingClientRect().right > width + 1 && !one.closest(".math, .graph"));
    const cut = [...inner.querySelectorAll(".math")].filter(one => one.scrollWidth > one.clientWidth + 1);
    found[width] = {{wide: wide.map(one => one.textContent.slice(0, 60)), cut: cut.length,
      scrolls: inner.documentElement.scrollWidth > width}};
  }}
  found.heights = [...inner.querySelectorAll("math")].filter(one =>
    one.getClientRects().length && one.getBoundingClientRect().height < 5).length;
  document.title = JSON.stringify(found);
}};
</script>"""


@pytest.mark.slow
@pytest.mark.skipif(BROWSER is None, reason="there is no Chromium")
def test_nothing_is_wider_than_the_screen(tmp_path: Path) -> None:
    frame = tmp_path / "frame.html"
    page = html.escape(render_html(document()), quote=True)
    frame.write_text(FRAME.format(page=page), encoding="utf-8")
    done = subprocess.run(
        [BROWSER, *OPTIONS, f"--user-data-dir={tmp_path / 'user'}", frame.as_uri()],
        capture_output=True, text=True, timeout=60, check=True,
    )  # fmt: skip
    title = re.search(r"<title>(.*?)</title>", done.stdout, re.DOTALL)
    assert title is not None and title[1], "the page was not laid out"
    found = json.loads(html.unescape(title[1]))
    for width in ("380", "800", "1280"):
        assert found[width]["wide"] == [] and not found[width]["scrolls"]
    assert found["800"]["cut"] == found["1280"]["cut"] == 0  # a telephone may scroll a display
    assert found["heights"] == 0  # every formula that is shown has been set
