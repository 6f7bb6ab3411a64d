"""The ways of deciding whether a statement is true, all behind one small interface."""

from __future__ import annotations

from study.methods.method import ACCEPTED, NONE, REJECTED, Method
from study.methods.registry import methods

__all__ = ["ACCEPTED", "NONE", "REJECTED", "Method", "methods"]
