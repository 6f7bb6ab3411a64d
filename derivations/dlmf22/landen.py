r"""22.7. Landen's transformations: the same functions with another modulus."""

from kowalevski_cas.paper.claims import EqualSolutions
from kowalevski_cas.paper.derivation import Scene, Section

section = Section("22.7", "Landen transformations", copied=False)

descending = section.display("22.7.1", r"k_1=\frac{1-k'}{1+k'}")
ascending = section.display("22.7.5", r"k_2=\frac{2\sqrt{k}}{1+k}, \quad k_2'=\frac{1-k}{1+k}")
moduli = section.lemma("moduli-22.7", "k^2+k'^2=1", "https://dlmf.nist.gov/22.2: the moduli")

smaller = Scene(constants=("k'",), time="z").solving("k", moduli[1]).defining(descending)
larger = (
    Scene(constants=("k",), time="z")
    .adjoining(r"\sqrt{k}")
    .defining(ascending[1])
    .naming("k_2'", ascending[2])
)

by_smaller = section.display(
    "22.7.2",
    r"""
\operatorname{sn}(z,k) = \frac{(1+k_1)\operatorname{sn}(z/(1+k_1),k_1)}{1+k_1\operatorname{sn}^2(z/(1+k_1),k_1)}, \quad
\operatorname{cn}(z,k) = \frac{\operatorname{cn}(z/(1+k_1),k_1)\operatorname{dn}(z/(1+k_1),k_1)}{1+k_1\operatorname{sn}^2(z/(1+k_1),k_1)}, \quad
\operatorname{dn}(z,k) = \frac{\operatorname{dn}^2(z/(1+k_1),k_1)-(1-k_1)}{1+k_1-\operatorname{dn}^2(z/(1+k_1),k_1)}""",
)
section.claim(
    EqualSolutions(
        "22.7.2",
        smaller,
        "three rows of the DLMF, https://dlmf.nist.gov/22.7.E2 to E4: both sides solve one system",
        equations=(*by_smaller,),
    )
)

by_larger = section.display(
    "22.7.6",
    r"""
\operatorname{sn}(z,k) = \frac{(1+k_2')\operatorname{sn}(z/(1+k_2'),k_2)\operatorname{cn}(z/(1+k_2'),k_2)}{\operatorname{dn}(z/(1+k_2'),k_2)}, \quad
\operatorname{cn}(z,k) = \frac{(1+k_2')(\operatorname{dn}^2(z/(1+k_2'),k_2)-k_2')}{k_2^2\operatorname{dn}(z/(1+k_2'),k_2)}, \quad
\operatorname{dn}(z,k) = \frac{(1-k_2')(\operatorname{dn}^2(z/(1+k_2'),k_2)+k_2')}{k_2^2\operatorname{dn}(z/(1+k_2'),k_2)}""",
)
section.claim(
    EqualSolutions(
        "22.7.6",
        larger,
        "three rows of the DLMF, https://dlmf.nist.gov/22.7.E6 to E8: both sides solve one system",
        equations=(*by_larger,),
    )
)
