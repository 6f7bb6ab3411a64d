"""Printed derivations of mathematical mechanics, read, proved or refuted."""

__version__ = "0.1.0"
