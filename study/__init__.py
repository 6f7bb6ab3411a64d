"""The study: what each way of checking costs, how sure it is, and where it fails.

A study is a sequence of steps, one module each. A step says what is to be
measured (:func:`measure`, a sequence of tasks) and draws what was measured
(:func:`draw`, from stored rows only). A new step is one new module and one line
in :data:`STEPS`.
"""

from __future__ import annotations

from importlib import import_module
from typing import cast

from study.step import Measured, Row, Step, Task

STEPS: dict[str, str] = {
    "speed-accuracy": "speed_accuracy",
    "growth": "growth",
    "theta": "stability.theta",
    "branch": "stability.branch",
    "degenerate": "stability.degenerate",
    "primes": "stability.primes",
    "precision": "stability.precision",
    "swell": "stability.swell",
    "scenes": "scenes",
    "phase-point": "phase_point",
    "motion-precision": "motion.precision",
    "motion-leaving": "motion.leaving",
    "motion-limits": "motion.limits",
    "motion-long": "motion.long",
}
"""The module of each step below this package, by the step's name, in the order of the study."""


def load(name: str) -> Step:
    """The step with this name."""
    if name not in STEPS:
        raise ValueError(f"there is no step “{name}”; the study has: {', '.join(STEPS)}")
    return cast(Step, import_module(f"{__name__}.{STEPS[name]}"))


__all__ = ["STEPS", "Measured", "Row", "Step", "Task", "load"]
