"""A motion as NumPy arrays: t (N), omega, alpha, beta (N, 3), radius (N); the rest as JSON."""

from __future__ import annotations

import io
import json

import numpy as np

from kowalevski_cas.motion.result import Result


def render(result: Result) -> bytes:
    """The contents of the file, for ``numpy.load``."""
    states = result.states
    arrays = {"t": result.times}
    arrays.update(omega=states[:, :3], alpha=states[:, 3:6], beta=states[:, 6:])
    if result.radii is not None:
        arrays["radius"] = result.radii
    told = {
        name: np.array(json.dumps(getattr(result, name)))
        for name in ("invariants", "critical_sets", "regime")
    }
    file = io.BytesIO()
    np.savez(file, allow_pickle=True, **arrays, **told)
    return file.getvalue()
