"""Measurements of speed: medians and ratios, never a pass or a fail."""
