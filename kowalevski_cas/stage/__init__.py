"""Scenes given meaning by an arithmetic."""

from kowalevski_cas.stage.evaluate import StageError, Triple, Value, evaluate, scalar, vector
from kowalevski_cas.stage.stage import Stage

__all__ = ["Stage", "StageError", "Triple", "Value", "evaluate", "scalar", "vector"]
