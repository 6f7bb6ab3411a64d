"""The simple pendulum of the textbooks: its motions in Jacobi's elliptic functions."""

from kowalevski_cas.paper.derivation import Derivation

from . import motion, solutions

derivation = Derivation(
    name="pendulum",
    title="The simple pendulum",
    author="Textbooks of mechanics; restated by the kowalevski_cas authors",
    source="E. T. Whittaker, Analytical Dynamics, §44; https://dlmf.nist.gov/22.19.i",
    sections=(motion.section, solutions.section),
)
