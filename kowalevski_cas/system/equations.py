"""What equations of motion say of their names, and scenes with roots and with special constants."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.notation import (
    Application,
    Conjugate,
    Constant,
    Derivative,
    Formula,
    Modulus,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Relation,
    Root,
    Sum,
    Summation,
    Vector,
    Vocabulary,
    rank,
    read,
    read_display,
    split_display,
    times,
    to_latex,
)
from kowalevski_cas.notation.cursor import is_word
from kowalevski_cas.notation.functions import SIGN
from kowalevski_cas.notation.open import OpenParser, independent, words_that_move
from kowalevski_cas.notation.primed import primed_names
from kowalevski_cas.notation.symbol import name_of_rate
from kowalevski_cas.notation.vocabulary import VECTOR
from kowalevski_cas.paper.amplitudes import (
    SQUARE,
    conjugate_equations,
    conjugate_name,
    with_conjugates,
)
from kowalevski_cas.paper.claims.forms import minus
from kowalevski_cas.paper.constraints import constraints, multipliers
from kowalevski_cas.paper.differentials import differentials, rates
from kowalevski_cas.paper.exponents import half_power, linear_exponent
from kowalevski_cas.paper.implied import implied_equations
from kowalevski_cas.paper.logarithms import with_real_logarithms
from kowalevski_cas.paper.matrix_equations import equations_of_entries, matrix_equations
from kowalevski_cas.paper.names import BRACKET, head, is_bold, summation_indices
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.signs import is_inequality
from kowalevski_cas.paper.summation import expand_sum, without_sums
from kowalevski_cas.paper.texts import IN_WORDS, Display, Printed
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.system.refused import (
    check_derivatives,
    check_ends,
    check_indices,
    check_marks,
    check_momenta,
    check_motion,
    check_no_differentials,
    check_stars,
    check_unit,
    check_words,
)
from kowalevski_cas.system.vectors import Vectors, bold, lengths, names_only, vectors_of

Names = Collection[str]


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
    moving = {name for formula in formulas.values() for name in moving_names(formula)}
    return constraints(formulas, moving, vectors)


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
    variables = tuple(part for one in moving for part in vectors.get(one, (one,)))
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


def vocabulary_of(display: Display, vectors: Vectors, declared: Names) -> Vocabulary:
    """What is a vector, a matrix, a function or the independent variable in a display."""
    words = vocabulary(())
    names = [name for place in display for name in place.heads.names]
    functions = frozenset(function for function, arguments in map(head, names) if arguments)
    matrices = {name for place in display if place.heads.matrix for name in place.heads.names}
    matrices |= {name for name in names if is_bold(name)}
    dots = ["t"] if r"\dot" in display.tex or r"\ddot" in display.tex else []
    times = [*dict.fromkeys([*dots, *independent(display.tex)])] or ["t"]
    if len(times) > 1:
        by = " and by ".join(times)
        raise ValueError(f"derivatives by {by}: print one independent variable, or partial ones")
    scalars = functions.union(declared, words_that_move(display.tex), filter(is_word, names))
    words = replace(
        words, scalars=scalars, functions=words.functions | functions, vectors=frozenset(vectors),
        matrices=frozenset(matrices - vectors.keys()), times=frozenset(times),
        moving=frozenset(sorted(vectors)[:1]),  # by what a gradient is, does not matter yet
    )  # fmt: skip
    return replace(words, scalars=scalars.union(primed_names(display.tex, words)))


def with_row(scene: Scene, place: Printed, formula: Formula) -> Scene:
    """A scene with what is defined or supposed beside the equations of motion."""
    if {*place.heads.names} - {*scene.variables, *scene.constants}:
        return scene.defining(place)
    if (supposing := _suppose(scene, place, formula)) is not None:
        return supposing
    if len(place.heads.squares) == 1:
        return scene.adjoining(place)
    what = "is no equation of motion, and defines no name: print a name alone on one side"
    raise ValueError(f"{place.tex} {what}; what is supposed is printed with \\ne")


def _suppose(scene: Scene, place: Printed, formula: Formula) -> Scene | None:
    """A scene with what is supposed not to vanish, or to be positive, or the imaginary unit."""
    if is_inequality(formula):
        return with_roots(scene, place.display).assuming(place)
    match formula:
        case Relation((left, right), (r"\ne",)):
            return scene.having(nonzero=(to_latex(minus((left, right))),))
        case Relation((Power(Name("i"), Number(2)), Negative(Number(1))), ("=",)):
            kept = tuple(name for name in scene.constants if name != "i")
            return replace(scene, constants=kept).with_unit(place)
    return None


def read_rows(display: Display, words: Vocabulary) -> dict[Printed, Formula]:
    """The statements of a display, where any letter is a name; sums are written out."""

    def print_row(formula: Formula) -> Formula:
        formula = expand_sum(formula) if isinstance(formula, Summation) else formula
        return formula.map_children(print_row)

    found = read_display(display.tex, words, OpenParser)
    return {place: print_row(one.formula) for place, one in zip(display, found, strict=True)}


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


def moving_names(formula: Formula) -> list[str]:
    """The names that stand under a derivative, or by whose rates something is derived."""
    if isinstance(formula, Derivative) and isinstance(formula.argument, Name | Vector | Sum):
        return [node.name for node in formula.argument.nodes() if isinstance(node, Name)]
    if isinstance(formula, Derivative) and isinstance(formula.argument, Conjugate):
        return [conjugate_name(name) for name in sorted(formula.argument.names())]
    found = [name for child in formula.children() for name in moving_names(child)]
    by = formula.by if isinstance(formula, Partial) else ""
    return [name_of_rate(by), *found] if name_of_rate(by) != by else found


def with_parameters(scene: Scene, display: Display) -> Scene:
    r"""A scene with the new names of which a display defines functions, as :math:`L(\lambda)`.

    They are constants: a function stands for its value whatever they are. New vectors have
    components.
    """
    words = vocabulary((scene,))
    if (vectors := vectors_of(display, scene.vectors, words)) != scene.vectors:
        scene = replace(scene, vectors=vectors)
    heads_of = [head(name) for place in display for name in place.heads.names]
    arguments = dict.fromkeys(one for name, listed in heads_of if name != BRACKET for one in listed)
    known = {name for name, _ in heads_of} | {*scene.names(), *scene.vectors, scene.time, "t"}
    new = (
        argument
        for argument in arguments
        if argument not in known and not argument.startswith(r"\dot")
    )
    return scene.having(constants=tuple(new))


def with_levels(scene: Scene, place: Printed) -> Scene:
    """A scene with the new names in an integral: T for it, or its value, as h in :math:`2T=2h`."""
    known = {*scene.names(), *scene.definitions, *scene.vectors, scene.time}
    scene = with_parameters(scene, place.display)
    heads = place.heads.names or place.heads.multiples
    for name in heads:
        if name not in known:
            scene = scene.naming(name, place)
    formula = read_rows(place.display, vocabulary((scene,)))[place]
    members = formula.members if isinstance(formula, Relation) else ()
    names = [{node.name for node in member.nodes() if isinstance(node, Name)} for member in members]
    new = {one for own in names if own.isdisjoint({*known, *heads}) for one in own}
    if known.isdisjoint(one for own in names for one in own):
        return scene  # of nothing that moves it is no value
    return scene.having(constants=tuple(sorted(new - {*scene.names()})))


def with_roots(scene: Scene, display: Display) -> Scene:
    """A scene with the square roots that are printed in a display of its names.

    Raises ``ValueError`` if a name is defined there by two expressions, of which one would be lost,
    and for a bar, which would say nothing.
    """
    printed = read_display(display.tex, vocabulary((scene,)))
    waiting = [without_sums(statement.formula) for statement in printed]
    for place, formula in zip(display, waiting, strict=True):
        named = {*place.heads.names} & {*scene.definitions}
        sides = [side for side in formula.children() if not isinstance(side, Constant)]
        if named and len(sides) > len(named) + 1:
            raise ValueError(f"{place.tex} gives {min(named)} twice: leave one side out")
    inner_first = (node for formula in waiting for node in reversed([*formula.nodes()]))
    for formula in inner_first:
        if isinstance(formula, Conjugate) and scene.unit is None:
            raise ValueError(
                f"{to_latex(formula)} is a conjugate, and all is real: rename it, or print i^2=-1 "
                "beside the equations of motion if they are complex"
            )
        words = vocabulary((scene,))
        root = _root(formula)
        if isinstance(formula, Modulus) and scene.unit and rank(formula.argument, words) != VECTOR:
            root = Root(times(formula.argument, Conjugate(formula.argument)))
        if root is not None and (name := to_latex(root)) not in scene.roots:
            scene = scene.adjoining(name)
    return scene


def _root(formula: Formula) -> Root | None:
    """The square root that a root, an absolute value, a length or a power 3/2 is made of."""
    match formula:
        case Root():
            return formula
        case Modulus(argument):
            return Root(Power(argument, Number(2)))
        case Application(function, (argument,)) if function == SIGN:
            return Root(Power(argument, Number(2)))
        case Power(base, exponent) if half_power(exponent) is not None:
            return Root(base)
    return None


def _with_real_root(scene: Scene, name: str, place: Printed, formula: Formula) -> Scene:
    """A scene on which what a relation says to be a square is not negative.

    A claim that does not speak of the name is one about real points, too.
    """
    for side in formula.children():
        if name not in side.names() and not side.names().isdisjoint(scene.constants):
            tex = rf"{to_latex(side)}\ge0"
            display = replace(
                place.display, id=f"{place.display.id}-real", tex=tex, source=IN_WORDS
            )
            return with_roots(scene, display).assuming(display)
    return scene


def restrict(scene: Scene, place: Printed) -> Scene:
    """A scene with what a relation says of its constants."""
    formula = read(place.tex, vocabulary((scene,)), OpenParser)
    check_no_differentials(formula)
    if (supposing := _suppose(scene, place, formula)) is not None:
        return supposing
    # A name that is a square is not negative: as the root of it, the other one would be left out.
    for name in (*place.heads.names, *place.heads.squares):
        if name in scene.constants:
            kept = tuple(constant for constant in scene.constants if constant != name)
            rest = replace(scene, constants=kept)
            if name not in place.heads.squares:
                return rest.naming(name, place)
            return _with_real_root(rest.adjoining(place), name, place, formula)
    known = ", ".join(scene.constants)
    solve = f"solve it for one of {known}, or" if known else "there is none:"
    raise ValueError(f"{place.tex} gives no constant: {solve} declare a further one by `having`")
