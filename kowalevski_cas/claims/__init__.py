"""The kinds of claims, one file each."""

from kowalevski_cas.claims.change import ChangedEquation, InvertibleChange, Unit
from kowalevski_cas.claims.claim import Claim, Finding, Neighbour
from kowalevski_cas.claims.coefficient import Coefficient
from kowalevski_cas.claims.constant_root import ConstantRoot
from kowalevski_cas.claims.critical_set import CriticalSet
from kowalevski_cas.claims.definition import Definition
from kowalevski_cas.claims.degree import Degree
from kowalevski_cas.claims.dimension import Dimension, Independence
from kowalevski_cas.claims.double_zero import DoubleZero
from kowalevski_cas.claims.equilibria import Equilibria
from kowalevski_cas.claims.equivalence import Equivalence
from kowalevski_cas.claims.exponents import SolvedExponents
from kowalevski_cas.claims.first_integral import FirstIntegral
from kowalevski_cas.claims.identity import Identity
from kowalevski_cas.claims.implication import Implication
from kowalevski_cas.claims.invariant_relations import InvariantRelations
from kowalevski_cas.claims.limit import Limit
from kowalevski_cas.claims.measure import LastMultiplier
from kowalevski_cas.claims.reality import Reality
from kowalevski_cas.claims.scaling import Scaling

__all__ = [
    "ChangedEquation",
    "Claim",
    "Coefficient",
    "ConstantRoot",
    "CriticalSet",
    "Definition",
    "Degree",
    "Dimension",
    "DoubleZero",
    "Equilibria",
    "Equivalence",
    "Finding",
    "FirstIntegral",
    "Identity",
    "Implication",
    "Independence",
    "InvariantRelations",
    "InvertibleChange",
    "LastMultiplier",
    "Limit",
    "Neighbour",
    "Reality",
    "Scaling",
    "SolvedExponents",
    "Unit",
]
