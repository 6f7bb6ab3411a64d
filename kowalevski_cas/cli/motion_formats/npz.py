"""A motion as NumPy arrays: t (N), omega, alpha, beta (N, 3); invariants and regime as JSON."""

from __future__ import annotations

import io
import json

import numpy as np

from kowalevski_cas.motion.result import Result


def render(result: Result) -> bytes:
    """The contents of the file, for ``numpy.load``."""
    file = io.BytesIO()
    np.savez(
        file,
        t=result.times,
        omega=result.states[:, :3],
        alpha=result.states[:, 3:6],
        beta=result.states[:, 6:],
        invariants=np.array(json.dumps(result.invariants)),
        regime=np.array(json.dumps(result.regime)),
    )
    return file.getvalue()
