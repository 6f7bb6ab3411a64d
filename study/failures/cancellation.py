r"""θ → 0: what is left of the identity for F2, at points of real motions with small θ.

Floating point gets the coordinates rounded once, a ball gets them exactly; FLINT computes with
fractions. What counts is the difference of both sides against the exact left side.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from math import isfinite

from matplotlib.axes import Axes

from kowalevski_cas.algebra.points import ExactPoint
from kowalevski_cas.algebra.programs import Program
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.search.place import Candidate
from study.charts import curve, display_name
from study.paper import both, paper, sides
from study.step import Measured, Row, Task

TITLE = r"cancellation as $\theta\to0$"

CLAIM = "F2-prime"

LARGEST, BITS = 20, 64

CAPTION = (
    r"the difference of the two sides of $F_2'=(U_1+U_2)F_1/\sqrt\theta$ in the initial variables, "
    rf"at exact points with $\sqrt\theta=10^{{-k}}$, $k\le{LARGEST}$; balls have {BITS} bits"
)


def measure(quick: bool) -> Iterator[Task]:
    """A row a method: lists over the exponents k."""
    exponents = [0, 4, 8] if quick else list(range(LARGEST + 1))
    for method in ("flint", "ball", "floating"):
        yield Task(method, "cancellation", partial(relative_errors, method, exponents))


def relative_errors(method: str, exponents: Sequence[int]) -> Measured:
    """The relative errors at √θ = 10⁻ᵏ; ``None`` where nothing is finite."""
    # The scene of the limit has the abbreviations (9) and the root; here β is kept.
    limit, whole = paper().claims["limit"].scene, paper().claims["eq6"].scene
    scene = replace(limit, name="initial with the root", variables=whole.variables, zero=())
    exact, programs = both(scene)
    points = [point_at(Fraction(1, 10**k)) for k in exponents]
    left, right = sides(CLAIM, exact)
    if method == "flint":
        errors = [_size(exact, left - right, point) for point in points]
    else:
        element, other = sides(CLAIM, programs)
        error = {"floating": _float_difference, "ball": _radius}[method]
        errors = [error(programs.carry(element - other), point) for point in points]
    sizes = [_size(exact, left, point) for point in points]
    relative = [e / size if isfinite(e) else None for e, size in zip(errors, sizes, strict=True)]
    return {"exponents": list(exponents), "errors": relative}


def _size(at: Evaluation, element: Element, point: ExactPoint) -> float:
    """The absolute value of an element at an exact point: exactly zero, or rounded once."""
    parts = Candidate(at, point)(element).terms()
    re, im = (sum(parts.get(mask, {}).values(), Fraction(0)) for mask in (0, 1))
    return abs(complex(re, im))


def _float_difference(difference: Program, point: ExactPoint) -> float:
    """The absolute value of a difference in floating point."""
    import numpy as np

    from kowalevski_cas.algebra.floating import at

    ring = difference.ring
    values = {name: np.array([complex(*point[name])]) for name in ring.generators}
    with np.errstate(all="ignore"):
        found = at(values, {name: np.ones(1) for name in ring.roots})(difference)
    return float(np.abs(found.value)[0])


def _radius(difference: Program, point: ExactPoint) -> float:
    """The radius of the ball in which a difference lies."""
    from flint import ctx

    from kowalevski_cas.algebra.ball import ball_point, exact_balls

    with ctx.workprec(BITS):
        return float(ball_point(difference.ring, exact_balls(point))(difference).rad())


def point_at(root: Fraction) -> ExactPoint:
    """An exact point of a real motion at which √θ has this value."""
    xi = root * Fraction(3, 5), root * Fraction(4, 5)  # 3² + 4² = 5²
    alpha = [Fraction(7, 10), Fraction(-2, 5), Fraction(3, 2)]
    beta = [xi[1] - alpha[1], alpha[0] - xi[0], Fraction(1, 3)]
    omega = [Fraction(5, 7), Fraction(-3, 4), Fraction(11, 8)]
    vectors = {r"\omega": omega, r"\alpha": alpha, r"\beta": beta}
    zero = Fraction(0)
    return {f"{v}_{k + 1}": (x, zero) for v, xs in vectors.items() for k, x in enumerate(xs)}


def draw(axes: Axes, rows: Sequence[Row]) -> None:
    """The relative errors against k."""
    for row in rows:
        label = "" if any(row["errors"]) else f"{display_name(row['method'])}: exactly 0"
        curve(axes, row, "exponents", "errors", label, least=1e-20)
    axes.set_xlabel(r"$k$: $\sqrt{\theta}=10^{-k}$")
