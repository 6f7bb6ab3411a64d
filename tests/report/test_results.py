"""The main results: whether they stand follows from the verdicts, and from what they rest on."""

from __future__ import annotations

import hashlib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.notation import Relation
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.report.document import Judgement, Paragraph
from kowalevski_cas.report.findings import Findings
from kowalevski_cas.report.marks import MARKS
from kowalevski_cas.report.results import main_results
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.report.tally import wrong_places
from kowalevski_cas.verify.outcome import Outcome, Verdict
from tests.report.fixtures import (
    WORDS,
    C,
    P,
    R,
    claim,
    condition,
    correction,
    counterexample,
    outcomes,
    point,
    read,
)
from tests.report.test_contents import said

PRINT = Path(__file__).parents[3] / "shared/paper/000_68642ca11e599718.txt"


def paragraphs(*found: Outcome, main: tuple[str, ...]) -> list[str]:
    phrases = Phrases(WORDS, {})
    blocks = main_results(Findings(phrases, found), main)
    return [said(b.text if isinstance(b, Paragraph) else b.head) for b in blocks]  # type: ignore[union-attr]


def misprint(name: str, rests_on: tuple[str, ...] = ()) -> Outcome:
    right = correction("x=x", "", P, place=name)
    return claim(name, "1", "x=y", "", R, correction=right, rests_on=rests_on)


def test_without_a_main_result_nothing_is_said() -> None:
    assert paragraphs(*outcomes(), main=()) == []


@pytest.mark.parametrize(
    ("verdict", "sentence"),
    [(P, "stands"), (C, "stands"), (R, "fails"), (Verdict.UNDECIDED, "is not decided"),
     (Verdict.TIMEOUT, "is not decided"), (Verdict.PROBABLE, "is not decided")],
)  # fmt: skip
def test_the_verdict_says_whether_it_stands(verdict: Verdict, sentence: str) -> None:
    first, second = paragraphs(claim("a", "1", "x=x", "it is so", verdict), main=("a",))
    means = f" The sign {C} marks what {MARKS[C].meaning}."
    sign = means if verdict is C else ""  # where a sign needs words
    assert first == f"The main result {sentence}.{sign}"
    assert "it is so" in second


def test_several_results_are_told_apart() -> None:
    both = claim("a", "1", "x=x", "", P), claim("b", "1", "x=y", "", R)
    assert paragraphs(*both, main=("a", "b"))[0].startswith(
        "Of two main results one stands and one fails."
    )


def test_what_is_false_beside_them_is_counted() -> None:
    both = claim("a", "1", "x=x", "", P), claim("b", "1", "x=y", "it is not so", R)
    findings = Findings(Phrases(WORDS, {}), both)
    assert paragraphs(*both, main=("a",))[0] == (
        "The main result stands. One other statement is false."
    )
    assert "other" not in paragraphs(*both, main=("a", "b"))[0]
    heading, false = wrong_places(findings)
    assert said(heading.text) == "One statement is false."
    assert isinstance(false, Judgement) and "“it is not so”" in said(false.head)


def test_a_misprint_has_its_two_values_beside_it() -> None:
    fails = counterexample(point({"x": "1"}), "1", "2")
    (lead, line) = wrong_places(
        Findings(Phrases(WORDS, {}), [misprint("m")._replace(counterexample=fails)])
    )
    assert said(lead.text) == (
        "Misprinted. In brackets: the two sides at a point, which is given with the formula "
        "below. The correction is proved."
    )
    pair = Relation((fails.left, fails.right), (r"\ne",))  # one formula, which is not broken
    assert isinstance(line, Judgement) and line.head[-4:] == (" (", pair, ")", ".")


def test_what_fails_elsewhere_than_in_the_misprint_is_named() -> None:
    fails = counterexample(point({"x": "1"}), "1", "2", "the left side of another is 1, not 2")
    wrong = misprint("m")._replace(counterexample=fails)
    (_, line) = wrong_places(Findings(Phrases(WORDS, {}), [wrong]))
    assert said(line.head).endswith(" (the left side of another is 1, not 2).")


def test_a_short_misprint_is_shown_as_printed_and_as_meant() -> None:
    for print_, short in (("x=2x", True), ("x=" + "+".join(["x"] * 20), False)):
        wrong = misprint("m")._replace(formulas=read(print_))
        (_, line) = wrong_places(Findings(Phrases(WORDS, {}), [wrong]))
        said_whole = ("for ", *read(print_), " read ", *read("x=x"), ".")
        assert isinstance(line, Judgement) and (line.head[-5:] == said_whole) == short


