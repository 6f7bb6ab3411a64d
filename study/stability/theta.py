r"""θ → 0: what is left of the identities for F1 and F2, and of the real form (16).

Points of real motions with :math:`\sqrt\theta=10^{-k}`, exactly. Floating point gets the
coordinates rounded once; a ball gets them exactly, in 64 bits; FLINT computes with
fractions. What counts is the difference of both sides (or of the computed and the
exact value) against the exact left side.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache, partial
from typing import TYPE_CHECKING, Any

from kowalevski_cas.algebra.programs import Program
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pictures import FAINT, INK, new_figure
from kowalevski_cas.problem.evaluate import Evaluation
from study.charts import curve, legend_below, marked
from study.paper import both, paper
from study.stability.material import Gaussian, as_complex, exact_value, log10, sides
from study.step import Measured, Row, Task

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "digits lost as θ → 0"

LARGEST = 150
"""Up to θ = 10^-300."""

BITS = 64

CASES = {
    "F1', complex variables": ("F1-prime", "complex"),
    "F2', complex variables": ("F2-prime", "complex"),
    "F1', initial variables": ("F1-prime", "initial"),
    "F2', initial variables": ("F2-prime", "initial"),
    "(16), first": ("eq16.1", "real"),
    "(16), second": ("eq16.2", "real"),
}
r"""Identities, and polynomials of which the value is compared with the exact one.

