"""One run of the growing work: the seconds from the start to each step.

It is the program ``python -m study.grow ARITHMETIC CLAIM STEPS``.
"""

from __future__ import annotations

import sys

from kowalevski_cas.algebra import POINTS, load
from study.direct import direct
from study.growing import growth, steps


def main(arithmetic: str, claim: str, most: str) -> None:
    """Tell the seconds of each step."""
    if arithmetic == "direct":
        found = direct(claim, int(most))
    else:
        kind = None if arithmetic in POINTS else load(arithmetic)
        found = steps(growth(claim, kind), int(most))
    for k, seconds in enumerate(found, 1):
        print(f"step {k} {seconds:.6f}", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
