"""Mutants: a sign, an index, a power changed. False ones are denied at points that are checked here."""

import re
from dataclasses import replace
from itertools import islice, pairwise

import pytest

from kowalevski_cas import System
from kowalevski_cas.library import available, load
from kowalevski_cas.notation import Constant, Name, NotationError, Power, Relation, to_latex
from kowalevski_cas.paper import claims as kinds
from kowalevski_cas.paper.claims import (
    ChangedEquation,
    Coefficient,
    Equivalence,
    FirstIntegral,
    Identity,
    Implication,
    Independence,
)
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.certificate import certificate
from kowalevski_cas.verify.corrections import true_ones
from kowalevski_cas.verify.counterexamples import counterexample
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement
from tests.paper.plain import close, complex_motion, evaluate, motion, value
from tests.paper.small import derivation
from tests.sample import sampled
from tests.verify.test_refutations import is_refuted


def free_body():
    """Claims of the kinds that no paper has."""
    body = System(r"\dot x=yz,\quad \dot y=-2zx,\quad \dot z=xy")
    body.define(r"\{x,y\}=z,\quad \{y,z\}=x,\quad \{z,x\}=y")
    H, K = body.define(r"H=\frac{1}{2}(x^2-z^2)"), body.define("K=x^2+y^2+z^2")
    body.jacobi(), body.casimir(K), body.involution(K, H), body.integrable(H, casimirs=[K])
    body.darboux("x-z", "-y")
    L = body.define(r"{\bf L}=\begin{pmatrix}0&-z&y\\z&0&-x\\-y&x&0\end{pmatrix}")
    M = body.define(r"{\bf M}=\begin{pmatrix}0&-z&0\\z&0&x\\0&-x&0\end{pmatrix}")
    body.lax(L, M)
    body.inequality(r"x^2+y^2+z^2\ge2xy")
    body.states(kinds.Dimension, "global", "", levels=(), equations=("x=0",), dimension=2)
    body.states(kinds.LocalDimension, "dimension", "", equations=("x=0",), dimension=2)
    body.states(kinds.RestPoints, "rest", "", relations=("x=0", "y=0"))
    body.states(kinds.Eigenvalue, "eigenvalue", "", "", "1", relations=("x=0", "y=1", "z=0"))
    body.states(kinds.AllIntegrals, "all", "", integrals=("x^2-z^2", "x^2+y^2+z^2"), degree=2)
    darboux = {"cofactor": "-y", "solutions": ("x-z",), "integrals": (), "degree": 1}
    body.states(kinds.AllDarboux, "all-darboux", "", **darboux)
    return derivation(body.section)


def rotation():
    """Claims of the kinds that are about maps."""
    turn = System(r"x_{n+1}=y_n,\quad y_{n+1}=-x_n")
    turn.integral("x_n^2+y_n^2"), turn.measure("x_n^2+y_n^2+1"), turn.symplectic()
    turn.integrable("x_n^2+y_n^2"), turn.invariant("x_n=0", "y_n=0")
    turn.states(kinds.FixedPointsOfMap, "fixed", "", relations=("x_n=0", "y_n=0"))
    known = {"invariants": ("x_n^2+y_n^2",), "degree": 2}
    turn.states(kinds.AllInvariantsOfMap, "all-invariants", "", **known)
    return replace(derivation(turn.section), name="rotation")


def flow():
    """Claims about a flow, about a solution by the time, and about a motion that begins on a line."""
    plane = System(r"\dot x=-y+xy,\quad \dot y=x+2y^2")
    plane.states(kinds.Divergence, "divergence", "", printed="5y")
    plane.states(kinds.PreservedMeasure, "measure", "", printed=r"\frac{1}{(1-x)^5}")
    by_time = plane.section.display("by-time", r"u=\cos2t,\quad \ddot u=-4u,\quad u=1,\quad t=0")
    alone = Scene("the time", definitions={"u": by_time[1]})
    plane.section.claim(
        kinds.Solution(
            "by-time", alone, "", printed=by_time[1], equations=(by_time[2],),
            beginning=(by_time[3],), start=(by_time[4],),
        )
    )  # fmt: skip
    line = plane.section.display("line", r"x^2=x,\quad 1^2=1")
    on_it = kinds.Identity("begins", Scene("numbers"), "", printed=line[2])
    plane.section.claim(
        kinds.RelationsOfMotion("line", plane.scene, "", relations=(line[1],), beginning=(on_it,))
    )
    return replace(derivation(plane.section), name="flow")


