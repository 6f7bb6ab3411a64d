"""One document in three formats: the same words, the same formulas, always the same bytes."""

import json
import re
import subprocess
import sys
from collections.abc import Callable
from html.parser import HTMLParser
from importlib.resources import files
from itertools import product
from pathlib import Path

import pytest

from kowalevski_cas.notation import Negative, Number, Relation
from kowalevski_cas.notation.formula import Changed
from kowalevski_cas.notation.mathml import to_mathml
from kowalevski_cas.notation.typst import to_typst
from kowalevski_cas.report.contents import Contents
from kowalevski_cas.report.document import Code, Document, Emphasis, Sign, Text
from kowalevski_cas.report.html import HtmlWriter, render_html
from kowalevski_cas.report.latex import LatexWriter, render_latex
from kowalevski_cas.report.pdf import has_latex, latex_pdf
from kowalevski_cas.report.typst import TypstWriter, render_typst
from kowalevski_cas.verify.outcome import Verdict
from tests.report.fixtures import claim, document, in_order, outcomes, read, run

Renders = Callable[[Document], str]
RENDERS = (render_html, render_latex, render_typst)
ALL = pytest.mark.parametrize("render", RENDERS)


class Page(HTMLParser):
    """What is in a page: ids, links, the names of elements, and the words outside of formulas."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.ids: list[str] = []
        self.links: list[str] = []
        self.open: list[str] = []
        self.names: set[str] = set()
        self.marks: list[dict[str, str | None]] = []
        self.words = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = dict(attrs)
        self.ids += [found["id"] or ""] if "id" in found else []
        self.links += [found["href"] or ""] if tag == "a" else []
        self.names.add(tag)
        self.marks += [found] if "mark" in (found.get("class") or "").split() else []
        if tag not in ("meta", "img", "input"):
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.words += "" if {"math", "style", "script"} & {*self.open} else data


@pytest.fixture(scope="module")
def html() -> str:
    return render_html(document())


@pytest.mark.slow
def test_same_bytes_from_run_to_run() -> None:
    code = (
        "import sys; from tests.report.fixtures import document; "
        "from tests.report.test_writers import RENDERS; "
        "sys.stdout.buffer.write('\\0'.join(r(document()) for r in RENDERS).encode())"
    )
    again = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        check=True,
        env={"PYTHONHASHSEED": "1", "PATH": "", "PYTHONPATH": ":".join(sys.path)},
    )
    assert again.stdout.decode() == "\0".join(render(document()) for render in RENDERS)


@ALL
def test_measured_time_is_not_in_it(render: Renders) -> None:
    known = run()
    slow = known._replace(outcomes=tuple(o._replace(seconds={"flint": 9.75}) for o in outcomes()))
    assert render(Contents(slow, in_order(slow)).document()) == render(document())


@ALL
def test_no_gap_of_the_page_is_left_open(render: Renders) -> None:
    text = render(document())
    assert not re.search(r"@[a-z]+@", text)
    assert document().title.partition("“")[2][:40] in text


@pytest.mark.parametrize(
    ("plain", "tex"),
    [
        ("100% of_the {special} #1 & \\ ~ ^", r"100\% of\_the \{special\} \#1 \& \textbackslash{} \textasciitilde{} \textasciicircum{}"),
        ("costs 5$", r"costs 5\$"),
        ('the "proof"', "the ``proof''"),
        ("ω₁² ≠ β", r"$\omega _1^2$ $\ne $ $\beta $"),
        ("Ж", "[U+0416]"),
        ("a\x00b", "ab"),
    ],
)  # fmt: skip
def test_words_are_escaped_for_latex(plain: str, tex: str) -> None:
    assert LatexWriter().text((plain,)) == tex


@pytest.mark.skipif(not has_latex(), reason="no pdflatex here")
def test_latex_takes_any_scripts_behind_one_another() -> None:
    scripts = ("₁", "₂", "ₙ", "²", "⁻", "′")
    texts = ["ω" + "".join(some) for many in (2, 3) for some in product(scripts, repeat=many)]
    body = r"\par ".join(LatexWriter().text((text, " costs $", text)) for text in texts)
    latex_pdf(rf"\documentclass{{article}}\begin{{document}}{body}\end{{document}}")


def test_words_are_escaped_for_the_others() -> None:
    text: Text = ("a < b & #c_1 *d* $5",)
    assert TypstWriter().text(text) == r"a \< b & \#c\_1 \*d\* \$5"
    assert HtmlWriter(Path()).text(text) == "a &lt; b &amp; #c_1 *d* $5"


def test_the_apostrophe_of_a_sentence_is_none_of_a_source() -> None:
    text: Text = ("Kowalevski's ", Code("x'"))
    assert Page(HtmlWriter(Path()).text(text)).words == "Kowalevski’s x'"


def test_a_line_is_broken_within_long_formulas_only() -> None:
    short, tall, long = read(r"x_1 = -1 - 2i \quad m = -\frac{3}{2} \quad x_1=" + "x_1+" * 9 + "m")
    latex, typst = LatexWriter().text, TypstWriter().text
    assert latex((short,)) == r"\mbox{$x_1 = -1 - 2i$}"
    assert latex((tall,)) == r"\mbox{$m = -\frac{3}{2}$}"
    assert typst((short,)).startswith("#box[$") and typst((tall,)).startswith("#tall[$")
    assert latex((long,)).startswith("$") and typst((long,)).startswith("$")
    shown = [HtmlWriter(Path()).text((one,)).count("<math>") for one in (short, tall, long)]
    assert shown[:2] == [1, 1] and shown[2] > 1


def test_fractions_on_two_lines_do_not_touch() -> None:
    import typst

    (formula,) = read(r"m = -\frac{7519}{800}")
    one = TypstWriter().text((formula,))
    asked = f"""#context [#metadata((
      measure(block(width: 8em, [{one} {one}])).height - measure([{one}]).height
      - measure($ inline({to_typst(formula)}) $).height) / 1pt) <w>]"""
    page = (files("kowalevski_cas.report") / "pages/page.typ").read_text(encoding="utf-8")
    looks = "#let tall", "#set par", "#set text", "#show math.equation: set text"
    defined = [line for line in page.split("\n") if line.startswith(looks)]
    source = "\n".join((*defined, asked))
    assert json.loads(typst.query(source.encode(), "<w>", field="value", one=True)) > 1


def test_a_display_that_cannot_be_read_is_shown_as_it_is_typed() -> None:
    odd = document(claim("odd", "1", r"x = \nosuchthing{y}{<z>}", "", Verdict.ERROR))
    assert r"x = \nosuchthing{y}{<z>}" in Page(render_html(odd)).words
    assert r"\texttt{x = \textbackslash{}nosuchthing" in render_latex(odd)
    assert r'"x = \\nosuchthing{y}{<z>}"' in render_typst(odd)


def test_each_format_has_every_kind_of_text() -> None:
    text: Text = (Emphasis(("why",), strong=True), Code("eq_1"), Sign(Verdict.REFUTED))
    assert LatexWriter().text(text) == r"\textbf{why}\texttt{eq\_1}\Sign{refuted}"
    assert TypstWriter().text(text) == '#strong[why];#raw("eq_1");#sign("refuted");'
    page = Page(HtmlWriter(Path()).text(text))
    assert page.words == "whyeq_1✗" and {"strong", "code"} < page.names


class TestHtml:
    def test_every_element_is_closed_and_every_link_ends_somewhere(self, html: str) -> None:
        page = Page(html)
        assert not page.open
        assert len(set(page.ids)) == len(page.ids)
        inner = {link[1:] for link in page.links if link.startswith("#")}
        assert inner <= set(page.ids)
        assert {f"claim.{outcome.claim}" for outcome in outcomes()} <= inner
        assert set(page.links) == {f"#{name}" for name in inner}  # it can be sent alone

    def test_nothing_is_loaded(self, html: str) -> None:
        assert not Page(html).names & {"link", "iframe", "object"}
        assert not re.search(r"@import|url\(|\bsrc=|https?://(?!www\.w3\.org)", html)
        assert len(html.encode()) < 2_000_000

    def test_marks_have_a_name_for_those_who_cannot_see_them(self, html: str) -> None:
        marks = Page(html).marks
        assert len(marks) > 2 * len(outcomes())
        assert all(mark["role"] == "img" and mark["aria-label"] for mark in marks)

    def test_formulas_are_mathml_from_the_tree(self, html: str) -> None:
        (formula,) = read("i^2")
        formula = Relation((formula, Changed(Negative(Number(1)))), ("=",))
        shown = f'<math display="block">{to_mathml(formula)}</math>'
        assert shown.replace(" ", "") in html.replace(" ", "")
        shown = re.sub(r'data-text="[^"]*"', "", html)
        assert not re.search(r"\\(frac|sqrt|omega)", shown)

    def test_what_is_wide_has_a_form_for_telephones(self, html: str) -> None:
        assert html.count('<div class="wide">') == html.count('<div class="narrow">') > 5
