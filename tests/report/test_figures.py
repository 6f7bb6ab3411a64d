"""Pictures that other commands left beside a report."""

import json
from pathlib import Path

import pytest
from pypdf import PdfReader

from kowalevski_cas.pictures import new_figure, save, style
from kowalevski_cas.report import pdf
from kowalevski_cas.report.contents import Contents
from kowalevski_cas.report.figures import FigureFile, figures_of
from kowalevski_cas.report.html import render_html
from kowalevski_cas.report.latex import render_latex
from kowalevski_cas.report.pdf import write_report
from tests.report.fixtures import P, claim, in_order, run
from tests.sample import sampled

SMALL = run(claim("a", "1", "x=x", "", P))
CAPTION = "A line, drawn with 50% of the ink; $x_1=2$."

needs_latex = pytest.mark.skipif(not pdf.has_latex(), reason="no pdflatex here")


def offer(
    folder: Path, derivation: str = "kharlamov2002", heights: tuple[int, int] = (0, 1)
) -> Path:
    entries = [{"name": "line", "caption": CAPTION}, {"name": "not-there", "caption": "Nothing."}]
    with style():
        figure = new_figure(2, 1)
        figure.subplots().plot([0, 1], heights)
        save(figure, folder, "line")
    (folder / "figures.json").write_text(json.dumps({"derivations": {derivation: entries}}))
    return folder


def test_a_report_shows_the_pictures_of_its_derivation_that_are_there(tmp_path: Path) -> None:
    offer(tmp_path / "motion")
    offer(tmp_path / "others", "another2003")
    assert figures_of(tmp_path, "kharlamov2002") == (FigureFile("motion/line", CAPTION),)
    assert figures_of(tmp_path, "another2003") == (FigureFile("others/line", CAPTION),)


def test_a_drawing_stands_in_the_page_and_a_picture_where_there_is_none(tmp_path: Path) -> None:
    offer(tmp_path / "motion")
    (one,) = figures_of(tmp_path, "kharlamov2002")
    shown = Contents(SMALL, in_order(SMALL)).document((one,))
    assert "<img" in render_html(shown, tmp_path)
    (tmp_path / "motion/line.svg").write_text("<svg><path d='M0 0'/></svg>")
    page = render_html(shown, tmp_path)
    assert "<figure><svg><path" in page and "<img" not in page


@pytest.mark.parametrize("text", sampled(["", "{", "[]", '{"kharlamov2002": [1]}'], 2))
def test_a_list_that_cannot_be_read_shows_nothing(tmp_path: Path, text: str) -> None:
    (offer(tmp_path / "motion") / "figures.json").write_text(text)
    assert figures_of(tmp_path, "kharlamov2002") == ()


@pytest.mark.parametrize(
    "by_latex", [False, pytest.param(True, marks=[needs_latex, pytest.mark.slow])]
)
def test_they_are_in_the_pdf(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, by_latex: bool
) -> None:
    monkeypatch.setattr(pdf, "has_latex", lambda: by_latex)
    offer(tmp_path / "motion")
    written = write_report(SMALL, in_order(SMALL), tmp_path)
    text = " ".join(page.extract_text() for page in PdfReader(written.pdf).pages)
    assert "drawn with 50% of the ink" in " ".join(text.split())
    source = written.tex.read_text(encoding="utf-8")
    shown = Contents(SMALL, in_order(SMALL)).document(figures_of(tmp_path, "kharlamov2002"))
    assert source == render_latex(shown)
    page = written.html.read_text(encoding="utf-8")
    assert page == render_html(shown, tmp_path) and 'src="data:image/png;base64,' in page
    before = written.pdf.read_bytes()
    offer(tmp_path / "motion", heights=(1, 0))
    assert write_report(SMALL, in_order(SMALL), tmp_path).pdf.read_bytes() != before
