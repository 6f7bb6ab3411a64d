"""Rows of the DLMF: a row with one token changed is proved only where it is true all the same."""

import cmath
import random
import runpy
from pathlib import Path

import pytest

from kowalevski_cas.library import load
from kowalevski_cas.notation import Application, Constant, NotationError, Relation
from kowalevski_cas.paper.claims.claim import Neighbour
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.confirm import Disagreement
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement
from tests.sample import sampled

CHAPTERS = {name: load(name) for name in ("dlmf22", "dlmf4")}
ROWS = [(name, claim) for name, one in CHAPTERS.items() for claim in one.claims]


def jacobi(u, k):
    """sn, cn and dn by a power series and by doubling the argument."""
    s = u / 4096
    s = s - (1 + k * k) * s**3 / 6
    c, d = cmath.sqrt(1 - s * s), cmath.sqrt(1 - k * k * s * s)
    for _ in range(12):
        below = 1 - k * k * s**4
        s, c, d = (
            2 * s * c * d / below,
            (c * c - s * s * d * d) / below,
            (d * d - k * k * s * s * c * c) / below,
        )
    return {"s": s, "c": c, "d": d, "n": 1}


def applied(function, u, *modulus):
    name = function.removeprefix("\\").removeprefix("mathrm{").removesuffix("}")
    if modulus:
        of = jacobi(u, modulus[0])
        return of[name[0]] / of[name[1]]
    if name == "exp":
        return cmath.exp(u)
    if name == "det":
        return determinant(u)
    inverse = {
        "sec": "cos",
        "csc": "sin",
        "cot": "tan",
        "sech": "cosh",
        "csch": "sinh",
        "coth": "tanh",
    }
    return 1 / getattr(cmath, inverse[name])(u) if name in inverse else getattr(cmath, name)(u)


def determinant(rows):
    if not rows:
        return 1
    minors = ([row[:k] + row[k + 1 :] for row in rows[1:]] for k in range(len(rows)))
    return sum((-1) ** k * rows[0][k] * determinant(minor) for k, minor in enumerate(minors))


def quarter_period(k):
    """K by the arithmetic and geometric mean."""
    a, b = 1, (1 - k * k) ** 0.5
    for _ in range(8):
        a, b = (a + b) / 2, (a * b) ** 0.5
    return cmath.pi / 2 / a


def value(formula, at, step=5e-3):
    """What a formula is where names have values; derivatives are differences, by z if by a dot.

    Roots are principal ones times a sign.
    """
    kind = type(formula).__name__

    def inner(one):
        return value(one, at, step)

    if kind == "Name":
        return (
            inner(at[formula.name])
            if not isinstance(at[formula.name], complex | float)
            else at[formula.name]
        )
    if kind == "Number":
        return formula.value
    if isinstance(formula, Application):
        return applied(formula.function, *map(inner, formula.arguments))
    if kind == "Derivative":
        by = {"dot": "z", "prime": "z"}.get(formula.mark, formula.mark)
        around = [
            value(formula.argument, at | {by: at[by] + k * step}, step) for k in (-2, -1, 1, 2)
        ]
        return (around[0] - 8 * around[1] + 8 * around[2] - around[3]) / (12 * step)
    if kind == "Modulus":
        return abs(inner(formula.argument))
    below = [inner(child) for child in formula.children()]
    if kind in ("Sum", "Product"):
        total = below[0]
        for one in below[1:]:
            total = total + one if kind == "Sum" else total * one
        return total
    if kind == "Vector":
        return below
    return {
        "Negative": lambda a: -a,
        "Quotient": lambda a, b: a / b,
        "Power": lambda a, b: a**b,
        "Root": lambda a: at["sign"] * cmath.sqrt(a),
    }[kind](*below)


def is_true(formula, definitions, tries=3, sign=1):
    """Whether the members of a chain are equal at points; ``None`` if they are defined nowhere."""
    chance, seen = random.Random(5), None
    for _ in range(tries):
        k = chance.uniform(0.3, 0.8)
        at = {n: chance.uniform(0.2, 0.9) for n in ("z", "u", "v", "x", "y", "z_1", "z_2", "z_3")}
        at |= {"A": chance.uniform(-1, 1), "B": chance.uniform(-1, 1)}
        at |= {
            r"\varphi": cmath.phase(complex(at["A"], at["B"])),
            "k": k,
            "k'": (1 - k * k) ** 0.5,
            r"\pi": cmath.pi,
            "i": 1j,
            "K": quarter_period(k),
            "sign": sign,
            **definitions,
        }
        try:
            values = [value(m, at) for m in formula.members if not isinstance(m, Constant)]
        except (ZeroDivisionError, OverflowError):
            continue
        size = 1 + max(map(abs, values))
        if any(abs(one - values[0]) > 1e-5 * size for one in values):
            return False
        seen = True
    return seen


def mutants(name, claim, count):
    """Neighbours of a row of which the formula is false as numbers, with either sign of its root."""
    texts = CHAPTERS[name].texts()
    definitions = {n: texts.formula(p).members[-1] for n, p in claim.scene.definitions.items()}
    signs = (1, -1) if getattr(claim, "root", None) else (1,)
    for printed in claim.establishes():
        assert is_true(texts.formula(printed), definitions)
    all_of_them = [*claim.neighbours(texts)]
    random.Random(claim.id).shuffle(all_of_them)
    found = 0
    for neighbour in all_of_them:
        assert isinstance(neighbour, Neighbour)
        formula = neighbour.edit.formula
        try:
            false = isinstance(formula, Relation) and all(
                is_true(formula, definitions, sign=sign) is False for sign in signs
            )
        except (KeyError, TypeError, ValueError):
            continue
        if false:
            found += 1
            yield neighbour
        if found == count:
            return


def verdict(name, neighbour):
    session = Session(CHAPTERS[name], ["flint"], timeout=20)
    try:
        statement = Statement(neighbour.claim, session.on(neighbour.claim, neighbour.texts))
        return str(session.decider.outcome(statement, 0.0).verdict)
    except (Meaningless, NotationError, Unproved, Disagreement, StopIteration, TimeoutError):
        return "error"  # nothing is proved, of a claim that is none of the derivation


@pytest.mark.parametrize(("name", "claim"), sampled(ROWS, 1))
def test_a_mutant_of_a_row_is_never_proved(name, claim):
    for neighbour in mutants(name, claim, 2):
        assert verdict(name, neighbour) in ("refuted", "undecided", "error"), neighbour.words


def test_the_page_of_rows_says_what_is_recorded():
    page = Path(__file__).parents[1] / "docs" / "dlmf"
    text = runpy.run_path(str(page.with_suffix(".py")))["page"]()
    assert page.with_suffix(".md").read_text(encoding="utf-8") == text
    assert "refuted" not in text and text.count("not judged") == 3
