r"""The printed formulas of the motion, compiled: equations, integrals, the phase point.

Each is read from the derivation that proves it: Kharlamov (2002), and the motions on N⁴ of
Kharlamov and Savushkin (2004).
"""

from __future__ import annotations

from dataclasses import replace as changed
from functools import cache

from kowalevski_cas.arithmetic import load as load_arithmetic
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.library import load as load_derivation
from kowalevski_cas.motion.compile import Function, function
from kowalevski_cas.notation import Formula, Name, replace
from kowalevski_cas.paper.scene import Scene, vocabulary
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.paper.texts import Texts

OMEGA = (r"\omega_1", r"\omega_2", r"\omega_3")
ALPHA = (r"\alpha_1", r"\alpha_2", r"\alpha_3")
BETA = (r"\beta_1", r"\beta_2", r"\beta_3")
STATE = (*OMEGA, *ALPHA, *BETA)
"""The order of the nine numbers of a state."""

INTEGRALS = ("H", "K", "a^2", "b^2", "c", "F_1", "F_2")
"""What is constant on N⁴: (17), (4), and the left sides of (16)."""

SUPPLIED = ("s_1s_2-a^2", "s_1s_2-b^2", r"\ell-2ms_1", r"\ell-2ms_2", "rS_2")
"""Parts of the phase point that a caller supplies, by names that are the parts themselves."""

ARGUMENTS = ("S_1", "S_2", "f_1", "f_2", "d", r"\psi", *SUPPLIED, "r")
"""The arguments of :func:`phase_point`."""

CONSTANTS = ("x_1x_2", "x_1x_2+z_1z_2", "w_1w_2", "H", "G", "p^2", "c_1c_2")
"""The values of :func:`constants`."""


@cache
def equations() -> Function:
    """The right-hand sides of the nine equations (3), (5), by the nine variables."""
    derivation, scenes = _derivation("kharlamov2002")
    stage = Stage(scenes["Kowalevski case"], load_arithmetic("flint"), derivation.texts())
    return function([stage.field[name] for name in STATE], STATE)


@cache
def integrals() -> Function:
    """The values of :data:`INTEGRALS`, by the nine variables."""
    derivation, scenes = _derivation("kharlamov2002")
    printed = {display.id: display for display in derivation.displays()}
    eq4, eq16, xi = printed["eq4"], printed["eq16"], printed["xi"]
    scene = scenes["Kowalevski case"]
    scene = changed(
        scene,
        definitions={**scene.definitions, "c": eq4[3], r"\xi_1": xi[1], r"\xi_2": xi[2]},
        roots={"a": eq4[1], "b": eq4[2]},
    )
    stage = Stage(scene, load_arithmetic("flint"), derivation.texts())
    names = [_value(stage, name) for name in INTEGRALS[:5]]
    sides = [scalar(stage.relation(eq16[number]).members[0], stage) for number in (1, 2)]
    return function([*names, *sides], STATE)


@cache
def constants() -> Function:
    r"""The values of :data:`CONSTANTS` by the nine variables, all of them polynomials."""
    derivation, scenes = _derivation("kharlamov_savushkin2004")
    initial, real = scenes["initial variables"], scenes["real variables"]
    scene = changed(
        initial, vectors=real.vectors, definitions={**initial.definitions, **real.definitions}
    )
    stage = Stage(scene, load_arithmetic("flint"), derivation.texts())
    return function([_value(stage, name) for name in CONSTANTS], STATE)


@cache
def phase_point() -> Function:
    r"""The nine variables by :data:`ARGUMENTS`.

    They are homogeneous of degree zero in those that involve :math:`s_1` (with
    :math:`S_1, f_1, rS_2` and d): a common factor changes nothing.
    """
    derivation, scenes = _derivation("kharlamov_savushkin2004")
    paper = Stage(scenes["phase point"], load_arithmetic("flint"), derivation.texts())
    variables = (*ARGUMENTS, "s_1", "s_2", "a", "b", "m", r"\ell")
    scene = Scene("supplied", "the phase point by what is supplied", variables=variables)
    stage = Stage(scene, load_arithmetic("flint"), Texts(vocabulary((scene,))))
    values = []
    for name in STATE:
        formula = paper.definition(name)
        for tex in SUPPLIED:
            formula = _named(formula, stage.formula(tex), Name(tex))
        values.append(scalar(formula, stage))
    return function(values, ARGUMENTS)


@cache
def jacobi_rates() -> Function:
    """The rates of sn, cn, dn of n·t, by sn, cn, dn, n and the modulus k."""
    derivation, _ = _derivation("kharlamov_savushkin2004")
    printed = {display.id: display for display in derivation.displays()}
    functions = (r"\mathrm{sn}", r"\mathrm{cn}", r"\mathrm{dn}")
    scene = Scene(
        "Jacobi's functions",
        "sn, cn, dn as variables",
        variables=functions,
        constants=("n", "k"),
        field=(printed["jacobi"][3], printed["jacobi-rates"][1], printed["jacobi-rates"][2]),
    )
    stage = Stage(scene, load_arithmetic("flint"), derivation.texts())
    return function([stage.field[name] for name in functions], (*functions, "n", "k"))


def _value(stage: Stage, tex: str) -> Element:
    """The value of an expression in the names of the stage."""
    return scalar(stage.formula(tex), stage)


def _named(formula: Formula, wanted: Formula, name: Name) -> Formula:
    """The formula with a name in place of a subformula."""
    if formula == wanted:
        return name
    for place, child in enumerate(formula.children()):
        formula = replace(formula, (place,), _named(child, wanted, name))
    return formula


@cache
def _derivation(name: str) -> tuple[Derivation, dict[str, Scene]]:
    """A derivation of the library, and its scenes by their names."""
    derivation = load_derivation(name)
    return derivation, {scene.name: scene for scene in derivation.scenes()}
