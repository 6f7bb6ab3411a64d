"""From a run to files, by LaTeX and by Typst."""

import io
import os
import re
import stat
import sys
from pathlib import Path

import pytest
from pypdf import PdfReader

from kowalevski_cas.report import pdf
from kowalevski_cas.report.latex import render_latex
from kowalevski_cas.report.pdf import ReportError, write_report
from tests.report.fixtures import P, claim, document, in_order, run

PAPER = in_order(run())

needs_latex = pytest.mark.skipif(
    not pdf.has_latex(), reason="no pdflatex here; CI_TEX=1 .ci/run installs it"
)


def said(content: bytes) -> tuple[int, str]:
    reader = PdfReader(io.BytesIO(content))
    text = " ".join(page.extract_text() for page in reader.pages)
    return len(reader.pages), re.sub(r"\s+", " ", text)


def check(content: bytes) -> None:
    pages, text = said(content)
    assert 5 <= pages <= 12
    for label in ("(4)", "(10)", "(16)", "(22)", "Before (9)"):
        assert label in text.replace("- ", "-").replace("fi", "fi")
    for heading in ("Main equations", "misprints", "What rests on what", "What is proved"):
        assert heading in text
    assert not re.search(r"\\[A-Za-z]", text)  # no TeX was left unread


@pytest.mark.slow
def test_typst_makes_the_same_bytes_again(tmp_path: Path) -> None:
    written, again = (write_report(run(), PAPER, tmp_path / k) for k in "ab")
    assert written.pdf.read_bytes() == again.pdf.read_bytes()
    assert (written.tex.name, written.pdf.name) == ("kharlamov2002.tex", "kharlamov2002.pdf")
    assert written.notes == ()
    assert written.tex.read_text(encoding="utf-8") == render_latex(document())
    check(written.pdf.read_bytes())


@pytest.mark.slow
def test_a_pdf_is_made_anew_if_what_it_is_made_of_has_changed(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    made: list[str] = []

    def making(source: str, *rest: object) -> bytes:
        made.append(source)
        return b"%PDF-"  # of the report, and of its erratum

    monkeypatch.setattr(pdf, "typst_pdf", making)
    for title in ("A", "A", "B", "B"):
        one = write_report(run()._replace(title=title), PAPER, tmp_path).pdf
    assert len(made) == 4
    one.write_bytes(one.read_bytes()[:-1])
    write_report(run()._replace(title="B"), PAPER, tmp_path)
    assert len(made) == 5


@pytest.mark.slow
@needs_latex
def test_latex_has_no_overfull_boxes_and_no_missing_references(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    logs: list[str] = []
    latex = pdf._latex

    def listening(folder: Path) -> None:
        latex(folder)
        logs.append((folder / "report.log").read_text(encoding="utf-8", errors="replace"))

    monkeypatch.setattr(pdf, "has_latex", lambda: True)
    monkeypatch.setattr(pdf, "_latex", listening)
    written = write_report(run(), PAPER, tmp_path)
    assert written.notes == ()
    check(written.pdf.read_bytes())
    assert not re.findall(r"Overfull.*", logs[-1])
    assert not re.findall(
        r"undefined|multiply defined|Rerun (?:to|LaTeX)|Missing character", logs[-1]
    )


@needs_latex
def test_latex_says_what_it_stumbled_over() -> None:
    with pytest.raises(ReportError, match=r"failed: .*Undefined control sequence"):
        pdf.latex_pdf(r"\documentclass{article}\begin{document}\nosuchthing\end{document}")


@pytest.mark.slow
def test_a_failing_latex_gives_way_to_typst(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(*_: object) -> bytes:
        raise ReportError("pdflatex failed: File `fancyhdr.sty' not found.")

    monkeypatch.setattr(pdf, "has_latex", lambda: True)
    monkeypatch.setattr(pdf, "latex_pdf", failing)
    written = write_report(run(), PAPER, tmp_path)
    assert written.notes == (
        "pdflatex failed: File `fancyhdr.sty' not found. The PDF was made by Typst instead.",
    )


@pytest.mark.parametrize("what", [ReportError("no"), KeyboardInterrupt()])
def test_a_failure_leaves_the_earlier_pdf(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, what: BaseException
) -> None:
    earlier = tmp_path / "kharlamov2002.pdf"
    earlier.write_bytes(b"earlier")

    def failing(*_: object) -> bytes:
        raise what

    monkeypatch.setattr(pdf, "typst_pdf", failing)
    with pytest.raises(type(what)):
        write_report(run(), PAPER, tmp_path)
    assert earlier.read_bytes() == b"earlier"
    names = [f"kharlamov2002.{suffix}" for suffix in ("html", "json", "pdf", "tex")]
    assert sorted(p.name for p in tmp_path.iterdir()) == names


def test_an_interrupt_while_writing_leaves_the_earlier_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    earlier = tmp_path / "kharlamov2002.json"
    earlier.write_text("earlier")

    def interrupted(*names: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_report(run(), PAPER, tmp_path)
    assert earlier.read_text() == "earlier"
    assert list(tmp_path.iterdir()) == [earlier]


def test_files_are_readable_by_others(tmp_path: Path) -> None:
    small = run(claim("a", "1", "x=x", "", P))
    written = write_report(small, in_order(small), tmp_path / "new")
    assert stat.S_IMODE(written.pdf.stat().st_mode) == 0o644


def test_a_folder_that_cannot_be(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError, match="cannot be written"):
        write_report(run(), PAPER, tmp_path / "file" / "reports")


def test_no_typst_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setitem(sys.modules, "typst", None)
    with pytest.raises(ReportError, match="pip install typst"):
        write_report(run(), PAPER, tmp_path)
