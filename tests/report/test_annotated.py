"""The author's paper with a verdict beside every formula."""

from functools import cache
from pathlib import Path

import pytest

from kowalevski_cas.audit.audit import audit
from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.cli import main, plain
from kowalevski_cas.reading import read
from kowalevski_cas.report.annotated import annotate
from kowalevski_cas.report.document import (
    Code,
    Document,
    Equations,
    Heading,
    Judgement,
    Link,
    Paragraph,
    Sign,
    Table,
)
from kowalevski_cas.report.html import render_html
from kowalevski_cas.report.marks import SPOILED
from kowalevski_cas.source.files import decode
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.outcome import Verdict
from study.mutants.synthetic import synthetic
from tests.audit.material import base
from tests.audit.test_audit import misprinted
from tests.report.test_contents import parts, said
from tests.report.test_writers import Page

FIRST = r"\begin{equation}\label{eq6}"
"""A place in the article, behind (4)."""


@cache
def page(old: str = "", new: str = "") -> Document:
    """The derivation as an article, in which one piece of text is another one."""
    text = synthetic(base().interpretation.derivation).text
    assert old in text
    return annotate(audit(decode("paper.tex", text.replace(old, new, 1).encode()), base()))


def of_the_paper(document: Document) -> str:
    html = render_html(document)
    return html[html.index('<h2 id="paper">') :]


@pytest.mark.slow
def test_every_claim_stands_in_the_text_and_every_link_ends_somewhere() -> None:
    found = Page(render_html(page()))
    claims = {f"claim.{claim.id}" for claim in base().interpretation.derivation.claims}
    assert claims <= set(found.ids) and len(set(found.ids)) == len(found.ids)
    assert {link[1:] for link in found.links} <= set(found.ids)


@pytest.mark.slow
def test_what_the_author_writes_stands_around_it_in_his_order() -> None:
    document = page(FIRST, r"As (\ref{eq4}) says: " + FIRST)
    paragraph = next(b for b in document.blocks if isinstance(b, Paragraph) and "As (" in b.text)
    assert Link("claim.eq4.1", ("4",)) in paragraph.text
    text = of_the_paper(document)
    assert text.index("claim.eq4.1") < text.index(" says:") < text.index('id="claim.eq6"')


@pytest.mark.slow
def test_a_formula_of_the_author_is_judged_as_he_types_it() -> None:
    good = r"K = J_1^2  + J_2^2"
    document = page(good, r"K = J_1^2  - J_2^2")
    assert "claim.eq6" in {p.target for p in parts(document.blocks[:12]) if isinstance(p, Link)}
    (claim,) = [p for p in parts(document.blocks) if getattr(p, "anchor", "") == "claim.eq6"]
    assert claim.verdict is Verdict.REFUTED
    assert any(isinstance(p, Equations) and p.wrong for p in parts(claim))


@pytest.mark.slow
def test_a_formula_that_is_missing_is_not_passed_over() -> None:
    text = synthetic(base().interpretation.derivation).text
    start = text.index(r"\begin{equation}\label{eq22}")
    end = text.index(r"\end{equation}", start) + len(r"\end{equation}")
    document = annotate(audit(Source("paper.tex", text[:start] + text[end:]), base()))
    lost = [b for b in document.blocks if isinstance(b, Heading) and b.anchor == "lost"]
    assert lost and "claim.eq22" in Page(render_html(document)).ids


@pytest.mark.slow
def test_formulas_that_nobody_knows_are_shown() -> None:
    odd = r"Some $\zeta_7^2$, $\unknown{x}$ and $$p_5 = q_5.$$ " + FIRST
    document = page(FIRST, odd)
    text = of_the_paper(document)
    assert "<mi>ζ</mi>" in text and "<mi>q</mi>" in text
    assert r"\unknown{x}" in said(document.blocks)


