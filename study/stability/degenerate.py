r"""Degenerate fields: c₁ → 0, β → 0, parallel fields; what loses its meaning, and who notices.

Near a degeneration: the smallest singular value of the differentials of the
integrals (4) and of (16), at exact points of the set, against the distance ε to it. The rank
by singular values drops when this falls below the roundoff; the exact rank drops at
ε = 0 and not before.

At a degeneration: every claim is put to points modulo primes at which the fields
are degenerate.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING

from kowalevski_cas.algebra import load_points
from kowalevski_cas.algebra.numbers import rank
from kowalevski_cas.algebra.points import Points, Question
from kowalevski_cas.algebra.programs import Program
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.paper.claims import InvariantRelations
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.pictures import new_figure
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.goals import Rank
from kowalevski_cas.problem.sampled import Sampled
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.search.place import Candidate
from kowalevski_cas.verify.screen import questions
from study.charts import by_place, marked, split
from study.paper import both, paper
from study.stability.material import Gaussian, as_complex
from study.step import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "degenerate fields"

LARGEST = 24

FAMILIES = {"c₁ → 0": "c_1", "β → 0": "beta", "parallel": "parallel"}

AT: dict[str, tuple[tuple[str, ...], ...]] = {
    "c₁ = 0": (
        ("c_1=0", "c_2=0"),
        (
            r"({\bs\alpha},{\bs\alpha})-({\bs\beta},{\bs\beta})=0",
            r"({\bs\alpha},{\bs\beta})=0",
        ),
    ),
    "β = 0": ((r"\beta_1=0", r"\beta_2=0", r"\beta_3=0"),),
    "parallel": ((r"\alpha_1\beta_2-\alpha_2\beta_1=0", r"\alpha_1\beta_3-\alpha_3\beta_1=0"),),
}
"""Equations of each degeneration; those are taken that a scene knows and can solve."""


def measure(quick: bool) -> Iterable[Task]:
    """Singular values and exact ranks along each family; the claims at each degeneration."""
    exponents = list(range(0, LARGEST + 1, 8 if quick else 1))
    for family in FAMILIES:
        yield Task("floating", family, partial(singular_values, family, exponents))
        yield Task("exact", family, partial(exact_ranks, family, exponents))
    for place in AT:
        yield Task("modular", place, partial(claims_at, place, quick))


# -- near a degeneration ---------------------------------------------------------


def point_near(family: str, distance: Fraction) -> dict[str, Gaussian]:
    r"""An exact point of (16) at this distance ε from the degeneration.

    All points have :math:`\omega_1=1`, :math:`\omega_2=-1`, :math:`\xi_1=0`, :math:`\xi_2=2`,
    so that :math:`w_1^2+x_1=0` makes the second equation true for all fields; the first
    one gives :math:`\omega_3=\beta_3-\alpha_3`.
    """
    two = Fraction(2)
    if FAMILIES[family] == "c_1":
        alpha, beta = [two, Fraction(1), two], [Fraction(1), two, distance - 2]
    elif FAMILIES[family] == "beta":
        beta = [distance * b for b in (Fraction(1, 2), Fraction(-1), Fraction(3, 4))]
        alpha = [beta[1], 2 - beta[0], two]
    else:
        alpha = [Fraction(4, 5), Fraction(8, 5), two]
        beta = [Fraction(2, 5), Fraction(4, 5), 1 + distance]
    omega = [Fraction(1), Fraction(-1), beta[2] - alpha[2]]
    vectors = {r"\omega": omega, r"\alpha": alpha, r"\beta": beta}
    zero = Fraction(0)
    return {f"{v}_{k + 1}": (x, zero) for v, xs in vectors.items() for k, x in enumerate(xs)}


RELATIONS, LEVELS = "eq16.invariance", "M4-dimension"
"""The claims whose set and whose integrals are taken."""


def relations(at: Evaluation) -> list[Element]:
    """The polynomials (16)."""
    claim = paper().claims[RELATIONS]
    assert isinstance(claim, InvariantRelations)
    return [at.scalar(function) for function in claim.functions(paper().corrected)]


def differentials(at: Evaluation) -> list[list[Element]]:
    """The differentials of the integrals (4) and of the polynomials (16)."""
    (levels,) = paper().statement(LEVELS).goals
    assert isinstance(levels, Rank)
    functions = [*map(at.scalar, levels.functions), *relations(at)]
    return [[at.partial(f, name) for name in at.setting.variables] for f in functions]


def singular_values(family: str, exponents: Sequence[int]) -> Measured:
    """The smallest singular value against the largest, and the rank that NumPy finds."""
    import numpy as np

    from kowalevski_cas.algebra.floating import at

    _, programs = both(paper().claims[RELATIONS].scene)
    points = [point_near(family, Fraction(1, 10**k)) for k in exponents]
    ring, count = programs.programs, len(points)
    rows = [list(map(programs.carry, row)) for row in differentials(programs)]
    values = {name: np.array([as_complex(p[name]) for p in points]) for name in ring.generators}
    with np.errstate(all="ignore"):
        point = at(ring, values, {name: np.ones(count) for name in ring.roots})
        values_of = [[np.broadcast_to(point(e).value, count) for e in row] for row in rows]
    matrix = np.array(values_of)
    matrices = np.moveaxis(matrix, 2, 0)
    spectra = np.linalg.svd(matrices, compute_uv=False)
    return {
        "exponents": list(exponents),
        "smallest": [float(s[-1] / s[0]) for s in spectra],
        "ranks": [int(r) for r in np.linalg.matrix_rank(matrices)],
    }


def exact_ranks(family: str, exponents: Sequence[int]) -> Measured:
    """The exact rank at exact points of the set, for each ε and, last, for ε = 0."""
    exact, _ = both(paper().claims[RELATIONS].scene)
    rows, functions = differentials(exact), relations(exact)
    ranks, on_set = [], True
    for distance in (*(Fraction(1, 10**k) for k in exponents), Fraction(0)):
        at = Candidate(exact, point_near(family, distance))
        on_set = on_set and at.vanish(functions)
        ranks.append(rank([[at(entry) for entry in row] for row in rows]))
    return {
        "verdict": "measured" if on_set else "error",
        "exponents": list(exponents),
        "ranks": ranks,
    }


# -- at a degeneration -----------------------------------------------------------


def claims_at(place: str, quick: bool) -> Measured:
    """What each claim is worth where the fields are degenerate.

    ``holds``, ``fails``, ``undefined`` (something is divided by zero at every point),
    ``empty`` (no point was found on the set), or ``elsewhere`` (the scene does not
    know the fields).
    """
    points = load_points("modular")
    chosen = [id for id in paper().claims if not quick or id in ("eq15", "N4-dimension")]
    return {"claims": {id: _at(id, place, points) for id in chosen}}


def _at(id: str, place: str, points: Points) -> str:
    scene, statement = paper().claims[id].scene, paper().statement(id)
    said = "elsewhere"
    if scene.zero:
        return said  # one field only
    setting = paper().corrected(scene)
    at = Sampled(setting.finder)
    found = questions(statement, paper().verdicts(statement), [], {setting: at})
    own = [question for question in found if question.ring is at.programs and question.programs()]
    for group in AT[place]:
        equations = _known(at, group)
        if equations is not None and said in ("elsewhere", "empty"):
            said = _asked(own, equations, points) if own else "not asked"
    return said


def _asked(questions: Sequence[Question], equations: Sequence[Program], points: Points) -> str:
    answers = []
    for question in questions:
        there = replace(question, given=[*question.given, *equations])
        answer = points.answer(there)
        if answer.holds is None:
            alone = points.answer(Question(question.ring, there.given, there.given))
            return "undefined" if alone.holds else "empty"
        answers.append(answer.holds)
    return "holds" if all(answers) else "fails"


def _known(at: Sampled, equations: tuple[str, ...]) -> list[Program] | None:
    """The equations in a scene, where they say something."""
    assert isinstance(at.setting, Elaboration)
    try:
        found = [at.carry(e) for e in at.differences(at.setting.equations(equations))]
    except Meaningless:
        return None
    return [e for e in found if e.number != 0] or None


# -- the picture -----------------------------------------------------------------

SIGNS = {"holds": "✓", "fails": "✗", "undefined": "÷0", "empty": "∅"}

LEGEND = (
    "✗ false there    ÷0 divided by zero at every point\n"
    "∅ no point of the set was found    – not asked there"
)


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """Singular values on the left; on the right the claims that are not simply true there."""
    found = by_place(rows)
    figure = new_figure(height=4.2)
    left, right = figure.subplots(1, 2, width_ratios=(1.25, 1))
    for mark, family in marked(FAMILIES):
        row, exact = found["floating", family], found["exact", family]
        xs = [10.0**-k for k in row["exponents"]]
        ys = [max(value, 1e-25) for value in row["smallest"]]
        full = [rank == exact["ranks"][0] for rank in row["ranks"]]
        label = f"{family}: exact rank {exact['ranks'][0]}, at 0: {exact['ranks'][-1]}"
        left.plot(xs, ys, label=label, color=mark.colour, ls=mark.dashes)
        split(left, mark, zip(xs, ys, full, strict=True), "")
    left.set(xscale="log", yscale="log", xlabel="ε, the distance from the degeneration")
    left.set_title("smallest singular value (hollow: rank lost)")
    left.invert_xaxis()
    left.legend(loc="lower left", fontsize=6.5)
    right.set_axis_off()
    right.set_title("claims at a degeneration")
    right.text(0.0, 0.0, LEGEND, fontsize=6.5, transform=right.transAxes)
    at = {place: found["modular", place]["claims"] for place in AT}
    changed = [
        id
        for id in at[next(iter(AT))]
        if {said[id] for said in at.values()} & {"fails", "undefined", "empty"}
    ]
    table = right.table(
        [[SIGNS.get(said[id], "–") for said in at.values()] for id in changed],
        rowLabels=changed,
        colLabels=list(at),
        cellLoc="center",
        bbox=(0.42, 0.12, 0.6, 0.88),
    )
    table.auto_set_font_size(False)
    table.set_fontsize(6.5)
    for cell in table.get_celld().values():
        cell.set_linewidth(0.3)
    return {"stability-degenerate": figure}
