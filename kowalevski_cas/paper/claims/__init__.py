"""The kinds of claims, one file each: the attributes of a statement, and its goals."""

from kowalevski_cas.paper.claims.all_integrals import AllDarboux, AllIntegrals
from kowalevski_cas.paper.claims.all_invariants import AllInvariantsOfMap
from kowalevski_cas.paper.claims.change import ChangedEquation, InvertibleChange, Unit
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.claims.coefficient import Coefficient
from kowalevski_cas.paper.claims.constant_root import ConstantRoot
from kowalevski_cas.paper.claims.critical_set import CriticalSet
from kowalevski_cas.paper.claims.darboux import DarbouxPolynomial
from kowalevski_cas.paper.claims.definition import Definition
from kowalevski_cas.paper.claims.degree import Degree
from kowalevski_cas.paper.claims.dimension import Dimension, Independence
from kowalevski_cas.paper.claims.double_zero import DoubleZero
from kowalevski_cas.paper.claims.equilibria import Equilibria, RestPoints
from kowalevski_cas.paper.claims.equivalence import Equivalence
from kowalevski_cas.paper.claims.everywhere import EverywhereIndependent
from kowalevski_cas.paper.claims.exponents import SolvedExponents
from kowalevski_cas.paper.claims.first_integral import FirstIntegral
from kowalevski_cas.paper.claims.identity import Identity
from kowalevski_cas.paper.claims.implication import Implication
from kowalevski_cas.paper.claims.inequality import Inequality
from kowalevski_cas.paper.claims.invariant_relations import InvariantRelations
from kowalevski_cas.paper.claims.lax_pair import LaxPair
from kowalevski_cas.paper.claims.limit import Limit
from kowalevski_cas.paper.claims.local_dimension import LocalDimension
from kowalevski_cas.paper.claims.maps import (
    IntegrableMap,
    InvariantOfMap,
    InvariantSetOfMap,
    MeasureOfMap,
    OfMap,
    PoissonMap,
)
from kowalevski_cas.paper.claims.measure import LastMultiplier
from kowalevski_cas.paper.claims.poisson import Casimir, Involution, Jacobi, LiouvilleIntegrable
from kowalevski_cas.paper.claims.reality import Reality
from kowalevski_cas.paper.claims.scaling import Scaling
from kowalevski_cas.paper.claims.solutions import EqualSolutions
from kowalevski_cas.paper.claims.union import Union
