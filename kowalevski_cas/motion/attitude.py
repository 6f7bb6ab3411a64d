"""The body in space: by the two fields, which are fixed there and known in the body."""

from __future__ import annotations

import numpy as np

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.parameters import Inadmissible

PARALLEL = 1e-8
"""The sine of the angle between fields that leave the turn about them untold."""


def frames(states: Array) -> Array:
    """The axes of space by those of the body, a row an axis, at states (N, 9): (N, 3, 3).

    The first axis has the direction of α, the third one that of α × β. Raises
    :class:`~kowalevski_cas.motion.parameters.Inadmissible` for parallel fields.
    """
    alpha, beta = _directions(states[:, 3:6]), _directions(states[:, 6:])
    normal = np.cross(alpha, beta)
    if np.any(~(np.linalg.norm(normal, axis=1) > PARALLEL)):
        raise Inadmissible("the fields are parallel: they do not tell the turn about them")
    third = _directions(normal)
    return np.stack([alpha, np.cross(third, alpha), third], axis=1)


def _directions(vectors: Array) -> Array:
    """The vectors (N, 3) by their lengths, of any size; zero where there is none."""
    largest = np.max(np.abs(vectors), axis=1, keepdims=True)
    scaled = vectors / np.where(largest > 0, largest, 1.0)
    lengths = np.linalg.norm(scaled, axis=1, keepdims=True)
    found: Array = scaled / np.where(lengths > 0, lengths, 1.0)
    return found


def quaternions(states: Array) -> Array:
    """Unit quaternions (N, 4), the real part first, that turn the body's axes into those of space.

    A vector v of the body is q v q⁻¹ in space. Of both signs that is taken which continues the
    quaternion before, and at first that with a positive real part. Raises ``Inadmissible`` for
    parallel fields.

    >>> states = np.array([[0.0, 0, 0, 1, 0, 0, 0, 2, 0], [0, 0, 0, 0, 1, 0, -1, 0, 0]])
    >>> quaternions(states).round(3)
    array([[ 1.   ,  0.   ,  0.   ,  0.   ],
           [ 0.707,  0.   ,  0.   , -0.707]])
    """
    from scipy.spatial.transform import Rotation

    found: Array = Rotation.from_matrix(frames(states)).as_quat(scalar_first=True)
    found /= np.linalg.norm(found, axis=1)[:, None]
    turned = np.sum(found[1:] * found[:-1], axis=1) < 0
    signs = np.cumprod(np.where(np.append(found[0, 0] < 0, turned), -1.0, 1.0))
    continued: Array = found * signs[:, None] + 0.0
    return continued
