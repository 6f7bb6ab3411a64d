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
from copy import copy
from dataclasses import replace
from functools import cached_property, partial
from html import escape
from importlib import import_module
from itertools import chain, count
from pathlib import Path
from typing import Any

from kowalevski_cas.library import READ
from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Number,
    OpenParser,
    Partial,
    Relation,
    Root,
    Summation,
    Vocabulary,
    from_sympy,
    print_prose,
    read,
    read_display,
    read_prose,
    to_latex,
    to_mathml,
    to_plain,
    to_sympy,
)
from kowalevski_cas.paper.claims import (
    Casimir,
    Claim,
    DarbouxPolynomial,
    FirstIntegral,
    Identity,
    Implication,
    InvariantRelations,
    Involution,
    Jacobi,
    LiouvilleIntegrable,
)
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.plain import written_out
from kowalevski_cas.paper.scene import Scene, head, vocabulary
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.problem.prune import mentions
from kowalevski_cas.verify.found import Finding
from kowalevski_cas.verify.outcome import Counterexample, Outcome, Verdict, in_latex
from kowalevski_cas.verify.run import verify

LONGEST = 24
"""The signs of a formula by which a claim is called."""


QUESTIONS = "kowalevski_cas.cli.questions"
_RATE = re.compile(r"\\dot\{([^{}]*)\}(.*)")

Tex = Any
"""A formula: LaTeX, what was defined, or an expression of SymPy."""


class Shown:
    """Something with formulas: in a notebook, in LaTeX, and for SymPy."""

    system: System
    formulas: tuple[Formula, ...]

    def sympy(self) -> Any:
        """The formula as an expression of SymPy, or a list if there are several."""
        found = [to_sympy(formula, self.system.symbols) for formula in self.formulas]
        return found[0] if len(found) == 1 else found

    def __repr__(self) -> str:
        return ", ".join(map(to_plain, self.formulas))

    def _repr_latex_(self) -> str:
        return f"${in_latex(self.formulas)}$"


class Function(Shown):
    """What a system has a name for; it stands for that name wherever LaTeX is taken."""

    def __init__(self, system: System, place: Printed, name: str) -> None:
        self.system, self.place, self.name = system, place, name

    @property
    def formulas(self) -> tuple[Formula, ...]:  # type: ignore[override]
        """The equation that defines it."""
        return (self.system.read(self.place.tex),)


class Stated(Shown):
    """A claim about a system. It is decided when something is asked of it."""

    def __init__(self, system: System, claim: Claim) -> None:
        self.system, self.claim = system, claim

    @cached_property
    def outcome(self) -> Outcome:
        """All that a run says about it, with FLINT."""
        derivation = Derivation("", "", "", "", (self.system.section,))
        return verify(derivation, ["flint"], [self.claim.id]).outcomes[0]

    @property
    def verdict(self) -> Verdict:
        """Whether it is proved, perhaps under conditions, refuted, or not decided."""
        return self.outcome.verdict

    @property
    def formulas(self) -> tuple[Formula, ...]:  # type: ignore[override]
        """What is claimed, as it is read."""
        return self.outcome.formulas

    @property
    def conditions(self) -> tuple[Formula, ...]:
        """The expressions that are supposed not to vanish."""
        return tuple(condition.expression for condition in self.outcome.conditions)

    @property
    def counterexample(self) -> Counterexample | None:
        """An exact point at which it fails."""
        return self.outcome.counterexample

    def __repr__(self) -> str:
        return self._said(to_plain, str, "{}").strip()

    def _repr_html_(self) -> str:
        return f"<p>{self._said(_math, escape, '<b>{}</b>')}</p>"

    def _said(self, shown: Callable[[Formula], str], said: Callable[[str], str], mark: str) -> str:
        """The verdict, its conditions, what is claimed, and why it is not decided."""
        own = self.outcome
        words = read_prose(own.words, vocabulary((self.claim.scene,)))
        where = ", ".join(f"{shown(formula)} ≠ 0" for formula in self.conditions)
        found = [f"where {where}"] if where else []
        found += [print_prose(words, said, shown), ", ".join(map(shown, self.formulas))]
        found += [said(own.message)] if own.message else []
        return f"{mark.format(own.verdict)}: {'; '.join(filter(None, found))}"


