"""How many states a second the closed forms make, by the clock of the processor.

The times are spread to 10¹². On N⁴ they are compared with SciPy's ``ellipj`` alone in the same run:
at the same times, and at arguments within a period, which it need not bring there.
"""

from __future__ import annotations

from collections.abc import Callable
from time import process_time

import numpy as np
from scipy.special import ellipj

from kowalevski_cas.motion import Motion, MotionO4, load

COUNT, REPEATS = 1_000_000, 3

ON_N4 = (("0.8", "0.9"), ("-0.3", "0.4"))
"""Constants m, ℓ, with a = 1, b = 0.4."""

ON_O4 = (("0.4", "-0.5"), ("-0.9", "0.6"), ("0.9", "0.2"), ("1.200000000001", "0.2"))
"""Constants s, τ, with a = 1.2, b = 0.7; the last ones within 10⁻¹² of s = a."""


def main() -> None:
    """Measure, and print."""
    closed, times = load("closed"), np.linspace(0, 1e12, COUNT)
    within = np.random.default_rng(1).uniform(-2, 2, COUNT)
    alone, reduced = (rate(lambda u=u: ellipj(u, 0.3)) for u in (times, within))
    print(f"ellipj at the times {alone:,.0f}, within a period {reduced:,.0f}")
    for m, ell in ON_N4:
        motion = Motion.of(1, "0.4", m, ell=ell)
        made = rate(lambda motion=motion: closed(motion, times))
        print(f"N4 {m} {ell} {made:,.0f}, of ellipj {made / alone:.2f} and {made / reduced:.2f}")
    for s, tau in ON_O4:
        on_O4 = MotionO4.of("1.2", "0.7", s, tau)
        print(f"O4 {s} {tau} {rate(lambda motion=on_O4: closed(motion, times)):,.0f}")


def rate(make: Callable[[], object]) -> float:
    """How many a second, in the best of some runs."""
    least = np.inf
    for _ in range(REPEATS):
        start = process_time()
        make()
        least = min(least, process_time() - start)
    return float(COUNT / least)


if __name__ == "__main__":
    main()
