"""From a run to files: HTML, LaTeX, and PDF by TeX where there is one, else by Typst."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path
from types import MappingProxyType
from typing import Final

from kowalevski_cas import UserError
from kowalevski_cas.files import write
from kowalevski_cas.report.contents import Contents
from kowalevski_cas.report.document import Document, Graph
from kowalevski_cas.report.figures import FigureFile, copy_figures, figures_of
from kowalevski_cas.report.graph import Drawing
from kowalevski_cas.report.graph.svg import svg
from kowalevski_cas.report.html import render_html
from kowalevski_cas.report.latex import render_latex
from kowalevski_cas.report.places import PaperSection
from kowalevski_cas.report.typst import render_typst
from kowalevski_cas.report.witnesses import Witness, programs
from kowalevski_cas.schema import head
from kowalevski_cas.verify.outcome import Outcome, Run

_SECONDS: Final = 120


class ReportError(UserError):
    """A report could not be made; the message says why and what to do."""


@dataclass(frozen=True)
class Written:
    """The files of a report, with an ``erratum`` if there is one, and what is worth telling."""

    html: Path
    tex: Path
    pdf: Path
    erratum: Path | None = None
    notes: tuple[str, ...] = ()

    @property
    def pages(self) -> tuple[Path, ...]:
        """What a reader opens."""
        return tuple(filter(None, (self.html, self.pdf, self.erratum)))


def page(
    run: Run,
    sections: Sequence[PaperSection],
    certified: Mapping[str, str],
    beside: Path | None = None,
    evidence: str = "",
) -> tuple[Document, dict[str, str]]:
    """A report, and its files by name: the page, and the facts behind it as JSON.

    Its certificates are at the address ``evidence``.

    Pictures, and which programs confirmed what, are looked for in the folder ``beside``.
    """
    told = () if beside is None else programs(beside, run.derivation, certified)
    shown = () if beside is None else figures_of(beside, run.derivation)
    document = Contents(run, sections, certified, told, evidence).document(shown)
    return document, {
        f"{run.derivation}.html": render_html(document, beside or Path()),
        f"{run.derivation}.json": facts(run, certified, told),
    }


def facts(run: Run, certified: Mapping[str, str], programs: Sequence[Witness]) -> str:
    """A run as JSON, without what it measured of time: the same bytes from run to run.

    Of programs that confirm certificates it speaks if any were asked.
    """

    def claim(outcome: Outcome) -> dict[str, object]:
        confirmed = [program.name for program in programs if outcome.claim in program.claims]
        return {
            "section": outcome.section,
            "scene": outcome.scene,
            "verdict": outcome.verdict,
            "statement": outcome.digest,
            "certificate": certified.get(outcome.claim),
            "decided by": dict(outcome.verdicts),
            **({"confirmed by": confirmed} if programs else {}),
            "rests on": list(outcome.rests_on),
            "read with the corrections of": list(outcome.corrected),
        }

    content = {
        **head("facts"),
        "derivation": run.derivation,
        "digest": run.digest,
        "versions": {**run.versions, **{program.name: program.version for program in programs}},
        "claims": {outcome.claim: claim(outcome) for outcome in run.outcomes},
    }
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def write_report(
    run: Run,
    sections: Sequence[PaperSection],
    folder: Path,
    certified: Mapping[str, str] = MappingProxyType({}),
    evidence: str = "",
) -> Written:
    """Write a report into a folder, as HTML, LaTeX and PDF, and the facts behind it as JSON.

    With misprints or false statements there is an erratum too, as LaTeX and PDF.

    Each file appears whole or not at all: a failure or an interrupt leaves an earlier one as it
    was, and a PDF that was made of the same source and pictures is left alone.
    Links lead to the certificates, from the report at the address ``evidence``.
    LaTeX makes the PDF where it is installed and complete, else Typst.
    Pictures of the derivation that are in a folder below are shown (:mod:`.figures`), and so is
    which programs confirmed its certificates (:mod:`.witnesses`).

    Raises:
        ReportError: if no PDF can be made; the other files are written by then.
        OSError: if a file cannot be written.
    """
    document, files = page(run, sections, certified, folder, evidence)
    for name, text in files.items():
        write(folder / name, text)
    stem = folder / run.derivation
    tex, pdf, notes = write_paper(document, stem, figures_of(folder, run.derivation), folder)
    errata = Contents(run, sections).erratum()
    erratum = None
    if errata is not None:
        _, erratum, _ = write_paper(errata, folder / f"{run.derivation}-erratum")
    return Written(folder / f"{run.derivation}.html", tex, pdf, erratum, notes)


def write_paper(
    document: Document, stem: Path, shown: tuple[FigureFile, ...] = (), folder: Path = Path()
) -> tuple[Path, Path, tuple[str, ...]]:
    """Write a document as LaTeX and PDF; returns both, and what is worth telling.

    Raises:
        ReportError: if no PDF can be made; the LaTeX is written by then.
        OSError: if a file cannot be written.
    """
    source = render_latex(document)
    tex, pdf = (stem.with_name(f"{stem.name}.{suffix}") for suffix in ("tex", "pdf"))
    write(tex, source)
    notes: tuple[str, ...] = ()
    if has_latex():
        made = _fingerprint_comment("latex", source, shown, folder)
        try:
            if not _ends(pdf, made):
                write(pdf, latex_pdf(source, shown, folder) + made)
            return tex, pdf, ()
        except ReportError as error:
            notes = (f"{error} The PDF was made by Typst instead.",)
    source, picture = render_typst(document), svg(_picture(document))
    made = _fingerprint_comment("typst", source + picture, shown, folder)
    if not _ends(pdf, made):
        write(pdf, typst_pdf(source, picture, shown, folder) + made)
    return tex, pdf, notes


def _picture(document: Document) -> Drawing:
    """The picture in a document, which Typst takes as a file of its own."""
    drawn = (block.picture for block in document.blocks if isinstance(block, Graph))
    return next(drawn, Drawing((), (), 0.0, 0.0))


def _fingerprint_comment(
    engine: str, source: str, shown: tuple[FigureFile, ...], folder: Path
) -> bytes:
    """A comment behind the end of a PDF, which binds what it was made of."""
    parts = [source.encode(), *(figure.file(folder).read_bytes() for figure in shown)]
    digests = "".join(sha256(part).hexdigest() for part in parts)
    return f"%{engine} {sha256(digests.encode()).hexdigest()}\n".encode()


def _ends(file: Path, end: bytes) -> bool:
    """Whether there is a file that ends so."""
    return file.is_file() and file.read_bytes().endswith(end)


# ------------------------------------------------------------------------ LaTeX


def has_latex() -> bool:
    """Whether a LaTeX is installed."""
    return shutil.which("pdflatex") is not None


def latex_pdf(source: str, shown: tuple[FigureFile, ...] = (), beside: Path = Path()) -> bytes:
    """The PDF that pdflatex makes of a document, which shows figures from the folder ``beside``.

    Raises:
        ReportError: if it fails; the message has its first complaint.
    """
    with tempfile.TemporaryDirectory(prefix="kowalevski-") as name:
        folder = Path(name)
        (folder / "report.tex").write_text(source, encoding="utf-8")
        copy_figures(shown, beside, folder)
        for _ in range(4):
            _latex(folder)
            if not re.search(r"Rerun (to|LaTeX)", _log(folder)):
                break
        return (folder / "report.pdf").read_bytes()


def _latex(folder: Path) -> None:
    options = ["-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape", "report.tex"]
    surroundings = {
        **os.environ,
        "SOURCE_DATE_EPOCH": "0",
        "FORCE_SOURCE_DATE": "1",
        "max_print_line": "1000",
        "openin_any": "p",
        "openout_any": "p",
    }
    try:
        done = subprocess.run(
            ["pdflatex", *options],
            cwd=folder,
            env=surroundings,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=_SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise ReportError(f"pdflatex did not end within {_SECONDS} s.") from None
    if done.returncode:
        complaint = re.search(r"^! *(.+)", _log(folder), re.MULTILINE)
        what = complaint[1].rstrip(".") if complaint else f"exit code {done.returncode}"
        raise ReportError(f"pdflatex failed: {what}.")


def _log(folder: Path) -> str:
    log = folder / "report.log"
    return log.read_text(encoding="utf-8", errors="replace") if log.exists() else ""


# ------------------------------------------------------------------------ Typst


def typst_pdf(
    source: str, picture: str, shown: tuple[FigureFile, ...] = (), beside: Path = Path()
) -> bytes:
    """The PDF that Typst makes of a document, with its picture in SVG, and figures from a folder.

    Raises:
        ReportError: if Typst is not installed, or fails; the message has its first complaint.
    """
    if find_spec("typst") is None:
        raise ReportError(
            "The PDF needs either LaTeX (pdflatex) or the typst wheel: pip install typst."
        )
    with tempfile.TemporaryDirectory(prefix="kowalevski-") as name:
        folder = Path(name)
        (folder / "report.typ").write_text(source, encoding="utf-8")
        (folder / "picture.svg").write_text(picture, encoding="utf-8")
        copy_figures(shown, beside, folder)
        # Typst begins threads, which do not outlive a fork: it has a process of its own.
        done = subprocess.run(
            [sys.executable, "-c", _TYPST], cwd=folder, capture_output=True, check=False
        )
        if done.returncode:
            said = done.stderr.decode(errors="replace").strip() or "it gave no reason"
            raise ReportError(f"Typst failed: {said.splitlines()[-1]}.")
        return (folder / "report.pdf").read_bytes()


_TYPST = """
import sys, typst
try:
    typst.compile("report.typ", output="report.pdf", root=".", ignore_system_fonts=True)
except (RuntimeError, ValueError) as error:
    sys.exit(str(error).splitlines()[0])
"""
