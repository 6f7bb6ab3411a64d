"""What the tests of audits share: the paper's source where it is, and one memory."""

from functools import cache
from pathlib import Path

import pytest

from kowalevski_cas.audit.audit import Audit, audit
from kowalevski_cas.audit.memory import Memory
from kowalevski_cas.audit.source import Source, decode, read_source
from kowalevski_cas.audit.synthetic import synthetic
from kowalevski_cas.library import find, load
from kowalevski_cas.proof.evidence import load_evidence

PAPERS = Path(__file__).parents[2] / ".." / "shared" / "paper"
NAME = "kharlamov2002"


def paper_path() -> Path:
    """The paper's source; the test is skipped where it is not."""
    found = sorted([*PAPERS.glob("*.tex"), *PAPERS.glob("*.txt")])
    if not found:
        pytest.skip("the paper's source is not part of the repository, and not beside it")
    return found[0]


@cache
def memory() -> Memory:
    return Memory(load(NAME), evidence=load_evidence(find(NAME)), patience=600)


@cache
def source() -> Source:
    """The paper's source, or the derivation as an article."""
    found = sorted([*PAPERS.glob("*.tex"), *PAPERS.glob("*.txt")])
    return read_source(found[0]) if found else synthetic(memory().derivation)


def changed(old: str, new: str) -> Audit:
    """The audit of the source with one piece of text changed, spaces of any kind ignored."""
    text = source().text
    assert old in text, f"{old} does not stand in the source"
    return audit(Source("paper.tex", text.replace(old, new, 1)), memory())


def article(body: str, preamble: str = "") -> Source:
    text = (
        f"\\documentclass{{article}}\n{preamble}\n\\begin{{document}}\n{body}\n\\end{{document}}\n"
    )
    return decode("article.tex", text.encode())
