"""The page in a browser: nothing is wider than the screen, all links end, readers hear it all."""

from __future__ import annotations

from base64 import b64decode
from collections import Counter
from collections.abc import Iterator
from io import BytesIO
from itertools import pairwise
from pathlib import Path

import pytest
from PIL import Image

from kowalevski_cas.notation import Vocabulary
from kowalevski_cas.notation import read as parse
from kowalevski_cas.report.document import Equations, Graph
from kowalevski_cas.report.graph import Drawing
from kowalevski_cas.report.html import render_html
from kowalevski_cas.report.marks import MARKS
from tests.report.browser import PROGRAM, Browser
from tests.report.fixtures import document, read

pytestmark = [pytest.mark.slow, pytest.mark.skipif(PROGRAM is None, reason="there is no Chromium")]

WIDE = """[...document.querySelectorAll("main *, header *")].filter(one =>
  one.getBoundingClientRect().right > innerWidth + 1 && !one.closest(".math, .graph"))
  .map(one => one.textContent.slice(0, 60))"""
CUT = """[...document.querySelectorAll(".math")].filter(one =>
  one.getClientRects().length && one.scrollWidth > one.clientWidth + 1).length"""
FLAT = """[...document.querySelectorAll("math")].filter(one =>
  one.getClientRects().length && one.getBoundingClientRect().height < 5).length"""
BESIDE = """[...document.querySelectorAll(".display > .label:has(math)")].filter(one =>
  one.getBoundingClientRect().top < one.previousSibling.getBoundingClientRect().bottom)"""
NARROWED = "one.previousSibling.scrollWidth > one.previousSibling.clientWidth + 1"
LETTERS = """(svg => 2.45 * svg.getBoundingClientRect().width / svg.viewBox.baseVal.width)(
  document.querySelector(".graph svg"))"""
