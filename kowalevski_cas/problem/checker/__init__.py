"""Check certificates (docs/certificate.md), with nothing but Python's standard library.

A certificate states a problem, spaces and goals, and gives evidence. Everything in it but the
problem was found by a search that is not trusted: here it is all computed again, by exact
polynomials over the integers. What is not understood is rejected.

To be read in this order, and each file knows those before it only:

* ``reading``: the shapes of JSON that a certificate may have, and the bounds of it all;
* ``polynomials``: over the rational numbers, with generators that are roots of others;
* ``division``: by what is known not to vanish;
* ``formulas``: what formulas mean; derivatives, conjugates;
* ``spaces``: names with definitions, a vector field or a change of variables;
* ``evidence``: real points, combinations, sums of squares, proofs by cases;
* ``goals``, ``along``, ``counts``, ``kernels``: what is stated, what shows it, what denies it;
* ``problem``: spaces and goals, what exists, and the words for what is proved;
* ``certificate``, and ``command`` for the command line, which ``__main__`` runs.

The folder is a program: ``python -I -S FOLDER FILE...`` runs it, wherever it has been copied to.
"""

from .certificate import Certificate, check
from .division import quotient
from .evidence import locate
from .formulas import Map, Rates, Value
from .polynomials import Element, Ring
from .problem import KINDS, Problem, Theorem, sentence
from .reading import (
    BITS,
    DEGREE,
    FORMAT,
    NAMES,
    SIZE,
    VERSION,
    WORK,
    Block,
    Budget,
    Exhausted,
    Json,
    Rejected,
    Spend,
    need,
    printable,
)
from .spaces import Space

__all__ = [
    "BITS", "DEGREE", "FORMAT", "KINDS", "NAMES", "SIZE", "VERSION", "WORK",
    "Block", "Budget", "Certificate", "Element", "Exhausted", "Json", "Map", "Problem", "Rates",
    "Rejected", "Ring", "Space", "Spend", "Theorem", "Value", "check", "locate", "need",
    "printable", "quotient", "sentence",
]  # fmt: skip
