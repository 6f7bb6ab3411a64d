"""Finders: cofactors, exact points, corrections. What they find is checked, never trusted.

The search always uses FLINT; the check is done in whatever arithmetic decides.
"""
