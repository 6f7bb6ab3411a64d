"""What can be claimed about equations of motion, a method each."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any

from kowalevski_cas.paper.claims import (
    Casimir,
    Claim,
    DarbouxPolynomial,
    FirstIntegral,
    Identity,
    Implication,
    InvariantRelations,
    Involution,
    Jacobi,
    LiouvilleIntegrable,
)
from kowalevski_cas.system.answers import Function, Stated

Tex = Any
"""A formula: LaTeX, what was defined, or an expression of SymPy."""


class Claims(ABC):
    """The kinds of claims that are made of formulas alone; each takes the verdict to expect."""

    @abstractmethod
    def states(
        self,
        kind: type[Claim],
        name: str,
        says: str,
        expect: str = "",
        printed: Tex = "",
        **attributes: Any,
    ) -> Stated:
        """A claim of any kind."""

    @abstractmethod
    def _tex(self, formula: Tex) -> str:
        """A formula as LaTeX."""

    def _listed(self, formulas: Sequence[Tex]) -> str:
        return ", ".join(f"${self._tex(one)}$" for one in formulas)

    def identity(self, equation: Tex, expect: str = "") -> Stated:
        """Both sides are equal; derivatives are along the motion."""
        says = "both sides are the same function"
        return self.states(Identity, "identity", says, expect, equation)

    def implication(self, equation: Tex, given: Sequence[Tex], expect: str = "") -> Stated:
        """An equation holds wherever the given ones do."""
        says = "this holds wherever what is given does"
        return self.states(Implication, "implication", says, expect, equation, given=tuple(given))

    def integral(self, formula: Tex, given: Sequence[Tex] = (), expect: str = "") -> Stated:
        """A function is constant along every motion, perhaps on an invariant set only."""
        says = "this is constant along every motion"
        return self.states(FirstIntegral, "integral", says, expect, formula, given=tuple(given))

    def invariant(self, *relations: Tex, expect: str = "") -> Stated:
        """No motion leaves the set on which these hold; a function stands for its zeros."""
        zero = tuple(f"{self._tex(F)}=0" if isinstance(F, Function) else F for F in relations)
        says = f"no motion leaves the set where {self._listed(zero)}"
        return self.states(InvariantRelations, "invariant", says, expect, relations=zero)

    def darboux(self, formula: Tex, cofactor: Tex, expect: str = "") -> Stated:
        """A polynomial F with F' = KF, where K is the cofactor."""
        says = "its derivative is this multiple of it"
        return self.states(DarbouxPolynomial, "darboux", says, expect, formula, cofactor=cofactor)

    def lax(self, first: Function, second: Function, expect: str = "") -> Stated:
        """A Lax pair of matrices: L' = LM - ML."""
        L, M = self._tex(first), self._tex(second)
        says = "the equations of motion give this Lax equation"
        return self.states(Identity, "lax", says, expect, rf"\frac{{d}}{{dt}}{L}={L}{M}-{M}{L}")

    def jacobi(self, expect: str = "") -> Stated:
        """The Poisson bracket that was defined satisfies Jacobi's identity."""
        return self.states(Jacobi, "jacobi", "the bracket satisfies Jacobi's identity", expect)

    def casimir(self, formula: Tex, expect: str = "") -> Stated:
        """A function whose bracket with every function vanishes."""
        says = "its bracket with every function vanishes"
        return self.states(Casimir, "casimir", says, expect, formula)

    def involution(self, *functions: Tex, expect: str = "") -> Stated:
        """Functions whose brackets with each other vanish."""
        says = f"the brackets of {self._listed(functions)} with each other vanish"
        return self.states(Involution, "involution", says, expect, functions=functions)

    def integrable(self, *integrals: Tex, casimirs: Sequence[Tex] = (), expect: str = "") -> Stated:
        """Integrability in the sense of Liouville; the first integral is the Hamiltonian."""
        says = f"the motion is integrable in the sense of Liouville, by {self._listed(integrals)}"
        return self.states(
            LiouvilleIntegrable, "integrable", says, expect,
            integrals=integrals, casimirs=tuple(casimirs),
        )  # fmt: skip