Exactly, (16) has to be :math:`\sqrt\theta F_1` and :math:`\theta F_2` up to a number.
"""

METHODS = ("floating", "ball", "exact")


def measure(quick: bool) -> Iterable[Task]:
    """A row for each method and case: lists over the exponents k."""
    exponents = [0, 4, 8, LARGEST] if quick else [*range(20), *range(20, LARGEST + 1, 5)]
    for case in CASES:
        for method in METHODS:
            yield Task(method, case, partial(lost, method, case, exponents))
    for name in ("E_1", "E_2"):
        yield Task("exact", f"{name} on ξ₁=ξ₂=0", partial(order_of_leaving, name))


def lost(method: str, case: str, exponents: Sequence[int]) -> Measured:
    """The decimal logarithms of the relative errors; ``None`` where nothing is finite, or zero."""
    id, kind = CASES[case]
    scene = scene_of(kind)
    exact, programs = both(scene)
    points = [point_at(kind, Fraction(1, 10**k)) for k in exponents]
    left, right = _sides(id, exact)
    truth = [exact_value(exact, left, point) for point in points]
    sizes = [abs(re) + abs(im) for re, im in truth]
    if method == "exact":
        if right is None:
            holds = len(set(_ratios(id, truth, exponents))) == 1
            errors: list[float | None] = [None for _ in points]
        else:
            differences = [exact_value(exact, left - right, point) for point in points]
            errors = [0.0 if any(d) else None for d in differences]
            holds = not any(any(d) for d in differences)
        verdict = "proved" if holds else "refuted"
        return {"verdict": verdict, "exponents": list(exponents), "errors": errors}
    one, other = _sides(id, programs)
    difference = programs.carry(one if other is None else one - other)
    find = _floating if method == "floating" else _ball
    errors = find(difference, points, None if other is not None else truth, sizes)
    return {"exponents": list(exponents), "errors": errors}


def _ratios(
    id: str, truth: Sequence[Gaussian], exponents: Sequence[int]
) -> list[tuple[Fraction, Fraction]]:
    r"""The values of (16) over :math:`\sqrt\theta F_1` or :math:`\theta F_2`, taken elsewhere."""
    on = paper().corrected(scene_of("initial"))
    function = r"\sqrt{x_1x_2}F_1" if id == "eq16.1" else "x_1x_2F_2"
    element = on.finder.scalar(on.formula(function))
    found = []
    for (value, _), k in zip(truth, exponents, strict=True):
        re, im = exact_value(on.finder, element, point_at("initial", Fraction(1, 10**k)))
        size = re * re + im * im
        found.append((value * re / size, -value * im / size))
    return found


def _floating(
    program: Program,
    points: Sequence[dict[str, Gaussian]],
    truth: Sequence[Gaussian] | None,
    sizes: Sequence[Fraction],
) -> list[float | None]:
    import numpy as np

    from kowalevski_cas.algebra.floating import at

    ring = program.ring
    values = {
        name: np.array([as_complex(point[name]) for point in points]) for name in ring.generators
    }
    signs = {name: np.ones(len(points)) for name in ring.roots}
    with np.errstate(all="ignore"):
        found = np.broadcast_to(at(ring, values, signs)(program).value, len(points))
    errors: list[float | None] = []
    for k, size in enumerate(sizes):
        value = complex(found[k])
        if not np.isfinite(value):
            errors.append(None)
            continue
        re, im = Fraction(value.real), Fraction(value.imag)
        if truth is not None:
            re, im = re - truth[k][0], im - truth[k][1]
        error = (abs(re) + abs(im)) / size
        errors.append(log10(error) if error else -17.0)
    return errors


def _ball(
    program: Program,
    points: Sequence[dict[str, Gaussian]],
    truth: Sequence[Gaussian] | None,
    sizes: Sequence[Fraction],
) -> list[float | None]:
    from flint import arb, ctx, fmpq

    from kowalevski_cas.algebra.ball import ball_point, exact_balls

    errors: list[float | None] = []
    for point, size in zip(points, sizes, strict=True):
        with ctx.workprec(BITS):
            ball = ball_point(program.ring, exact_balls(point))(program)
            if not ball.is_finite():
                errors.append(None)
                continue
            radius = ball.rad() / arb(fmpq(size.numerator, size.denominator))
            errors.append(float(radius.log() / arb(10).log()) if radius > 0 else -20.0)
    return errors


# -- scenes and points ---------------------------------------------------------


@cache
def scene_of(kind: str) -> Scene:
    """The complex variables with the root; the initial ones with i and the root; the real ones."""
    if kind == "complex":
        return paper().claims["F1-prime"].scene
    if kind == "real":
        return paper().claims["eq16.invariance"].scene
    # The scene of the limit has the abbreviations (9) and the root; here β is kept.
    limit, whole = paper().claims["limit"].scene, paper().claims["eq6"].scene
    return replace(limit, name="initial with the root", variables=whole.variables, zero=())


def point_at(kind: str, root: Fraction) -> dict[str, Gaussian]:
    """An exact point of a real motion at which √θ has this value."""

    def real(value: Fraction) -> Gaussian:
        return value, Fraction(0)

    xi = root * Fraction(3, 5), root * Fraction(4, 5)  # 3² + 4² = 5²
    alpha = [Fraction(7, 10), Fraction(-2, 5), Fraction(3, 2)]
    beta = [xi[1] - alpha[1], alpha[0] - xi[0], Fraction(1, 3)]
    omega = [Fraction(5, 7), Fraction(-3, 4), Fraction(11, 8)]
    if kind != "complex":
        vectors = {r"\omega": omega, r"\alpha": alpha, r"\beta": beta}
        return {f"{v}_{k + 1}": real(x) for v, xs in vectors.items() for k, x in enumerate(xs)}
    pairs = {
        "x": xi,
        "y": (alpha[0] + beta[1], alpha[1] - beta[0]),
        "z": (alpha[2], beta[2]),
        "w": (omega[0], omega[1]),
    }
    point = {r"\omega_3": real(omega[2]), "w_3": real(Fraction(1))}  # w_3 may be anything
    for name, (re, im) in pairs.items():
        point |= {f"{name}_1": (re, im), f"{name}_2": (re, -im)}
    (zr, zi), (xr, x_i), (yr, yi) = point["z_1"], point["x_1"], point["y_2"]
    c = zr * zr - zi * zi + xr * yr - x_i * yi, 2 * zr * zi + xr * yi + x_i * yr
    return point | {"c_1": c, "c_2": (c[0], -c[1])}


def _sides(id: str, at: Evaluation) -> tuple[Any, Any]:
    """Both sides of an identity; the left side alone of an equation with zero."""
    left, right = sides(id, at)
    return (left, None) if id.startswith("eq16") else (left, right)


def order_of_leaving(name: str) -> Measured:
    """The first derivative of (16) along the motion that does not vanish at a point of ξ₁=ξ₂=0.

    Both polynomials vanish there with their first derivatives, and are left all the same.
    """
    at, _ = both(scene_of("real"))
    point = point_at("real", Fraction(0))
    element, _ = _sides("eq16.1" if name == "E_1" else "eq16.2", at)
    derivatives = []
    for _ in range(6):
        derivatives.append(exact_value(at, element, point)[0])
        if derivatives[-1]:
            break
        element = at.derivative(element)
    return {"order": len(derivatives) - 1, "value": str(derivatives[-1])}


# -- the picture ---------------------------------------------------------------

TICKS = [0, -5, -10, -30, -100, -300]


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """Relative errors against θ: floating point on the left, radii of balls on the right."""
    figure = new_figure(height=3.8)
    left, right = figure.subplots(1, 2, sharey=True)
    titles = {"floating": "floating point, 53 bits", "ball": f"balls, {BITS} bits"}
    for axes, (method, title) in zip((left, right), titles.items(), strict=True):
        for mark, row in marked(row for row in rows if row["method"] == method):
            errors = [None if error is None else min(error, 2.0) for error in row["errors"]]
            exponents = [-2 * k for k in row["exponents"]]
            curve(axes, exponents, errors, label=row["case"], markevery=4, **mark.line)
        axes.axhline(0, color=FAINT, linewidth=0.8)
        axes.text(4, 0.3, "nothing is left", color=INK, fontsize=7, ha="left")
        axes.set_title(title)
        axes.set_xscale("symlog", linthresh=10)
        axes.set_xticks(TICKS, list(map(str, TICKS)))
        axes.set(xlim=(5, -330), ylim=(-21, 3), xlabel=r"$\log_{10}\theta$")
    left.set_ylabel(r"$\log_{10}$ of the relative error")
    legend_below(figure, left, 3, fontsize=7)
    leaving = ", ".join(
        f"${row['case'].split()[0]}$ with order {row['order']}" for row in rows if "order" in row
    )
    exact = [row["verdict"] for row in rows if row["method"] == "exact" and "order" not in row]
    figure.suptitle(
        f"exactly, {exact.count('proved')} of {len(exact)} hold at every θ; "
        rf"on $\xi_1=\xi_2=0$ motions leave (16): {leaving}",
        fontsize=7.5,
    )
    return {"stability-theta": figure}
