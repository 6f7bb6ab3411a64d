"""Motions on O⁴: separated, by two quadratures on a curve of genus 2, and inverted."""
