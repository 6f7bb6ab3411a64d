r"""LaTeX to formula to LaTeX: a derivation as its author printed it.

>>> words = Vocabulary(frozenset({"x_1", "x_2"}))
>>> to_latex(read(r"x'_1 = {\frac 1 {x_2}}", words))
"x_1' = \\frac{1}{x_2}"
"""

from kowalevski_cas.notation.defined_names import DefinedNames, defined_names
from kowalevski_cas.notation.edits import Edit, edits, is_small_change, replace, substitute, subtree
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import (
    EQUALITIES,
    Application,
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
    equal,
    once,
    power,
    times,
    total,
)
from kowalevski_cas.notation.latex import to_latex
from kowalevski_cas.notation.layout import split_display
from kowalevski_cas.notation.plain import to_plain
from kowalevski_cas.notation.prose import Prose, print_prose, read_prose
from kowalevski_cas.notation.reader import PrintedStatement, read, read_display, read_statement
from kowalevski_cas.notation.values import rank
from kowalevski_cas.notation.vocabulary import Vocabulary
