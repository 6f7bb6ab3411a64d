"""A motion as a table with a header: the time, the nine variables, and the radius of a ball."""

from __future__ import annotations

from kowalevski_cas.motion.result import Result

COLUMNS = [f"{name}{k}" for name in ("omega", "alpha", "beta") for k in (1, 2, 3)]


def render(result: Result) -> bytes:
    """A line a state, in digits that give back the same floats."""
    radii = [[]] * len(result.times) if result.radii is None else result.radii[:, None].tolist()
    rows = zip(result.times.tolist(), result.rows, radii, strict=True)
    lines = [",".join(map(repr, (t, *row, *radius))) for t, row, radius in rows]
    header = ["t", *COLUMNS, *["radius"] * (result.radii is not None)]
    return "\n".join([",".join(header), *lines, ""]).encode()
