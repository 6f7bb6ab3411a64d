"""The hodographs of a motion on O⁴, the third critical subsystem."""

from __future__ import annotations

from dataclasses import replace

from matplotlib.figure import Figure

from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.pictures import hodographs
from kowalevski_cas.paper.closed_form import HyperellipticForm

ABOUT = HyperellipticForm

CAPTION = (
    "Hodographs of the angular velocity of a motion on $O^4$, in the body and in space, where the "
    "axes are those of the two fields; they have the length that is told."
)


def draw(motion: Motion | MotionO4) -> Figure:
    """Both hodographs of a motion on O⁴, or of one in the same fields."""
    return hodographs.draw(motion if isinstance(motion, MotionO4) else example(motion))


def example(motion: Motion) -> MotionO4:
    """A motion on O⁴ in the fields of one on N⁴: there is one with s = b/2, τ = −r²/2."""
    known = motion.parameters
    found = MotionO4.of(known.a, known.b, known.b / 2, -known.r_square / 2)
    return replace(found, turn=motion.turn)
