"""What the tests of audits share: the paper's source where it is, and one run."""

from functools import cache, wraps
from pathlib import Path

import pytest

from kowalevski_cas.audit.audit import Audit, audit
from kowalevski_cas.audit.patch import repair_source
from kowalevski_cas.audit.session import AuditSession
from kowalevski_cas.library import find, load
from kowalevski_cas.processes import each
from kowalevski_cas.source.files import decode, read_source
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.record import load_record
from study.mutants.synthetic import synthetic

PAPERS = Path(__file__).parents[2] / ".." / "shared" / "paper"
NAME = "kharlamov2002"


def paper_path() -> Path:
    """The paper's source; the test is skipped where it is not."""
    found = sorted([*PAPERS.glob("*.tex"), *PAPERS.glob("*.txt")])
    if not found:
        pytest.skip("the paper's source is not part of the repository, and not beside it")
    return found[0]


@cache
def base() -> AuditSession:
    """The run of the derivation, to which audits add nothing."""
    folder = find(NAME)
    stored, record = load_certificates(folder), load_record(folder)
    return AuditSession(load(NAME), ["flint"], certificates=stored, timeout=2, record=record)


def watched(test):
    """A test in a process of its own, where the limits of time of an audit hold."""

    @wraps(test)
    def run(*arguments, **named):
        audited()
        (_,) = each(lambda _: test(*arguments, **named), [None], 1)

    return run


@cache
def source() -> Source:
    """The paper's source, or the derivation as an article."""
    found = sorted([*PAPERS.glob("*.tex"), *PAPERS.glob("*.txt")])
    return read_source(found[0]) if found else synthetic(base().interpretation.derivation)


@cache
def audited() -> Audit:
    """The audit of the source as it is."""
    return audit(source(), base())


@cache
def patched() -> str:
    """The source with its misprints mended."""
    return repair_source(audited()).text


@cache
def audited_again() -> Audit:
    """The audit of what is mended."""
    return audit(Source("paper.tex", patched()), base())


def changed(old: str, new: str) -> Audit:
    """The audit of the source with one piece of text changed, spaces of any kind ignored."""
    text = source().text
    assert old in text, f"{old} does not stand in the source"
    return audit(Source("paper.tex", text.replace(old, new, 1)), base())


def article(body: str, preamble: str = "") -> Source:
    text = (
        f"\\documentclass{{article}}\n{preamble}\n\\begin{{document}}\n{body}\n\\end{{document}}\n"
    )
    return decode("article.tex", text.encode())
