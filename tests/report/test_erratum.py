"""The erratum: what is to be changed, and nothing else."""

from __future__ import annotations

from kowalevski_cas.report.contents import Contents
from kowalevski_cas.report.document import Document, Equations, Link
from kowalevski_cas.report.latex import render_latex
from kowalevski_cas.report.typst import render_typst
from kowalevski_cas.verify.outcome import Outcome
from tests.report.fixtures import P, R, claim, correction, in_order, outcomes, run
from tests.report.test_contents import parts, said


def erratum(*chosen: Outcome) -> Document | None:
    whole = run(*chosen)
    return Contents(whole, in_order(whole)).erratum()


def test_where_nothing_is_wrong_there_is_none() -> None:
    assert erratum(claim("a", "1", "x=x", "", P)) is None


def test_each_misprint_stands_there_as_printed_and_as_meant() -> None:
    page = erratum(*outcomes())
    assert page is not None
    whole = run(*outcomes())
    slips = Contents(whole, in_order(whole)).findings.slips
    assert len(slips) > 1
    assert sum(isinstance(block, Equations) for block in page.blocks) == 2 * len(slips)
    assert said(page.blocks).count("Because ") >= len(slips)


def test_what_is_false_is_said_with_the_nearest_truth() -> None:
    false = claim("a", "1", "x=m", "all are equal", R, correction=correction("x=x", "some are", P))
    page = erratum(false)
    assert page is not None
    assert "Section 1: All are equal. This is false. Read: some are." in said(page.blocks)
    assert any(isinstance(block, Equations) for block in page.blocks)


def test_it_stands_alone_and_can_be_set() -> None:
    page = erratum(*outcomes())
    assert page is not None
    assert not any(isinstance(part, Link) for part in parts(page.blocks))
    assert r"\begin{document}" in render_latex(page) and render_typst(page)
