"""No more than a scene needs: generators of each scene and of its claims, and what more would cost.

A claim stands on a scene; its statement uses some of the generators. Where they
differ, each difference has a derived reason: the vector field needs the generator,
the claim is about a set in the space of all variables, or another claim on the same
scene uses it. The claims of Section 3 are then proved, searches included, on their own
scenes and once more in the ring of all generators of the paper.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from statistics import median
from time import perf_counter
from typing import TYPE_CHECKING, Any

from kowalevski_cas.claims import (
    Claim,
    CriticalSet,
    Dimension,
    Equilibria,
    Independence,
    InvertibleChange,
    LastMultiplier,
)
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.proof.verify import DECIDED
from kowalevski_cas.stage.programs import ProgramStage, programs

from kowalevski_cas.algebra.programs import Op, Program, field_of
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pictures import FAINT, new_figure
from study.charts import list_cases, marked, names, split
from study.stability.material import bench, claim, paper
from study.step import Measured, Row, Task
from study.worker import asked

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "no more than a scene needs"

SECTION = "3"

SECONDS, MEBIBYTES = 60.0, 1500

REPEATS = 5

SPACE = (CriticalSet, Dimension, Equilibria, Independence, InvertibleChange, LastMultiplier)
"""Kinds of claims about the space of all variables of a scene."""

TARGET = f"{__name__}:prove"

BOTH = ("own scene", "general scene")


def measure(quick: bool) -> Iterable[Task]:
    """The generators of every claim; the cost of proving those of Section 3 on two scenes."""
    derivation, _ = paper()
    for one in derivation.claims:
        yield Task("generators", one.id, partial(generators, one))
    section = next(s for s in derivation.sections if s.number == SECTION)
    chosen = section.claims[:2] if quick else section.claims
    for one in chosen:
        for method in BOTH:
            question = {"claim": one.id, "general": method == BOTH[1], "repeats": REPEATS}
            yield Task(method, one.id, partial(asked, TARGET, SECONDS, MEBIBYTES, question))


# -- generators --------------------------------------------------------------------


def generators(one: Claim) -> Measured:
    """The generators of the scene of a claim and of its statement, and why they differ."""
    stage = bench("modular").stage(one.scene)
    assert isinstance(stage, ProgramStage)
    scene = [*stage.programs.generators, *stage.programs.roots]
    used = statement(one.id)
    reasons = {name: reason(name, one, stage, used) for name in scene if name not in used}
    return {
        "verdict": "equal" if not reasons else "justified" if all(reasons.values()) else "more",
        "scene": scene,
        "statement": [name for name in scene if name in used],
        "reasons": reasons,
    }


@cache
def statement(id: str) -> frozenset[str]:
    """The generators on which what a claim asks at points depends, on its own scene."""
    one, work = claim(id), bench("modular")
    stage = work.stage(one.scene)
    assert isinstance(stage, ProgramStage)
    asked = [
        program
        for question in one.questions(work)
        if question.ring is stage.programs
        for program in (*question.programs(), *question.given)
    ]
    return frozenset(support(asked))


def support(asked: Iterable[Program]) -> set[str]:
    """The generators and roots that programs contain, those of the field where it is used."""
    found: set[str] = set()
    moved: dict[int, Mapping[str, Program]] = {}
    waiting = list(asked)
    seen: set[Program] = set()
    while waiting:
        program = waiting.pop()
        if program in seen:
            continue
        seen.add(program)
        if program.op in (Op.GENERATOR, Op.ROOT):
            found.add(str(program.data))
        if program.op is Op.ALONG:
            moved[id(program.data)] = field_of(program)
        waiting += program.args
        if not waiting:
            rates = (field[name] for field in moved.values() for name in found if name in field)
            waiting = [rate for rate in rates if rate not in seen]
    return found


def reason(name: str, one: Claim, stage: ProgramStage, used: frozenset[str]) -> str:
    """Why a scene has a generator that a statement does not use; empty if nothing says so."""
    if isinstance(one, SPACE):
        return "the claim is about the space of all variables"
    if name in one.scene.undefined:
        return "printed by the paper and defined nowhere"
    if name in (exponent for _, exponent in one.scene.powers):
        return "the exponent of a power"
    if name in stage.field and name in closure(used, stage):
        return "the vector field is closed with it"
    others = [c.id for c in paper()[0].claims if c.scene is one.scene and c is not one]
    users = [id for id in others if name in statement(id)]
    if users:
        return f"{', '.join(users[:3])}{', …' if len(users) > 3 else ''} on the same scene"
    if one.beyond_points:
        return "what is claimed beyond points"
    return ""


def closure(used: frozenset[str], stage: ProgramStage) -> set[str]:
    """The generators that the field joins to some of them, in either direction."""
    found = set(used)
    while True:
        moving = {name: support(programs([rate])) for name, rate in stage.field.items()}
        joined = [{name, *others} for name, others in moving.items()]
        more = found.union(*(group for group in joined if group & found))
        if more == found:
            return found
        found = more


# -- what more would cost -------------------------------------------------------------


def general(scene: Scene) -> Scene:
    """The scene with all other generators of the paper beside its own."""
    derivation, _ = paper()
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
    _, texts = paper()
    one = claim(question["claim"])
    if question["general"]:
        one = replace(one, scene=general(one.scene))
    seconds = []
    for _ in range(question["repeats"]):
        start = perf_counter()
        finding = one.decide(Bench("flint", texts))
        seconds.append(perf_counter() - start)
    stage = Bench("flint", texts).stage(one.scene)
    return {
        "seconds": median(seconds),
        "spread": [min(seconds), max(seconds)],
        "verdict": str(finding.verdict),
        "generators": len(stage.ring.names),
    }


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
