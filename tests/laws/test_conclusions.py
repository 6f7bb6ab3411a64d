"""What is concluded in words is what was found: it is read back, and differentiated by SymPy."""

import random
import re

import pytest

from kowalevski_cas import System
from kowalevski_cas.notation import Power, Product, read_prose, to_latex
from kowalevski_cas.notation.formula import Application
from kowalevski_cas.notation.sympy import to_sympy
from kowalevski_cas.paper.vocabulary import vocabulary

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

FEW, MANY = 2, 25
MARKS = [FEW, pytest.param(MANY, marks=pytest.mark.slow)]

CONCLUSION = re.compile(r"so \$(.*)\$ is (constant along every motion|a last multiplier|an exponential factor)")  # fmt: skip


def systems(seed):
    """Systems with many invariant lines and planes, of which products are integrals."""
    choose = random.Random(seed)
    a, b, c, d = (choose.choice([-3, -2, -1, 1, 2, 3]) for _ in range(4))
    n, m = choose.randint(1, 3), choose.randint(1, 2)
    yield rf"\dot x=x({a}+{n}y),\quad \dot y=y({b}+{m}x)", 1
    yield rf"\dot x=x({a}+{c}x+y),\quad \dot y=y({b}+{d}x+{n}y)", 1
    yield rf"\dot x=-{n}x+yz,\quad \dot y=-{n}y-xz,\quad \dot z=-{n}z+xy", 2
    yield rf"\dot x=-\nu x+yz,\quad \dot y=-\nu y-xz,\quad \dot z=-\nu z+{m * m}xy", 2
    yield rf"\dot x=x(a+{n}y),\quad \dot y=y(b-x)", 1


def findings(system, degree):
    """What is found, with the words that are said of it."""
    system.seconds = 20
    yield from system.find_darboux(degree)
    yield from system.find_integrals(degree)
    yield from system.find_closure("x+y", order=2)
    yield from system.find_exponents()


def factors(formula):
    """The factors of a product."""
    return formula.factors if isinstance(formula, Product) else (formula,)


def logarithm(formula, symbols):
    """The logarithm of a factor in SymPy, which has no word here for exponentials."""
    from sympy import log

    match formula:
        case Application(r"\exp", (inner,)):
            return to_sympy(inner, symbols)
        case Power(base, exponent):
            return to_sympy(exponent, symbols) * log(to_sympy(base, symbols))
    return log(to_sympy(formula, symbols))


def is_right(formula, ending, field, symbols):
    """Whether a conclusion holds, by the logarithmic derivative along the field."""
    from sympy import diff, simplify

    own = sum(logarithm(one, symbols) for one in factors(formula))
    rate = simplify(sum(diff(own, x) * force for x, force in field.items()))
    if ending.startswith("constant"):
        return rate == 0
    if ending.startswith("a last"):
        return simplify(rate + sum(diff(force, x) for x, force in field.items())) == 0
    return rate.is_polynomial()


def field_of(system):
    """The vector field in SymPy."""
    formulas = system._formulas(system.section.displays[0])
    return {
        to_sympy(equation.members[0].argument, system.symbols): to_sympy(
            equation.members[1], system.symbols
        )
        for equation in formulas
    }


@pytest.mark.parametrize("many", MARKS)
def test_a_conclusion_is_read_back_as_it_was_found(many):
    concluded = 0
    for seed in range(many):
        for tex, degree in systems(seed):
            system = System(tex)
            field = field_of(system)
            for stated in findings(system, degree):
                words = vocabulary((stated.claim.scene,))
                runs = read_prose(stated.claim.words, words)
                again = "".join(r if isinstance(r, str) else f"${to_latex(r)}$" for r in runs)
                said = stated.claim.words.replace(r",\ ", "$, $")
                assert again.replace(" ", "") == said.replace(" ", "")
                if conclusion := CONCLUSION.fullmatch(stated.claim.words):
                    concluded += 1
                    (_, formula, _) = runs
                    assert is_right(formula, conclusion[2], field, system.symbols), stated
                else:
                    assert not stated.claim.words.startswith("so "), "another connective: add it"
    assert concluded >= many
