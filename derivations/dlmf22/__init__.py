"""Chapter 22 of the DLMF: identities of Jacobi's elliptic functions."""

from kowalevski_cas.paper.derivation import Derivation

from . import addition, derivatives, elementary, landen

derivation = Derivation(
    name="dlmf22",
    title="Jacobian elliptic functions: identities",
    author="W. P. Reinhardt and P. L. Walker; the rows restated by the kowalevski_cas authors",
    source="NIST Digital Library of Mathematical Functions, Chapter 22, https://dlmf.nist.gov/22",
    sections=(elementary.section, landen.section, addition.section, derivatives.section),
)
