r"""The branch of the root: a loop about θ = 0, and √x₁·√x₂ against √(x₁x₂).

The principal value of :math:`\sqrt\theta` jumps on the negative half of the axis; a
root that is a generator with a relation has no branch, and what is proved of it holds
for both. Exactly: with :math:`x_j=e^{i\varphi_j}` the product of the principal roots
is the principal root of the product where :math:`-\pi<\varphi_1+\varphi_2\le\pi`, and its
negative elsewhere. Where the sum is ±π the product lies on the cut, and floating point
decides by its rounding.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING

from kowalevski_cas.algebra import load_points
from kowalevski_cas.algebra.points import Question
from kowalevski_cas.notation import Name
from kowalevski_cas.pictures import INK, new_figure
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.screen import questions
from study.charts import by_place, marked
from study.paper import both, paper
from study.step import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "the branch of √(x₁x₂)"

NAIVE = r"\sqrt{x_1}\sqrt{x_2}"
ROOT = r"\sqrt{x_1x_2}"


def measure(quick: bool) -> Iterable[Task]:
    """Signs on a grid of angles, a loop, and what the tool says."""
    number = 16 if quick else 64
    yield Task("floating", "products of roots", partial(products, number))
    yield Task("exact", "products of roots", partial(rule, number))
    yield Task("floating", "loop", partial(loop, 8 * number))
    yield Task("modular", "claims for both roots", both_roots)
    yield Task("exact", "the root of a factor", undeclared)


def angles(number: int) -> list[Fraction]:
    """Angles in units of π, between -1 and 1, none of which is an end."""
    return [Fraction(2 * k + 1 - number, number) for k in range(number)]


def products(number: int) -> Measured:
    """Signs of √x₁·√x₂ against √(x₁x₂), by the principal values of floating point."""
    points = [cmath.rect(1.0, float(a) * cmath.pi) for a in angles(number)]
    signs = []
    for x in points:
        ratios = [cmath.sqrt(x) * cmath.sqrt(y) / cmath.sqrt(x * y) for y in points]
        signs.append([1 if ratio.real > 0 else -1 for ratio in ratios])
    return {"signs": signs}


def rule(number: int) -> Measured:
    """The same signs by adding the angles, exactly."""
    grid = angles(number)
    signs = [[1 if -1 < a + b <= 1 else -1 for b in grid] for a in grid]
    return {"signs": signs}


def loop(number: int) -> Measured:
    """√θ for θ twice around zero: the principal value, and the one that is continued."""
    turns = [4 * k / number for k in range(number + 1)]  # in units of π
    principal = [cmath.sqrt(cmath.rect(1.0, turn * cmath.pi)) for turn in turns]
    continued = [cmath.rect(1.0, turn * cmath.pi / 2) for turn in turns]
    jumps = sum(abs(b - a) > 1 for a, b in pairwise(principal))
    return {
        "turns": turns,
        "principal": [value.real for value in principal],
        "continued": [value.real for value in continued],
        "jumps": jumps,
    }


def both_roots() -> Measured:
    """Which claims about √θ stay true when the sign of the root is changed; F1 itself does not."""
    points = load_points("modular")
    same: dict[str, bool] = {}
    for id, claim in paper().claims.items():
        if ROOT not in claim.scene.roots:
            continue
        answers = []
        statement = paper().statement(id)
        for question in questions(statement, paper().verdicts(statement), [], {}):
            if not question.residuals or ROOT not in question.ring.roots:
                continue
            bit = question.ring.roots.index(ROOT)
            changed = Question(
                question.ring,
                residuals=[program.conjugate_root(bit) for program in question.residuals],
                given=[program.conjugate_root(bit) for program in question.given],
            )
            answers.append(bool(points.answer(changed).holds))
        if answers:
            same[id] = all(answers)
    _, at = both(paper().claims["F1-prime"].scene)
    f1 = at.carry(at.scalar(Name("F_1")))
    bit = at.programs.roots.index(ROOT)
    return {
        "verdict": "probable" if all(same.values()) else "refuted",
        "claims": same,
        "F1 changes its sign": (f1 + f1.conjugate_root(bit)).is_zero,
    }


def undeclared() -> Measured:
    """What the tool says when the root is written as a product of roots: there is no such root."""
    on = paper().corrected(paper().claims["F1-prime"].scene)
    try:
        on.finder.scalar(on.formula(NAIVE))
    except Meaningless as error:
        return {"verdict": "refused", "reason": str(error)}
    return {"verdict": "accepted"}


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """The loop on the left, the signs of the products on the right."""
    found = by_place(rows)
    around = found["floating", "loop"]
    computed, exact = (
        found[method, "products of roots"]["signs"] for method in ("floating", "exact")
    )
    figure = new_figure(height=3.2)
    left, right = figure.subplots(1, 2)
    ways = {"continued": "continued along the loop", "principal": "principal value"}
    for mark, (name, label) in marked(ways.items()):
        left.plot(around["turns"], around[name], label=label, color=mark.colour, ls=mark.dashes)
    left.set_title(r"$\mathrm{Re}\sqrt{\theta}$ on $\theta=e^{i\varphi}$")
    left.set(xlabel=r"$\varphi/\pi$", ylim=(-1.1, 1.9))
    left.legend(loc="upper center")
    places = [float(angle) for angle in angles(len(computed))]
    for mark, (sign, label, marker) in marked(((1, "equal", "."), (-1, "opposite", "x"))):
        points = [
            (x, y)
            for x, row in zip(places, computed, strict=True)
            for y, seen in zip(places, row, strict=True)
            if seen == sign
        ]
        right.plot(
            *zip(*points, strict=True), ls="none", marker=marker, ms=1.6, color=mark.colour,
            label=label,
        )  # fmt: skip
    for ends in ((0, 1), (-1, 0)):
        right.plot(ends, ends[::-1], color=INK, lw=1)
    pairs = [
        a == b for r, s in zip(computed, exact, strict=True) for a, b in zip(r, s, strict=True)
    ]
    right.set_title(r"$\sqrt{x_1}\sqrt{x_2}$ against $\sqrt{x_1x_2}$")
    right.set(xlabel=r"$\arg x_1/\pi$", ylabel=r"$\arg x_2/\pi$", aspect="equal")
    right.set(xlim=(-1, 1), ylim=(-1, 1))
    handles = right.get_legend_handles_labels()
    figure.legend(*handles, loc="outside lower right", ncols=2, markerscale=4)
    figure.suptitle(
        f"floating point agrees with the exact rule at {sum(pairs)} of {len(pairs)} places",
        fontsize=7.5,
    )
    return {"stability-branch": figure}
