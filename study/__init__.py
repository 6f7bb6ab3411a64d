"""The study: what each way of checking costs, how sure it is, and where it fails.

A step is one module: ``measure`` says what is to be measured, ``draw`` makes one chart of
stored rows, ``CAPTION`` says what it shows and for which parameters. A new step is a new
module and its name in :data:`STEPS`.
"""

from __future__ import annotations

from importlib import import_module
from typing import cast

from study.step import Measured, Row, StudyStep, Task

STEPS = (
    "speed-accuracy",
    "growth",
    "failures",
    "work-precision",
    "leaving",
    "lasting",
    "perturbed",
    "searches",
)
"""The steps in the order of the study; each is a module of that name below this package."""


def load(name: str) -> StudyStep:
    """The step with this name."""
    if name not in STEPS:
        raise ValueError(f"there is no step “{name}”; the study has: {', '.join(STEPS)}")
    return cast(StudyStep, import_module(f"{__name__}.{name.replace('-', '_')}"))


__all__ = ["STEPS", "Measured", "Row", "Step", "Task", "load"]