class System:
    r"""Equations of motion: what has a derivative moves, and all other names are constant.

    They may be of higher order, and define names in passing: :math:`\dot q=\partial H/\partial p`,
    :math:`\dot p=-\partial H/\partial q`, :math:`H=\frac12p^2+q^4`.

    Args:
        field: a display of equations with derivatives, or the right sides by variables of SymPy.
        name: what the claims of a file with several systems are called after.
        vectors: the components of the names in bold type.

    Raises:
        NotationError: an equation cannot be read.
        ValueError: they are no equations of motion; the message says why.
    """

    def __init__(
        self,
        field: str | Mapping[Any, Any],
        name: str = "",
        vectors: Mapping[str, tuple[str, ...]] | None = None,
    ) -> None:
        self.symbols: dict[str, Any] = {}
        """The symbols of SymPy in which the system is written, by their names here."""
        self.prefix = f"{name}-" if name else ""
        if not isinstance(field, str):
            rows = (rf"\dot{{{self._tex(x)}}}={self._tex(force)}" for x, force in field.items())
            field = r",\quad ".join(rows)
        self.section = Section(name or "1", "")
        display = self.section.display(f"{self.prefix}field", field)
        components = vectors or {}
        laws, definitions, moving, others = _names(display, components)
        variables = tuple(part for one in moving for part in components.get(one, (one,)))
        constants = tuple(part for one in others for part in components.get(one, (one,)))
        words = "the equations of motion"
        scene = Scene(name or "the system", words, components, variables, constants, (*laws,))
        self._stand_on(_rooted(scene.defining(*definitions), display))
        self.section.title = _echo(variables, constants, "${}$".format)

    def __repr__(self) -> str:
        return _echo(self.scene.variables, self.scene.constants, lambda n: to_plain(self.read(n)))

    def _repr_latex_(self) -> str:
        display = self.section.displays[0]
        return f"${in_latex(self._formulas(display))}$"

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
        self._stand_on(_rooted(self.scene.defining(display), display))
        return Function(self, display[1], display[1].heads.names[0])

    def where(self, *relations: Tex) -> System:
        r"""The system for special constants: ``b=2\sigma``, ``r^2=x^2+y^2``, ``\sigma\ne0``.

        Raises:
            NotationError: a relation cannot be read.
            ValueError: a relation gives no constant.
        """
        special, said = copy(self), ", ".join(map(self._tex, relations))
        scene = self.scene.described(f"{self.scene.name} where {said}", f"${said}$")
        for relation in relations:
            place = self._place("where", relation)
            scene = _restricted(scene, place)
            read_display(place.display.tex, vocabulary((scene,)))
        special._stand_on(scene)
        return special

    # -- claims ------------------------------------------------------------------

    def identity(self, equation: Tex, expect: str = "") -> Stated:
        """Both sides are equal; derivatives are along the motion."""
        says = "both sides are the same function"
        return self.states(Identity, "identity", says, expect, equation)

    def implication(self, equation: Tex, given: Sequence[Tex], expect: str = "") -> Stated:
        """An equation holds wherever the given ones do."""
        says = "this holds wherever what is given does"
        return self.states(Implication, "implication", says, expect, equation, given=tuple(given))

    def integral(self, formula: Tex, given: Sequence[Tex] = (), expect: str = "") -> Stated:
        """A function is constant along every motion, perhaps on an invariant set only."""
        says = "this is constant along every motion"
        return self.states(FirstIntegral, "integral", says, expect, formula, given=tuple(given))

    def invariant(self, *relations: Tex, expect: str = "") -> Stated:
        """No motion leaves the set on which these hold; a function stands for its zeros."""
        zero = tuple(f"{one.name}=0" if isinstance(one, Function) else one for one in relations)
        says = f"no motion leaves the set where {self._listed(zero)}"
        return self.states(InvariantRelations, "invariant", says, expect, relations=zero)

    def darboux(self, formula: Tex, cofactor: Tex, expect: str = "") -> Stated:
        """A polynomial F with F' = KF, where K is the cofactor."""
        says = "its derivative is this multiple of it"
        return self.states(DarbouxPolynomial, "darboux", says, expect, formula, cofactor=cofactor)

    def lax(self, first: Function, second: Function, expect: str = "") -> Stated:
        """A Lax pair of matrices: L' = LM - ML."""
        L, M = first.name, second.name
        says = "the equations of motion give this Lax equation"
        return self.states(Identity, "lax", says, expect, rf"\frac{{d}}{{dt}}{L}={L}{M}-{M}{L}")

    def jacobi(self, expect: str = "") -> Stated:
        """The Poisson bracket that was defined satisfies Jacobi's identity."""
        return self.states(Jacobi, "jacobi", "the bracket satisfies Jacobi's identity", expect)

    def casimir(self, formula: Tex, expect: str = "") -> Stated:
        """A function whose bracket with every function vanishes."""
        says = "its bracket with every function vanishes"
        return self.states(Casimir, "casimir", says, expect, formula)

    def involution(self, *functions: Tex, expect: str = "") -> Stated:
        """Functions whose brackets with each other vanish."""
        says = f"the brackets of {self._listed(functions)} with each other vanish"
        return self.states(Involution, "involution", says, expect, functions=functions)

    def integrable(self, *integrals: Tex, casimirs: Sequence[Tex] = (), expect: str = "") -> Stated:
        """Integrability in the sense of Liouville; the first integral is the Hamiltonian."""
        says = f"the motion is integrable in the sense of Liouville, by {self._listed(integrals)}"
        return self.states(
            LiouvilleIntegrable, "integrable", says, expect,
            integrals=integrals, casimirs=tuple(casimirs),
        )  # fmt: skip

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
        claim = finding.claim(id, partial(self._place, id))
        self.section.claim(claim)
        if expect:
            self.section.expected[id] = expect
        return Stated(self, claim)

    # -- questions ---------------------------------------------------------------

    def find_integrals(self, degree: int, weighted: bool = False) -> list[Stated]:
        """The polynomial first integrals up to a degree, and that there are no others.

        If it is ``weighted``, variables count by weights for which the motion is homogeneous.
        """
        return self._found("integrals", degree=degree, weighted=weighted)

    def find_darboux(self, degree: int, special: bool = False) -> list[Stated]:
        """The Darboux polynomials up to a degree, perhaps for ``special`` constants too."""
        return self._found("darboux", degree=degree, special=special)

    def find_closure(self, seed: Tex, order: int = 4) -> list[Stated]:
        """Invariant sets from a function and its derivatives, up to an order."""
        return self._found("closure", self._tex(seed), order=order)

    def conditions(self, polynomial: Tex) -> list[Stated]:
        """For which constants a polynomial divides its derivative: all cases, with cofactors."""
        return self._found("parameters", self._tex(polynomial))

    def _found(self, question: str, *words: str, **options: int) -> list[Stated]:
        """What the command ``find`` finds, as claims like any other."""
        module, parser = import_module(f"{QUESTIONS}.{question}"), ArgumentParser(question)
        module.add_arguments(parser)
        told = [f"--{name}={value}" for name, value in options.items() if type(value) is int]
        told += [f"--{name}" for name, value in options.items() if value is True]
        on = Elaborations(Texts(vocabulary((self.scene,))))
        told += ["--", *words] if words else []
        found = module.search(on, self.scene, parser.parse_args(told))
        return [self._state(self._id(question, ""), one) for one in found]

    # -- formulas ----------------------------------------------------------------

    def read(self, tex: str) -> Formula:
        """A formula in the names of the system; raises ``NotationError`` for any other name."""
        return read(tex, vocabulary((self.scene,)))

    def _listed(self, formulas: Sequence[Tex]) -> str:
        return ", ".join(f"${self._tex(one)}$" for one in formulas)

    def _formulas(self, display: Display) -> list[Formula]:
        return [s.formula for s in read_display(display.tex, vocabulary((self.scene,)))]

    def _tex(self, formula: Tex) -> str:
        if isinstance(formula, str):
            return formula
        return formula.name if isinstance(formula, Function) else to_latex(self._of_sympy(formula))

    def _of_sympy(self, expression: Any) -> Formula:
        return from_sympy(expression, self._name)

    def _name(self, symbol: Any) -> str:
        """How a symbol of SymPy is printed, as one name."""
        from sympy import latex

        formula = read(latex(symbol), Vocabulary(), OpenParser)
        name = formula.name if isinstance(formula, Name) else rf"\mathrm{{{symbol.name}}}"
        self.symbols[name] = symbol
        return name

    def _place(self, id: str, formula: Tex) -> Printed:
        """Where a formula stands: where it was defined, or in a display of its own."""
        if isinstance(formula, Function):
            return formula.place
        known = {one.id for one in self.section.displays}
        display = self.section.display(_new(id, known), self._tex(formula))
        if len([*display]) != 1:
            raise ValueError(f"{display.tex}: one formula is expected; give each by itself")
        return display[1]

    def _id(self, kind: str, tex: str) -> str:
        """A new id, after the letters of a formula."""
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


