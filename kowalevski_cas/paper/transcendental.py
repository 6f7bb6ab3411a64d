r"""Variables that stand under sines, cosines or exponentials only, and what stands in their place.

An angle :math:`\theta` of which the equations know the sine and the cosine is a point of a circle:
:math:`\sin\theta` is a variable and :math:`\cos\theta` a root of :math:`1-\sin^2\theta`. In the
place of a variable x with :math:`e^x` stands :math:`e^{x/2}`, which is not zero, and of which even
powers are used only; its square is any positive number. So every value that a point gives is the
value at an angle, and at a number x; what is proved or refuted is so for the functions themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from kowalevski_cas.notation import (
    Application,
    Formula,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Sum,
    once,
    times,
    to_latex,
    total,
)
from kowalevski_cas.problem.space import Adjoined, Let, Meaningless, Motion, Step

ONE, TWO = Number(1), Number(2)
CIRCULAR = frozenset({r"\sin", r"\cos", r"\tan", r"\cot"})
EXPONENTIAL = frozenset({r"\exp", r"\sinh", r"\cosh"})


class Transcendental:
    """The variables of which formulas have sines, cosines or exponentials.

    Calling it writes a function of them out in what stands in their place.
    """

    def __init__(self, formulas: Iterable[Formula], variables: Iterable[str]) -> None:
        found = set[tuple[str, frozenset[str]]]().union(*map(_arguments, formulas))
        names = [name for name in variables if "_{" not in name]
        kinds = {name: {kind for one, kind in found if one == name} for name in names}
        self.angles = tuple(name for name in names if kinds[name] == {CIRCULAR})
        self.exponents = tuple(name for name in names if kinds[name] == {EXPONENTIAL})

    def __contains__(self, name: str) -> bool:
        return name in self.angles or name in self.exponents

    def instead(self, name: str) -> str:
        """The variable in the place of one; itself if it is none of these."""
        if name in self.angles:
            return rf"\sin{{{name}}}"
        return rf"\mathrm{{e}}^{{{name}/2}}" if name in self.exponents else name

    @property
    def roots(self) -> dict[str, Adjoined]:
        """The cosines, as roots."""
        found = {}
        for name in self.angles:
            cosine, sine = rf"\cos{{{name}}}", Name(self.instead(name))
            found[cosine] = Adjoined(cosine, Sum((ONE, Negative(Power(sine, TWO)))))
        return found

    def chain(self, name: str) -> tuple[Formula, Formula]:
        """The derivative by a variable of what stands in its place: a factor, and a divisor."""
        if name in self.angles:
            return Name(rf"\cos{{{name}}}"), ONE
        return Name(self.instead(name)), TWO

    def row(self, row: Motion) -> Motion:
        """A row of the field for what stands in the place of its variable."""
        if not any(name in self for name in row.names):
            return row
        if len(row.names) > 1:
            raise Meaningless("print the equations of motion of angles one by one", row.names[0])
        factor, divisor = self.chain(row.names[0])
        below = row.factor if divisor == ONE else Product((divisor, row.factor))
        return Motion((self.instead(row.names[0]),), below, Product((factor, row.force)))

    def partial(self, argument: Formula, name: str, step: Callable[[str], Step | None]) -> Formula:
        """The partial derivative by a variable, through what stands in its place.

        That by an angle is written out, so that nothing is divided by the cosine. ``step`` tells
        what defines a name.
        """
        if isinstance(argument, Name) and argument.name in self:
            return Number(int(argument.name == name))
        if name in self.angles:
            return self._by_angle(argument, name, step)
        if name not in self:
            return Partial(argument, name)
        factor, divisor = self.chain(name)
        product = Product((factor, Partial(argument, self.instead(name))))
        return product if divisor == ONE else Quotient(product, divisor)

    def _by_angle(self, formula: Formula, name: str, step: Callable[[str], Step | None]) -> Formula:
        """The derivative by an angle, by the rules for sums, products, quotients and powers."""
        sine, cosine = self.instead(name), rf"\cos{{{name}}}"

        def of(part: Formula) -> Formula:
            return self._by_angle(part, name, step)

        match formula:
            case Number():
                return Number(0)
            case Name(one) if one in (sine, cosine):
                return Name(cosine) if one == sine else Negative(Name(sine))
            case Name(one):
                defined = step(one)
                return of(defined.formula) if isinstance(defined, Let) else Number(0)
            case Sum() | Negative():
                return formula.mapped(of)
            case Product(factors):
                return total(
                    times(*factors[:k], of(factor), *factors[k + 1 :])
                    for k, factor in enumerate(factors)
                )
            case Power(base, Number(exponent)) if exponent > 1:
                return times(Number(exponent), Power(base, Number(exponent - 1)), of(base))
            case Quotient(above, below):
                turned = Sum((times(of(above), below), Negative(times(above, of(below)))))
                return Quotient(turned, Power(below, TWO))
        raise Meaningless(f"print the derivative of {to_latex(formula)} by {name}", name)

    def __call__(self, formula: Application) -> Formula | None:
        """What a function means here; ``None`` for another function.

        Raises :class:`Meaningless` for an argument that is no whole combination of these variables.
        """
        function, (argument, *_) = formula.function, formula.arguments
        if function not in CIRCULAR | EXPONENTIAL:
            return None
        terms = [*_terms(argument, 1)]
        known = self.angles if function in CIRCULAR else self.exponents
        if not all(name in known for name, _ in terms):
            raise Meaningless(
                f"{to_latex(formula)} is not known here: its argument has to be made of variables "
                "that stand under such functions in the equations of motion or in definitions, "
                r"with whole coefficients; for \omega t print an angle with \dot\varphi=\omega"
            )
        if function in EXPONENTIAL:
            power = self._exponential(terms)
            if function == r"\exp":
                return power
            inverse = Quotient(ONE, power)
            other = inverse if function == r"\cosh" else Negative(inverse)
            return Quotient(Sum((power, other)), TWO)
        cosine, sine = self._circular(terms)
        return {
            r"\sin": sine,
            r"\cos": cosine,
            r"\tan": Quotient(sine, cosine),
            r"\cot": Quotient(cosine, sine),
        }[function]

    def _exponential(self, terms: list[tuple[str, int]]) -> Formula:
        above: list[Formula] = []
        below: list[Formula] = []
        for name, count in terms:
            (above if count > 0 else below).append(
                Power(Name(self.instead(name)), Number(2 * abs(count)))
            )
        return Quotient(times(*above), times(*below)) if below else times(*above)

    def _circular(self, terms: list[tuple[str, int]]) -> tuple[Formula, Formula]:
        """The cosine and the sine of a sum, by the addition theorems."""
        cosine: Formula = ONE
        sine: Formula = Number(0)
        for name, count in terms:
            c, s = Name(rf"\cos{{{name}}}"), Name(self.instead(name))
            one: Formula = s if count > 0 else Negative(s)
            for _ in range(abs(count)):
                if cosine == ONE:
                    cosine, sine = c, one
                    continue
                cosine, sine = (
                    Sum((Product((cosine, c)), Negative(Product((sine, one))))),
                    Sum((Product((sine, c)), Product((cosine, one)))),
                )
        return cosine, sine


@once
def _arguments(formula: Formula) -> set[tuple[str, frozenset[str]]]:
    """The names under sines and exponentials, with the kind of function."""
    return {
        (name, kind)
        for one in formula.nodes()
        if isinstance(one, Application)
        for kind in (CIRCULAR, EXPONENTIAL)
        if one.function in kind
        for name in one.names()
    }


def _terms(formula: Formula, sign: int) -> Iterator[tuple[str, int]]:
    """A combination of names with whole coefficients; the name is empty for anything else."""
    match formula:
        case Name(name):
            yield name, sign
        case Negative(argument):
            yield from _terms(argument, -sign)
        case Sum(terms):
            for term in terms:
                yield from _terms(term, sign)
        case Product((Number(count), Name(name))) if count:
            yield name, sign * count
        case _:
            yield "", 0
