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
    alpha, beta = states[:, 3:6], states[:, 6:]
    normal = np.cross(alpha, beta)
    lengths = np.linalg.norm(alpha, axis=1) * np.linalg.norm(beta, axis=1)
    size = np.linalg.norm(normal, axis=1)
    if np.any(~(size > PARALLEL * lengths)):
        raise Inadmissible("the fields are parallel: they do not tell the turn about them")
    first = alpha / np.linalg.norm(alpha, axis=1)[:, None]
    third = normal / size[:, None]
    return np.stack([first, np.cross(third, first), third], axis=1)


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
