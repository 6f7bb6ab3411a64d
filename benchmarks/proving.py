"""How long proving, checking and reporting take, against the rows of ``proving.json``.

With ``--write`` the rows are committed anew.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from benchmarks.rows import compare, measure_rows

CLAIMS = 2_000
"""About one system."""

COMMANDS = (
    "kowalevski-cas verify kharlamov2002",
    "kowalevski-cas verify kharlamov2002 kharlamov_savushkin2004",
    "kowalevski-cas verify",
    "kowalevski-cas verify --arithmetic symengine",
    "kowalevski-cas verify --arithmetic sympy",
    "kowalevski-cas verify --arithmetic all --report reports",
    "kowalevski-cas check -q",
    "kowalevski-cas verify claims.py",
    "kowalevski-cas verify claims.py --report claims",
)
"""Cold: what is known of an earlier run is not asked for, but that a PDF has the same source."""


def main() -> None:
    """Measure, and compare."""
    with tempfile.TemporaryDirectory() as folder:
        lines = ["from kowalevski_cas import System", r'system = System(r"\dot x=y,\ \dot y=-x")']
        lines += [f'system.integral("{k}x^2+{k}y^2")' for k in range(2, CLAIMS + 2)]
        (Path(folder) / "claims.py").write_text("\n".join(lines) + "\n", encoding="utf-8")
        compare(measure_rows(COMMANDS, folder), Path(__file__).with_suffix(".json"))


if __name__ == "__main__":
    main()
