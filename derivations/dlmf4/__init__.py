"""Chapter 4 of the DLMF: identities of trigonometric and hyperbolic functions."""

from kowalevski_cas.paper.derivation import Derivation

from . import hyperbolic, trigonometric

derivation = Derivation(
    name="dlmf4",
    title="Elementary functions: trigonometric and hyperbolic identities",
    author="R. Roy and F. W. J. Olver; the rows restated by the kowalevski_cas authors",
    source="NIST Digital Library of Mathematical Functions, Chapter 4, https://dlmf.nist.gov/4",
    sections=(trigonometric.section, hyperbolic.section),
)
