r"""The functions that a paper defines, as :math:`\varphi(s)=4ms^2`, at their arguments."""

from __future__ import annotations

from kowalevski_cas.notation import (
    Application,
    Formula,
    Modulus,
    Name,
    Negative,
    Number,
    Partial,
    Quotient,
    Sum,
    substitute,
)
from kowalevski_cas.notation.functions import DERIVATIVE_OF, EXTREMES, SIGN
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.names import head, primitive
from kowalevski_cas.paper.slopes import derived
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.problem.space import Meaningless


def _check_known_elsewhere(
    function: str, body: Formula, arguments: set[str], setting: Meaning
) -> None:
    """Refuse a value at other arguments, if these stand below a name or in a derivative."""
    if any(isinstance(n, Partial) and n.by in arguments for n in body.nodes()):
        raise Meaningless(f"{function} is printed by a derivative: it is not known elsewhere")
    met, waiting = set[str](), [*body.names()]
    while waiting:
        name = waiting.pop()
        if name in met or name in arguments or name not in setting.scene.definitions:
            continue
        met.add(name)
        below = setting.definition(name).names()
        if below & arguments:
            said = f"{name} stands in {function}, and has {min(below & arguments)} in it"
            raise Meaningless(f"{said}: print it as a function of that, too")
        waiting += below


def check_derivative(formula: Formula, setting: Meaning) -> None:
    """Refuse the derivative of a function by an argument that stands in its definition as well.

    By :math:`V(q)=cq^2` the derivative of :math:`V(c)=c^3` is not :math:`V'(c)=2c^2`.
    """
    if not (isinstance(formula, Partial) and isinstance(formula.argument, Application)):
        return
    function, by = formula.argument, formula.by
    for name in setting.scene.definitions:
        own, arguments = head(name)
        if own != function.function or by in arguments or Name(by) not in function.arguments:
            continue
        reach = Reach(setting)
        reach.formula(setting.definition(name))
        if by in reach.names:
            raise Meaningless(f"{by} stands in what {name} is: name its argument otherwise", by)


def without_extremes(formula: Formula) -> Formula:
    r"""A formula with maxima and minima by absolute values.

    >>> from kowalevski_cas.notation import Vocabulary, read, to_plain
    >>> words = Vocabulary(frozenset("xy"), functions=frozenset([r"\max"]))
    >>> to_plain(without_extremes(read(r"\max(x,y)", words)))
    '(x + y + |x − y|)/2'

    Of one number there is none: it is left as it is.
    """
    formula = formula.map_children(without_extremes)
    match formula:
        case Application(function, (first, *others)) if function in EXTREMES and others:
            for other in others:
                apart: Formula = Modulus(Sum((first, Negative(other))))
                apart = apart if function == EXTREMES[0] else Negative(apart)
                first = Quotient(Sum((first, other, apart)), Number(2))
            return first
    return formula


def _by_moduli(formula: Application, setting: Meaning) -> Formula | None:
    """A sign, a maximum or a minimum by absolute values; ``None`` for any other function."""
    complex_names = {"i", *(name for pair in setting.conjugates for name in pair)}
    if formula.function in EXTREMES and setting.scene.unit and formula.names() & complex_names:
        raise Meaningless(f"which of complex numbers is {formula.function}?", formula.function)
    match formula:
        case Application(function, (argument,)) if function == SIGN:
            return Quotient(argument, Modulus(argument))
        case Application(function, (_, _, *_)) if function in EXTREMES:
            return without_extremes(formula)
    return None


def _body(name: str, order: int, setting: Meaning) -> Formula:
    """What a function is by its definition, derived by its only argument."""
    function, arguments = head(name)
    body = setting.definition(name)
    if any(isinstance(n, Application) and n.function == function for n in body.nodes()):
        raise Meaningless(f"{name} is defined by itself", function)
    if order and len(arguments) != 1:
        raise Meaningless(f"by what is {function} derived? it has several arguments")
    return derived(body, arguments[0], order)


def value_of(formula: Application, setting: Meaning) -> Formula:
    r"""The expression for which a function with these arguments stands, or :math:`V''` at one."""
    base, order = primitive(formula.function)
    for name in setting.scene.definitions:
        function, arguments = head(name)
        if arguments and function == base:
            if len(arguments) != len(formula.arguments):
                raise Meaningless(f"{name} is used with {len(formula.arguments)} arguments")
            values = dict(zip(arguments, formula.arguments, strict=True))
            body = _body(name, order, setting)
            expressions = [setting.texts.expression(argument) for argument in arguments]
            if [*formula.arguments] == expressions:
                return body
            if not all(isinstance(argument, Name) for argument in expressions):
                raise Meaningless(f"{name} is used with other velocities: define it anew")
            _check_known_elsewhere(name, body, {*arguments}, setting)
            return substitute(body, values)
    if (known := _by_moduli(formula, setting)) is not None:
        return known
    what = f"the function {formula.function} has no meaning here"
    if formula.function in DERIVATIVE_OF:
        what += ": only its derivative is known, in a first integral or where it is derived"
    elif formula.function == r"\log":
        what += r": print \ln"
    raise Meaningless(what, formula.function)
