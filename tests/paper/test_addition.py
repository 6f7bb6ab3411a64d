"""Addition theorems are theorems: with another table of the functions they are not proved."""

import json
from dataclasses import replace

import pytest

from kowalevski_cas.notation import NotationError
from kowalevski_cas.notation.functions import (
    CIRCULAR,
    EXPONENTIAL,
    FAMILIES,
    JACOBI,
    ROTATED,
    WEIERSTRASS,
)
from kowalevski_cas.paper.addition import rotation, theorem
from kowalevski_cas.paper.families import By
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.codec import digest, evidence_data, problem_data
from kowalevski_cas.problem.evidence import At
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Along
from kowalevski_cas.problem.prune import prune
from kowalevski_cas.search.find import Finder
from tests.sample import sampled

SUMS = [By.SUM, By.DIFFERENCE, By.OPPOSITE]


def certificate(goal, evidence):
    """The text of a certificate of one goal, which nobody has checked."""
    problem = prune([goal])
    head = {"format": "kowalevski-cas certificate", "version": 2, "claim": "theorem"}
    sign = "holds" if isinstance(evidence, At) else "denied"
    entry = evidence_data(evidence) | ({} if sign == "holds" else {"goal": 0})
    data = head | problem_data(problem) | {"sign": sign, "evidence": [entry]}
    return json.dumps(data | {"digest": digest(problem)})


@pytest.mark.parametrize(
    ("family", "by"), [(f, by) for f in FAMILIES for by in (*SUMS, By.DOUBLE) if f.sum]
)
def test_addition_theorems_are_proved(family, by):
    goal = theorem(family, by)
    evidence = Finder(finder_of).proof(goal)
    Judge(finder_of).holds(goal, evidence)
    assert checker.check(certificate(goal, evidence)).sign == "holds"


def mutants(family):
    """Families of which one entry of the table is another one."""
    for key in ("rates", "zero", "sum", "minus", "double"):
        own = getattr(family, key)
        for letter, tex in own.items():
            for old, new in (
                ("0", "1"),
                ("1", "0"),
                ("-", "+"),
                ("+", "-"),
                ("s", "c"),
                ("c", "s"),
                ("^2", "^3"),
            ):
                if old in tex and not (key == "rates" and tex == "-s" and new == "+"):
                    mutant = tex.replace(old, new, 1)
                    if mutant[0] != "+":
                        yield key, replace(family, **{key: {**own, letter: mutant}})


@pytest.mark.parametrize(
    ("family", "key", "mutant"),
    sampled(
        [
            (f, key, one)
            for f in (CIRCULAR, EXPONENTIAL, JACOBI, WEIERSTRASS)
            for key, one in mutants(f)
        ],
        5,
    ),
)
def test_with_another_table_none_is_proved(family, key, mutant):
    """Rates, values at zero, sums and opposites: one of them alone is not another one.

    What the search does not find the checker does not believe either.
    """
    proved = []
    for by in (*SUMS, By.DOUBLE):
        try:
            goal, true = theorem(mutant, by), theorem(family, by)
        except NotationError:
            continue
        if (goal.initial, goal.equations) == (true.initial, true.equations) and key != "rates":
            continue  # it does not speak of what was changed
        finder = Finder(finder_of)
        try:
            evidence = finder.proof(goal)
        except ValueError:
            continue
        proved.append(evidence)
        point = finder.proof(true)
        for forged in (point, At(finder.point(finder_of(goal.space)))):
            with pytest.raises((Unproved, ValueError)):
                Judge(finder_of).holds(goal, forged)
            with pytest.raises(checker.Rejected):
                checker.check(certificate(goal, forged))
    assert not any(proved)


def test_what_is_false_is_denied_by_a_derivative():
    """That of the sine of a sum where the second angle is zero."""
    family = replace(CIRCULAR, sum={**CIRCULAR.sum, "s": "sc_1-cs_1"})
    goal = theorem(family, By.SUM)
    evidence = Finder(finder_of).refutation(goal)
    assert evidence.order == 1
    Judge(finder_of).denies(goal, evidence)
    assert checker.check(certificate(goal, evidence)).sign == "denied"


def test_it_begins_where_the_system_is_regular():
    """A motion that begins at a pole has no solution to be equal to."""
    true = theorem(CIRCULAR, By.SUM)
    initial = tuple((name, value) for name, value in true.initial[1:])
    for goal in (Along(true.space, initial, true.equations), Along(true.space, (), true.equations)):
        with pytest.raises(checker.Rejected):
            checker.check(certificate(goal, Finder(finder_of).proof(true)))


@pytest.mark.parametrize("family", ROTATED)
def test_functions_at_imaginary_arguments_are_proved(family):
    goal = rotation(family)
    evidence = Finder(finder_of).proof(goal)
    Judge(finder_of).holds(goal, evidence)
    assert checker.check(certificate(goal, evidence)).sign == "holds"


@pytest.mark.parametrize(
    ("family", "letter", "wrong"),
    [
        (CIRCULAR, "s", r"\frac{1}{2}(e^2-\frac{1}{e^2})"),
        (CIRCULAR, "c", r"\frac{i}{2}(e^2+\frac{1}{e^2})"),
        (EXPONENTIAL, "e", "c-is"),
        (JACOBI, "s", r"\frac{s}{c}"),
        (JACOBI, "c", r"\frac{d}{c}"),
        (JACOBI, "d", r"\frac{1}{c}"),
    ],
)
def test_other_functions_at_imaginary_arguments_are_not(family, letter, wrong, monkeypatch):
    mutant = replace(family, imaginary={**family.imaginary, letter: wrong})
    monkeypatch.setitem(ROTATED, mutant, ROTATED[family])
    goal = rotation(mutant)
    assert Finder(finder_of).proof(goal) is None
    with pytest.raises(checker.Rejected):
        checker.check(certificate(goal, Finder(finder_of).proof(rotation(family))))
