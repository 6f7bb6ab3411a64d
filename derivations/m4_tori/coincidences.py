r"""3. Where two roots of the polynomial coincide: the common points of M^4 and O^4."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2005.first_two import on_M4
from ..kharlamov2005.values import on_O4_values
from .levels import quartic

section = Section("3", "Coinciding roots", copied=None)

common = (
    Scene("M⁴ and O⁴", constants=("s", r"\tau_3", "r", "u"), nonzero=("s", r"\tau_3"))
    .adjoining(
        section.lemma(
            "p-where-k-vanishes",
            r"p^2 = \frac{\tau_3^2+r^4+4s^2\tau_3}{2\tau_3}",
            "$k=0$ on $O^4$ solved for $p^2$",
        ),
        section.lemma("j-of-s", r"j^2 = \frac{r^4-\tau_3^2}{2s}", "the partial integral on both"),
    )
    .defining(on_O4_values, quartic[1])
)

section.states(
    Identity,
    on_M4,
    on=common,
    says="the integrals on both $M^4$ and $O^4$",
    ids=("both.k", "both.g"),
)

section.identity(
    "double",
    r"R(u) = -(u-\tau_3)^2\left[(u+\tau_3)^2+\frac{j^4}{\tau_3}\right]",
    on=common,
    says=r"$\tau_3$ is a double root of $R$",
)
