r"""The printed formulas of the motion, compiled: equations, integrals, the phase point.

The nine equations and the integrals are those of Kharlamov (2002), read from its derivation.
"""

from __future__ import annotations

from functools import cache

from kowalevski_cas.arithmetic import load as load_arithmetic
from kowalevski_cas.dataclass import replace as changed
from kowalevski_cas.derivation import Derivation
from kowalevski_cas.library import load as load_derivation
from kowalevski_cas.motion.compile import Function, function
from kowalevski_cas.notation import Formula, Name, Relation, replace
from kowalevski_cas.scene import Scene, vocabulary
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.texts import Display, Texts

OMEGA = (r"\omega_1", r"\omega_2", r"\omega_3")
ALPHA = (r"\alpha_1", r"\alpha_2", r"\alpha_3")
BETA = (r"\beta_1", r"\beta_2", r"\beta_3")
STATE = (*OMEGA, *ALPHA, *BETA)
"""The order of the nine numbers of a state."""

INTEGRALS = ("H", "K", "a^2", "b^2", "c", "F_1", "F_2")
"""What is constant on N⁴: (17), (4), and the left sides of (16)."""

PHASE_POINT = Display(
    "phase-point",
    r"""
\alpha_1 = \frac{(s_1s_2-a^2)\psi+S_1S_2f_1f_2}{2d^2}, \quad
\alpha_2 = \frac{(s_1s_2-a^2)f_1f_2-S_1S_2\psi}{2d^2}, \quad
\alpha_3 = \frac{rS_1}{d}, \quad
\beta_1 = -\frac{(s_1s_2-b^2)f_1f_2-S_1S_2\psi}{2d^2}, \quad
\beta_2 = \frac{(s_1s_2-b^2)\psi+S_1S_2f_1f_2}{2d^2}, \quad
\beta_3 = \frac{rS_2}{d}, \quad
\omega_1 = \frac{r(\ell-2ms_1)f_2}{2d}, \quad
\omega_2 = \frac{r(\ell-2ms_2)f_1}{2d}, \quad
\omega_3 = -\frac{S_2f_1+S_1f_2}{d}""",
    "4",
)

SUPPLIED = ("s_1s_2-a^2", "s_1s_2-b^2", r"\ell-2ms_1", r"\ell-2ms_2", "rS_2")
"""Parts of the phase point that a caller supplies, by names that are the parts themselves."""

ARGUMENTS = ("S_1", "S_2", "f_1", "f_2", "d", r"\psi", *SUPPLIED, "r")
"""The arguments of :func:`phase_point`."""


@cache
def equations() -> Function:
    """The right-hand sides of the nine equations (3), (5), by the nine variables."""
    derivation, scene = _kowalevski()
    stage = Stage(scene, load_arithmetic("flint"), derivation.texts())
    return function([stage.field[name] for name in STATE], STATE)


@cache
def integrals() -> Function:
    """The values of :data:`INTEGRALS`, by the nine variables."""
    derivation, scene = _kowalevski()
    printed = {display.id: display for display in derivation.displays()}
    eq4, eq16, xi = printed["eq4"], printed["eq16"], printed["xi"]
    full = changed(
        scene,
        definitions={**scene.definitions, "c": eq4[3], r"\xi_1": xi[1], r"\xi_2": xi[2]},
        roots={"a": eq4[1], "b": eq4[2]},
    )
    texts = derivation.texts()
    stage = Stage(full, load_arithmetic("flint"), texts)
    names = [scalar(texts.expression(name), stage) for name in ("H", "K", "a^2", "b^2", "c")]
    sides = [scalar(stage.relation(eq16[number]).members[0], stage) for number in (1, 2)]
    return function([*names, *sides], STATE)


@cache
def phase_point() -> Function:
    r"""The nine variables by :data:`ARGUMENTS`.

    They are homogeneous of degree zero in those that involve :math:`s_1` (with
    :math:`S_1, f_1, rS_2` and d): a common factor changes nothing.
    """
    variables = (*ARGUMENTS, "s_1", "s_2", "a", "b", "m", r"\ell")
    scene = Scene("phase point", "", variables=variables)
    texts = Texts(vocabulary((scene, Scene("state", "", variables=STATE))))
    stage = Stage(scene, load_arithmetic("flint"), texts)
    values = {}
    for number in range(1, 10):
        relation = texts.formula(PHASE_POINT[number])
        assert isinstance(relation, Relation) and isinstance(relation.members[0], Name)
        right = relation.members[1]
        for tex in SUPPLIED:
            right = _named(right, texts.expression(tex), Name(tex))
        values[relation.members[0].name] = scalar(right, stage)
    return function([values[name] for name in STATE], ARGUMENTS)


@cache
def theta() -> Function:
    r"""The value of :math:`x_1x_2`, by the nine variables."""
    return _complex("x_1x_2")


@cache
def constants() -> Function:
    r"""The values of :math:`x_1x_2`, :math:`x_1x_2+z_1z_2`, :math:`w_1w_2` and m.

    m is real on N⁴ only; its real part is taken.
    """
    return _complex(
        "x_1x_2",
        "x_1x_2+z_1z_2",
        "w_1w_2",
        r"\mathop{\rm Re}\nolimits[\frac{1}{c_2}\frac{x_2}{x_1}(w_1^2+x_1)]",
    )


def _complex(*printed: str) -> Function:
    """Expressions in the complex variables (9), by the nine variables."""
    derivation, _ = _kowalevski()
    name = "initial variables with the constants (4)"
    scene = next(scene for scene in derivation.scenes() if scene.name == name)
    texts = derivation.texts({"eq9.i": "i^2=-1"})  # the misprint i^2=1, corrected
    stage = Stage(scene, load_arithmetic("flint"), texts)
    return function([scalar(texts.expression(tex), stage) for tex in printed], STATE)


def _named(formula: Formula, wanted: Formula, name: Name) -> Formula:
    """The formula with a name in place of a subformula."""
    if formula == wanted:
        return name
    for place, child in enumerate(formula.children()):
        formula = replace(formula, (place,), _named(child, wanted, name))
    return formula


@cache
def _kowalevski() -> tuple[Derivation, Scene]:
    derivation = load_derivation("kharlamov2002")
    scenes = derivation.scenes()
    return derivation, next(scene for scene in scenes if scene.name == "Kowalevski case")
