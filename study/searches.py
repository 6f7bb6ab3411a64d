"""How fast searches are, by several methods, against the share of published systems they finish."""

from __future__ import annotations

import subprocess
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from itertools import count
from math import prod
from typing import Any

from flint import (
    Ordering,
    fmpq,
    fmpq_mat,
    fmpq_mpoly,
    fmpq_mpoly_ctx,
    fmpz_mat,
    fmpz_mpoly_ctx,
    fmpz_mpoly_vec,
    nmod_mat,
)
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter
from sympy import QQ, Poly, groebner, symbols
from sympy.polys.matrices import DomainMatrix

from kowalevski_cas.algebra.elimination import PRIME
from kowalevski_cas.algebra.flint import polynomial_of, terms_of
from kowalevski_cas.algebra.kernels import kernel, residue
from kowalevski_cas.algebra.polynomials import primitive
from kowalevski_cas.limits import time_limit
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pictures import new_figure
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.polynomial_fields import Exponents, PolynomialField, Terms, monomials
from kowalevski_cas.processes import each
from kowalevski_cas.search.branches import branches
from kowalevski_cas.search.groebner import Basis
from kowalevski_cas.search.integrals import first_integrals
from kowalevski_cas.search.parameters import DarbouxAnsatz, cofactor_monomials
from kowalevski_cas.tools import TOOLS
from study.charts import display_name, line_style, look, seconds
from study.process import processor_seconds
from study.published import PUBLISHED, Published
from study.step import Measured, Row, Task

TITLE = "searches"

Prepared = Callable[[Published], Callable[[], int]]
"""What prepares a system, and gives what is timed."""

SECONDS = 5.0

QUICK = ("the oscillator", "Nahm", "logistic growth")
"""The systems of a quick study."""

LEFT = [published for published in PUBLISHED if published.question == "integrals"]
RIGHT = [published for published in PUBLISHED if published.question == "darboux"]

CAPTION = (
    f"The share of systems that a search finishes within a time, up to {SECONDS:g} s; all times "
    "are of the processor. On the left the polynomials without a derivative along "
    f"{len(LEFT)} published fields, up to the degree of the published integrals, where constants "
    "are replaced by numbers: the kernel of one matrix, by python-flint (of integers; its rank of "
    "rational numbers), SymPy (sparse) and Singular (syzygies, with its start); modulo a prime of "
    "61 bits as a whole, which is its rank only, and by blocks, lifted and checked. In the middle "
    "constants are symbols: the same matrix over the field of fractions in them, which says what "
    "is so for almost all values, by SymPy and Singular; and the whole search of this program, "
    "which asks for which values there are more, and what are functions of others. "
    "On the right the equations for quadratic $F$ "
    f"with $F'=KF$ in {len(RIGHT)} published fields, where constants are unknown too: solved by "
    "cases, one factor after another, and by Gröbner bases of four programs, of which the one with "
    "cofactors is this one's."
)


def measure(quick: bool) -> Iterator[Task]:
    """Each method on each system; methods take turns."""
    for published, question, methods in QUESTIONS:
        for one in published:
            if one.name in QUICK or not quick:
                for name, method in methods.items():
                    yield Task(name, f"{question}: {one.name}", partial(_time, method, one))


def _time(method: Prepared, one: Published) -> Measured:
    """How long it takes, without the preparation, and how many solutions or cases there are."""
    work = method(one)

    def run_method(_: int) -> Measured:
        start = processor_seconds()
        try:
            with time_limit(SECONDS):
                size = work()
        except TimeoutError:
            return {"seconds": SECONDS, "verdict": "timeout", "reason": f"{SECONDS:g} s"}
        return {"seconds": processor_seconds() - start, "verdict": "finished", "size": size}

    (found,) = each(run_method, [0])
    return found


# -- kernels -------------------------------------------------------------------------


def _finder(one: Published, scene: Scene | None = None) -> Evaluation:
    system = one.system()
    scene = scene or system.scene
    derivation = Derivation("published", one.name, "", "", (system.section,))
    return Elaborations(derivation.texts(None, scene))(scene).finder


Coefficients = dict[Exponents, Terms]
"""What is before the monomials of the variables: polynomials in the constants."""


def _derivatives(one: Published) -> tuple[list[str], list[Coefficients]]:
    """Names for the constants, and the derivatives of all monomials up to the degree."""
    field = PolynomialField(_finder(one))
    constants = [f"c{k}" for k, _ in enumerate(field.names[field.size :])]
    derivatives = []
    for degree in range(1, one.degree + 1):
        for exponents in monomials((1,) * field.size, degree):
            found: Coefficients = {}
            for powers, value in field.derivative((*exponents, *(0 for _ in constants))).items():
                found.setdefault(powers[: field.size], {})[powers[field.size :]] = value
            derivatives.append(found)
    return constants, derivatives


