"""P. Leroy (2020): the free rigid body in Jacobi's elliptic functions, after an article by others.

The note gives formulas for an implementation, and corrects an article by Celledoni, Fassò,
Säfström and Zanna. Formulas are those of its source, the argument of ψ(t) and of integrals left out.
"""

from kowalevski_cas.paper.derivation import Derivation

from . import cases, quaternion, rotation, setting

derivation = Derivation(
    name="leroy2020",
    title="On an Article by Celledoni et al.",
    author="Pascal Leroy",
    source="documentation/Celledoni.tex in https://github.com/mockingbirdnest/Principia",
    edition=(
        "the file of commit 9ffb8b0c4e75, which last changed in 270a10aaab9e "
        "(SHA-256 8e1f13fb004031b9 …)"
    ),
    sections=(setting.section, cases.section, rotation.section, quaternion.section),
    main=("lambda-i", "lambda-ii", "common", "angle.1", "angle-iii.2", "angle-iii.3"),
)
