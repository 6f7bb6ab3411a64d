"""What equations of motion say of their names, and the scene that they make."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.notation import (
    Application,
    Constant,
    Derivative,
    Formula,
    Name,
    Power,
    Relation,
    split_display,
)
from kowalevski_cas.paper.amplitudes import SQUARE, conjugate_equations, with_conjugates
from kowalevski_cas.paper.constraints import constraints, multipliers
from kowalevski_cas.paper.differentials import differentials, rates
from kowalevski_cas.paper.exponents import linear_exponent
from kowalevski_cas.paper.implied import implied_equations
from kowalevski_cas.paper.logarithms import with_real_logarithms
from kowalevski_cas.paper.matrix_equations import equations_of_entries, matrix_equations
from kowalevski_cas.paper.names import head, summation_indices
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.system.refused import (
    check_derivatives,
    check_ends,
    check_indices,
    check_marks,
    check_momenta,
    check_motion,
    check_stars,
    check_unit,
    check_words,
)
from kowalevski_cas.system.roots import with_roots
from kowalevski_cas.system.rows import Names, moving_names, read_rows, vocabulary_of
from kowalevski_cas.system.scenes import with_row
from kowalevski_cas.system.vectors import Vectors, bold, lengths, names_only, vectors_of


def components(tex: str, vectors: Vectors, declared: Names = ()) -> dict[str, tuple[str, ...]]:
    """The vectors of equations of motion with their components, beside those that are told."""
    display, known = Display("field", tex, ""), bold(vectors)
    words = replace(vocabulary_of(display, known, declared), matrices=frozenset())
    return vectors_of(display, known, words)


def with_motion(tex: str, vectors: Vectors, declared: Names = (), arguments: Names = ()) -> str:
    """Equations of motion, with those that what is printed implies.

    ``arguments`` of functions may stand nowhere else.
    """
    display = Display("field", tex, "")
    words = vocabulary_of(display, vectors, declared)
    printed = read_rows(display, words)
    if rows := [*equations_of_entries(printed, min(words.times))]:
        return r",\quad ".join((tex, *rows))
    nodes = (node for one in printed.values() for node in one.nodes())
    marks = {node.mark for node in nodes if isinstance(node, Derivative)}
    ratios = dict[tuple[int, int], list[str]]()
    for at, one in zip(split_display(tex), printed.values(), strict=True):
        if differentials(one):
            ratios.setdefault(at, []).extend(rates(one, words.times, marks == {"prime"}))
    for start, end in sorted(ratios, reverse=True):
        tex = tex[:start] + r",\quad ".join(ratios[start, end]) + tex[end:]
    if ratios:
        return with_motion(tex, vectors, declared, arguments)
    formulas = [*printed.values()]
    moving = {name for formula in formulas for name in moving_names(formula)}
    implied = implied_equations([*formulas, *map(Name, arguments)])
    more = [*implied, *conjugate_equations(formulas, moving)]
    more += lengths([*formulas, *map(Name, arguments)], vectors, moving)
    tex = r",\quad ".join((tex, *more))
    display = Display("field", tex, "")
    if places := constraints_in(display, vectors, declared):
        scene = scene_by(display, "", vectors, declared)
        tex = r",\quad ".join((tex, *multipliers(scene, places)))
    return tex


def constraints_in(display: Display, vectors: Vectors, declared: Names = ()) -> list[Printed]:
    """The constraints among equations of motion with multipliers."""
    formulas = read_rows(display, vocabulary_of(display, vectors, declared))
    laws = matrix_equations(formulas)
    rest = {place: formula for place, formula in formulas.items() if place not in laws}
    moving = {name for formula in rest.values() for name in moving_names(formula)}
    return constraints(rest, moving, vectors)


def with_time(tex: str, vectors: Vectors, declared: Names = ()) -> str:
    """Equations of motion, with one for the time, :math:`dt/dt=1`, if it stands in them."""
    display = Display("field", tex, "")
    words = vocabulary_of(display, vectors, declared)
    formulas = [*read_rows(display, words).values()]
    moving = {name for formula in formulas for name in moving_names(formula)}
    for time in words.times - moving:
        if any(Name(time) in formula.nodes() for formula in formulas):
            return rf"{tex},\quad \frac{{d{time}}}{{d{time}}}=1"
    return tex


def scene_by(display: Display, name: str, vectors: Vectors, declared: Names = ()) -> Scene:
    """The scene of equations of motion, and of what is defined and supposed beside them.

    Words are names if they are ``declared``, differentiated or defined there.

    Raises ``ValueError`` if they do not say what moves, and how.
    """
    check_words(display.tex)
    words = vocabulary_of(display, vectors, declared)
    formulas = read_rows(display, words)
    matrix_laws = matrix_equations(formulas)
    formulas = {place: one for place, one in formulas.items() if place not in matrix_laws}
    moving = dict.fromkeys(one for formula in formulas.values() for one in moving_names(formula))
    words = replace(words, moving=frozenset(moving))  # only these may be printed as x(t)
    bound = constraints_in(display, vectors, declared)
    printed = {p: one for p, one in read_rows(display, words).items() if not _is_empty(one)}
    bound += matrix_laws
    formulas = {place: one for place, one in printed.items() if place not in bound}
    laws = tuple(p for p, one in formulas.items() if _is_law(one) or _is_momentum(one, moving))
    moving = _without_momenta(formulas, laws, moving, vectors)
    others = [place for place in formulas if place not in laws]
    heads_of = [head(one) for place in others for one in place.heads.names or place.heads.squares]
    check_momenta(formulas.values(), moving)
    in_laws = {one for place in laws for one in formulas[place].names()}
    arguments = {one for _, given in heads_of for one in (*given, *summation_indices(given))}
    defined = ({f for f, _ in heads_of} | arguments - in_laws) - {*moving}
    nodes = (node for formula in printed.values() for node in formula.nodes())
    names = [node.name for node in nodes if isinstance(node, Name)]
    check_marks(formulas.values())
    check_motion(display, formulas, laws, moving, defined.union(declared))
    variables = (*dict.fromkeys(part for one in moving for part in vectors.get(one, (one,))),)
    fixed = [one for one in names if one not in defined and one not in words.matrices]
    parts = dict.fromkeys(part for one in fixed for part in vectors.get(one, (one,)))
    constants = tuple(part for part in parts if part not in variables and part not in defined)
    check_indices((*variables, *constants), moving)
    check_ends(display.tex, (one for one in fixed if one not in moving), moving)
    check_derivatives(constants, defined, moving)
    if SQUARE not in formulas.values():
        check_stars(constants, {*variables, *constants, *defined})
    title, time = name or "the system", min(words.times)
    scene = Scene(title, vectors, variables, constants, laws, time)
    for place in others:
        scene = with_row(scene, place, formulas[place])
    check_unit(scene.constants)
    if scene.unit is not None:
        scene = with_conjugates(scene, formulas.values())
    scene = scene.having(powers=tuple(dict.fromkeys(_powers(formulas.values(), scene))))
    return with_real_logarithms(with_roots(scene, display), formulas.values())


def _powers(formulas: Iterable[Formula], scene: Scene) -> Iterator[tuple[str, str]]:
    r"""The names of which powers stand in formulas, with the constants in the exponents.

    A T may be that of a transposed matrix.
    """
    for node in (node for formula in formulas for node in formula.nodes()):
        match node:
            case Power(Name(base), exponent) if exponent.names():
                with suppress(Meaningless):
                    symbols = {*linear_exponent(exponent)} & {*scene.constants} - {"T"}
                    yield from ((base, one) for one in sorted(symbols))


def _is_empty(formula: Formula) -> bool:
    r"""Whether nothing is said but how components are called, or that a name is constant."""
    match formula:
        case Relation((Name(), Constant()), ("=",)):
            return True
    return names_only(formula)


def _is_law(formula: Formula) -> bool:
    """Whether a rate stands in an equation, and no name for something else on its left."""
    first = formula.members[0] if isinstance(formula, Relation) else formula
    return not isinstance(first, Name | Application) and bool(moving_names(formula))


def _is_momentum(formula: Formula, moving: Names) -> bool:
    r"""Whether it gives a rate by a name that moves, as :math:`p=m\dot q` beside :math:`\dot p`."""
    match formula:
        case Relation((Name(p), right), ("=",)) if p in moving:
            return right.names() & {*moving} == {*moving_names(right)} != set()
    return False


def _without_momenta(
    formulas: Mapping[Printed, Formula], laws: Sequence[Printed], moving: Names, vectors: Vectors
) -> dict[str, None]:
    r"""What moves, with :math:`\boldsymbol\omega` for :math:`\mathbf M=I\boldsymbol\omega`.

    A vector of which the rate is printed may be defined by another one, which stands in its
    equation of motion and has none of its own.
    """
    owner = {part: name for name, parts in vectors.items() for part in parts}
    vector = {place: {owner.get(one, one) for one in f.names()} for place, f in formulas.items()}
    found = dict.fromkeys(moving)
    for place, formula in formulas.items():
        match formula:
            case Relation((Name(M), _), ("=",)) if M in vectors and M in found:
                in_law = set[str]().union(*(vector[law] for law in laws))
                others = sorted(vector[place] & in_law & {*vectors} - {*moving})
                if place not in laws and len(others) == 1:
                    found = dict.fromkeys(others[0] if one == M else one for one in found)
    return found