def _math(formula: Formula) -> str:
    return f"<math>{to_mathml(formula)}</math>"


def _names(
    display: Display, vectors: Mapping[str, tuple[str, ...]]
) -> tuple[list[Printed], list[Printed], tuple[str, ...], tuple[str, ...]]:
    """The equations of motion, what is defined beside them, what moves, and the other names."""
    words = vocabulary(())
    heads = [head(name) for place in display for name in place.heads.names]
    named = frozenset(name for name, arguments in heads if arguments)  # as H in H(q,p)=…
    words = replace(
        words, vectors=frozenset(vectors), scalars=named, functions=words.functions | named
    )
    moving = dict.fromkeys(name for place in display for name in _moving(_open(place, words)))
    words = replace(words, moving=frozenset(moving))  # only these may be printed as x(t)
    laws = [place for place in display if _is_law(_open(place, words))]
    others = [place for place in display if place not in laws]
    for place in others:
        if not {*place.heads.names} - {*moving}:
            raise ValueError(f"{place.tex} is no equation of motion, and defines no name")
    if len(laws) > len(moving):
        raise ValueError(
            f"{len(laws)} equations for {len(moving)} unknowns ({', '.join(moving)}): "
            "leave one out, or claim it as an identity"
        )
    mentioned = dict.fromkeys(name for place in display for name in _mentioned(place, words))
    if "t" in mentioned:
        raise ValueError("the time t stands in the equations: give it a name, with \\dot s=1")
    heads = [head(name) for place in others for name in place.heads.names]
    defined = {*moving, *(one for name, arguments in heads for one in (name, *arguments))}
    for name in (name for place in display for name in _derived(_open(place, words))):
        if name not in defined:
            raise ValueError(f"{name} is differentiated, and nothing defines it: add {name}=…")
    return laws, others, tuple(moving), tuple(name for name in mentioned if name not in defined)


