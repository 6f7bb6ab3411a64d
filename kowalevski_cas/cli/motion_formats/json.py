"""A motion as JSON: states, invariants, regime."""

from __future__ import annotations

import json

from kowalevski_cas.motion.result import Result


def render(result: Result) -> bytes:
    """One state a line, so that long files can be read and compared by lines."""
    entries = [
        {"t": t, "omega": row[:3], "alpha": row[3:6], "beta": row[6:]}
        for t, row in zip(result.times.tolist(), result.rows, strict=True)
    ]
    if result.radii is not None:
        for entry, radius in zip(entries, result.radii.tolist(), strict=True):
            entry["radius"] = radius
    states = ",\n".join(map(json.dumps, entries))
    rest = {
        "invariants": result.invariants,
        "critical_sets": result.critical_sets,
        "regime": result.regime,
    }
    tail = ",\n".join(f"{json.dumps(k)}: {json.dumps(v, indent=1)}" for k, v in rest.items())
    return f'{{"states": [\n{states}\n],\n{tail}\n}}\n'.encode()
