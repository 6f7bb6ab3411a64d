"""The body has exactly four equilibria, unless a = b and c = 0."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from kowalevski_cas.proof.cases import Terms
from kowalevski_cas.proof.roots import Roots

from derivations.kharlamov2002 import derivation
from kowalevski_cas.cli.formats.json import counterexample as in_tex
from kowalevski_cas.notation import Number, to_latex
from kowalevski_cas.paper.claims import Equilibria, Finding
from kowalevski_cas.search.squares import sum_of_squares
from kowalevski_cas.verify.outcome import Counterexample, Verdict
from kowalevski_cas.verify.run import Bench

ARITHMETICS = ("flint", "sympy", "symengine")
TEXTS = derivation.texts()
[CLAIM] = [claim for claim in derivation.claims if isinstance(claim, Equilibria)]

Vector = tuple[Fraction, ...]


def decide(arithmetic: str, count: int = 4) -> Finding:
    return replace(CLAIM, count=count).decide(Bench(arithmetic, TEXTS))


def listed(found: Counterexample) -> list[tuple[Vector, Vector]]:
    """The fields at the states of rest that a counterexample lists."""

    def vector(tex: str) -> Vector:
        return tuple(Fraction(x) for x in tex.strip("()").split(","))

    values = in_tex(found)["point"]
    alpha = [vector(v) for name, v in values.items() if r"\alpha" in name]
    beta = [vector(v) for name, v in values.items() if r"\beta" in name]
    return list(zip(alpha, beta, strict=True))


def scalar_product(left: Vector, right: Vector) -> Fraction:
    return sum((x * y for x, y in zip(left, right, strict=True)), Fraction(0))


def is_equilibrium(alpha: Vector, beta: Vector) -> bool:
    """e1 x alpha + e2 x beta = 0, in components."""
    return (beta[2], -alpha[2], alpha[1] - beta[0]) == (0, 0, 0)


def constants(alpha: Vector, beta: Vector) -> tuple[Fraction, ...]:
    pairs = ((alpha, alpha), (beta, beta), (alpha, beta))
    return tuple(scalar_product(left, right) for left, right in pairs)


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_there_are_four_unless_the_fields_are_orthogonal_and_equal(arithmetic: str) -> None:
    finding = decide(arithmetic)
    assert finding.verdict is Verdict.CONDITIONAL
    assert [to_latex(c.expression) for c in finding.conditions] == ["(a^2 - b^2)^2 + 4c^2"]


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_on_the_exceptional_locus_there_are_five(arithmetic: str) -> None:
    [condition] = decide(arithmetic).conditions
    assert condition.witness is not None
    states = listed(condition.witness)
    assert condition.witness.left == Number(5) == Number(len(set(states)))
    assert condition.witness.right == Number(4)
    assert all(is_equilibrium(alpha, beta) for alpha, beta in states)
    [(a2, b2, c)] = {constants(alpha, beta) for alpha, beta in states}
    assert a2 == b2
    assert c == 0
    assert a2 * b2 - c**2 != 0


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
@pytest.mark.parametrize("count", [2, 3, 5, 8])
def test_another_number_is_refuted_by_a_list_of_all(arithmetic: str, count: int) -> None:
    found = decide(arithmetic, count).counterexample
    assert found is not None
    assert (found.left, found.right) == (Number(4), Number(count))
    states = listed(found)
    assert len(set(states)) == 4
    assert all(is_equilibrium(alpha, beta) for alpha, beta in states)
    [(a2, b2, c)] = {constants(alpha, beta) for alpha, beta in states}
    assert (a2 - b2) ** 2 + 4 * c**2 != 0
    assert a2 * b2 - c**2 != 0


def test_each_mutant_is_refuted() -> None:
    for neighbour in CLAIM.neighbours(TEXTS):
        assert neighbour.claim.decide(Bench("flint", TEXTS)).verdict is Verdict.REFUTED


def certificate() -> tuple[dict[str, object], Roots]:
    shelf: dict[str, object] = {}
    CLAIM.decide(Bench("flint", TEXTS, shelf=shelf))
    [label] = [label for label in shelf if label.startswith("roots")]
    return shelf, Roots.read(shelf[label])


def test_the_eliminant_is_a_biquadratic() -> None:
    eliminant = certificate()[1].eliminant
    one = Fraction(1)
    assert eliminant.form == (1, 0, 1)
    assert eliminant.equation == {
        (4, 0, 0, 0): one,
        (2, 1, 0, 0): -2 * one,
        (2, 0, 1, 0): -2 * one,
        (0, 2, 0, 0): one,
        (0, 1, 1, 0): -2 * one,
        (0, 0, 2, 0): one,
        (0, 0, 0, 2): 4 * one,
    }


def changed(terms: Terms) -> Terms:
    first = max(terms)
    return {**terms, first: terms[first] + 1}


@pytest.mark.parametrize("part", ["equation", "numerators", "quotients", "products", "signs"])
def test_a_wrong_certificate_proves_nothing(part: str) -> None:
    shelf, roots = certificate()
    eliminant = roots.eliminant
    if part == "equation":
        power = next(k for k in eliminant.equation if k[0] == 2)
        wrong = eliminant._replace(equation={**eliminant.equation, power: Fraction(2)})
        roots = roots._replace(eliminant=wrong)
    elif part == "numerators":
        first, *rest = eliminant.numerators
        roots = roots._replace(eliminant=eliminant._replace(numerators=(changed(first), *rest)))
    elif part == "quotients":
        first, *rest = (q for q in roots.quotients)
        roots = roots._replace(quotients=(changed(first or {(0, 0, 0, 0): Fraction(1)}), *rest))
    elif part == "products":
        (number, powers), *others = roots.products
        roots = roots._replace(products=((-number, powers), *others))
    else:
        sign, *signs = roots.signs
        roots = roots._replace(signs=(sign._replace(in_variables=(), in_parameters=()), *signs))
    [label] = [label for label in shelf if label.startswith("roots")]
    finding = CLAIM.decide(Bench("flint", TEXTS, shelf={label: roots}))
    assert finding.verdict is Verdict.UNDECIDED


def test_what_is_negative_somewhere_is_no_sum_of_squares() -> None:
    one = Fraction(1)
    assert sum_of_squares({(2, 0): one, (1, 1): 3 * one, (0, 2): one}) is None
    assert sum_of_squares({(2, 0): one, (1, 1): one, (0, 2): one}) is not None
    assert sum_of_squares({(2, 0): one, (0, 1): one}) is None
