"""A motion as a table with a header: the time and the nine variables."""

from __future__ import annotations

from kowalevski_cas.motion.result import Result

COLUMNS = [f"{name}{k}" for name in ("omega", "alpha", "beta") for k in (1, 2, 3)]


def render(result: Result) -> bytes:
    """A line a state, in digits that give back the same floats."""
    rows = zip(result.times.tolist(), result.states.tolist(), strict=True)
    lines = [",".join(map(repr, (t, *row))) for t, row in rows]
    return "\n".join([",".join(["t", *COLUMNS]), *lines, ""]).encode()
