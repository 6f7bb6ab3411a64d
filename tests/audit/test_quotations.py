"""A claim in words has a verdict where the source says it in these words, and nowhere else."""

import re

import pytest

from kowalevski_cas.audit.audit import audit
from kowalevski_cas.library import load
from kowalevski_cas.paper.claims import ChangedEquation, Identity, Unit
from kowalevski_cas.reading.statements import read_statements
from kowalevski_cas.reading.text import references
from kowalevski_cas.source.files import read_source
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.outcome import Verdict
from tests.audit.material import NAME, audited, base, changed, paper_path, source
from tests.sample import sampled


@pytest.mark.parametrize("name", ["kharlamov2002"])
def test_every_claim_that_no_formula_prints_quotes_the_author(name):
    for section in load(name).sections:
        for claim in section.claims:
            formula = isinstance(claim, Identity | ChangedEquation | Unit)
            ours = claim.printed is not None and claim.printed.display.source
            quoting_lemma = claim.id in ("eq1", "kowalevski-variable")
            assert bool(claim.sentence) == (not formula and (not ours or quoting_lemma)), claim.id


def test_all_sentences_are_found_where_they_stand():
    quoted = {
        claim.id: claim.sentence
        for claim in base().interpretation.derivation.claims
        if claim.sentence
    }
    assert audited().sentences.keys() == quoted.keys()
    lines = source().text.split("\n")
    for id, region in audited().sentences.items():
        assert quoted[id].split()[0] in lines[region.line - 1]


def reworded(old: str, new: str) -> str:
    """The source with some words in the place of others, however its lines are broken."""
    words = r"\s+".join(map(re.escape, old.split()))
    text, count = re.subn(words, lambda _: new, source().text)
    assert count
    return text


CHANGES = [
    ("there exists only four such points", "there exists only five such points", "equilibria"),
    ("defines the four-dimensional manifold", "defines the three-dimensional manifold", "eq7"),
    ("is exactly the set of", "contains the set of", "critical-set"),
    ("have two independent first", "have two dependent first", "N4-independence"),
    ("has dimension~4", "has dimension~5", "N4-dimension"),
    ("is purely imaginary", "is not purely imaginary", "reality"),
    ("Recall the", "It is false that one can recall the", "area"),
    ("generalizes the so-called", "generalizes the so-called but", "limit"),
]


@pytest.mark.parametrize(("old", "new", "claim"), sampled(CHANGES, 3))
def test_other_words_get_no_verdict_of_ours(old, new, claim):
    found = audit(Source("paper.tex", reworded(old, new)), base())
    outcome = found.outcomes[claim]
    assert outcome.verdict is Verdict.UNDECIDED
    assert outcome.message.startswith("the words differ: line ")
    assert new.split()[0] in outcome.message
    assert claim not in found.sentences
    others = {id for id, one in found.outcomes.items() if one is not base().outcomes[id]}
    quoted = {c.id: c.sentence for c in base().interpretation.derivation.claims}
    assert {quoted[id] for id in others} == {quoted[claim]}


def test_spaces_fonts_and_line_breaks_are_no_words():
    text = reworded("there exists only four", "there\n{\\it exists}~only\\ four % points\n")
    assert audit(Source("paper.tex", text), base()).sentences.keys() == audited().sentences.keys()


@pytest.mark.slow
def test_a_formula_in_a_sentence_is_compared_as_a_formula():
    found = changed("$A_3=1$", "$A_3=2$")
    assert "time-unit" in found.sentences
    assert not found.outcomes["time-unit"].verdict.green


@pytest.mark.slow
def test_a_formula_that_is_not_there_decides_nothing():
    text = source().text
    found = audit(
        Source("paper.tex", text.replace(r"J_1  = \omega _1^2", r"J_1 \ne \omega _1^2")), base()
    )
    assert not found.outcomes["eq6"].verdict.green
    start = text.index("K = J_1^2")
    begin, end = text.rindex("\\begin", 0, start), text.index("\\end{equation}", start)
    found = audit(Source("paper.tex", text[:begin] + text[end + 14 :]), base())
    assert found.outcomes["eq6"].verdict is Verdict.UNDECIDED
    assert "eq6: the derivation has this formula" in found.outcomes["eq6"].message


def test_what_the_paper_cites_before_a_formula_is_cited_there() -> None:
    """In the words that lead to the formula, or in the sentence of a claim about it."""
    paper, derivation = read_statements(read_source(paper_path())), load(NAME)
    own = {display.id: {*display.cites} for display in derivation.displays()}
    for claim in derivation.claims:
        for place in claim.establishes():
            own[place.display.id] |= {*references(claim.sentence)}
    cited = {
        display.label.strip("()"): {*display.cites}
        for display, typed in paper.displays
        if typed.labels and display.cites
    }
    assert len(cited) > 5
    assert [id for id, labels in cited.items() if not labels <= own[id]] == []
