"""How a motion is written: a function for each format."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable
from decimal import Decimal
from io import BytesIO
from textwrap import fill

import numpy as np

from kowalevski_cas.motion.result import Trajectory
from kowalevski_cas.schema import head

SMALL, LARGE = 1e-2, 1e5
"""Numbers below the first are small for four decimals, those from the second are large."""

LEAST = -300
"""The least power of ten in units of which states are printed."""

WIDTH = 80
"""Letters in a line of a table."""

TOLD = ("invariants", "critical_sets", "regime")
"""What is said of a motion besides its states."""


def _told(result: Trajectory) -> list[str]:
    """What is said of a motion, with its frequencies if they are asked for."""
    return [*TOLD, *(name for name in result.also if name == "frequencies")]


def _attitudes(result: Trajectory) -> list[list[float]]:
    """The quaternions, a row a state, if they are asked for."""
    found: list[list[float]] = result.attitude.tolist() if "attitude" in result.also else []
    return found


def as_json(result: Trajectory) -> bytes:
    """States, a line each, so that long files can be read and compared by lines; what is told."""
    entries = [
        {"t": t, "omega": row[:3], "alpha": row[3:6], "beta": row[6:]}
        for t, row in zip(result.times.tolist(), result.rows, strict=True)
    ]
    if result.radii is not None:
        for entry, radius in zip(entries, result.radii.tolist(), strict=True):
            entry["radius"] = radius
    for entry, quaternion in zip(entries, _attitudes(result), strict=False):
        entry["attitude"] = quaternion
    states = ",\n".join(map(json.dumps, entries))
    told = [f"{json.dumps(n)}: {json.dumps(getattr(result, n), indent=1)}" for n in _told(result)]
    begin = json.dumps(head("motion"))[:-1]
    return ",\n".join([f'{begin}, "states": [\n{states}\n]', *told]).encode() + b"\n}\n"


def _digits(value: float | str) -> str:
    """A constant to six digits, also where no float holds it."""
    return f"{value if isinstance(value, float) else Decimal(value):.6g}"


def as_table(result: Trajectory) -> bytes:
    """For reading: the states to four decimals, then the constants, their drift and the regime.

    Where the velocities or the fields are too small for four decimals, or too large, all of them
    are in units of a power of ten.
    """
    lines = [_head(f"{letter}{k}" for letter in "ωαβ" for k in "₁₂₃")]
    rows = np.array(result.rows).reshape(-1, 9)
    powers = [_power(rows[:, :3])] * 3 + [_power(rows[:, 3:])] * 6
    lines += _lines(result, (rows / 10.0 ** np.array(powers)).tolist())
    units = [f"{n} in units of 1e{k}" for n, k in (("ω", powers[0]), ("α, β", powers[-1])) if k]
    lines += [", ".join(units)] * bool(units)
    if attitudes := _attitudes(result):
        lines += ["", _head(f"q{k}" for k in "₀₁₂₃"), *_lines(result, attitudes)]
    constants = [f"{n} = {_digits(v)}" for n, v in result.motion.constants.items()]
    told = [", ".join(constants)]
    told.append(f"The integrals drift by at most {max(map(abs, result.drift.values())):.2g}.")
    if "frequencies" in result.also:
        told.append("; ".join(f"{n}: {_words(v)}" for n, v in result.frequencies.items()))
    regime = {n: v for n, v in result.regime.items() if isinstance(v, str)}
    told.append(regime.pop("none", "; ".join(f"{n}: {v}" for n, v in regime.items())))
    lines += ["", *map(_wrap, told)]
    return "\n".join([*lines, ""]).encode()


def _head(names: Iterable[str]) -> str:
    """The names above the columns of a table."""
    return "".join(f"{name:>8}" for name in ("t", *names))


def _lines(result: Trajectory, rows: list[list[float]]) -> list[str]:
    """The times, each with a row of numbers."""
    return [
        f"{t:>8.6g}" + "".join(map(_decimal, row))
        for t, row in zip(result.times.tolist(), rows, strict=True)
    ]


def _wrap(words: str) -> str:
    """Words in lines that are no wider than a table; an equation stays in one."""
    whole = words.replace(" = ", "\xa0=\xa0")
    return fill(whole, WIDTH, break_on_hyphens=False).replace("\xa0", " ")


def _words(value: object) -> str:
    """A number, several, or words."""
    if isinstance(value, list):
        return ", ".join(map(_words, value))
    return f"{value:.12g}" if isinstance(value, float) else str(value)


def _power(values: np.ndarray[tuple[int, int], np.dtype[np.float64]]) -> int:
    """The power of ten in units of which values are printed, zero if four decimals suit them."""
    largest = float(np.max(np.abs(values), initial=0.0))
    suited = SMALL <= largest < LARGE or not largest
    return 0 if suited else max(math.floor(math.log10(largest)), LEAST)


def _decimal(value: float) -> str:
    """A number of eight letters, with a blank before it; there is no −0."""
    return f"{round(value, 4) + 0.0:8.4f}" if abs(value) < 10 else f" {value:7.3g}"


def as_csv(result: Trajectory) -> bytes:
    """A table with a header: the time, the variables, the radius of a ball; floats read back."""
    radii = [[]] * len(result.times) if result.radii is None else result.radii[:, None].tolist()
    attitudes = _attitudes(result) or [[]] * len(result.times)
    rows = zip(result.times.tolist(), result.rows, radii, attitudes, strict=True)
    lines = [",".join(map(repr, (t, *row, *radius, *turn))) for t, row, radius, turn in rows]
    names = [f"{name}{k}" for name in ("omega", "alpha", "beta") for k in (1, 2, 3)]
    header = ["t", *names, *["radius"] * (result.radii is not None)]
    header += [f"q{k}" for k in range(4)] * ("attitude" in result.also)
    return "\n".join([",".join(header), *lines, ""]).encode()


def as_npz(result: Trajectory) -> bytes:
    """NumPy arrays: t (N), omega, alpha, beta (N, 3), radius (N); what is told as JSON."""
    omega, alpha, beta = np.split(result.states, 3, axis=1)
    arrays = {"t": result.times, "omega": omega, "alpha": alpha, "beta": beta}
    if result.radii is not None:
        arrays["radius"] = result.radii
    if "attitude" in result.also:
        arrays["attitude"] = result.attitude
    told = {name: np.array(json.dumps(getattr(result, name))) for name in _told(result)}
    file = BytesIO()
    np.savez(file, allow_pickle=True, **arrays, **told)
    return file.getvalue()


FORMATS: dict[str, Callable[[Trajectory], bytes]] = {
    "table": as_table, "json": as_json, "csv": as_csv, "npz": as_npz,
}  # fmt: skip
"""The contents of a file in each format."""
