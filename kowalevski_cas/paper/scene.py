"""Scenes: the smallest stage on which a claim can stand, and changes between them.

A scene only says what there is, in the words of the paper; an arithmetic gives
it meaning (:mod:`kowalevski_cas.stage`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from dataclasses import field as default

from kowalevski_cas.notation import Vocabulary
from kowalevski_cas.paper.texts import Printed


@dataclass(frozen=True, eq=False)
class Change:
    r"""A change of variables from the scene ``source``, by printed formulas.

    ``formulas`` gives new variables through old ones (equation 9 of the paper);
    variables with the same name in both scenes are kept. ``time`` is the
    printed relation between the independent variables, as :math:`\tau=it`. The
    vector field is carried over by the chain rule.
    """

    source: Scene
    formulas: tuple[Printed, ...]
    time: Printed


@dataclass(frozen=True, eq=False)
class Locus:
    """A place where a denominator vanishes or the fields degenerate, by equations."""

    words: str
    equations: tuple[str, ...]
    condition: str
    """The expression that is non-zero away from the locus."""


@dataclass(frozen=True, eq=False)
class Scene:
    r"""Variables, constants, relations among them, a conjugation and a vector field.

    ``vectors``
        names of vectors with the names of their components.
    ``variables``, ``constants``
        what moves and what does not.
    ``field``
        printed equations with a derivative on the left, or a :class:`Change`.
    ``time``
        the independent variable, ``"t"`` or ``"\tau"``.
    ``clock``
        the printed relation of another independent variable to ``time``.
    ``unit``
        the printed relation that the imaginary unit obeys; the letter is ``i``.
    ``definitions``
        names that stand for an expression, with the place that prints it; a function
        comes with its arguments, as ``\varphi(s)``, and the Poisson bracket with a pair of
        coordinates and their indices, as ``\{M_i,\alpha_j\}``, summed over k.
    ``roots``
        square roots, as generators: either printed as a root of an expression,
        ``\sqrt{x_1x_2}``, or a name with the place that prints its square. A printed
        root with a place is no generator: its value is printed there.
    ``powers``
        pairs of a name and a symbolic exponent, as ``(\theta, m)``.
    ``undefined``
        names that the paper prints and defines nowhere: they may be anything.
    ``zero``
        printed equations that set variables to zero.
    ``conjugates``
        pairs of variables that are each other's conjugates; the rest are real.
    ``nonzero``
        what the scene takes for granted not to vanish.
    ``loci``
        the places at which every statement about sets is tried once more.
    """

    name: str
    words: str
    vectors: Mapping[str, tuple[str, ...]] = default(default_factory=dict)
    variables: tuple[str, ...] = ()
    constants: tuple[str, ...] = ()
    field: tuple[Printed, ...] | Change = ()
    time: str = "t"
    clock: Printed | None = None
    unit: Printed | None = None
    definitions: Mapping[str, Printed] = default(default_factory=dict)
    roots: Mapping[str, Printed | None] = default(default_factory=dict)
    powers: tuple[tuple[str, str], ...] = ()
    undefined: tuple[str, ...] = ()
    zero: tuple[Printed, ...] = ()
    conjugates: tuple[tuple[str, str], ...] = ()
    nonzero: tuple[str, ...] = ()
    loci: tuple[Locus, ...] = ()

    def places(self) -> Iterator[Printed]:
        """Every place of the paper on which the scene rests."""
        yield from (printed for printed in (self.unit, self.clock) if printed is not None)
        yield from self.definitions.values()
        yield from (printed for printed in self.roots.values() if printed is not None)
        yield from self.zero
        if isinstance(self.field, Change):
            yield from self.field.formulas
            yield from self.field.source.places()
            yield self.field.time
        else:
            yield from self.field

    def names(self) -> Iterator[str]:
        """Every scalar name that has a meaning on the scene."""
        yield from self.variables
        yield from self.constants
        yield from self.undefined
        for name in self.definitions:
            function, arguments = head(name)
            if function == BRACKET:
                yield EPSILON
                yield from (f"{argument[:-1]}{k}" for argument in arguments for k in "ijk")
            elif is_bold(name):
                yield from self.vectors.get(name, ())
            else:
                yield from arguments or (function,)
        yield from (name for name in self.roots if not name.startswith(r"\sqrt"))
        if self.unit is not None:
            yield "i"

    def component(self, name: str) -> tuple[str, int] | None:
        """The vector with a definition of which a name is a component, and which one."""
        for vector, components in self.vectors.items():
            if vector in self.definitions and name in components:
                return vector, components.index(name)
        return None


def is_bold(name: str) -> bool:
    """Whether a name is printed in bold, that is, denotes a vector or a matrix."""
    return name.startswith((r"\boldsymbol", r"\mathbf"))


BRACKET, EPSILON = r"\{", r"\varepsilon_{ijk}"
"""The Poisson bracket as a function, and the sign of a permutation."""


def head(name: str) -> tuple[str, tuple[str, ...]]:
    r"""The function and its arguments in a head like ``\varphi(s)``; a bare name has none.

    >>> head("f(s)"), head("H"), head(r"\{M_i,M_j\}")[1]
    (('f', ('s',)), ('H', ()), ('M_i', 'M_j'))
    """
    if name.startswith(BRACKET):
        return BRACKET, tuple(name[2:-2].split(","))
    function, _, arguments = name.partition("(")
    return function, tuple(arguments.removesuffix(")").split(",")) if arguments else ()


def vocabulary(scenes: tuple[Scene, ...]) -> Vocabulary:
    """The names of all these scenes; bold capitals that are no declared vectors are matrices."""
    times = frozenset({"t", *(scene.time for scene in scenes)})
    bold = {n for s in scenes for n in (*s.vectors, *s.definitions) if is_bold(n)}
    vectors = {name for scene in scenes for name in scene.vectors}
    capitals = {n for n in bold if n.startswith(r"\mathbf{") and n[8].isupper()}
    matrices = frozenset(capitals - vectors)
    return Vocabulary(
        scalars=times.union(name for scene in scenes for name in scene.names()),
        vectors=frozenset(bold) - matrices,
        matrices=matrices,
        functions=frozenset(
            head(n)[0] for s in scenes for n in s.definitions if head(n)[1] and n[:2] != BRACKET
        ),
        times=times,
    )
