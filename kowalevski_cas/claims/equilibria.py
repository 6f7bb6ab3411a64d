r"""Equilibria: how many states of rest there are for given values of the integrals."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from kowalevski_cas.arithmetic.numbers import Substitution, number_ring
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, Neighbour, members, refuted, show_number
from kowalevski_cas.claims.real_roots import RealRoots
from kowalevski_cas.claims.rest import Rest
from kowalevski_cas.notation import to_latex
from kowalevski_cas.proof.outcome import Condition, Counterexample, Point, Step, Verdict
from kowalevski_cas.search.eliminants import Eliminant
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.texts import Printed, Texts
