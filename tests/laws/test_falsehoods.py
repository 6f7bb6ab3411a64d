"""What is false is never green, unless a condition is named that excludes the point where it is."""

from collections import Counter
from fractions import Fraction

import pytest

from kowalevski_cas.notation import Formula, Name, Negative, Number, Power, Product, Quotient, Sum
from kowalevski_cas.verify.run import Session
from tests.laws.falsehoods import KINDS, NAMES, Maker
from tests.laws.systems import Stated, System

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

FEW, MANY = 2, 200


def value(formula: Formula, point: dict[str, int]) -> Fraction:
    """The value of a rational expression at a point."""
    match formula:
        case Number(number):
            return Fraction(number)
        case Name(name):
            return Fraction(point[name])
        case Negative(argument):
            return -value(argument, point)
        case Sum(terms):
            return sum((value(term, point) for term in terms), Fraction(0))
        case Product(factors):
            result = Fraction(1)
            for factor in factors:
                result *= value(factor, point)
            return result
        case Power(base, Number(exponent)):
            return value(base, point) ** exponent
        case Quotient(above, below):
            return value(above, point) / value(below, point)
    raise AssertionError(f"a condition is no rational expression: {formula}")


def outcome_of(false, seconds):
    stated = Stated(false.about, false.tex, given=false.given, number=false.number)
    system = System("false", false.motion, NAMES, (stated,), nonzero=false.nonzero, root=false.root)
    (outcome,) = Session(system.derivation(), ("flint",), timeout=seconds).run().outcomes
    return outcome


def never_green(kind, many, seconds):
    maker = Maker(2002)
    counted = Counter()
    for _ in range(many):
        false = kind(maker)
        outcome = outcome_of(false, seconds)
        verdict = str(outcome.verdict)
        counted[verdict] += 1
        assert verdict != "proved", false
        if verdict == "conditional":
            assert false.point is not None, (false, outcome.conditions)
            names = {**false.point, **({"r": 0} if false.root else {})}
            assert any(value(c.expression, names) == 0 for c in outcome.conditions), false
    return counted


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_what_is_false_is_never_green(kind):
    counted = never_green(kind, FEW, 1)
    assert counted["error"] < FEW


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_thousands_of_false_statements_are_never_green(kind, record_property):
    counted = never_green(kind, MANY, 5)
    record_property("verdicts", dict(counted))
    print(kind.__name__, dict(counted))
