r"""Critical sets: where all derivatives of a function along a level surface vanish."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations, combinations_with_replacement, islice

from kowalevski_cas.arithmetic.derivation import gradient
from kowalevski_cas.arithmetic.numbers import rational
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.cases import System, granted_used
from kowalevski_cas.claims.claim import (
    AtPoint,
    Claim,
    Finding,
    Neighbour,
    conditions_of,
    counterexample,
    equation,
    green,
    refuted,
    show,
    show_number,
)
from kowalevski_cas.claims.membership import combination
from kowalevski_cas.proof.outcome import Condition, Counterexample, Step, Verdict
from kowalevski_cas.search.cases import Case
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.texts import Printed, Texts
