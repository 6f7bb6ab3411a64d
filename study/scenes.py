"""No more than a scene needs: generators of each scene and of its claims, and what more would cost.

A claim stands on a scene; its statement uses some of the generators. Where they
differ, each difference has a derived reason: the vector field is closed with the generator,
or another claim on the same scene uses it. The claims of Section 3 are then proved,
searches included, on their own scenes and once more in the ring of all generators of the paper.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields, replace
from functools import cache, partial
from statistics import median
from time import perf_counter
from typing import TYPE_CHECKING, Any

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pictures import FAINT, new_figure
from kowalevski_cas.problem.accept import Judge, Unproved
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.space import generators as names_of
from kowalevski_cas.verify.statement import Statement, finder_of
from kowalevski_cas.verify.teller import DECIDED
from study.charts import list_cases, marked, names, split
from study.paper import paper
from study.step import Measured, Row, Task
from study.worker import asked

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "no more than a scene needs"

SECTION = "3"

SECONDS, MEBIBYTES = 60.0, 1500

REPEATS = 5

TARGET = f"{__name__}:prove"

BOTH = ("own scene", "general scene")


def measure(quick: bool) -> Iterable[Task]:
    """The generators of every claim; the cost of proving those of Section 3 on two scenes."""
    source = paper()
    for one in source.claims.values():
        yield Task("generators", one.id, partial(generators, one))
    section = next(s for s in source.derivation.sections if s.number == SECTION)
    chosen = section.claims[:2] if quick else section.claims
    for one in chosen:
        for method in BOTH:
            question = {"claim": one.id, "general": method == BOTH[1], "repeats": REPEATS}
            yield Task(method, one.id, partial(asked, TARGET, SECONDS, MEBIBYTES, question))


# -- generators --------------------------------------------------------------------


def generators(one: Claim) -> Measured:
    """The generators of the scene of a claim and of its statement, and why they differ."""
    setting, used = paper().corrected(one.scene), statement(one)
    scene = [*names_of(setting), *setting.roots]
    reasons = {name: reason(name, one) for name in scene if name not in used}
    return {
        "verdict": "equal" if not reasons else "justified" if all(reasons.values()) else "more",
        "scene": scene,
        "statement": [name for name in scene if name in used],
        "reasons": reasons,
    }


@cache
def statement(one: Claim) -> frozenset[str]:
    """The generators that the goals of a claim lead to, on its own scene."""
    on = paper().corrected
    space = Statement(one, on).spaces.get(on(one.scene))
    return frozenset() if space is None else frozenset((*names_of(space), *space.roots))


def reason(name: str, one: Claim) -> str:
    """Why a scene has a generator that a statement does not use; empty if nothing says so."""
    if name in one.scene.undefined:
        return "printed by the paper and defined nowhere"
    if name in (exponent for _, exponent in one.scene.powers):
        return "the exponent of a power"
    if name in (getattr(one, field.name) for field in fields(one)):
        return "the claim is about what stands for it"
    if name in closure(statement(one), paper().corrected(one.scene)):
        return "the vector field is closed with it"
    others = [c for c in paper().claims.values() if c.scene is one.scene and c is not one]
    users = [other.id for other in others if name in statement(other)]
    if users:
        return f"{', '.join(users[:3])}{', …' if len(users) > 3 else ''} on the same scene"
    return ""


def closure(used: frozenset[str], setting: Elaboration) -> set[str]:
    """The generators that the field joins to some of them, in either direction."""
    moves = setting.field or setting.change is not None
    rates = setting.finder.rates if moves else {}
    groups = [{name, *support(rate)} for name, rate in rates.items()]
    found, before = set(used), 0
    while before != len(found):
        before = len(found)
        found = found.union(*(group for group in groups if group & found))
    return found


def support(element: Element) -> set[str]:
    """The generators and roots that stand in the numerator of an element."""
    names, found = element.ring.polynomials.generators, set()
    for mask, terms in element.terms().items():
        found |= {name for bit, name in enumerate(element.ring.roots) if mask >> bit & 1}
        found |= {name for powers in terms for name, e in zip(names, powers, strict=True) if e}
    return found


# -- what more would cost -------------------------------------------------------------


def general(scene: Scene) -> Scene:
    """The scene with all other generators of the paper beside its own."""
    derivation = paper().derivation
    known = {*scene.names(), *scene.roots, *(n for ns in scene.vectors.values() for n in ns)}
    others = dict.fromkeys(
        name
        for one in derivation.scenes()
        for name in (*one.variables, *one.constants)
        if name not in known
    )
    unit = next(one.unit for one in derivation.scenes() if one.unit is not None)
    return replace(
        scene,
        name=f"{scene.name}, among all generators",
        constants=(*scene.constants, *others),
        unit=scene.unit or unit,
    )


def prove(question: Mapping[str, Any]) -> Measured:
    """Prove a claim with nothing found before, some times over; the median of the times."""
    one, texts = paper().claims[question["claim"]], paper().corrected.texts
    if question["general"]:
        one = replace(one, scene=general(one.scene))
    seconds = []
    for _ in range(question["repeats"]):
        start = perf_counter()
        verdict = _decided(Statement(one, on := Elaborations(texts)))
        seconds.append(perf_counter() - start)
    return {
        "seconds": median(seconds),
        "spread": [min(seconds), max(seconds)],
        "verdict": verdict,
        "generators": len(on(one.scene).finder.ring.names),
    }


def _decided(statement: Statement) -> str:
    """The verdict for which what a search finds is accepted; conditions are not told."""
    verdicts, judge = statement.search(), Judge(finder_of, statement.names)
    if verdicts is None:
        return "undecided"
    try:
        if isinstance(verdicts, Denial):
            judge.denies(statement.goals[verdicts.goal], verdicts.evidence)
            return "refuted"
        for goal, evidence in zip(statement.goals, verdicts, strict=True):
            judge.holds(goal, evidence)
    except Unproved:
        return "error"
    return "proved"


# -- the chart --------------------------------------------------------------------------


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """The times on both scenes."""
    timed = [row for row in rows if row["method"] in BOTH]
    cases = names(timed, "case")
    figure = new_figure(height=1.2 + 0.22 * len(cases))
    axes = figure.subplots()
    for mark, method in marked(BOTH):
        points = [
            (row["seconds"], cases.index(row["case"]), row["verdict"] in DECIDED)
            for row in timed
            if row["method"] == method
        ]
        split(axes, mark, points, method)
    for place, case in enumerate(cases):
        ends = [row["seconds"] for row in timed if row["case"] == case]
        axes.plot(ends, [place] * len(ends), color=FAINT, linewidth=0.8, zorder=0)
    xlabel = f"seconds with FLINT, searches included (hollow: none in {SECONDS:g} s, or undecided)"
    list_cases(axes, cases, xlabel)
    axes.set_title("proving Section 3 on its own scenes, and among all generators")
    axes.legend(loc="best")
    return {"scenes": figure}