DEAD = """[...document.querySelectorAll("a[href^='#'], a[*|href^='#']")].map(one =>
  one.getAttribute("href") || one.getAttribute("xlink:href"))
  .filter(href => !document.getElementById(href.slice(1)))"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    folder = tmp_path_factory.mktemp("browser")
    page = folder / "page.html"
    page.write_text(render_html(document()), encoding="utf-8")
    with Browser(folder / "user") as browser:
        browser.show(page)
        browser.value("document.querySelectorAll('details').forEach(one => one.open = true)")
        yield browser


@pytest.mark.parametrize("pixels", [380, 768, 1280])
@pytest.mark.parametrize("paper", [False, True], ids=["screen", "paper"])
def test_nothing_is_wider_than_the_screen(browser: Browser, pixels: int, paper: bool) -> None:
    browser.width(pixels, paper)
    assert browser.value(WIDE) == []
    assert browser.value("document.documentElement.scrollWidth <= innerWidth")
    assert browser.value(FLAT) == 0  # every formula that is shown has been set
    if pixels > 500:  # a telephone may scroll a display
        assert browser.value(CUT) == 0


def test_what_stands_beside_a_formula_leaves_it_its_room(browser: Browser) -> None:
    browser.width(1280)
    assert browser.value(f"{BESIDE}.length") > 0
    browser.width(380)
    assert browser.value(f"{BESIDE}.filter(one => {NARROWED}).length") == 0


@pytest.mark.parametrize("pixels", [380, 768, 1280])
def test_what_stands_in_boxes_is_neither_small_nor_huge(tmp_path: Path, pixels: int) -> None:
    page = tmp_path / "page.html"
    with Browser(tmp_path / "user") as browser:
        for width in (45, 80, 150, 260):
            graph = Graph(Drawing((), (), width, 19.0))
            page.write_text(render_html(document()._replace(blocks=(graph,))), encoding="utf-8")
            browser.show(page)
            browser.width(pixels)
            assert 9 <= browser.value(LETTERS) <= 14


@pytest.mark.parametrize("letter", ["x", "M", r"\theta", r"\lambda", r"\beta"])
def test_a_dot_stands_clear_of_its_letter(letter: str, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    words = Vocabulary(scalars=frozenset({letter}))
    shown = Equations((parse(rf"\dot {letter}=0", words),), "")
    page.write_text(render_html(document()._replace(blocks=(shown,))), encoding="utf-8")
    with Browser(tmp_path / "user") as browser:
        browser.show(page)
        browser.width(800)
        box = browser.value(
            "(one => ({x: one.x, y: one.y - 4, width: one.width, height: one.height + 4}))"
            "(document.querySelector('mover').getBoundingClientRect())"
        )
        taken = browser("Page.captureScreenshot", format="png", clip={**box, "scale": 4})
    picture = Image.open(BytesIO(b64decode(taken["data"]))).convert("L")
    width, height = picture.size
    inked = [picture.crop((0, y, width, y + 1)).getextrema()[0] < 128 for y in range(height)]
    assert sum(here and not above for above, here in pairwise([False, *inked])) == 2


def test_every_link_ends_somewhere(browser: Browser) -> None:
    assert browser.value("document.querySelectorAll('a[href^=\"#\"]').length") > 50
    assert browser.value(DEAD) == []


def test_marks_and_formulas_are_in_the_accessibility_tree(browser: Browser) -> None:
    browser.width(1280)
    roles = browser.roles()
    shown = browser.value(
        "[...document.querySelectorAll('math')].filter(one => one.getClientRects().length).length"
    )
    counted = Counter(role for role, _ in roles)
    assert counted["MathMLMath"] + counted["math"] == shown > 100
    images = Counter(name for role, name in roles if role in ("image", "img"))
    marks = browser.value(
        "[...document.querySelectorAll('.mark')].filter(one => one.getClientRects().length).length"
    )
    assert sum(images[mark.word] for mark in MARKS.values()) == marks > 20


def test_it_loads_nothing(browser: Browser) -> None:
    assert browser.value("document.querySelectorAll('script[src], link, iframe').length") == 0
    assert browser.value("performance.getEntriesByType('resource').length") == 0


POINT = """(([link, kind]) => { link.dispatchEvent(new PointerEvent(kind, {pointerType: 'mouse'}));
  const glance = document.querySelector('.glance'), place = glance.getBoundingClientRect();
  return [glance.hidden, glance.textContent.includes('(14)') || glance.querySelectorAll('math').length,
    place.left >= 0 && place.right <= innerWidth, glance.querySelectorAll('[id]').length]; })"""
PRESS = """(button => { let copied = ''; document.execCommand = () => {
  copied = document.activeElement.value ?? document.querySelector('textarea').value; };
  navigator.clipboard && (navigator.clipboard.writeText = async text => { copied = text; });
  button.click(); return new Promise(done => setTimeout(() => done(copied), 50)); })"""


def test_a_link_shows_what_it_leads_to(browser: Browser) -> None:
    for pixels in (380, 1280):
        browser.width(pixels)
        link = 'document.querySelector(\'main > p a[href^="#claim"], .claim a[href^="#claim"]\')'
        hidden, formulas, inside, ids = browser.value(f"{POINT}([{link}, 'pointerenter'])")
        assert (hidden, inside, ids) == (False, True, 0) and formulas
        assert browser.value(f"{POINT}([{link}, 'pointerleave'])")[0]


NEAR = """(([link, kind]) => { link.dispatchEvent(new PointerEvent(kind));
  const lines = [...document.querySelectorAll('.graph .line')], own = link.getAttribute('href').slice(7);
  const near = link => link.classList.contains('near');
  return [lines.every(line => near(line) === line.dataset.ends.split(' ').includes(own)),
    lines.filter(near).length, [...document.querySelectorAll('.graph a')].filter(near).length,
    near(link)]; })"""


def test_a_box_shows_its_lines_and_the_boxes_at_their_ends(browser: Browser) -> None:
    for k in range(3):
        box = f"document.querySelectorAll('.graph a')[{k}]"
        exact, lines, boxes, own = browser.value(f"{NEAR}([{box}, 'pointerenter'])")
        assert exact and lines >= 1 and boxes >= 1 and not own
        assert browser.value(f"{NEAR}([{box}, 'pointerleave'])")[1:3] == [0, 0]


def test_formulas_and_errata_are_copied_as_tex(browser: Browser) -> None:
    buttons = "[...document.querySelectorAll('.copy button')]"
    assert browser.value(f"{buttons}.every(one => !one.parentElement.hidden)")
    texts = browser.value(f"{buttons}.map(one => [one.textContent, one.dataset.text])")
    assert all(text for _, text in texts)
    errata = [text for words, text in texts if words == "copy erratum"]
    assert errata and all(": for $" in text or ": it is false that " in text for text in errata)
    assert browser.value(f"{PRESS}({buttons}[0])") == texts[0][1]


BARS = """[...document.querySelectorAll('.bar')].filter(bar => bar.getClientRects().length).map(bar => {
  const inner = document.createRange(); inner.selectNodeContents(bar);
  return [bar.getBoundingClientRect().width, inner.getBoundingClientRect().width,
          parseFloat(getComputedStyle(bar).borderTopWidth)]; })"""
ROOTS = """[...document.querySelectorAll('msqrt, mfrac')].filter(one =>
  one.getClientRects().length).map(one => [one.getBoundingClientRect().width,
  Math.max(...[...one.children].map(child => child.getBoundingClientRect().width))])"""
BRACKETS = """[...document.querySelectorAll('mrow')].filter(row => row.getClientRects().length
  && row.children.length > 2 && row.firstChild.matches('mo:not([stretchy])')
  && '([|'.includes(row.firstChild.textContent)).map(row => {
  const high = [...row.children].slice(1, -1).map(one => one.getBoundingClientRect().height);
  return [row.firstChild.getBoundingClientRect().height, Math.max(...high)]; })"""
PRIMES = """[...document.querySelectorAll('mo')].filter(one => one.getClientRects().length
  && /^′+$/.test(one.textContent)).map(one => {
  const letter = (one.closest('mpadded') ?? one).previousSibling.getBoundingClientRect();
  const prime = one.getBoundingClientRect();
  return [letter.top - prime.top, prime.height, letter.height]; })"""
EXPONENTS = """[...document.querySelectorAll('msup')].filter(one => one.getClientRects().length
  && one.textContent.startsWith(')')).map(one => [one.firstChild, one.lastChild].map(
  part => part.getBoundingClientRect())).map(([bracket, power]) => [bracket.top - power.top,
  power.height])"""


SIGNS = (
    r"\overline{x_2z_1w_1}=\overline{U_1}+\bar x_1+\overline{\frac{x_1}{x_2}}",
    r"U_1'=\frac{1}{\sqrt{x_1x_2}}\left(\frac{z_1}{x_1}+\sqrt{\frac{x_1}{x_2}}\right)^2",
    r"(\overline{z_1+w_1})'=\sqrt{1+\frac{x_1}{1+\frac{z_1}{w_1}}}",
    r"U_1''=(x_1^2-z_1^2)^2",
)


def test_signs_are_as_large_as_what_they_cover(tmp_path: Path) -> None:
    """Bars, radicals, lines of fractions and brackets: to a tenth; primes and powers stay low."""
    page = tmp_path / "page.html"
    shown = tuple(Equations(read(tex)) for tex in SIGNS)
    assert all(display.formulas for display in shown)
    page.write_text(render_html(document()._replace(blocks=shown)), encoding="utf-8")
    with Browser(tmp_path / "user") as browser:
        browser.show(page)
        browser.width(1280)
        measured = (BARS, ROOTS, BRACKETS, PRIMES, EXPONENTS)
        bars, roots, brackets, primes, powers = map(browser.value, measured)
    assert [*map(len, (bars, roots, brackets, primes, powers))] == [5, 9, 1, 3, 1]
    assert all(abs(bar - inner) <= 0.1 * inner and line >= 1 for bar, inner, line in bars)
    assert all(inner <= whole for whole, inner in roots)
    assert all(bracket >= 0.9 * inner for bracket, inner in brackets)
    assert all(above <= 0.3 * letter and high <= 1.5 * letter for above, high, letter in primes)
    assert all(above <= 0.8 * high for above, high in powers)