def near_rest():
    """Claims about the linear part of a flow, which is free of s and π."""
    plane = System(r"\dot x=-2y+sxy+\pi x^2,\quad \dot y=2x+sy^2")
    rest = ("x=0", "y=0")
    plane.states(kinds.Frequency, "frequency", "", printed="4", relations=rest, is_square=True)
    plane.states(kinds.Period, "period", "", printed=r"\pi", relations=rest, is_square=False)
    about = {"relations": rest, "variable": "s"}
    plane.states(kinds.CharacteristicEquation, "characteristic", "", printed="3s^2=-12", **about)
    about = {"relations": rest, "variable": "s"}
    plane.states(kinds.FrequencyEquation, "frequencies", "", printed="3s^2=12", **about)
    plane.states(
        kinds.TraceOrDeterminant, "determinant", "", printed="4", relations=rest, is_trace=False
    )
    matrix = r"\begin{pmatrix}0&-2\\2&0\end{pmatrix}"
    plane.states(kinds.LinearPart, "linear-part", "", printed=matrix, relations=rest)
    return replace(derivation(plane.section), name="near-rest")


def grown():
    """A claim about a point of rest."""
    plane = System(r"\dot x=x(1-x),\quad \dot y=y(2-y)")
    plane.states(kinds.RestPoint, "rest-point", "", printed="(1,2)")
    return replace(derivation(plane.section), name="grown")


def canonical():
    """A claim about any function."""
    pair = System(r"\dot q=p,\quad \dot p=-2q").having("f")
    pair.define(r"\{q,p\}=1,\quad H=\frac{1}{2}p^2+q^2")
    pair.states(kinds.OfAllFunctions, "form", "", printed=r"\dot f=\{f,H\}", of="f")
    return replace(derivation(pair.section), name="canonical")


OWN = (canonical(), free_body(), rotation(), flow(), near_rest(), grown())
SESSIONS = {one.name: Session(one, ["flint"]) for one in (*map(load, available()), *OWN)}
CLAIMS = {
    (name, claim.id): claim for name in SESSIONS for claim in SESSIONS[name].derivation.claims
}
FIRST = {id: claim for (name, id), claim in CLAIMS.items() if name == "kharlamov2002"}
ENOUGH = (1, pytest.param(6, marks=pytest.mark.slow))
"""Mutants of one claim that are looked at."""

NOT_BY_HAND = {
    # their points satisfy relations that the equations written by hand do not know
    "eq9.i", "eq22", "redundant-integral", "appelrot-squares.1", "appelrot-squares.2",
}  # fmt: skip


def statements(session, claim, many=120):
    """The statements of the neighbours of a claim that say something, the first ones."""
    on = session.on(claim)

    def all_of_them():
        for neighbour in claim.neighbours(on.texts):
            try:
                yield neighbour, Statement(neighbour.claim, on.under(neighbour.texts))
            except (Meaningless, NotationError, ZeroDivisionError):
                continue

    return islice(all_of_them(), many)


def refuted_mutants(session, claim):
    """Mutants that are denied, with the evidence against them and what was accepted of it."""
    for neighbour, statement in statements(session, claim):
        try:
            denial = statement.search()
        except (Meaningless, NotationError, ZeroDivisionError):
            continue
        if isinstance(denial, Denial):
            judge = Judge(finder_of)
            judge.denies(statement.goals[denial.goal], denial.evidence)
            yield neighbour, statement, denial, judge.accepted


SLOW = {
    "any-c.1", "any-c.2", "M4.k", "M4.g", "s", "M4-independence", "N4-independence", "limit", "ansatz-exponents",
    "kowalevski-variable", "M4-dimension", "N4-dimension", "equilibria",
}  # fmt: skip
"""Their mutants have roots that are real nowhere, or at few points that are found; or large minors."""

LONG = ("point.", "norms.", "infinity.")
"""Claims on the phase point of O⁴, whose real points are dear."""

BY_HAND = ("consequences", "critical-points")
"""Claims on the critical set: of its equations the search finds no point but the origin."""


def is_slow(name, id):
    return id in SLOW or (name == "kharlamov2007" and id.startswith(LONG))


OF_EACH_KIND = {
    type(claim): (name, id)
    for (name, id), claim in reversed(CLAIMS.items())
    if not is_slow(name, id)
}
"""The first claim of each kind: a quick run looks at these."""

MUTABLE = [
    pytest.param(
        key, id="-".join(key), marks=[] if key in OF_EACH_KIND.values() else [pytest.mark.slow]
    )
    for key in CLAIMS
    if key[1] != "eq9.i"  # it has one neighbour, which is true: the print itself is the mutant
    and not key[1].startswith(BY_HAND)
]


@pytest.mark.parametrize("key", MUTABLE)
def test_a_mutant_is_refuted_at_an_exact_point_and_certified(key):
    """A sign, an index or a power changed makes each claim false somewhere."""
    session, claim = SESSIONS[key[0]], CLAIMS[key]
    _, statement, denial, accepted = next(refuted_mutants(session, claim))
    assert accepted.places or isinstance(claim, Independence | FirstIntegral)
    found = counterexample(statement, denial, accepted)
    assert found is None or (found.left != found.right and found.point.values)
    is_refuted(certificate(statement, denial, accepted))