def _open(place: Printed, words: Vocabulary) -> Formula:
    """What stands at a place, where any letter is a name; sums are written out."""

    def written(formula: Formula) -> Formula:
        formula = written_out(formula) if isinstance(formula, Summation) else formula
        return formula.mapped(written)

    return written(read(place.tex, words, OpenParser))


def _mentioned(place: Printed, words: Vocabulary) -> list[str]:
    return [one.name for one in mentions(_open(place, words)) if isinstance(one, Name)]


def _is_law(formula: Formula) -> bool:
    """Whether a rate stands in an equation, and no name for something else on its left."""
    first = formula.members[0] if isinstance(formula, Relation) else formula
    return not isinstance(first, Name | Application) and bool(_moving(formula))


def _moving(formula: Formula) -> list[str]:
    """The names that stand under a derivative, or by whose rates something is derived."""
    if isinstance(formula, Derivative) and isinstance(formula.argument, Name):
        return [formula.argument.name]
    found = [name for child in formula.children() for name in _moving(child)]
    rate = _RATE.fullmatch(formula.by) if isinstance(formula, Partial) else None
    return [rate[1] + rate[2], *found] if rate else found


def _derived(formula: Formula) -> list[str]:
    """The names of which partial derivatives are printed."""
    if isinstance(formula, Partial) and isinstance(formula.argument, Name):
        return [formula.argument.name]
    return [name for child in formula.children() for name in _derived(child)]


def _rooted(scene: Scene, display: Display) -> Scene:
    """A scene with the square roots that are printed in a display of its names."""
    waiting = [statement.formula for statement in read_display(display.tex, vocabulary((scene,)))]
    while waiting:
        formula = waiting.pop()
        waiting += formula.children()
        if isinstance(formula, Root) and (name := to_latex(formula)) not in scene.roots:
            scene = scene.adjoining(name)
    return scene


def _restricted(scene: Scene, place: Printed) -> Scene:
    """A scene with what a relation says of its constants."""
    formula = read(place.tex, vocabulary((scene,)), OpenParser)
    match formula:
        case Relation((left, Number(0)), (r"\ne",)):
            return scene.having(nonzero=(to_latex(left),))
    if any(name in scene.constants for name in place.heads.squares):
        return scene.adjoining(place)
    for name in place.heads.names:
        if name in scene.constants:
            kept = tuple(one for one in scene.constants if one != name)
            return replace(scene, constants=kept).naming(name, place)
    raise ValueError(
        f"{place.tex} gives no constant: solve it for one of {', '.join(scene.constants) or 'none'}"
    )


def _echo(variables: Sequence[str], constants: Sequence[str], shown: Callable[[str], str]) -> str:
    """What moves and what does not, in words."""
    moving = f"{', '.join(map(shown, variables))} move{'' if len(variables) > 1 else 's'}"
    still = f"{', '.join(map(shown, constants))} {'are' if len(constants) > 1 else 'is'} constant"
    return f"{moving}; {still}" if constants else moving


def display(source: str, label: str) -> str:
    r"""The display with this label in a TeX file, its macros written out: as it stands there now.

    A relative path is one from the folder of the file that asks.

    Raises:
        ValueError: the file cannot be read, or has no display, or several, with this label.
    """
    from kowalevski_cas.audit.audit import typed_formulas  # seldom asked for
    from kowalevski_cas.audit.source import read_source

    here = sys._getframe(1).f_globals.get("__file__", "")
    path = Path(here).parent / source
    if path.is_file():
        READ[path] = path.stat().st_mtime_ns
    found = [one for one in typed_formulas(read_source(path))[1] if label in one.labels]
    if len(found) != 1:
        raise ValueError(f"{path} has {len(found) or 'no'} displays with the label {label}")
    if found[0].trouble:
        raise ValueError(f"{path}: the display {label} cannot be read: {found[0].trouble}")
    return found[0].tex
