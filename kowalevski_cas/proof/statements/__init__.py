"""What each kind of claim states, in the parts of a certificate: one function a kind.

Where a claim rests on an argument in words as well, the words are noted.
"""

from kowalevski_cas.proof.statements import (
    combinations,
    critical_set,
    equalities,
    equilibria,
    ranks,
    scaling,
)
from kowalevski_cas.proof.statements.kinds import deny, state

__all__ = [
    "combinations",
    "critical_set",
    "deny",
    "equalities",
    "equilibria",
    "ranks",
    "scaling",
    "state",
]
