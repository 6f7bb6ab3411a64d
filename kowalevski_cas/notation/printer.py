"""What printers of all formats have in common: the order of things, and where brackets stand."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence

from kowalevski_cas.notation.brackets import (
    COMPOUND,
    SIGNED,
    bare,
    is_applied,
    is_base,
    is_unmarked,
    is_word,
)
from kowalevski_cas.notation.formula import (
    Application,
    Changed,
    Commutator,
    Conjugate,
    Constant,
    CrossProduct,
    Derivative,
    Diagonal,
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
    Relation,
    Root,
    ScalarProduct,
    Sum,
    Summation,
    Transposed,
    Unwritten,
    Vector,
)
from kowalevski_cas.notation.symbol import name_of_rate
from kowalevski_cas.notation.unicode import SIGNS


class Printer(ABC):
    """Prints each kind of node by the method of its name."""

    plus = "+"
    minus: str
    times: str
    cross: str
    prime: str
    d = "d"
    partial_d: str
    dots: str
    const: str
    comma = ", "
    thin = ""
    """The space beside a factor that is a word, as ``sn``."""
    round, square, bars = ("(", ")"), ("[", "]"), ("|", "|")
    braces: tuple[str, str]
    word_form: str
    fraction_form: str
    root_form: str
    radical_form: str
    """The sign of a root with its order, and what stands under it."""
    bar_form: str
    sum_form: str
    """The sign of a sum with the index, the first value, the last one."""
    change_forms = ("{}", "{}")
    """What another formula has not, as it should stand, and as it should not."""

    def __call__(self, formula: Formula) -> str:
        """The formula as a source text."""
        printed: str = getattr(self, formula.method)(formula)
        return printed

    # What a format has to say

    @abstractmethod
    def name(self, formula: Name) -> str:
        """A letter with its index."""

    def upright(self, word: str) -> str:
        """A word in upright letters."""
        return self.word_form.format(word)

    def sign(self, sign: str) -> str:
        """The sign of a relation."""
        return SIGNS[sign]

    def prefix(self, sign: str) -> str:
        """A plus or a minus with nothing before it, which stands close to what is behind it."""
        return sign

    @abstractmethod
    def side_by_side(self, parts: Iterable[str]) -> str:
        """Factors side by side."""

    def fraction(self, above: str, below: str) -> str:
        """A fraction of two texts that need no brackets."""
        return self.fraction_form.format(above, below)

    def quotient(self, formula: Quotient) -> str:
        """A fraction."""
        return self.fraction(self(formula.numerator), self(formula.denominator))

    @abstractmethod
    def superscript(self, base: str, exponent: str) -> str:
        """A power."""

    @abstractmethod
    def with_dots(self, argument: Formula, order: int) -> str:
        """Dots over the letter of a name, or over a formula in brackets."""

    @abstractmethod
    def rows(self, rows: Sequence[Sequence[str]]) -> str:
        """A matrix."""

    def with_primes(self, argument: Formula, order: int) -> str:
        """Primes behind a name, or behind a formula in brackets."""
        text = self(argument) if is_unmarked(argument) else self.enclose(argument)
        return text + self.prime * order

    def between(self, opening: str, text: str, closing: str) -> str:
        """A text in these brackets."""
        return opening + text + closing

    # Brackets

    def enclose(self, formula: Formula) -> str:
        """A formula in its brackets."""
        return self.in_brackets(self(formula), formula.bracket)

    def in_brackets(self, text: str, printed: str = "") -> str:
        """The text in brackets."""
        opening, closing = self.brackets(text, printed)
        return self.between(opening, text, closing)

    def brackets(self, text: str, printed: str) -> tuple[str, str]:
        """The brackets around a text: the printed ones, else square ones around round ones."""
        known = {"(": self.round, "[": self.square, r"\{": self.braces}
        inner = self.square if self.is_round(text) else self.round
        return known.get(printed, inner)

    def is_round(self, text: str) -> bool:
        """Whether round brackets stand in a text, and no square ones."""
        return self.round[0] in text and self.square[0] not in text

    def begins_with_number(self, text: str) -> bool:
        """Whether a number stands at the beginning of what was printed."""
        return text[0].isdigit()

    def finish(self, text: str) -> str:
        """What was printed, as the format reads it."""
        return text

    def comma_list(self, formulas: Iterable[Formula]) -> str:
        """A list; square brackets around it would be a commutator."""
        opening, closing = self.round
        return self.between(opening, self.comma.join(map(self, formulas)), closing)

    def term(self, formula: Formula) -> str:
        """The formula behind a sign."""
        return self.enclose(formula) if isinstance(formula, SIGNED) else self(formula)

    def factor(self, formula: Formula) -> str:
        """The formula beside other factors."""
        return self.enclose(formula) if isinstance(formula, COMPOUND) else self(formula)

    # Nodes

    def number(self, formula: Number) -> str:
        return str(formula.value)

    def sum(self, formula: Sum) -> str:
        first, *rest = formula.terms
        text = self(first) if isinstance(first, Negative) else self.term(first)
        for term in rest:
            sign, inner = self.signed(term)
            text += f" {sign} {self.term(inner)}"
        return text

    def signed(self, term: Formula) -> tuple[str, Formula]:
        """The sign before a term of a sum that is not the first, and what stands behind it."""
        if isinstance(term, Changed) and term.sign:
            sign, inner = self.signed(term.argument)
            return self.change_forms[term.wrong].format(sign), inner
        return (self.minus, term.argument) if isinstance(term, Negative) else (self.plus, term)

    def negative(self, formula: Negative) -> str:
        return self.prefix(self.minus) + self.term(formula.argument)

    def product(self, formula: Product) -> str:
        parts: list[str] = []
        before = formula.factors[0]
        for factor in formula.factors:
            part = self.factor(factor)
            parts.append(self.separator(before, factor, part) + part if parts else part)
            before = factor
        return self.side_by_side(parts)

    def separator(self, left: Formula, right: Formula, text: str) -> str:
        """What stands between two factors, of which the right one is printed as ``text``."""
        # A number behind a factor would look like a part of it, a bracket like its argument.
        if isinstance(bare(left), Number) and isinstance(bare(right), Number):
            return self.cross
        if self.begins_with_number(text) or is_applied(left, right):
            return self.times
        return self.thin if self.thin and (is_word(left) or is_word(right)) else ""

    def power(self, formula: Power) -> str:
        text = self(formula.base) if is_base(formula.base) else self.enclose(formula.base)
        return self.superscript(text, self(formula.exponent))

    def transposed(self, formula: Transposed) -> str:
        base = formula.argument
        text = self(base) if is_base(base) else self.enclose(base)
        return self.superscript(text, self(Name("T")))

    def root(self, formula: Root) -> str:
        return self.root_form.format(self(formula.argument))

    def radical(self, formula: Radical) -> str:
        """A root of another order."""
        return self.radical_form.format(formula.order, self(formula.argument))

    def conjugate(self, formula: Conjugate) -> str:
        return self.bar_form.format(self(formula.argument))

    def derivative(self, formula: Derivative) -> str:
        argument, mark, order = formula.argument, formula.mark, 1
        if mark not in ("dot", "prime"):
            return self.rate(self.d, argument, mark)
        while isinstance(argument, Derivative) and argument.mark == mark:
            argument, order = argument.argument, order + 1
        if mark == "prime":
            return self.with_primes(argument, order)
        return self.with_dots(argument, order)

    def partial(self, formula: Partial) -> str:
        return self.rate(self.partial_d, formula.argument, formula.by)

    def rate(self, d: str, argument: Formula, by: str) -> str:
        """A derivative as a fraction of differentials, or applied to what stands behind it."""
        variable = name_of_rate(by)
        moved = Name(by) if variable == by else Derivative(Name(variable), "dot")
        below = self.side_by_side([d, self(moved)])
        if isinstance(argument, Name):
            return self.fraction(self.side_by_side([d, self(argument)]), below)
        return self.side_by_side([self.fraction(d, below), self.enclose(argument)])

    def real_part(self, formula: RealPart) -> str:
        return self.side_by_side([self.upright("Re"), self.enclose(formula.argument)])

    def imaginary_part(self, formula: ImaginaryPart) -> str:
        return self.side_by_side([self.upright("Im"), self.enclose(formula.argument)])

    def application(self, formula: Application) -> str:
        return self.side_by_side([self(Name(formula.function)), self.comma_list(formula.arguments)])

    def vector(self, formula: Vector) -> str:
        rows = formula.components
        lengths = {len(row.components) if isinstance(row, Vector) else 0 for row in rows}
        if len(lengths) != 1 or 0 in lengths:
            return self.comma_list(rows)
        return self.rows([[*map(self, row.components)] for row in rows if isinstance(row, Vector)])

    def diagonal(self, formula: Diagonal) -> str:
        return self.side_by_side([self.upright("diag"), self.comma_list(formula.entries)])

    def scalar_product(self, formula: ScalarProduct) -> str:
        return self.comma_list((formula.left, formula.right))

    def cross_product(self, formula: CrossProduct) -> str:
        sides = []
        for side in (formula.left, formula.right):
            text = self(side)
            inner = isinstance(side, Sum | Negative | CrossProduct | Summation)
            # A dot between the factors of the right side would end that side.
            dot = side is formula.right and isinstance(side, Product) and self.times in text
            sides.append(self.in_brackets(text, side.bracket) if inner or dot else text)
        return f" {self.cross} ".join(sides)

    def poisson_bracket(self, formula: PoissonBracket) -> str:
        opening, closing = self.braces
        return f"{opening}{self(formula.left)}{self.comma}{self(formula.right)}{closing}"

    def commutator(self, formula: Commutator) -> str:
        opening, closing = self.square
        inner = self.comma.join((self(formula.left), self(formula.right)))
        return self.between(opening, inner, closing)

    def modulus(self, formula: Modulus) -> str:
        opening, closing = self.bars
        return self.between(opening, self(formula.argument), closing)

    def summation(self, formula: Summation) -> str:
        index, first, last = self(Name(formula.index)), self(formula.first), self(formula.last)
        return self.side_by_side([self.over(index, first, last), self.term(formula.body)])

    def over(self, index: str, first: str, last: str) -> str:
        """The sign of a sum with its limits."""
        return self.sum_form.format(index, first, last)

    def changed(self, formula: Changed) -> str:
        return self.change_forms[formula.wrong].format(self(formula.argument))

    def unwritten(self, formula: Unwritten) -> str:
        return self.dots

    def constant(self, formula: Constant) -> str:
        return self.const

    def relation(self, formula: Relation) -> str:
        first, *rest = map(self, formula.members)
        return first + "".join(
            f" {self.sign(sign)} {member}" for sign, member in zip(formula.signs, rest, strict=True)
        )
