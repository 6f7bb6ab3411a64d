r"""Equations of motion of one's own: what is claimed and asked about them, in Python or in a file.

>>> lorenz = System(r"\dot x=\sigma(y-x),\quad \dot y=\rho x-y-xz,\quad \dot z=xy-bz")
>>> lorenz
x, y, z move; σ, ρ, b are constant
>>> F = lorenz.define(r"F=x^2-2\sigma z")
>>> lorenz.where(r"b=2\sigma").darboux(F, cofactor=r"-2\sigma").verdict
<Verdict.PROVED: 'proved'>

A system builds the scenes and the claims that the derivations of papers write out, and is run like
them: ``kowalevski-cas verify lorenz.py``.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from copy import copy
from dataclasses import replace
from typing import Any, Self

from kowalevski_cas.paper.claims import (
    Casimir,
    DarbouxPolynomial,
    FirstIntegral,
    Identity,
    Implication,
    Inequality,
    IntegrableMap,
    InvariantRelations,
    Involution,
    Jacobi,
    LaxPair,
    LiouvilleIntegrable,
    MeasureOfMap,
    PoissonMap,
    Union,
)
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.pool import HERE
from kowalevski_cas.processes import each
from kowalevski_cas.questions import collect, forecast, question
from kowalevski_cas.system.answers import ClaimInParts, Function, SystemClaim, SystemClaims
from kowalevski_cas.system.cases import EquationOfCase, cases_of, opposite, parts
from kowalevski_cas.system.field import Field, Tex, Texs, listed
from kowalevski_cas.system.kinds import several
from kowalevski_cas.verify.finding import Finding


class System(Field):
    r"""Equations of motion: what has a derivative moves, and all other names are constant.

    They may be of higher order, and define names in passing: :math:`\dot q=\partial H/\partial p`,
    :math:`\dot p=-\partial H/\partial q`, :math:`H=\frac12p^2+q^4`.

    Args:
        field: a display of equations with derivatives, or the right sides by variables of SymPy.
        name: what the claims of a file with several systems are called after.
        vectors: the components of the names in bold type, where the display does not name them,
            as :math:`\mathbf r=(x,y,z)`, and neither has vector products nor :math:`r_1,r_2`.
        map: whether primes are images, as in :math:`x'=y`, and no rates. It is a map anyway
            with :math:`x_{n+1}=\ldots`.

    Raises:
        NotationError: an equation cannot be read.
        ValueError: they are no equations of motion; the message says why.
    """

    pool = HERE
    """Where searches are done: ``Pool(jobs=4)`` for four processes."""

    # -- claims; each takes the verdict to expect -------------------------------------

    def identity(self, equation: Tex, expect: str = "") -> SystemClaim:
        r"""Both sides are equal; derivatives are along the motion.

        With :math:`\pm` on one side they are for one of the signs, at each point; else for both.
        By cases each is claimed where its inequality holds, and that together they cover all.
        """
        if cases := cases_of(equation):
            return self._by_cases(cases, (), expect)
        if either := self._alternatives(equation):
            return self._either(either, (), expect)
        says = "both sides are the same function"
        return self.states(Identity, "identity", says, expect, equation)

    def implication(self, equation: Tex, given: Texs, expect: str = "") -> SystemClaim:
        r"""An equation holds wherever the given ones do; with :math:`\pm` as in an identity."""
        given = several(given)
        if cases := cases_of(equation):
            return self._by_cases(cases, given, expect)
        if either := self._alternatives(equation):
            return self._either(either, given, expect)
        says = f"this holds wherever {self._list(given)}"
        return self.states(Implication, "implication", says, expect, equation, given=given)

    def inequality(self, chain: Tex, given: Texs = (), expect: str = "") -> SystemClaim:
        r"""A chain as ``0<k\le1`` is true at all real points, or at those of an invariant set."""
        given = several(given)
        where = f" where {self._list(given)}" if given else ""
        says = f"this is so at all real points{where}"
        return self.states(Inequality, "inequality", says, expect, chain, given=given)

    def integral(self, formula: Tex, given: Texs = (), expect: str = "") -> SystemClaim:
        """A function is constant along every motion, perhaps on an invariant set only."""
        given = several(given)
        where = f" on the set where {self._list(given)}" if given else ""
        says = f"this is constant along every motion{where}"
        return self.states(FirstIntegral, "integral", says, expect, formula, given=given)

    def invariant(self, *relations: Tex, expect: str = "") -> SystemClaim:
        """No motion leaves the set on which these hold; a function stands for its zeros."""
        each = (one for F in relations for one in listed(F))
        zero = tuple(f"{self._tex(F)}=0" if isinstance(F, Function) else F for F in each)
        says = f"no motion leaves the set where {self._list(zero)}"
        return self.states(InvariantRelations, "invariant", says, expect, relations=zero)

    def darboux(self, formula: Tex, cofactor: Tex, expect: str = "") -> SystemClaim:
        """A polynomial F with F' = KF, where K is the cofactor."""
        K = self._tex(cofactor)
        says = f"it is a Darboux polynomial with the cofactor ${K}$"
        return self.states(DarbouxPolynomial, "darboux", says, expect, formula, cofactor=K)

    def lax(self, first: Function, second: Function, expect: str = "") -> SystemClaim:
        """A Lax pair of matrices: L' = LM - ML, where L has invariants that are not constant."""
        L, M = self._tex(first), self._tex(second)
        says = "the equations of motion give this Lax equation"
        equation = rf"\frac{{d}}{{dt}}{L}={L}{M}-{M}{L}"
        return self.states(LaxPair, "lax", says, expect, equation, matrix=first)

    def jacobi(self, expect: str = "") -> SystemClaim:
        """The Poisson bracket that was defined satisfies Jacobi's identity."""
        return self.states(Jacobi, "jacobi", "the bracket satisfies Jacobi's identity", expect)

    def casimir(self, formula: Tex, expect: str = "") -> SystemClaim:
        """A function whose bracket with every function vanishes."""
        says = "its bracket with every function vanishes"
        return self.states(Casimir, "casimir", says, expect, formula)

    def involution(self, *functions: Tex, expect: str = "") -> SystemClaim:
        """Functions whose brackets with each other vanish."""
        says = f"the brackets of {self._list(functions)} with each other vanish"
        return self.states(Involution, "involution", says, expect, functions=functions)

    def integrable(self, *integrals: Tex, casimirs: Texs = (), expect: str = "") -> SystemClaim:
        """Integrability in the sense of Liouville; the first integral is the Hamiltonian."""
        if self.law.images:
            says = f"the map is integrable in the sense of Liouville, by {self._list(integrals)}"
            kind, own = IntegrableMap, {"invariants": integrals, "casimirs": several(casimirs)}
            return self.states(kind, "integrable", says, expect, **own)
        says = f"the motion is integrable in the sense of Liouville, by {self._list(integrals)}"
        return self.states(
            LiouvilleIntegrable, "integrable", says, expect,
            integrals=integrals, casimirs=several(casimirs),
        )  # fmt: skip

    def measure(self, density: Tex = "1", expect: str = "") -> SystemClaim:
        """A map preserves the measure with this density, up to the orientation."""
        says = f"the map preserves the measure with the density ${self._tex(density)}$"
        return self.states(MeasureOfMap, "measure", says, expect, density)

    def symplectic(self, expect: str = "") -> SystemClaim:
        """A map preserves the Poisson bracket, the canonical one if none is printed."""
        return self.states(PoissonMap, "symplectic", "the map preserves the bracket", expect)

    def _by_cases(
        self, cases: tuple[EquationOfCase, ...], given: tuple[Tex, ...], expect: str
    ) -> SystemClaim:
        """Each equation where its inequality holds; and the last one does where no other does."""
        claims, left = [], [copy(self)]
        for equation, condition in cases:
            for case in [self.supposing(condition)] if condition else left:
                claims.append(
                    case.implication(equation, given, expect)
                    if given
                    else case.identity(equation, expect)
                )
            if (equation, condition) == cases[-1] and condition:
                claims += [one.inequality(condition, given, expect) for one in left]
            elif condition:
                left = [rest for one in left for rest in one._without(condition)]
        return ClaimInParts(tuple(claims))

    def _without(self, condition: str) -> Iterator[Self]:
        """The system where a chain of inequalities does not hold, by the first that does not."""
        here = self
        for inequality in parts(condition):
            if not here._aside().inequality(inequality).verdict.green:
                yield here.supposing(opposite(inequality))
            here = here.supposing(inequality)

    def _either(
        self, equations: tuple[str, ...], given: tuple[Tex, ...], expect: str
    ) -> SystemClaim:
        """At each point one of some equations holds."""
        where = f" where {self._list(given)}" if given else ""
        says = f"at each real point{where} one of these holds: {self._list(equations)}"
        sets = tuple((equation,) for equation in equations)
        return self.states(Union, "either", says, expect, given=given, sets=sets)

    def _list(self, formulas: Sequence[Tex]) -> str:
        return ", ".join(f"${self._tex(formula)}$" for formula in formulas)

    # -- questions ---------------------------------------------------------------

    def find_integrals(self, degree: int, weighted: bool = False, on: Texs = ()) -> SystemClaims:
        """The polynomial first integrals up to a degree, and that there are no others.

        If it is ``weighted``, variables count by weights for which the motion is homogeneous. If
        there are equations ``on`` which the motion is looked at, those on that invariant set.
        Of a map they are the polynomials that have the same values at the images.
        """
        if self.law.images and not (weighted or on):
            return self._claims_found("invariants", degree=degree, images=self.law.images)
        given = tuple(map(self._tex, several(on)))
        return self._claims_found("integrals", degree=degree, weighted=weighted, on=given)

    def find_darboux(self, degree: int, special: bool = False, cofactor: Tex = "") -> SystemClaims:
        """The Darboux polynomials up to a degree, perhaps for ``special`` constants too.

        Those for one ``cofactor`` only, if it is given, and that there are no others.
        """
        K = self._tex(cofactor)
        return self._claims_found("darboux", degree=degree, special=special, cofactor=K)

    def find_closure(self, seed: Tex, order: int = 4) -> SystemClaims:
        """Invariant sets from a function and its derivatives, up to an order."""
        return self._claims_found("closure", seed=self._tex(seed), order=order)

    def conditions(self, polynomial: Tex) -> SystemClaims:
        """For which constants a polynomial divides its derivative: all cases, with cofactors."""
        return self._claims_found("parameters", polynomial=self._tex(polynomial))

    def find_exponents(self) -> SystemClaims:
        """The weights, the balances of the leading terms, and the Kowalevski exponents of each."""
        return self._claims_found("exponents")

    def _claims_found(self, name: str, **options: Any) -> SystemClaims:
        """What the command ``find`` finds, as claims like any other.

        What is found in time is claimed; if something may be left, that is said.
        """
        if self.parts:
            raise ValueError(f"find {name} is asked of one case, or of one sign: print it alone")
        if (self.law.images and name != "invariants") or self.law.conventions.functions:
            of = "maps" if self.law.images else "a motion with functions that may be any"
            raise ValueError(f"find {name} is not known of {of}")
        for key in ("degree", "order"):
            value = options.get(key, 0)
            if not isinstance(value, int) or value < 0:
                raise ValueError(f"{key}={value!r}: a natural number is expected")
        if not self.law.images:
            forecast(self.scene, name, options.get("degree", 0))
        on = Elaborations(Texts(vocabulary((self.scene,))))

        def answer(scene: Scene) -> tuple[Scene, list[Finding], str]:
            search = question(name).search(on, scene, self.pool, **options)
            return scene, *collect(search, self.seconds)

        ((scene, findings, unfinished),) = each(answer, [self.scene])
        if unfinished:
            print(f"find {name}: {unfinished}", file=sys.stderr)
        here = (
            replace(finding, on=self.scene) if finding.on is scene else finding
            for finding in findings
        )
        return SystemClaims(self._state(self.numbering.id(name, ""), finding) for finding in here)
