r"""Equations of motion of one's own: what is claimed and asked about them, in Python or in a file.

>>> lorenz = System(r"\dot x=\sigma(y-x),\quad \dot y=\rho x-y-xz,\quad \dot z=xy-bz")
>>> lorenz
x, y, z move; σ, ρ, b are constant
>>> F = lorenz.define(r"F=x^2-2\sigma z")
>>> lorenz.where(r"b=2\sigma").darboux(F, cofactor=r"-2\sigma").verdict
<Verdict.PROVED: 'proved'>

A system builds the scenes and the claims that the derivations of papers write out, and is run like
them: ``kowalevski-cas verify lorenz.py``.
"""

from __future__ import annotations

import re
import sys
from argparse import ArgumentParser
from collections.abc import Callable, Container, Mapping, Sequence
from contextlib import suppress
from copy import copy
from dataclasses import replace
from importlib import import_module
from itertools import chain, count
from typing import Any

from kowalevski_cas.cli.find import forecast, found
from kowalevski_cas.library import MADE
from kowalevski_cas.notation import (
    Formula,
    OpenParser,
    heads,
    read,
    read_display,
    to_plain,
)
from kowalevski_cas.paper.claims import Claim, FirstIntegral
from kowalevski_cas.paper.derivation import Section
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.pool import HERE
from kowalevski_cas.processes import each
from kowalevski_cas.system.answers import Function, Stated, in_html
from kowalevski_cas.system.claims import Claims, Tex
from kowalevski_cas.system.equations import (
    components,
    moving_by,
    restricted,
    rooted,
    with_levels,
    with_parameters,
    with_time,
)
from kowalevski_cas.system.solved import solved
from kowalevski_cas.system.symbols import printed
from kowalevski_cas.verify.found import Finding
from kowalevski_cas.verify.outcome import Verdict, in_latex

LONGEST = 24
"""The signs of a formula by which a claim is called."""

QUESTIONS = "kowalevski_cas.cli.questions"


