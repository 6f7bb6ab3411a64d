"""A page to touch: the body as it moves on N⁴, by constants that are chosen on the diagram."""

from __future__ import annotations

import json
from base64 import b64encode
from importlib.resources import files
from typing import Any

import numpy as np

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.attitude import quaternions
from kowalevski_cas.motion.methods.closed import states
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.parameters import Inadmissible
from kowalevski_cas.motion.pictures.orbit import in_space
from kowalevski_cas.motion.plane import regime_at
from kowalevski_cas.motion.regimes import all_regimes
from kowalevski_cas.motion.transverse import kind

GRID, ACROSS, UP = 96, 17, 9
"""Points of the shaded diagram along each axis, and of the motions along each of them."""

COUNT, STEP = 400, 0.08
"""How many states of a motion the page has, and how far apart, for a field of the length 1."""


def page(motion: Motion) -> str:
    """The page, whole, for the fields of a motion, which is the first that is shown.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` for a single field.
    """
    known = motion.parameters
    a, b, m, ell = (float(x) for x in (known.a, known.b, known.m, known.ell))
    reach = round(1.25 * max(1 / a, abs(m)), 2)
    top = round(1.25 * max(2 * a * reach, abs(ell)), 2)
    found = [_entry(motion, abs(ell))]
    for column in np.linspace(-reach, reach, ACROSS + 2)[1:-1]:
        for row in np.linspace(0, top, UP + 2)[1:-1]:
            try:
                entry = Motion.of(known.a, known.b, round(column, 3), ell=round(row, 3))
                found.append(_entry(entry, round(row, 3)))
            except Inadmissible:
                continue
    found.sort(key=lambda entry: (entry["m"], entry["ell"]))
    start = min(
        range(len(found)), key=lambda k: abs(found[k]["m"] - m) + abs(found[k]["ell"] - abs(ell))
    )
    data = {
        "a": round(a, 6), "b": round(b, 6), "m": [-reach, reach], "ell": [0, top],
        "grid": _regions(motion, reach, top), "step": STEP / a**0.5, "count": COUNT,
        "start": start, "motions": found,
    }  # fmt: skip
    template = files(__package__).joinpath("page.html").read_text(encoding="utf-8")
    return template.replace("/*DATA*/null", json.dumps(data, ensure_ascii=False))


def _entry(motion: Motion, ell: float) -> dict[str, Any]:
    """A motion as the page has it: its constants, quaternions, and angular velocity in the body."""
    step = STEP / float(motion.parameters.a) ** 0.5
    followed = states(motion, step * np.arange(COUNT))
    omega = followed[:, :3]
    fastest = float(np.max(np.linalg.norm(in_space(followed), axis=1)))
    tori = motion.regime.tori
    return {
        "m": round(float(motion.parameters.m), 6),
        "ell": round(ell, 6),
        "h": round(float(motion.parameters.h), 4),
        "tori": "one torus" if tori == 1 else f"one of {tori} tori",
        "type": kind(motion.parameters),
        "fastest": fastest,
        "q": _shorts(quaternions(followed)),
        "omega": _shorts(omega / fastest),
    }


def _shorts(values: Array) -> str:
    """Numbers from −1 to 1 as whole numbers of two bytes, in base 64."""
    return b64encode(np.rint(32767 * values).astype("<i2").tobytes()).decode()


def _regions(motion: Motion, reach: float, top: float) -> list[str]:
    """The number of tori on a grid, a string a row, from ℓ = 0 upwards."""
    shares = (np.arange(GRID) + 0.5) / GRID
    m, ell = np.meshgrid((2 * shares - 1) * reach, shares * top)
    tori = np.array([*(regime.tori for regime in all_regimes()), 0])
    return ["".join(map(str, row)) for row in tori[regime_at(motion.parameters, m, ell)].tolist()]
