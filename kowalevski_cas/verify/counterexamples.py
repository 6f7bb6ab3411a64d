"""Counterexamples: the point at which a statement fails, and what it shows there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Number,
    Partial,
    Relation,
    Vector,
    equal,
    to_latex,
    total,
)
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.claims.forms import ZERO
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.collect import collect_sides
from kowalevski_cas.problem.differentials import functions_for_differentials
from kowalevski_cas.problem.evidence import (
    At,
    Denial,
    Entailment,
    Evidence,
    Minors,
    Regardless,
    Roots,
    Solutions,
)
from kowalevski_cas.problem.examine import Accepted
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Count, Exists, Fails, Follows, Goal, Rank
from kowalevski_cas.problem.place import PointEvaluation, number_formula
from kowalevski_cas.problem.space import Setting
from kowalevski_cas.verify.as_printed import point, printed_formula, printed_name, signed_product
from kowalevski_cas.verify.loci import circle_of
from kowalevski_cas.verify.outcome import Counterexample, PrintedPoint, Value
from kowalevski_cas.verify.statement import Statement

SHORT = 160
"""The most letters of an equation in LaTeX that is named within a sentence."""

OF_BRACKETS = ("Casimir", "Involution", "Jacobi", "LiouvilleIntegrable")
"""The kinds of claims that are about Poisson brackets."""

ORDINALS = ("first", "second", "third")
"""The components of a vector in space."""

MANY = "infinitely many"
"""How many solutions there are on a circle."""


def counterexample(
    statement: Statement, denial: Denial, accepted: Accepted
) -> Counterexample | None:
    """The point at which a denied goal fails, with the two values there, and what they are of."""
    found = against(statement, statement.goals[denial.goal], denial.evidence, accepted)
    return None if found is None else found._replace(defined=tuple(_definitions(statement)))


def _definitions(statement: Statement) -> Iterator[tuple[Formula, Printed]]:
    """The printed definitions of the names in a claim, and of the names in these, each once."""
    scene, texts = statement.claim.scene, statement.on.texts
    vector = {part: name for name, parts in scene.vectors.items() for part in parts}
    waiting = [*statement.claim.formulas(texts)]
    seen = {*statement.claim.shown()}
    if scene.clock and any(isinstance(n, Derivative) for f in waiting for n in f.nodes()):
        yield texts.formula(scene.clock), scene.clock
    for formula in waiting:
        for name in dict.fromkeys(node.name for node in formula.nodes() if isinstance(node, Name)):
            place = scene.definitions.get(name) or scene.definitions.get(vector.get(name, ""))
            if place is not None and place not in seen:
                seen.add(place)
                waiting.append(texts.formula(place))
                yield waiting[-1], place


def against(
    statement: Statement, goal: Goal, evidence: Evidence, accepted: Accepted
) -> Counterexample | None:
    """The last point that evidence against a goal gave, with the two values there, if any."""
    if isinstance(evidence, Solutions) and isinstance(goal, Count):
        return _solutions(statement, goal, accepted)
    if isinstance(evidence, Roots) and isinstance(goal, Count):
        number = len(evidence.eliminant)
        words = f"the number of solutions, all of them real, is {number}, not {goal.number}"
        there = _at(statement, accepted.places[-1])
        return Counterexample(there, Number(number), Number(goal.number), words)
    if isinstance(evidence, Minors) or not accepted.places:
        return None
    place = accepted.places[-1]
    if isinstance(goal, Rank):
        dimension = len(place.at.setting.variables) - len(
            functions_for_differentials(goal, place.at)
        )
        claimed = len(place.at.setting.variables) - goal.rank
        words = f"by the rank at this point the dimension is {dimension}, not {claimed}"
        return Counterexample(_at(statement, place), Number(dimension), Number(claimed), words)
    if statement.claim.is_kind("Inequality"):
        return _equal_or_less(statement, goal, place)
    if accepted.differs is not None:
        left, right = map(number_formula, accepted.differs)
        words = _words(statement, goal, place, (to_latex(left), to_latex(right)))
        return Counterexample(_at(statement, place), left, right, words)
    if isinstance(evidence, Regardless) and isinstance(goal, Exists):
        return _regardless(statement, goal, evidence, place)
    return None


def _equal_or_less(
    statement: Statement, goal: Goal, place: PointEvaluation
) -> Counterexample | None:
    """A point at which the larger side is the smaller one, or both are equal."""
    assert isinstance(goal, Follows)
    (stated,) = goal.conclusions or (goal.given[-1:],)
    (difference, _), printed = stated[0], statement.claim.scene.roots
    value = number_formula(place(place.at.scalar(difference)))
    values = place.point.values.items()
    shown_values = {n: v for n, v in values if n in printed or not n.startswith(r"\sqrt")}
    here = point(shown_values, statement.legend[place.at.setting])
    shown = to_latex(printed_formula(difference, statement.legend[place.at.setting]))
    words = f"there ${shown}={to_latex(value)}$"
    return Counterexample(here, value, Number(0), words)


def _at(statement: Statement, place: PointEvaluation) -> PrintedPoint:
    return point(place.point.values, statement.legend[place.at.setting])


def _words(
    statement: Statement, goal: Goal, place: PointEvaluation, values: tuple[str, str]
) -> str:
    """What fails at a point, if not what is printed; ``values`` are the two sides there."""
    assert isinstance(goal, Follows)
    value, other = values
    setting = statement.legend[place.at.setting]
    left, right = (printed_formula(side, setting) for side in _failing_equation(goal, place))
    order = 0
    while isinstance(left, Derivative):
        left, order = left.argument, order + 1
    component = _component(goal, place)
    if order and _is_zero(right):
        which = ("", "second ", "third ")[min(order, 3) - 1]
        of = to_latex(left)
        whose = f" of ${of}$" if len(of) < SHORT else " of a given function" if goal.given else ""
        return f"{component}the {which}derivative{whose} along the motion is ${value}$, not $0$"
    if statement.claim.is_kind(*OF_BRACKETS):
        if not order:
            return f"a bracket is ${value}$, not $0$"
        rate = f"the derivative of ${to_latex(left)}$ is ${value}$"
        return f"{rate}, and its bracket with the Hamiltonian ${other}$"
    if statement.claim.is_kind("EverywhereIndependent"):
        return "there the differentials are dependent"
    if right == Number(0) and (meaning := _of_vanishing(statement, left, value)):
        return meaning
    sides = to_latex(equal(left, right))
    number = _number(statement, (left, right))
    what = f" of {number}${sides}${',' * bool(number)}" if not order and len(sides) < SHORT else ""
    if not goal.given:
        printed = statement.claim.formulas(statement.on.texts)
        said = {m for one in printed if isinstance(one, Relation) for m in one.members}
        what = "" if said & {left, right} else what
        if not component + what:
            return ""
    words = f"{component}the left side{what} is ${value}$, {_other(right, other, component)}"
    if statement.claim.is_kind("CriticalSet"):
        surface = to_latex(equal(*(printed_formula(side, setting) for side in goal.given[-1])))
        return f"{words}, though this is a critical point on ${surface}$"
    return f"{words}, though the hypotheses hold" if goal.given else words


def _of_vanishing(statement: Statement, left: Formula, value: str) -> str:
    """What it means that something does not vanish of which no reader knows; empty if he does."""
    if statement.claim.is_kind("Eigenvalue", "Frequency"):
        return f"the determinant that has to vanish is ${value}$"
    if any(isinstance(node, Partial) for node in left.nodes()):
        return f"a derivative of the function is ${value}$, so the point is not critical"
    return ""


def _failing_equation(goal: Follows, place: PointEvaluation) -> tuple[Formula, Formula]:
    """The first equation of the last conclusion that does not hold at a point."""
    return next(
        sides for sides in goal.conclusions[-1] if not place.vanish(place.at.differences((sides,)))
    )


def _other(right: Formula, value: str, component: str) -> str:
    """What the other side is, of which perhaps a component is named before."""
    if _is_zero(right):
        return "not $0$"
    return f"{'that of ' * bool(component)}the right side ${value}$"


def _is_zero(formula: Formula) -> bool:
    """Whether a side is zero, or a vector of zeros."""
    return formula == ZERO or (isinstance(formula, Vector) and {*formula.components} == {ZERO})


def _component(goal: Follows, place: PointEvaluation) -> str:
    """Which component of a printed equation between vectors does not hold at a point."""
    pairs = place.at.pairs((_failing_equation(goal, place),))
    if not 1 < len(pairs) <= len(ORDINALS):
        return ""
    differ = (not place.vanish([one - other]) for one, other in pairs)
    return f"the {ORDINALS[[*differ].index(True)]} component of "


CONSTANT = "the function is constant by itself"


def _number(statement: Statement, sides: tuple[Formula, Formula]) -> str:
    """The number of an equation of a critical set, as its paper prints it, if it has one."""
    claim = statement.claim
    printed: tuple[Printed, ...] = vars(claim)["equations"] if claim.is_kind("CriticalSet") else ()
    for one in printed:
        if statement.on.texts.relation(one).members == sides and one.display.label.startswith("("):
            return f"{one.display.label}, "
    return ""


def why(claim: Claim, goal: Goal, evidence: Evidence) -> str:
    """Why a goal of a claim is denied, where no two values say so."""
    match goal, evidence:
        case Fails(conclusions=()), Entailment():
            return "no real point is such that the function has this value"
        case Fails(), Entailment() if claim.is_kind("FirstIntegral"):
            return CONSTANT
        case Fails(), Entailment() if claim.is_kind("LaxPair"):
            return "all invariants of the matrix are constant by themselves: it gives no integral"
        case Fails(), Entailment():
            return "what is said to fail somewhere holds everywhere"
        case Follows(conclusions=()), At() if claim.is_kind("Inequality"):
            return "both sides are equal at a real point"
        case Follows(conclusions=()), At():
            return "there is a real point where none is said to be"
        case Rank(functions=(own,)), Minors() if _is_constant(own, goal.space):
            return CONSTANT
        case Rank(functions=(_,)), Minors() if claim.is_kind("FirstIntegral"):
            return "on this set the function is constant by the equations of the set alone"
        case Rank(), Minors():
            return "the differentials depend on each other everywhere"
    return ""


def _is_constant(function: Formula, setting: Setting) -> bool:
    """Whether a function has no differential by itself, on whatever set it is looked at."""
    at = finder_of(setting)
    value = at.scalar(function)
    return all(at.partial(value, name).is_zero for name in setting.variables)


def _regardless(
    statement: Statement, goal: Exists, evidence: Regardless, place: PointEvaluation
) -> Counterexample | None:
    """What is left of an equation at a point where all bound names drop out."""
    inner = goal.goals[evidence.goal]
    assert isinstance(inner, Follows)
    for sides in inner.conclusions[0]:
        free = collect_sides(sides, goal.bound).get((), Number(0))
        value = place(place.at.scalar(free))
        if not value.is_zero:
            left = number_formula(value)
            words = (
                f"the derivative is ${to_latex(left)}$, "
                "and every combination of the functions is $0$"
            )
            return Counterexample(_at(statement, place), left, Number(0), words)
    return None


def _solutions(statement: Statement, goal: Count, accepted: Accepted) -> Counterexample:
    """The solutions that are listed, each name with the number of the solution."""
    first = accepted.places[0]
    setting = statement.legend[first.at.setting]
    values: dict[Formula, Value] = {
        printed_name(name, setting): value
        for name, value in first.point.values.items()
        if name not in goal.names
    }
    if circle := circle_of(goal, accepted.places):
        points: list[Mapping[str, Formula]] = [_on_circle(*circle)]
        words = f"a solution for every $\\varphi$, so that there are {MANY}, not {goal.number}"
        shown: Value = MANY
    else:
        points = [place.point.values for place in accepted.places]
        many = f"these are {len(points)} solutions" if len(points) > 1 else "this is a solution"
        words = f"{many}, and there should be {goal.number or 'none'}"
        shown = Number(len(points))
    for number, solution in enumerate(points, 1):
        for vector, names in setting.scene.vectors.items():
            entries = tuple(solution.get(name, ZERO) for name in names)
            if any(entry != ZERO for entry in entries):
                values[Name(vector if circle else f"{vector}_{number}")] = Vector(entries)
    return Counterexample(PrintedPoint(values), shown, Number(goal.number), words)


def _on_circle(one: PointEvaluation, other: PointEvaluation) -> dict[str, Formula]:
    """The points p cos φ + q sin φ."""
    angle = Name(r"\varphi")
    waves = [Application(function, (angle,)) for function in (r"\cos", r"\sin")]
    found = {}
    for name, value in one.point.values.items():
        pair = zip((value, other.point.values.get(name, ZERO)), waves, strict=True)
        found[name] = total(signed_product(factor, wave) for factor, wave in pair if factor != ZERO)
    return found
