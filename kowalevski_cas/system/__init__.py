"""Systems of one's own, as derivations that nobody has printed."""

from kowalevski_cas.system.answers import Function, SystemClaim
from kowalevski_cas.system.source import display
from kowalevski_cas.system.system import System
