"""Formulas as they are printed, written out in the operations of a space."""

from __future__ import annotations

from functools import cached_property

from kowalevski_cas.notation import (
    Application,
    Conjugate,
    Derivative,
    Formula,
    ImaginaryPart,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    RealPart,
    Root,
    Sum,
    substitute,
    to_latex,
)
from kowalevski_cas.paper.brackets import Brackets
from kowalevski_cas.paper.matrices import determinant, rows
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.scene import DETERMINANT, head
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import MARK


class Plain:
    """What formulas mean on a scene; calling it writes one out.

    Raises :class:`Meaningless` for what the scene does not know.
    """

    def __init__(self, setting: Meaning) -> None:
        self.setting = setting

    @cached_property
    def _brackets(self) -> Brackets:
        return Brackets(self.setting)

    def __call__(self, formula: Formula) -> Formula:
        """The formula in the operations of a space."""
        match formula:
            case RealPart(argument):
                inner = self(argument)
                return Quotient(Sum((inner, Conjugate(inner))), Number(2))
            case ImaginaryPart(argument):
                inner = self(argument)
                below = Product((Number(2), Name("i")))
                return Quotient(Sum((inner, Negative(Conjugate(inner)))), below)
            case Derivative(argument, mark):
                return self._derivative(self(argument), mark)
            case Application(function, (argument,)) if function == DETERMINANT:
                return determinant(rows(argument, self.setting))
            case Application():
                return self(self._applied(formula))
            case Root() if (value := self._printed_value(formula)) is not None:
                return value
            case Power(Name(base), exponent) if not _is_whole(exponent):
                return self._symbolic(base, exponent)
            case PoissonBracket(left, right):
                return self._brackets(self._components(left), self._components(right))
        return formula.mapped(self)

    def _derivative(self, argument: Formula, mark: str) -> Formula:
        """The rate by the time of the scene, or by the other one that its clock declares."""
        scene = self.setting.scene
        rate = Derivative(argument, MARK)
        if mark == ("dot" if scene.time == "t" else "prime") or mark == scene.time:
            return rate
        if scene.clock is None:
            raise Meaningless(f"no derivative is printed as “{mark}” on “{scene.name}”")
        scale = self(self.setting.texts.time_scale(scene.clock))
        return Quotient(rate, scale) if scene.time == "t" else Product((scale, rate))

    def _applied(self, formula: Application) -> Formula:
        """The expression for which a function with these arguments stands."""
        for name in self.setting.scene.definitions:
            function, arguments = head(name)
            if arguments and function == formula.function:
                if len(arguments) != len(formula.arguments):
                    raise Meaningless(f"{name} is used with {len(formula.arguments)} arguments")
                values = dict(zip(arguments, formula.arguments, strict=True))
                body = self.setting.definition(name)
                if _applies(body, function):
                    raise Meaningless(f"{name} is defined by itself", function)
                return substitute(body, values)
        raise Meaningless(f"the function {formula.function} has no meaning here", formula.function)

    def _printed_value(self, root: Root) -> Formula | None:
        """What a place prints for a root that is no generator; its square is the radicand."""
        found = self.printed_root(root)
        if found is None:
            return None
        name, printed = found
        value = self(self.setting.definition(name))
        square = self.setting.finder.scalar(value) ** 2
        if not (square - self.setting.finder.scalar(self(root.argument))).is_zero:
            raise Meaningless(f"the value at {printed.place} is not {name}")
        return value

    def printed_root(self, root: Root) -> tuple[str, Printed] | None:
        """The name of a root for which a place prints a value, and the place."""
        for name, printed in self.setting.scene.roots.items():
            if printed is None or not name.startswith(r"\sqrt"):
                continue
            own = self.setting.texts.expression(name)
            assert isinstance(own, Root)
            radicand = self.setting.finder.scalar(self(own.argument))
            if (radicand - self.setting.finder.scalar(self(root.argument))).is_zero:
                return name, printed
        return None

    def _symbolic(self, base: str, exponent: Formula) -> Formula:
        """A power with a symbolic exponent, through the declared powers as names."""
        above: list[Formula] = []
        below: list[Formula] = []
        for symbol, multiple in linear_exponent(exponent).items():
            name = f"{base}^{{{symbol}}}"
            if symbol and name not in self.setting.powers:
                raise Meaningless(f"the power {base}^{symbol} is not declared", symbol)
            factor: Formula = Name(name if symbol else base)
            (above if multiple > 0 else below).extend([factor] * abs(multiple))
        top: Formula = Product(tuple(above)) if len(above) > 1 else next(iter(above), Number(1))
        for factor in below:
            top = Quotient(top, factor)
        return top

    def _components(self, formula: Formula) -> tuple[bool, tuple[Formula, ...]]:
        """Whether a formula is a vector, and its components."""
        if isinstance(formula, Name) and formula.name in self.setting.scene.vectors:
            names = self.setting.scene.vectors[formula.name]
            return True, tuple(self(Name(n)) for n in names)
        return False, (self(formula),)


def linear_exponent(formula: Formula) -> dict[str, int]:
    """A symbolic exponent as integer multiples of names; the key ``""`` is the constant."""
    match formula:
        case Number(value):
            return {"": value}
        case Name(name):
            return {name: 1}
        case Negative(argument):
            return {k: -v for k, v in linear_exponent(argument).items()}
        case Sum(terms):
            total: dict[str, int] = {}
            for term in terms:
                for key, value in linear_exponent(term).items():
                    total[key] = total.get(key, 0) + value
            return total
    raise Meaningless(f"{to_latex(formula)} is no exponent that can be used here")


def _is_whole(exponent: Formula) -> bool:
    return isinstance(exponent.argument if isinstance(exponent, Negative) else exponent, Number)


def _applies(formula: Formula, function: str) -> bool:
    """Whether a function is applied somewhere in a formula."""
    if isinstance(formula, Application) and formula.function == function:
        return True
    return any(_applies(child, function) for child in formula.children())