def _columns(one: Published) -> list[Terms]:
    """The derivatives, with primes for the constants."""
    primes = (101, 103, 107, 109, 113, 127)

    def number(terms: Terms) -> Fraction:
        powers = ((zip(primes, e, strict=False), value) for e, value in terms.items())
        return sum((v * prod(p**e for p, e in pairs) for pairs, v in powers), Fraction(0))

    _, derivatives = _derivatives(one)
    columns = [{e: number(terms) for e, terms in column.items()} for column in derivatives]
    return [{e: value for e, value in column.items() if value} for column in columns]


Entries = Iterator[tuple[int, int, Any]]


def _entries(columns: Sequence[Mapping[Exponents, Any]]) -> tuple[int, Entries]:
    """The number of rows of a matrix, and its entries with their places."""
    rows: dict[Exponents, int] = {}
    for column in columns:
        for key in column:
            rows.setdefault(key, len(rows))
    places = ((rows[e], k, v) for k, column in enumerate(columns) for e, v in column.items())
    return max(1, len(rows)), places


def _by_blocks(columns: Sequence[Terms]) -> int:
    return len(kernel(columns))


def _modulo_a_prime(columns: Sequence[Terms]) -> int:
    height, places = _entries(columns)
    matrix = nmod_mat(height, len(columns), PRIME)
    for row, k, value in places:
        matrix[row, k] = residue(value)
    return len(columns) - int(matrix.rank())


def _rank(columns: Sequence[Terms]) -> int:
    height, places = _entries(columns)
    matrix = fmpq_mat(height, len(columns))
    for row, k, value in places:
        matrix[row, k] = fmpq(value.numerator, value.denominator)
    return len(columns) - int(matrix.rank())


def _rational(columns: Sequence[Terms]) -> int:
    whole = [primitive(column) if column else column for column in columns]
    height, places = _entries(whole)
    matrix = fmpz_mat(height, len(columns))
    for row, k, value in places:
        matrix[row, k] = int(value)
    return int(matrix.nullspace()[1])


def _rational_by_sympy(columns: Sequence[Terms]) -> int:
    height, places = _entries(columns)
    rows: dict[int, dict[int, object]] = {}
    for row, k, value in places:
        rows.setdefault(row, {})[k] = QQ(value.numerator, value.denominator)
    return int(DomainMatrix(rows, (height, len(columns)), QQ).nullspace().shape[0])


def _symbols_by_sympy(one: Published) -> Callable[[], int]:
    """Over the field of fractions in the constants."""
    constants, columns = _derivatives(one)
    domain = QQ.frac_field(*symbols(constants)) if constants else QQ

    def number(terms: Terms) -> Any:
        if not constants:
            return QQ.convert(sum(terms.values()))
        return domain.convert(Poly(terms, *domain.symbols).as_expr())

    def work() -> int:
        height, places = _entries(columns)
        rows: dict[int, dict[int, object]] = {}
        for row, k, terms in places:
            rows.setdefault(row, {})[k] = number(terms)
        return int(DomainMatrix(rows, (height, len(columns)), domain).nullspace().shape[0])

    return work


def _symbols_by_singular(one: Published) -> Callable[[], int]:
    """The relations over the field of fractions in the constants."""
    constants, columns = _derivatives(one)

    def number(terms: Terms) -> str:
        pairs = ((value, zip(constants, e, strict=True)) for e, value in terms.items())
        return "+".join("*".join([f"({v})", *(f"{c}^{e}" for c, e in p)]) for v, p in pairs)

    return _syzygies([{e: number(t) for e, t in column.items()} for column in columns], constants)


def _numbers_by_singular(one: Published) -> Callable[[], int]:
    return _syzygies(_columns(one))


def _syzygies(
    columns: Sequence[Mapping[Exponents, object]], constants: Sequence[str] = ()
) -> Callable[[], int]:
    """The relations of the columns, which are vectors of constants for Singular."""
    _, places = _entries(columns)
    vectors = [["0*gen(1)"] for _ in columns]
    for row, k, value in places:
        vectors[k].append(f"({value})*gen({row + 1})")
    module = ",".join("+".join(vector) for vector in vectors)
    field = f"({','.join(('0', *constants))})"
    text = f"ring r={field},x,dp; module m={module}; size(syz(m)); quit;"
    return partial(_number_by_singular, text)


def _number_by_singular(text: str) -> int:
    """The last number that Singular prints, which is started for it."""
    call = [*TOOLS["singular"].call(), "-q"]
    done = subprocess.run(call, input=text, capture_output=True, text=True, check=True)
    return int(done.stdout.split()[-1])


def _kernel(of: Callable[[Sequence[Terms]], int], one: Published) -> Callable[[], int]:
    return partial(of, _columns(one))


def _search(one: Published) -> Callable[[], int]:
    at = _finder(one)
    return lambda: len([*first_integrals(at, one.degree)])


LINEAR: dict[str, Prepared] = {
    "blocks": partial(_kernel, _by_blocks),
    "modular": partial(_kernel, _modulo_a_prime),
    "rank": partial(_kernel, _rank),
    "python-flint": partial(_kernel, _rational),
    "sympy": partial(_kernel, _rational_by_sympy),
    "singular": _numbers_by_singular,
}
"""For constants that are numbers."""

