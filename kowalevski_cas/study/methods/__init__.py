"""The ways of deciding whether a statement is true, all behind one small interface."""

from __future__ import annotations

from kowalevski_cas.study.methods.method import ACCEPTED, NONE, REJECTED, Method
from kowalevski_cas.study.methods.registry import methods

__all__ = ["ACCEPTED", "NONE", "REJECTED", "Method", "methods"]