class System(Claims):
    r"""Equations of motion: what has a derivative moves, and all other names are constant.

    They may be of higher order, and define names in passing: :math:`\dot q=\partial H/\partial p`,
    :math:`\dot p=-\partial H/\partial q`, :math:`H=\frac12p^2+q^4`.

    Args:
        field: a display of equations with derivatives, or the right sides by variables of SymPy.
        name: what the claims of a file with several systems are called after.
        vectors: the components of the names in bold type, where the display does not name them,
            as :math:`\mathbf r=(x,y,z)`, and neither has vector products nor :math:`r_1,r_2`.

    Raises:
        NotationError: an equation cannot be read.
        ValueError: they are no equations of motion; the message says why.
    """

    seconds = 60.0
    """For each claim, and for each question."""
    pool = HERE
    """Where searches are done: ``Pool(jobs=4)`` for four processes."""

    def __init__(
        self,
        field: str | Mapping[Any, Any],
        name: str = "",
        vectors: Mapping[str, tuple[str, ...]] | None = None,
    ) -> None:
        self.symbols: dict[str, Any] = {}
        """The symbols of SymPy in which the system is written, by their names here."""
        self.special: tuple[Display, ...] = ()
        """What is supposed of the constants."""
        self.prefix = f"{name}-" if name else ""
        self.section = Section(name or "1", "")
        MADE.append(self.section)
        tex = field if isinstance(field, str) else self._rows(field)
        parts = components(tex, vectors or {})
        display = self.section.display(f"{self.prefix}field", with_time(tex, parts))
        self._stand_on(moving_by(display, name, parts))
        moving, constant = self.scene.variables, self.scene.constants
        self.section.title = _echo(moving, constant, "${}$".format)

    def _rows(self, field: Mapping[Any, Any]) -> str:
        """Equations of motion by their right sides."""
        if not isinstance(field, Mapping):
            raise TypeError(f"LaTeX, or right sides by the variables of SymPy, and not {field!r}")
        rows = [rf"\dot{{{self._tex(x)}}}={self._tex(force)}" for x, force in field.items()]
        tex = r",\quad ".join(rows)
        if len(heads(tex)) != len(rows):
            raise ValueError(f"{tex}: give each variable one right side")
        return tex

    def __repr__(self) -> str:
        return self._echoed(to_plain)

    def _repr_latex_(self) -> str:
        return f"${in_latex(self._formulas(self.section.displays[0]))}$"

    def _repr_html_(self) -> str:
        equations = self._formulas(self.section.displays[0])
        return f"<p>{', '.join(map(in_html, equations))}; {self._echoed(in_html)}</p>"

    def _echoed(self, shown: Callable[[Formula], str]) -> str:
        """What moves, what is constant, and what is special, in words."""
        echo = _echo(
            self.scene.variables, self.scene.constants, lambda name: shown(self.read(name))
        )
        special = ", ".join(
            shown(formula) for one in self.special for formula in self._formulas(one)
        )
        return f"{echo}; {special}" if special else echo

    # -- scenes ------------------------------------------------------------------

    def _stand_on(self, scene: Scene) -> None:
        """Take this scene for what is said from here on."""
        self.scene = self.section.scenes[scene.name] = scene

    def define(self, formula: Tex) -> Function:
        r"""A name for what is printed, as in ``F=x^2-z``; what is derived from here knows it too.

        A matrix has a bold capital, ``{\bf L}=\begin{pmatrix}…\end{pmatrix}``; the Poisson bracket
        is defined by those of the variables that do not vanish, ``\{x,y\}=z``. Of several names in
        a display the first is returned.

        Raises:
            NotationError: it cannot be read.
            ValueError: it defines no new name.
        """
        tex = self._tex(formula)
        display = self.section.display(self._id("", tex), tex)
        if not [*display]:
            raise ValueError(f"“{tex}” defines no name")
        self._stand_on(rooted(with_parameters(self.scene, display).defining(display), display))
        name, formula = display[1].heads.names[0], self._formulas(display)[0]
        return Function(display[1], name, formula, self.symbols)

    def where(self, *relations: Tex) -> System:
        r"""The system for special constants: ``a+b=2c``, ``r^2=x^2+y^2``, ``\sigma\ne0``.

        Raises:
            NotationError: a relation cannot be read.
            ValueError: a relation gives no constant.
        """
        special, said = copy(self), ", ".join(map(self._tex, relations))
        scene = self.scene.called(f"{self.scene.name} where {said}")
        for relation in relations:
            tex = self._tex(relation)
            formula = read(tex, vocabulary((scene,)), OpenParser)
            tex = tex if heads(tex)[0].names else solved(formula, scene.constants) or tex
            place = self._place("where", tex, supposed=True)
            scene = restricted(scene, place)
            scene = rooted(scene, place.display)
            special.special += (place.display,)
        special._stand_on(scene)
        return special

    def having(self, *constants: str) -> System:
        r"""The system with more constants, as ``\rho``, which stand in no equation of motion."""
        more = copy(self)
        scene = self.scene.having(constants=constants)
        more._stand_on(scene.called(f"{scene.name} with {', '.join(constants)}"))
        return more

    # -- claims ------------------------------------------------------------------

    def states(
        self,
        kind: type[Claim],
        name: str,
        says: str,
        expect: str = "",
        printed: Tex = "",
        **attributes: Any,
    ) -> Stated:
        """A claim of any kind, called after the name and its first formula.

        Formulas, and tuples of them, are taken for what the kind expects at these attributes;
        numbers stay what they are.

        Raises:
            NotationError: a formula is broken TeX.
            ValueError: a formula is several, or there is no such verdict to expect.
        """
        id = self._id(name, self._tex(_first((printed, *attributes.values()))))
        return self._state(id, Finding(kind, self.scene, says, printed, attributes), expect)

    def _state(self, id: str, finding: Finding, expect: str = "") -> Stated:
        if expect and expect not in {*Verdict}:
            raise ValueError(f"expect “{expect}”: a verdict is one of {', '.join(Verdict)}")

        def placed(formula: Tex) -> Printed:
            return self._place(id, formula, supposed=finding.tex not in ("", formula))

        claim = finding.claim(id, placed)
        if isinstance(claim, FirstIntegral):
            with suppress(ValueError):
                claim = replace(claim, scene=with_levels(claim.scene, claim.own))
        for place in claim.places():
            with suppress(ValueError):  # what cannot be read is the outcome of the claim
                claim = replace(claim, scene=rooted(claim.scene, place.display))
        self.section.claim(claim)
        if expect:
            self.section.expected[id] = expect
        return Stated(claim, self.section, self.symbols, self.seconds)

    # -- questions ---------------------------------------------------------------

    def find_integrals(
        self, degree: int, weighted: bool = False, on: Sequence[Tex] = ()
    ) -> list[Stated]:
        """The polynomial first integrals up to a degree, and that there are no others.

        If it is ``weighted``, variables count by weights for which the motion is homogeneous. If
        there are equations ``on`` which the motion is looked at, those on that invariant set.
        """
        given = tuple(map(self._tex, on))
        return self._found("integrals", degree=degree, weighted=weighted, on=given)

    def find_darboux(self, degree: int, special: bool = False, cofactor: Tex = "") -> list[Stated]:
        """The Darboux polynomials up to a degree, perhaps for ``special`` constants too.

        Those for one ``cofactor`` only, if it is given, and that there are no others.
        """
        K = self._tex(cofactor)
        return self._found("darboux", degree=degree, special=special, cofactor=K)

    def find_closure(self, seed: Tex, order: int = 4) -> list[Stated]:
        """Invariant sets from a function and its derivatives, up to an order."""
        return self._found("closure", self._tex(seed), order=order)

    def conditions(self, polynomial: Tex) -> list[Stated]:
        """For which constants a polynomial divides its derivative: all cases, with cofactors."""
        return self._found("parameters", self._tex(polynomial))

    def find_exponents(self) -> list[Stated]:
        """The weights, the balances of the leading terms, and the Kowalevski exponents of each."""
        return self._found("exponents")

    def _found(self, question: str, *words: str, **options: Any) -> list[Stated]:
        """What the command ``find`` finds, as claims like any other.

        What is found in time is claimed; if something may be left, that is said.
        """
        forecast(self.scene, question, options.get("degree", 0))
        module, parser = import_module(f"{QUESTIONS}.{question}"), ArgumentParser(question)
        module.add_arguments(parser)
        each_of = ((n, v if isinstance(v, tuple) else (v,)) for n, v in options.items())
        single = [(name, value) for name, values in each_of for value in values]
        told = [f"--{name}={value}" for name, value in single if type(value) is not bool]
        told += [f"--{name}" for name, value in single if value is True]
        on = Elaborations(Texts(vocabulary((self.scene,))))
        told += ["--", *words] if words else []
        asked = parser.parse_args(told)

        def answered(scene: Scene) -> tuple[Scene, list[Finding], str]:
            return scene, *found(module.search(on, scene, asked, self.pool), self.seconds)

        ((scene, findings, unfinished),) = each(answered, [self.scene])
        if unfinished:
            print(f"find {question}: {unfinished}", file=sys.stderr)
        here = (replace(one, on=self.scene) if one.on is scene else one for one in findings)
        return [self._state(self._id(question, ""), one) for one in here]

    # -- formulas ----------------------------------------------------------------

    def read(self, tex: str) -> Formula:
        """A formula in the names of the system; raises ``NotationError`` for any other name."""
        return read(tex, vocabulary((self.scene,)))

    def _formulas(self, display: Display) -> list[Formula]:
        return [s.formula for s in read_display(display.tex, vocabulary((self.scene,)))]

    def _tex(self, formula: Tex) -> str:
        if isinstance(formula, str):
            return formula
        if not isinstance(formula, Function):
            return printed(formula, self.symbols)
        if self.scene.definitions.get(formula.name) != formula.place:
            raise ValueError(f"{formula!r} is defined elsewhere: define it on this system")
        return formula.name

    def _place(self, id: str, formula: Tex, supposed: bool) -> Printed:
        """Where a formula stands: where it was defined, or in a display of its own.

        What is only ``supposed`` need not stand in a paper of which this is the derivation.
        """
        tex = self._tex(formula)
        if isinstance(formula, Function):
            return formula.place
        known = {one.id for one in self.section.displays}
        if supposed:
            display = self.section.lemma(_new(id, known), tex, "supposed")
        else:
            display = self.section.display(_new(id, known), tex)
        if len([*display]) != 1:
            raise ValueError(f"{display.tex}: one formula is expected; give each by itself")
        return display[1]

    def _id(self, kind: str, tex: str) -> str:
        """A new id, after the label or the letters of a formula."""
        label = re.search(r"\\label\{([^}]*)\}", tex)
        tex = label[1] if label else tex
        letters = re.sub(r"[^A-Za-z0-9]+", "-", re.sub(r"=\s*0\b", "", tex))[:LONGEST].strip("-")
        id = self.prefix + "-".join(filter(None, (kind, letters)))
        return _new(id, {*(one.id for one in self.section.displays), *self.section.lines})


def _new(id: str, known: Container[str]) -> str:
    """An id, with a number if it is known."""
    ids = (f"{id}.{number}" for number in count(2))
    return next(one for one in chain([id], ids) if one not in known)


def _first(value: Any) -> Tex:
    """The first formula among values and tuples of them."""
    if not isinstance(value, tuple):
        return "" if isinstance(value, int) else value
    return next((one for one in map(_first, value) if not isinstance(one, str) or one), "")


def _echo(variables: Sequence[str], constants: Sequence[str], shown: Callable[[str], str]) -> str:
    """What moves and what does not, in words."""
    moving = f"{', '.join(map(shown, variables))} move{'' if len(variables) > 1 else 's'}"
    still = f"{', '.join(map(shown, constants))} {'are' if len(constants) > 1 else 'is'} constant"
    return f"{moving}; {still}" if constants else moving