SYMBOLIC: dict[str, Prepared] = {
    "search": _search,
    "sympy": _symbols_by_sympy,
    "singular": _symbols_by_singular,
}
"""For constants that are symbols."""


# -- polynomial equations ------------------------------------------------------------


def _equations(one: Published) -> tuple[list[fmpq_mpoly], range]:
    """Those for a quadratic F that begins with the square of the first variable, and for K."""
    at = _finder(one)
    size = len(at.setting.variables)
    powers = [e for degree in range(3) for e in monomials((1,) * size, degree)]
    first = (2, *(0,) * (size - 1))
    names = [rf"\mathrm{{c{k}}}" for k in range(len(powers))]
    letters = [rf"\mathrm{{k{k}}}" for k, _ in enumerate(cofactor_monomials(at))]
    scene = one.system().scene.having(constants=(*names, *letters))
    at = _finder(one, scene)
    ring, value = at.ring, at.ring.zero
    for name, exponents in zip(names, powers, strict=True):
        term = ring.one if exponents == first else ring.generator(name)
        for variable, exponent in zip(at.setting.variables, exponents, strict=True):
            term = term * ring.generator(variable) ** exponent
        value = value + term
    found = [
        c.terms()[0] for _, c in DarbouxAnsatz(at, value, letters).equations() if not c.is_zero
    ]
    moving = [ring.polynomials.generators.index(name) for name in at.setting.variables]
    width = len(ring.polynomials.generators)
    kept = [k for k in range(width) if k not in moving]
    context = fmpq_mpoly_ctx.get([f"g{k}" for k in kept], Ordering.degrevlex)
    own = [{tuple(e[k] for k in kept): v for e, v in terms.items()} for terms in found]
    return [polynomial_of(context, terms) for terms in own], range(len(kept))


def _by_cases(one: Published) -> Callable[[], int]:
    equations, places = _equations(one)
    return lambda: len([*branches(equations, places)])


def _with_cofactors(one: Published) -> Callable[[], int]:
    equations, _ = _equations(one)
    return lambda: len(Basis(equations, ()).interreduce())


def _by_flint(one: Published) -> Callable[[], int]:
    equations, places = _equations(one)
    context = fmpz_mpoly_ctx.get([f"g{k}" for k in places], Ordering.degrevlex)
    whole = [
        context.from_dict({e: int(v) for e, v in primitive(terms_of(equation)).items()})
        for equation in equations
    ]
    return lambda: len([*fmpz_mpoly_vec(whole, context).buchberger_naive().autoreduction()])


def _by_sympy(one: Published) -> Callable[[], int]:
    equations, places = _equations(one)
    names = symbols([f"g{k}" for k in places])
    polynomials = [Poly(terms_of(equation), *names) for equation in equations]
    return lambda: len(groebner(polynomials, *names, order="grevlex").exprs)


def _by_singular(one: Published) -> Callable[[], int]:
    equations, places = _equations(one)
    names = ",".join(equations[0].context().names() if equations else (f"g{k}" for k in places))
    ideal = ",".join(map(str, equations))
    text = f"ring r=0,({names}),dp; ideal i={ideal}; option(redSB); size(std(i)); quit;"
    return partial(_number_by_singular, text)


POLYNOMIAL: dict[str, Prepared] = {
    "cases": _by_cases,
    "basis": _with_cofactors,
    "python-flint": _by_flint,
    "sympy": _by_sympy,
    "singular": _by_singular,
}


QUESTIONS = ((LEFT, "numbers", LINEAR), (LEFT, "symbols", SYMBOLIC), (RIGHT, "darboux", POLYNOMIAL))
"""What is asked of which systems, and by which methods: a panel each."""


# -- the chart -----------------------------------------------------------------------


def draw(rows: Sequence[Row]) -> Figure:
    """The share of systems that are finished, against time: integrals, and equations."""
    figure = new_figure(height=4.6)
    panels = figure.subplots(1, 3, sharey=True)
    panels[1].sharex(panels[0])
    for axes, (_, question, methods) in zip(panels, QUESTIONS, strict=True):
        here = [row for row in rows if row["case"].startswith(question)]
        for method in methods:
            own = [row for row in here if row["method"] == method]
            times = sorted(row["seconds"] for row in own if row["verdict"] == "finished")
            shares = [100 * k / len(own) for k, _ in zip(count(1), times, strict=False)]
            axes.plot(times, shares, label=display_name(method), **line_style(look(method)))
        axes.set(xscale="log", xlabel="time for a system", ylim=(0, 104))
        axes.xaxis.set_major_formatter(FuncFormatter(seconds))
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2))
    panels[0].set_title("integrals, constants\nare numbers", size=8.5)
    panels[1].set_title("integrals, constants\nare symbols", size=8.5)
    panels[2].set_title("$F'=KF$ for all values\nof constants", size=8.5)
    panels[0].set_ylabel("systems finished, %")
    return figure