@pytest.mark.slow
def test_the_command_writes_the_page(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("kowalevski_cas.cli.audit.audit_run", lambda *_: base())
    source = tmp_path / "some paper.tex"
    source.write_text(synthetic(base().interpretation.derivation).text, encoding="utf-8")
    assert main(["audit", str(source), "--report", str(tmp_path / "out")]) == 1
    assert "some paper.html is written" in capsys.readouterr().err
    text = (tmp_path / "out" / "some paper.html").read_text(encoding="utf-8")
    assert "The source some paper.tex (SHA-256 " in text


@pytest.mark.slow
def test_bold_words_at_the_head_of_a_paragraph_are_sections() -> None:
    document = page(FIRST, r"{\bf 7.\,A second part.} It begins. {\bf Not} this. " + FIRST)
    parts = {b.anchor: said(b.text) for b in document.blocks if isinstance(b, Heading)}
    assert "".join(parts["part.1"].split()) == "7.Asecondpart" and "part.2" not in parts


@pytest.mark.slow
def test_no_link_is_dead_when_the_page_is_sent_alone() -> None:
    assert all(link.startswith("#") for link in Page(render_html(page())).links)


def test_a_definition_that_spoils_what_rests_on_it_is_named() -> None:
    run = misprinted(r"E=\frac{1}{2}(x^2-y^2)")
    document = annotate(audit(synthetic(run.interpretation.derivation), run))
    (told,) = [
        b
        for b in document.blocks
        if isinstance(b, Judgement) and said(b.head).startswith("energy:")
    ]
    assert said(told.head).startswith("energy: Misprinted. ") and told.verdict is Verdict.REFUTED
    assert any(isinstance(block, Equations) for block in told.blocks)
    blamed = [part.target for part in parts(told.head) if isinstance(part, Link)]
    assert "claim.rate" in blamed and "claim.value" in blamed


def test_a_page_without_certificates_names_formulas_by_their_numbers() -> None:
    records = [b for b in parts(page().blocks) if isinstance(b, Paragraph) and b.kind == "record"]
    told = [record for record in records if "decided by" in said(record.text)]
    assert told and not any(isinstance(part, Code) for record in told for part in record.text)


def test_what_fails_because_of_another_formula_does_not_look_like_a_misprint() -> None:
    run = misprinted(r"E=\frac{1}{2}(x^2-y^2)")
    document = annotate(audit(synthetic(run.interpretation.derivation), run))
    judged = {b.anchor: b for b in document.blocks if isinstance(b, Judgement)}
    failing = [judged["claim.rate"], judged["claim.value"]]
    assert [block.verdict for block in failing] == [SPOILED, SPOILED]
    for block in failing:
        assert "Fails because of " in said(block.head) and "False" not in said(block.head)
        assert not any(isinstance(p, Equations) and p.wrong for p in block.blocks)


def test_a_source_that_is_its_own_derivation_says_first_what_it_assumes() -> None:
    text = (
        r"\begin{document}The motion is $$\dot p=aqr,\quad \dot q=brp,\quad \dot r=cpq.$$ "
        r"Suppose that $a=-b$. Then $p^2+q^2$ is constant.\end{document}"
    )
    document = annotate(
        audit_reading(ReadingSession(read(decode("paper.tex", text.encode())), timeout=20))
    )
    places = {b.anchor: k for k, b in enumerate(document.blocks) if isinstance(b, Heading)}
    told = document.blocks[places["assumed"] + 1]
    assert places["assumed"] < places["paper"] and "; on it rests " in said(told)


def test_a_source_that_is_its_own_derivation_says_what_is_not_judged() -> None:
    text = (
        r"\begin{document}The motion is $$\dot p=q,\quad \dot q=-p.$$ Then $p^2+q^2$ is constant. "
        r"We find $$\oint p\,dq\frown p.$$ There are no other integrals.\end{document}"
    )
    document = annotate(
        audit_reading(ReadingSession(read(decode("paper.tex", text.encode())), timeout=20))
    )
    places = {b.anchor: k for k, b in enumerate(document.blocks) if isinstance(b, Heading)}
    told = [said(b) for b in document.blocks[places["unjudged"] + 1 : places["paper"]]]
    assert "an integral cannot be read" in told[0]
    assert "There are no other integrals." in told[-1]


def test_what_is_not_decided_stands_with_its_formula_and_the_reason() -> None:
    text = (
        r"\begin{document}The motion is $$\dot p=aqr,\quad \dot q=brp,\quad \dot r=cpq.$$ "
        r"At some moment $p+q=5$.\end{document}"
    )
    found = audit_reading(ReadingSession(read(decode("a/b.tex", text.encode())), timeout=20))
    document = annotate(found)
    assert document.title.startswith("“b.tex”")
    (place,) = (k for k, b in enumerate(document.blocks) if getattr(b, "anchor", "") == "open")
    note, told = document.blocks[place + 1 : place + 3]
    assert "it has no verdict" in said(note)
    assert isinstance(told, Judgement) and "alse as it was read" in said(told.blocks)
    assert any(isinstance(block, Equations) for block in told.blocks)
    assert "stands nowhere else (line 1)" in said(told.blocks)
    assert "At " in said(told.blocks[-1])


BODY = r"""\begin{document}A free body obeys
\begin{equation}\label{law} A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad C\dot r=(A+B)pq.\end{equation}
It has the first integrals
\begin{equation}\label{H} 2H=Ap^2+Bq^2+Cr^2 \end{equation} and
\begin{equation}\label{G} G^2=A^2p^2+B^2q^2+C^2r^2. \end{equation}\end{document}"""


def test_a_misprint_that_spoils_several_formulas_is_told_once_with_all_of_them() -> None:
    found = audit_reading(ReadingSession(read(decode("body.tex", BODY.encode())), timeout=20))
    document = annotate(found)
    (heading,) = (b for b in document.blocks if getattr(b, "anchor", "") == "misprints")
    told = document.blocks[document.blocks.index(heading) + 1]
    assert said(heading.text) == "One misprint" and isinstance(told, Judgement)
    where, numbers = told.head[:2], [p.text for p in parts(told.head) if isinstance(p, Link)]
    assert where == ("Formula 3 of ", Link("display.law", ("(1)",)))
    assert numbers == [("(1)",), ("(2)",), ("(3)",)]  # as TeX counts
    assert said(told.head[-1]) == " fail."
    assert not any(getattr(b, "anchor", "") == "false" for b in document.blocks)


TWO = r"""\begin{document}The equations of motion are
\begin{equation}\dot x=y,\quad\dot y=-x,\quad\dot u=v,\quad\dot v=-u.\end{equation} Let
\begin{equation}F=x^2-y^2,\end{equation} \begin{equation}G=u^2-v^2.\end{equation} Then
\begin{equation}\dot F=0,\end{equation} \begin{equation}\dot G=0,\end{equation}
and for $P=FG$ we have \begin{equation}\dot P=0.\end{equation} \end{document}"""


def test_a_claim_that_two_misprints_spoil_is_shown_as_spoiled_and_names_both() -> None:
    found = audit_reading(ReadingSession(read(decode("two.tex", TWO.encode())), timeout=20))
    document = annotate(found)
    judged = [b for b in document.blocks if isinstance(b, Judgement) and b.verdict is SPOILED]
    numbers = [[p.text[0] for p in parts(b.head) if isinstance(p, Link)] for b in judged]
    assert numbers == [["(2)"], ["(3)"], ["(2)", "(3)"]]
    assert all("Fails because of " in said(block.head) for block in judged)
    start = next(
        k for k, b in enumerate(document.blocks) if getattr(b, "anchor", "") == "misprints"
    )
    slips = [b for b in document.blocks[start + 1 : start + 3] if isinstance(b, Judgement)]
    numbers = [[p.text[0] for p in parts(b.head) if isinstance(p, Link)] for b in slips]
    assert numbers == [["(2)", "(4)", "(6)"], ["(3)", "(5)", "(6)"]]
    (legend,) = (b for b in document.blocks if "only because another" in said(b))
    assert Sign(Verdict.REFUTED) in legend.text and Sign(SPOILED) in legend.text


OSCILLATOR = r"""\begin{document}A body obeys
\begin{equation}\dot{\mathbf q}=\mathbf v,\quad\dot{\mathbf v}=-c\,\mathbf q.\end{equation}"""


def told(text: str) -> list[str]:
    """What the page of a source says in its first blocks and below its formulas, line by line."""
    found = audit_reading(ReadingSession(read(decode("paper.tex", text.encode())), timeout=20))
    return [*plain.lines(b for b in annotate(found).blocks if isinstance(b, Judgement | Paragraph))]


def test_a_statement_that_fails_by_a_misprint_elsewhere_is_named_before_its_point() -> None:
    text = rf"""{OSCILLATOR} Let \begin{{equation}}E=\mathbf v^2+\frac{{c\,\mathbf q^2}}2.\end{{equation}}
        Then \begin{{equation}}\dot E=0.\end{{equation}}\end{{document}}"""
    said = " ".join(map(str.strip, told(text)))
    assert "(3), Ė = 0, fails with the print. At " in said
    assert "the derivative of E along the motion is " in said


@pytest.mark.parametrize(
    ("claim", "words"),
    [
        (r"\dot{\mathbf G}=0", "the first component of the derivative of 𝐆 along the motion is "),
        (r"\dot{\mathbf G}=2\mathbf v", "the first component of the left side is "),
    ],
)
def test_a_component_is_named_that_fails(claim: str, words: str) -> None:
    text = rf"""{OSCILLATOR} Let $\mathbf G=\mathbf q\times\mathbf v+\mathbf v$. Then
        \begin{{equation}}{claim}.\end{{equation}}\end{{document}}"""
    assert words in " ".join(map(str.strip, told(text)))


def test_of_a_display_that_is_not_read_every_formula_is_shown_as_it_is_typed() -> None:
    text = (
        r"\begin{document}The motion is $$\dot p=q,\quad \dot q=-p.$$ Then "
        r"\begin{equation}\dot p=-\frac{du}{d\varphi},\qquad \frac{d^2u}{d\varphi^2}+u=3.\end{equation}"
        r"\end{document}"
    )
    html = of_the_paper(
        annotate(audit_reading(ReadingSession(read(decode("a.tex", text.encode())))))
    )
    assert r"\dot p=-\frac{du}{d\varphi}" in html and r"\frac{d^2u}{d\varphi^2}+u=3" in html


def test_a_misprint_in_a_section_that_claims_nothing_has_its_number_and_a_link() -> None:
    text = TWO.replace("The equations", r"\section{One} The equations").replace(
        " Then\n", "\n" + r"\section{Two} Then" + "\n"
    )
    found = audit_reading(ReadingSession(read(decode("two.tex", text.encode())), timeout=20))
    document = annotate(found)
    assert not any("The beginning" in said(b) for b in document.blocks if isinstance(b, Table))
    page = Page(render_html(document))
    start = next(
        k for k, b in enumerate(document.blocks) if getattr(b, "anchor", "") == "misprints"
    )
    link = next(part for part in parts(document.blocks[start + 1].head) if isinstance(part, Link))
    assert link.text == ("(2)",) and link.target in page.ids
    assert {target[1:] for target in page.links if target.startswith("#")} <= {*page.ids}
