"""Formulas as they are printed, written out in the operations of a space."""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction
from functools import cached_property, partial, reduce

from kowalevski_cas.algebra.present import fraction_formula
from kowalevski_cas.notation import (
    Application,
    Conjugate,
    Derivative,
    Formula,
    ImaginaryPart,
    Modulus,
    Name,
    Negative,
    Number,
    Partial,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    Radical,
    RealPart,
    Root,
    ScalarProduct,
    Sum,
    Summation,
    Vector,
    once,
    rank,
    substitute,
    times,
    to_latex,
)
from kowalevski_cas.notation.symbol import name_of_rate, rate_name
from kowalevski_cas.notation.vocabulary import MATRIX, VECTOR
from kowalevski_cas.paper.brackets import Brackets
from kowalevski_cas.paper.components import parts
from kowalevski_cas.paper.exponents import fraction, is_whole, linear_exponent
from kowalevski_cas.paper.functions import check_derivative, value_of
from kowalevski_cas.paper.logarithms import derivative_of, has_logarithm
from kowalevski_cas.paper.matrices import OF_MATRICES, by_rows, matrix_times_column, rows
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.names import head
from kowalevski_cas.paper.radicals import power_under
from kowalevski_cas.paper.rates import marks
from kowalevski_cas.paper.roots import root_of_number
from kowalevski_cas.paper.summation import expand_sum
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.mentions import mentions
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

    @cached_property
    def logarithms(self) -> dict[str, Formula]:
        """What names stand for that are defined by logarithms or arcs, as a potential may be."""
        bodies: dict[str, Formula] = {}
        for name in self.setting.scene.definitions:
            with suppress(Meaningless):
                bodies |= {} if head(name)[1] else {name: self.setting.definition(name)}
        found = {name: body for name, body in bodies.items() if has_logarithm(body)}
        # what is defined by such a name has a logarithm in it too, at whatever depth
        while found:
            above = {n: body for n, body in bodies.items() if body.names() & found.keys()}
            if not (new := {n: substitute(b, found) for n, b in above.items() if n not in found}):
                break
            found |= new
        return found

    def __call__(self, formula: Formula) -> Formula:
        """The formula in the operations of a space."""
        if is_arithmetic(formula) and not any(map(self._rank, mentions(formula))):
            return formula
        check_derivative(formula, self.setting)
        match formula:
            case RealPart(argument) | ImaginaryPart(argument):
                return _part(self(argument), isinstance(formula, RealPart))
            case Derivative(argument) | Partial(argument) if has_logarithm(
                written := substitute(argument, self.logarithms)
            ):
                return self(derivative_of(written, partial(_in_place, formula), self.setting))
            case Derivative(argument, mark):
                return self._derivative(self(argument), mark)
            case Application(function, (argument,)) if function in OF_MATRICES:
                return OF_MATRICES[function](rows(argument, self.setting))
            case Application():
                known = self.setting.transcendental(formula)
                return self(value_of(formula, self.setting) if known is None else known)
            case Power(base, exponent) if (part := fraction(exponent)) is not None:
                return self._fractional(base, part)
            case Root() | Radical():
                return self._root(formula)
            case Power(Name(base), exponent) if not is_whole(exponent):
                return self._symbolic(base, exponent)
        return self._shorthand(formula) or formula.map_children(self)

    def _root(self, root: Root | Radical) -> Formula:
        """A root: a power of the one in the place of its name, or what is printed for it."""
        if isinstance(root, Radical):
            return self._radical(root)
        if isinstance(root.argument, Name) and root.argument.name in self.setting.radicals:
            return self.setting.radicals.power(root.argument.name, Fraction(1, 2))
        value = self._value_in_print(root)
        return self._positive(Root(self(root.argument))) if value is None else value

    def _radical(self, radical: Radical) -> Formula:
        """A root of a power of a name with a root in its place; of a product, of its factors."""
        odd, argument = radical.order % 2, radical.argument
        if (power := power_under(radical)) is not None and power[0] in self.setting.radicals:
            return self.setting.radicals.power(*power)
        # no absolute value: an even order would not divide the odd power that is read under it
        if power is not None and power[1].denominator == 1:
            return Power(Name(power[0]), Number(int(power[1])))
        # √(xy) is not √x√y where both are negative; of odd roots that is so for all signs
        if odd and isinstance(argument, Product | Quotient | Negative):
            return self(argument.map_children(lambda part: Radical(part, radical.order)))
        if odd and isinstance(argument, Number) and argument.value in (0, 1):
            return argument
        raise Meaningless(
            f"{to_latex(radical)} is not known here: print roots of powers of variables or "
            r"constants, as \sqrt[3]{x^2}, or a name for what stands under the root"
        )

    def _fractional(self, base: Formula, exponent: Fraction) -> Formula:
        """A power with a fraction, of a name with a root in its place, or of a square root."""
        if isinstance(base, Name) and base.name in self.setting.radicals:
            return self.setting.radicals.power(base.name, exponent)
        if exponent.denominator > 2:
            shown = to_latex(base)
            raise Meaningless(
                f"the power {exponent} of {shown} is not known here: fractions are exponents of "
                "variables and constants"
            )
        root = Root(base) if exponent.denominator == 2 else base
        power = Power(root, Number(abs(exponent.numerator)))
        return self(power if exponent > 0 else Quotient(Number(1), power))

    def _rank(self, formula: Formula) -> int:
        return rank(formula, self.setting.texts.vocabulary)

    def _shorthand(self, formula: Formula) -> Formula | None:
        """Brackets, sums over an index, lengths, squares of vectors, gradients; or ``None``."""
        match formula:
            case PoissonBracket(left, right):
                return self._brackets(self._components(left), self._components(right))
            case Summation():
                return self(expand_sum(formula))
            case Power(base, Number(exponent)) if (square := self._square(base)) is not None:
                half, odd = divmod(exponent, 2)
                # the even powers of a vector are those of its square, the odd ones those of its
                # length
                even = Power(square, Number(half)) if half > 1 else square
                return even if not odd else Power(Root(square), Number(exponent))
            case Product(factors) if (product := self._matrix_product(factors)) is not None:
                return product
            case Modulus():
                square = self._square(formula)
                assert square is not None
                return self(Root(square))
            case Partial(argument, by):
                inner, derived = self(argument), self.setting.partial
                names = self.setting.scene.vectors.get(name_of_rate(by))
                if names is None:
                    return derived(inner, by)
                if name_of_rate(by) != by:
                    names = tuple(map(rate_name, names))
                return Vector(tuple(derived(inner, name) for name in names))
        return None

    def _matrix_product(self, factors: tuple[Formula, ...]) -> Formula | None:
        """The product of a matrix by its rows and a vector; ``None`` for any other product."""
        ranks = [*map(self._rank, factors)]
        if VECTOR not in ranks or MATRIX not in ranks:
            return None
        matrices = (factor for factor, own in zip(factors, ranks, strict=True) if own == MATRIX)
        if not any(by_rows(matrix, self.setting) for matrix in matrices):
            return None
        *before, vector = factors
        if ranks[-1] != VECTOR:
            raise Meaningless("a vector stands before a matrix: print it behind")
        matrix = Product(tuple(before)) if len(before) > 1 else before[0]
        return Vector(
            matrix_times_column(rows(matrix, self.setting), parts(self(vector), self.setting))
        )

    def _derivative(self, argument: Formula, mark: str) -> Formula:
        """The rate by the time of the scene, or by the other one that its clock declares."""
        scene = self.setting.scene
        rate = self._rate(argument)
        if self.is_by_own_time(mark):
            return rate
        change = self.setting.texts.time_change(scene.clock) if scene.clock is not None else None
        known = ("prime", change.time) if change is not None and scene.time == "t" else ("dot", "t")
        if change is None or mark not in known:
            if mark in marks(self.setting.printed_field):
                return rate
            raise Meaningless(f"no derivative is printed as “{mark}” on “{scene.name}”")
        scale = self(change.rate)
        return Quotient(rate, scale) if scene.time == "t" else Product((scale, rate))

    def is_by_own_time(self, mark: str) -> bool:
        """Whether derivatives with this mark are those by the time of the scene."""
        scene = self.setting.scene
        return (mark == "prime" and scene.primes) or mark in (
            "dot" if scene.time == "t" else "prime",
            scene.time,
        )

    def _rate(self, argument: Formula) -> Formula:
        """The derivative along the field; that of a variable may be a variable."""
        velocities, vectors = self.setting.velocities, self.setting.scene.vectors
        if argument == Name(self.setting.scene.time):
            return Number(1)
        if isinstance(argument, Name) and argument.name in velocities:
            return Name(velocities[argument.name])
        if isinstance(argument, Name) and argument.name in self.setting.transcendental:
            return self._rate_in_place(argument.name)
        if isinstance(argument, Name) and velocities.keys() & {*vectors.get(argument.name, ())}:
            return Vector(tuple(self._rate(Name(name)) for name in vectors[argument.name]))
        return Derivative(argument, MARK)

    def _rate_in_place(self, name: str) -> Formula:
        """The rate of a variable in whose place another one stands."""
        if self.setting.turning is None:
            _ = self.setting.field
        if name not in (self.setting.turning or {}):
            raise Meaningless(f"print the equation for the rate of {name} first", name)
        return (self.setting.turning or {})[name]

    def _square(self, formula: Formula) -> Formula | None:
        """The square of a vector, or of what stands between bars; ``None`` for anything else."""
        bars = isinstance(formula, Modulus)
        value = formula.argument if isinstance(formula, Modulus) else formula
        is_vector = self._rank(value) == VECTOR
        if not bars and not is_vector:
            return None
        value = other = self(value)
        # |z|² is z times its conjugate, and z² only for what is real
        if bars and (self.setting.conjugates or "i" in self.setting.roots):
            other = Conjugate(value)
        if is_vector:
            return ScalarProduct(value, other)
        return Power(value, Number(2)) if other is value else Product((value, other))

    def _value_in_print(self, root: Root) -> Formula | None:
        """What a place prints for a root that is no generator; its square is the radicand."""
        found = self.printed_root(root)
        if found is None:
            return None
        name, printed = found
        value = self(self.setting.definition(name))
        square = self.setting.finder.scalar(value) ** 2
        # the paper chooses the branch, but what it chooses has to be a root
        if not (square - self.setting.finder.scalar(self(root.argument))).is_zero:
            raise Meaningless(f"the value at {printed.place} is not {name}")
        return value

    def _positive(self, root: Root) -> Formula:
        """A printed root; raises :class:`Meaningless` if a name has its square, and either sign.

        Those of numbers are made of roots of primes.
        """
        if (number := root_of_number(root.argument)) is not None:
            # √6 as √2√3: roots of different primes are independent, those of 2, 3 and 6 are not
            roots = (Root(Number(prime)) for prime in number[1])
            return reduce(lambda a, b: Product((a, b)), roots, fraction_formula(number[0]))
        first, *others = self.setting.finder.root_names(root.argument)
        either = [name for name in others if name in self.setting.scene.roots]
        if first != "i" and not first.startswith(r"\sqrt"):
            either = [first]
        for name in (base for base in either if not base.startswith(r"\sqrt")):
            shown = to_latex(root)
            raise Meaningless(f"{name} may be {shown} or its opposite: print {name}, not {shown}")
        return root

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
        top = times(*above)
        for factor in below:
            top = Quotient(top, factor)
        return top

    def _components(self, formula: Formula) -> tuple[bool, tuple[Formula, ...]]:
        """Whether a formula is a vector, and its components."""
        if isinstance(formula, Name) and formula.name in self.setting.scene.vectors:
            names = self.setting.scene.vectors[formula.name]
            return True, tuple(self(Name(n)) for n in names)
        written = substitute(formula, self.logarithms)  # only its derivatives have values
        return False, (written if has_logarithm(written) else self(formula),)


@once
def is_arithmetic(formula: Formula) -> bool:
    """Whether a formula is made of names and numbers by ``+ - * /`` and whole powers alone."""
    match formula:
        case Name() | Number():
            return True
        case Power(base, exponent):
            return is_arithmetic(base) and is_whole(exponent)
        case Sum() | Negative() | Product() | Quotient():
            return all(map(is_arithmetic, formula.children()))
    return False


def _part(formula: Formula, is_real: bool) -> Formula:
    """The real part of what a formula is, or the imaginary one."""
    other, two = Conjugate(formula), Number(2)
    if is_real:
        return Quotient(Sum((formula, other)), two)
    return Quotient(Sum((formula, Negative(other))), Product((two, Name("i"))))


def _in_place(derivative: Formula, argument: Formula) -> Formula:
    """The same derivative of something else."""
    return derivative.map_children(lambda _: argument)