def test_every_kind_of_claim_has_mutants():
    """Those of unions are in ``test_section4.py``, as no search finds points off them; that of what
    is independent everywhere is in ``test_everywhere.py``, as it establishes no formula.
    """
    mutable = {type(claim).__name__ for claim in CLAIMS.values()} - {"Union"}
    offered = {n for n in kinds.MODULES if isinstance(getattr(kinds, n), type(kinds.Claim))}
    assert mutable == offered - {"Claim", "OfMap", "Union", "EverywhereIndependent"}


def on_by_hand(claim):
    kinds = (Identity, ChangedEquation, FirstIntegral, Equivalence, Implication)
    if not isinstance(claim, kinds) or isinstance(claim, Coefficient) or claim.id in NOT_BY_HAND:
        return False
    return (
        claim.scene.name not in {"any body", "general body"}
        and getattr(claim, "root", None) is None
    )


def is_level(formula, names):
    """Whether a member is a name, or a square of one, that only stands for a value."""
    base = formula.base if isinstance(formula, Power) else formula
    return isinstance(base, Name) and base.name not in names


@pytest.mark.parametrize("enough", ENOUGH)
@pytest.mark.parametrize("id", sampled([id for id, claim in FIRST.items() if on_by_hand(claim)], 1))
def test_the_two_values_are_those_that_plain_python_finds(id, enough):
    session, claim, checked = SESSIONS["kharlamov2002"], FIRST[id], 0
    for neighbour, statement, denial, accepted in refuted_mutants(session, claim):
        found = counterexample(statement, denial, accepted)
        if found is None:
            continue  # what should fail somewhere holds everywhere
        point = {to_latex(name): to_latex(v) for name, v in found.point.values.items()}
        left, right = (value(to_latex(v)) for v in (found.left, found.right))
        by_hand = complex_motion if claim.scene.time == r"\tau" else motion
        names = by_hand(point)
        if "w_3" in point:
            names["w_3"] = value(point["w_3"]) + names["i"] * 0
        names |= {k: value(tex) + names["i"] * 0 for k, tex in point.items() if k not in names}
        formula = neighbour.texts.formula(neighbour.printed)
        members = formula.members if isinstance(formula, Relation) else (formula,)
        members = [m for m in members if not isinstance(m, Constant)]
        if isinstance(claim, FirstIntegral):
            # Of a chain, the member that moves; bare names stand for the value, or move too.
            rates = [evaluate(m, names).rate for m in members if not is_level(m, names)]
            if right == 0:
                assert any(close(rate, left) for rate in rates) and left != 0
            else:  # the members are constant, and not equal
                values = [evaluate(m, names).value for m in members if not is_level(m, names)]
                assert any(close(v, right) for v in values) and not close(left, right)
        elif isinstance(claim, Identity | ChangedEquation):
            values = [evaluate(member, names).value for member in members]
            pairs = [*pairwise(values)]
            if isinstance(formula.members[-1], Constant):
                pairs.append((evaluate(members[0], names).rate, 0))
            assert any(close(a, left) and close(b, right) for a, b in pairs)
            assert not close(left, right)
        else:
            texts = session.on(claim).texts
            other = texts.formula(claim.to) if isinstance(claim, Equivalence) else None
            given = [other] if other else [neighbour.texts.formula(p) for p in claim.given]
            sides = [[evaluate(m, names).value for m in f.members[:2]] for f in given]
            own = [evaluate(m, names).value for m in (*members, *members[:1])[:2]]
            if len(members) == 1:
                own = [own[0], 0]
            holds, fails = (all(close(*s) for s in sides), not close(*own))
            assert (holds and fails) or (other is not None and not fails and not holds)
        checked += 1
        if checked == enough:
            break
    assert checked


NAMES = "eq10.1 eq10.5 theta-prime eq12 U1-prime eq14 F2-prime eq13.conjugate".split()


@pytest.mark.parametrize("id", sampled(NAMES, 1, seed=2))
def test_no_single_edit_of_an_identity_in_the_complex_variables_is_true(id):
    """But for the correction of what is misprinted."""
    session, claim = SESSIONS["kharlamov2002"], FIRST[id]
    on = session.on(claim)
    words = (n.words for n in true_ones(claim.neighbours(on.texts), on))
    true = [w for w in words if not re.match(r"insert [^$]*\$\\theta\$", w)]  # theta is x_1x_2
    printed = Statement(claim, on).holds()
    assert len(true) == (0 if printed else 1), true