def test_what_is_false_has_its_point_beside_it() -> None:
    fails = counterexample(point({"x": "1"}), "1", "2", "it is not so there")
    wrong = claim("b", "1", "x=y", "it is so", R, counterexample=fails)
    (_, false) = wrong_places(Findings(Phrases(WORDS, {}), [wrong]))
    assert isinstance(false, Judgement) and said(false.head).endswith("it is not so there.")


def test_conditions_are_named() -> None:
    needs = claim("a", "1", "x=x", "it is so", C, conditions=(condition("x", ""),))
    (_, block) = main_results(Findings(Phrases(WORDS, {}), [needs]), ["a"])
    assert isinstance(block, Judgement) and "where" in said(block.head)


@pytest.mark.parametrize(
    ("squares", "zeros", "words"), [("a^2+b^2", "a=0,b=0", ""), ("(a-x)^2+b^2", "a=x,b=0", " or ")]
)
def test_that_a_sum_of_squares_is_not_zero_is_said_of_them_unless_they_are_of_letters(
    squares: str, zeros: str, words: str
) -> None:
    needed = condition(squares, "", counterexample(point({"a": "0"}), "1", "2"))
    needed = needed._replace(zeros=(*read(zeros),))
    needs = claim("a", "1", "x=x", "it is so", C, conditions=(condition("x", ""), needed))
    (_, text) = paragraphs(needs, main=("a",))
    where = f"{words} " if words else " "
    assert text == (  # formulas are left out
        f"a: it is so, where  (elsewhere nothing is proved here), and {where}(without which it is false)."
    )


def test_dependent_differentials_refute_no_manifold() -> None:
    needed = condition("a", "", counterexample(point({"a": "0"}), "1", "2"))._replace(singular=True)
    needs = claim("a", "1", "x=x", "it is one", C, conditions=(needed,))
    (_, text) = paragraphs(needs, main=("a",))
    assert "false" not in text
    assert "without which the differentials of its equations are dependent somewhere" in text


def test_a_point_is_given_where_a_hypothesis_is_missing() -> None:
    needed = condition("a", "it is not so", counterexample(point({"a": "0"}), "1", "2"))
    needs = claim("a", "1", "x=x", "it is so", C, conditions=(needed,))
    (_, block) = Findings(Phrases(WORDS, {}), [needs]).hypotheses()
    assert isinstance(block, Judgement) and "At : the left side is" in said(block.blocks)


def test_every_hypothesis_that_is_missing_is_named_on_the_first_screen() -> None:
    needs = condition("a", "", counterexample(point({"a": "0"}), "1", "2"))
    found = [claim(name, "1", "x=x", "", C, conditions=(needs,)) for name in ("first", "second")]
    (missing,) = wrong_places(Findings(Phrases(WORDS, {}), found))
    assert said(missing.text) == "Not stated, though the proofs need it:  (for first and second)."
    assert [*wrong_places(Findings(Phrases(WORDS, {}), [claim("b", "1", "x=x", "", P)]))] == []


@given(st.lists(st.booleans(), min_size=1, max_size=4))
def test_a_misprint_is_named_if_and_only_if_the_result_rests_on_it(touching: list[bool]) -> None:
    wrong = [misprint(f"m{k}") for k in range(len(touching))]
    used = tuple(one.claim for one, touches in zip(wrong, touching, strict=True) if touches)
    step = claim("step", "1", "x=x", "", P, corrected=used)
    result = claim("a", "1", "x=x", "", P, rests_on=("step",))
    text = paragraphs(*wrong, step, result, main=("a",))[0]
    assert all((one.claim in text) == touches for one, touches in zip(wrong, touching, strict=True))
    assert ("not touch it" in text) == (not all(touching))


def test_a_main_result_is_a_claim() -> None:
    with pytest.raises(ValueError, match="no claim is called eq1"):
        Derivation("d", "", "", "", (Section("1", ""),), main=("eq1",))


@pytest.mark.skipif(not PRINT.exists(), reason="the paper is not here")
def test_the_digest_of_the_edition_is_that_of_the_text(derivation: Derivation) -> None:
    assert hashlib.sha256(PRINT.read_bytes()).hexdigest()[:16] in derivation.edition
