r"""Points modulo random primes: quick, certain when they refute, and with a bound when they do not.

A residual N/D that does not vanish identically has at most as many zeros as its
degree allows (J. T. Schwartz, 1980; R. Zippel, 1979): on the variety of the roots
and of the given equations, of degree at most :math:`\prod\max(2,\deg)` by Bézout,
a point chosen at random modulo p is one with probability at most
:math:`2\deg N\prod/p`. A prime that divides N altogether is met with
probability at most (bits of N)/61 over the number of primes. Primes lie between
:math:`2^{61}` and :math:`2^{62}` and are 1 modulo 4, so that -1 has a root.

With given equations the bound is that for each of their components through
which a point was found.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import islice
from random import Random

from flint import fmpz, nmod, nmod_mat

from kowalevski_cas.algebra.bounds import Sizes
from kowalevski_cas.algebra.points import Answer, NoPoint, Points, Question
from kowalevski_cas.algebra.programs import Program, Programs
from kowalevski_cas.algebra.residue_points import NoRoot, satisfy, valuation
from kowalevski_cas.algebra.valuation import Valuation

LOWEST = 2**61
PRIMES = 2
"""How many primes are taken."""

POINTS = 2
"""How many points are taken modulo each prime."""

TRIES = 200
"""How many random points are looked at, times two for each root, for one where all roots exist."""

LOG2_OF_PRIMES = 54.0
r"""There are more than 2^54 primes that are 1 modulo 4 between 2^61 and 2^62.

By P. Dusart's bounds there are 2^61/(62 ln 2)(1 ± 0.1) = 2^55.6 primes, nearly half of
them in each class modulo 4.
"""


class Arithmetic(Points):
    """Residues modulo primes, by FLINT's ``nmod``."""

    name = "modular"

    def answer(self, question: Question) -> Answer:
        """No at the first point that says so; yes, with the bound, if there is none."""
        random = Random(self.seed)
        try:
            for prime in primes(random, PRIMES):
                for _ in range(POINTS):
                    point = residue_point(question, prime, random)
                    found = _refutation(question, point, prime)
                    if found is not None:
                        return found
        except NoPoint as error:
            return Answer(None, str(error))
        bound = error_bound(question)
        words = f"{PRIMES * POINTS} points modulo {PRIMES} primes, seed {self.seed}"
        return Answer(True, words, bound=bound)


class SampledPrograms(Programs):
    """Programs of which points tell whether they vanish; they are the same in every run.

    The answer "no" is certain; the answer "yes" is wrong with the probability that
    :func:`bound_of` bounds. The points remember what was evaluated there, so that programs
    that share steps with earlier ones cost little.
    """

    def __init__(self, generators: Iterable[str]) -> None:
        super().__init__(generators)
        self._samples: list[Valuation] = []

    def vanishes(self, program: Program) -> bool:
        """Whether a program vanishes at random points modulo random primes."""
        return all(point(program) == 0 for point in self.samples)

    @property
    def samples(self) -> Sequence[Valuation]:
        """Random points modulo random primes; raises :class:`NoPoint` if there is none."""
        if not self._samples:
            random = Random(0)
            numbers = [square.number for square in self.radicands if square.number is not None]
            with_roots = (p for p in primes(random, TRIES) if all(_has_root(n, p) for n in numbers))
            for prime in islice(with_roots, PRIMES):
                # Programs that are asked later may need any of the roots.
                roots = [self.generator(name) for name in self.roots]
                self._samples.append(residue_point(Question(self, roots), prime, random))
        if not self._samples:
            raise NoPoint(f"the printed roots of numbers exist modulo none of {TRIES} primes")
        return self._samples


def _has_root(number: Fraction, prime: int) -> bool:
    """Whether a rational number has a square root modulo a prime."""
    return fmpz(number.numerator * number.denominator).jacobi(prime) >= 0


def primes(random: Random, number: int) -> Iterator[int]:
    """Random primes between 2^61 and 2^62 that are 1 modulo 4."""
    while number:
        candidate = LOWEST + 4 * random.randrange(LOWEST // 4) + 1
        if fmpz(candidate).is_prime():
            number -= 1
            yield candidate


def residue_point(question: Question, prime: int, random: Random) -> Valuation:
    """A random point modulo a prime at which what is asked is defined and what is given holds.

    Raises :class:`NoPoint` if none is found.
    """
    ring = question.ring
    tries = TRIES << len(ring.roots)
    for _ in range(tries):
        values = {name: nmod(random.randrange(1, prime), prime) for name in ring.generators}
        signs = {name: random.choice((1, -1)) for name in ring.roots}
        try:
            if question.given:
                values = satisfy(question.given, values, signs, prime, random)
            point = valuation(values, signs, prime)
            if any(point(equation) != 0 for equation in question.given):
                continue
            for program in question.programs():
                point(program)
            return point
        except (ZeroDivisionError, NoRoot):
            continue
    raise NoPoint(f"no point was found modulo {prime} in {tries} tries")


def error_bound(question: Question) -> float:
    """The bound on the chance that all points agree with a false statement."""
    sizes = Sizes()
    programs = question.programs()
    bezout = 1
    for program in (*question.ring.radicands, *question.given):
        bezout *= max(2, sizes(program).degree)
    largest = max((sizes(program) for program in programs), key=lambda s: s.degree)
    degree = largest.degree * max(1, question.rank)
    bits = max(sizes(program).bits for program in programs) * max(1, question.rank)
    at_a_point = min(1.0, 2 * degree * bezout / LOWEST)
    bad_prime = min(1.0, bezout * (bits + 1) / 61 / 2**LOG2_OF_PRIMES)
    return float(min(1.0, bad_prime + at_a_point**POINTS) ** PRIMES)


def _refutation(question: Question, point: Valuation, prime: int) -> Answer | None:
    if question.somewhere and all(point(program) == 0 for program in question.somewhere):
        return _no(question, point, prime, "0", r"\ne 0", "it vanishes there, and everywhere")
    for program in question.residuals:
        if (value := point(program)) != 0:
            return _no(question, point, prime, str(int(value)), "0", "left minus right side")
    if question.rows:
        entries = [int(point(entry)) for row in question.rows for entry in row]
        found = nmod_mat(len(question.rows), len(question.rows[0]), entries, prime).rank()
        if found != question.rank:
            left, right = str(found), str(question.rank)
            return _no(question, point, prime, left, right, "the rank there, and the one claimed")
    return None


def _no(
    question: Question, point: Valuation, prime: int, left: str, right: str, words: str
) -> Answer:
    found = point.coordinates(question.ring)
    values = {name: str(int(value)) for name, value in found.items()}
    return Answer(False, f"{words}, modulo {prime}", point=values, left=left, right=right)
