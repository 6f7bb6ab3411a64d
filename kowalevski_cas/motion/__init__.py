r"""Motions of the top: on N⁴ and O⁴ separated and solved, and followed by any of several methods.

>>> from kowalevski_cas.motion import Motion, load, through
>>> motion = Motion.of(a=1, b="0.4", m="0.8", ell="0.9")
>>> str(motion.regime), motion.regime.tori
('m > 0, -a < -b < C < b < a < A', 1)

A method takes a motion and an array of times and returns the states (ω, α, β), one a row:

>>> import numpy as np
>>> states = load("closed")(motion, np.array([0.0, 1e6]))
>>> states.shape
(2, 9)

Through a state that has no closed form goes a general motion, for the integrators:

>>> through([0.1, 0.2, 0.3, 1, 0, 0, 0, 0.4, 0]).why.partition(";")[0]
'the state is not on N⁴: the left side of (16), equation 1, is 0.172 of its size'
"""

from kowalevski_cas.motion.frequencies import Frequencies, frequencies
from kowalevski_cas.motion.general import General, through
from kowalevski_cas.motion.methods import METHODS, load
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.parameters import Inadmissible, MethodError, Parameters
from kowalevski_cas.motion.regimes import Regime, all_regimes, coincidences, regime_of
