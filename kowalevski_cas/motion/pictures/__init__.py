"""Pictures of a motion, one module each: ``draw(motion)`` is the figure, ``CAPTION`` explains it.

Motions that are known by a state alone have a picture that integrates them; see :data:`OF_ANY`.

``ABOUT`` is the offer of the derivation whose report shows it, if not the closed form on N⁴.

A new picture is one new module and one line in :data:`PICTURES`.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, NamedTuple

from kowalevski_cas.paper.closed_form import ClosedForm

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PICTURES = {
    "hodographs": "of the angular velocity, in the body and in space",
    "traces": "of the field vectors on their spheres in the body",
    "torus": "which one trajectory fills",
    "poincare": "section, with other motions on the same level; of any motion",
    "rectangle": "of the separated variables, and the curve in it",
    "bifurcation": "diagrams in the planes of (m, h) and (m, ℓ)",
    "atlas": "of all regimes in these fields",
    "resonances": "maps of the rotation number over the diagrams of N⁴ and O⁴",
    "subsystems": "diagrams of O⁴ and M⁴",
    "sections": "of the diagram of the whole top, with the tori in its chambers",
    "surfaces": "of critical values, that diagram in space",
    "third": "subsystem: hodographs of a motion on O⁴",
}

ON_N4 = ("torus", "rectangle", "bifurcation", "atlas")
"""What is drawn for motions on N⁴ alone."""

OF_ANY = ("poincare",)
"""What is drawn for any motion, also where there is no closed form."""

OF_FIELDS = ("atlas", "resonances", "subsystems", "sections", "surfaces", "third")
"""What looks alike for all motions in the same fields."""


class Picture(NamedTuple):
    """How a picture is drawn, what it shows, and which offer of a derivation it is about.

    The caption is text with mathematics between dollars.
    """

    draw: Callable[..., Figure]
    caption: str
    about: type


def load(name: str) -> Picture:
    """The picture with this name."""
    if name not in PICTURES:
        raise ValueError(f"there is no picture “{name}”; there are {', '.join(PICTURES)}")
    module = import_module(f"{__name__}.{name}")
    return Picture(module.draw, module.CAPTION, getattr(module, "ABOUT", ClosedForm))
