"""Which points are critical for (2L^2-H)^2-K on the reduced phase space."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from kowalevski_cas.proof.cases import Case

from derivations.kharlamov2002 import derivation
from kowalevski_cas.cli.formats.json import counterexample as in_tex
from kowalevski_cas.notation import edits, to_latex
from kowalevski_cas.paper.claims import CriticalSet, Finding
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.verify.outcome import Counterexample, Verdict
from kowalevski_cas.verify.run import Bench

ARITHMETICS = ("flint", "sympy", "symengine")
TEXTS = derivation.texts()
[CLAIM] = [claim for claim in derivation.claims if isinstance(claim, CriticalSet)]
ON_ZERO_LEVEL = replace(CLAIM, zero_level=True)
assert CLAIM.printed is not None

Point = tuple[Fraction, ...]


def decide(claim: CriticalSet, arithmetic: str = "flint", texts: Texts = TEXTS) -> Finding:
    return claim.decide(Bench(arithmetic, texts))


def point(found: Counterexample) -> Point:
    names = (*(rf"\omega_{k}" for k in (1, 2, 3)), *(rf"\alpha_{k}" for k in (1, 2, 3)))
    return tuple(_fraction(in_tex(found)["point"][name]) for name in names)


def _fraction(tex: str) -> Fraction:
    return Fraction(tex.replace(r"\frac{", "").replace("}{", "/").replace("}", ""))


def function(x: Point) -> Fraction:
    w1, w2, w3, a1, a2, a3 = x
    area = a1 * w1 + a2 * w2 + a3 * w3 / 2
    energy = w1**2 + w2**2 + w3**2 / 2 - a1
    kowalevski = (w1**2 - w2**2 + a1) ** 2 + (2 * w1 * w2 + a2) ** 2
    return (2 * area**2 - energy) ** 2 - kowalevski


def equations(x: Point) -> tuple[Fraction, Fraction]:
    """The left sides of (18) and (19)."""
    w1, w2, w3, a1, a2, a3 = x
    first = (a1**2 + a2**2) * w3 - 2 * (a1 * w1 + a2 * w2) * a3
    return first, 2 * a1 * a2 * (w1**2 - w2**2 + a1) - (a1**2 - a2**2) * (2 * w1 * w2 + a2)


def derivative(x: Point, direction: Point) -> Fraction:
    """The derivative of the function, exactly: its degree on a line is at most 8."""
    nodes = [Fraction(k) for k in range(-4, 5) if k]
    total = Fraction(0)
    for node in nodes:
        weight = Fraction(1) / node
        for other in nodes:
            if other != node:
                weight *= other / (other - node)
        step = tuple(a + node * b for a, b in zip(x, direction, strict=True))
        total += weight * (function(step) - function(x))
    return total


def along_the_sphere(x: Point) -> list[Fraction]:
    a1, a2, a3 = x[3:]
    zero, one = Fraction(0), Fraction(1)
    free = [tuple(one if k == j else zero for k in range(6)) for j in range(3)]
    turns = [(-a2, a1, zero), (-a3, zero, a1), (zero, -a3, a2)]
    return [derivative(x, d) for d in (*free, *((zero, zero, zero, *turn) for turn in turns))]


def on_the_sphere(x: Point) -> bool:
    return sum(a * a for a in x[3:]) == 1


def edited(printed: Printed, tex: str) -> Texts:
    """The texts with the edit that gives this source."""
    found = [e for e in edits(TEXTS.statement(printed), TEXTS.vocabulary) if e.words == tex]
    return TEXTS.edited(printed, found[0])


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_not_all_critical_points_lie_on_the_set(arithmetic: str) -> None:
    """The word “exactly” is refuted: a body that starts at rest, its axis level, is critical."""
    finding = decide(CLAIM, arithmetic)
    assert finding.verdict is Verdict.REFUTED
    assert finding.counterexample is not None
    x = point(finding.counterexample)
    assert on_the_sphere(x)
    assert x[3] ** 2 + x[4] ** 2 != 0
    assert along_the_sphere(x) == [0] * 6
    assert any(equations(x))
    assert function(x) != 0
    assert finding.correction is not None
    assert finding.correction.verdict is Verdict.CONDITIONAL
    assert "at which the function vanishes" in finding.correction.words


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_on_the_zero_level_the_set_is_exactly_that_off_the_poles(arithmetic: str) -> None:
    finding = decide(ON_ZERO_LEVEL, arithmetic)
    assert finding.verdict is Verdict.CONDITIONAL
    [condition] = finding.conditions
    assert to_latex(condition.expression) == r"\alpha_1^2 + \alpha_2^2"
    assert condition.witness is not None
    x = point(condition.witness)
    assert on_the_sphere(x)
    assert (x[3], x[4]) == (0, 0)
    assert equations(x) == (0, 0)
    assert any(along_the_sphere(x))


def test_the_points_off_the_set_are_a_curve() -> None:
    """On omega_1 = omega_2 = alpha_3 = 0 with omega_3^2 = 2 alpha_1 the function is -1."""
    shelf: dict[str, object] = {}
    CLAIM.decide(Bench("flint", TEXTS, shelf=shelf))
    [label] = [label for label in shelf if label.startswith("cases") and "any level" in label]
    open_cases = [one for one in Case.read(shelf[label]).nodes() if one.kind == "open"]
    assert open_cases
    for one in open_cases:
        linear = {next(iter(terms)) for terms in one.known if len(terms) == 1}
        assert {(1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0), (0, 0, 0, 0, 0, 1)} <= linear


@pytest.mark.parametrize(
    "words",
    [
        "sign of $K$",
        "sign of $H$",
        "$2L^2$ without $2$",
        "$3$ for $2$",
        r"$2$ before $K$",
    ],
)
@pytest.mark.parametrize("claim", [CLAIM, ON_ZERO_LEVEL], ids=["any level", "zero level"])
def test_another_function_moves_on_the_set(claim: CriticalSet, words: str) -> None:
    assert claim.printed is not None
    finding = decide(claim, texts=edited(claim.printed, words))
    assert finding.verdict is Verdict.REFUTED
    assert finding.counterexample is not None
    x = point(finding.counterexample)
    assert on_the_sphere(x)
    assert equations(x) == (0, 0)
    assert x[3] ** 2 + x[4] ** 2 != 0


def test_the_edits_do_not_leak_through_shared_stages() -> None:
    bench = Bench("flint", TEXTS)
    assert ON_ZERO_LEVEL.decide(bench).verdict is Verdict.CONDITIONAL
    assert ON_ZERO_LEVEL.printed is not None
    texts = edited(ON_ZERO_LEVEL.printed, "sign of $K$")
    assert ON_ZERO_LEVEL.decide(bench.with_texts(texts)).verdict is Verdict.REFUTED
    assert ON_ZERO_LEVEL.decide(bench).verdict is Verdict.CONDITIONAL


@pytest.mark.parametrize("index", [0, 1])
def test_another_set_is_not_proved(index: int) -> None:
    """Changed signs in (18) and (19) give sets that are larger, smaller, or elsewhere."""
    printed = CLAIM.equations[index]
    signs = [e for e in edits(TEXTS.statement(printed), TEXTS.vocabulary) if "sign" in e.words]
    for edit in signs[1:8]:
        finding = decide(ON_ZERO_LEVEL, texts=TEXTS.edited(printed, edit))
        assert not finding.verdict.green, edit.words


def test_the_correction_comes_first() -> None:
    neighbour = next(CLAIM.neighbours(TEXTS))
    assert neighbour.claim.decide(Bench("flint", TEXTS)).verdict is Verdict.CONDITIONAL


def test_a_wrong_tree_of_cases_proves_nothing() -> None:
    shelf: dict[str, object] = {}
    ON_ZERO_LEVEL.decide(Bench("flint", TEXTS, shelf=shelf))
    [label] = [label for label in shelf if label.startswith("cases")]
    case = Case.read(shelf[label])
    (split,) = case.reductions
    fewer = split._replace(factors=split.factors[:-1])
    forgotten = case._replace(reductions=(fewer,), children=case.children[:-1])
    claimed = Case("set", ())
    for wrong in (forgotten, claimed, case._replace(kind="empty")):
        finding = ON_ZERO_LEVEL.decide(Bench("flint", TEXTS, shelf={label: wrong}))
        assert finding.verdict is Verdict.UNDECIDED
