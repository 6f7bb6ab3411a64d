r"""22.8. Addition theorems."""

from dataclasses import replace

from kowalevski_cas.paper.derivation import Section

from .setting import dlmf, moduli

section = Section("22.8", "Addition theorems", copied=False)

on = moduli(section)


section.identity(
    "22.8.1",
    r"\operatorname{sn}(u+v,k) = \frac{\operatorname{sn}(u,k)\operatorname{cn}(v,k)\operatorname{dn}(v,k)+\operatorname{sn}(v,k)\operatorname{cn}(u,k)\operatorname{dn}(u,k)}{1-k^2\operatorname{sn}^2(u,k)\operatorname{sn}^2(v,k)}",
    on=on,
    says=dlmf("22.8.1"),
)

section.identity(
    "22.8.2",
    r"\operatorname{cn}(u+v,k) = \frac{\operatorname{cn}(u,k)\operatorname{cn}(v,k)-\operatorname{sn}(u,k)\operatorname{dn}(u,k)\operatorname{sn}(v,k)\operatorname{dn}(v,k)}{1-k^2\operatorname{sn}^2(u,k)\operatorname{sn}^2(v,k)}",
    on=on,
    says=dlmf("22.8.2"),
)

section.identity(
    "22.8.3",
    r"\operatorname{dn}(u+v,k) = \frac{\operatorname{dn}(u,k)\operatorname{dn}(v,k)-k^2\operatorname{sn}(u,k)\operatorname{cn}(u,k)\operatorname{sn}(v,k)\operatorname{cn}(v,k)}{1-k^2\operatorname{sn}^2(u,k)\operatorname{sn}^2(v,k)}",
    on=on,
    says=dlmf("22.8.3"),
)

section.identity(
    "22.8.4",
    r"\operatorname{cd}(u+v,k) = \frac{\operatorname{cd}(u,k)\operatorname{cd}(v,k)-k'^2\operatorname{sd}(u,k)\operatorname{nd}(u,k)\operatorname{sd}(v,k)\operatorname{nd}(v,k)}{1+k^2k'^2\operatorname{sd}^2(u,k)\operatorname{sd}^2(v,k)}",
    on=on,
    says=dlmf("22.8.4"),
)

section.identity(
    "22.8.5",
    r"\operatorname{sd}(u+v,k) = \frac{\operatorname{sd}(u,k)\operatorname{cd}(v,k)\operatorname{nd}(v,k)+\operatorname{sd}(v,k)\operatorname{cd}(u,k)\operatorname{nd}(u,k)}{1+k^2k'^2\operatorname{sd}^2(u,k)\operatorname{sd}^2(v,k)}",
    on=on,
    says=dlmf("22.8.5"),
)

section.identity(
    "22.8.6",
    r"\operatorname{nd}(u+v,k) = \frac{\operatorname{nd}(u,k)\operatorname{nd}(v,k)+k^2\operatorname{sd}(u,k)\operatorname{cd}(u,k)\operatorname{sd}(v,k)\operatorname{cd}(v,k)}{1+k^2k'^2\operatorname{sd}^2(u,k)\operatorname{sd}^2(v,k)}",
    on=on,
    says=dlmf("22.8.6"),
)

section.identity(
    "22.8.7",
    r"\operatorname{dc}(u+v,k) = \frac{\operatorname{dc}(u,k)\operatorname{dc}(v,k)+k'^2\operatorname{sc}(u,k)\operatorname{nc}(u,k)\operatorname{sc}(v,k)\operatorname{nc}(v,k)}{1-k'^2\operatorname{sc}^2(u,k)\operatorname{sc}^2(v,k)}",
    on=on,
    says=dlmf("22.8.7"),
)

section.identity(
    "22.8.8",
    r"\operatorname{nc}(u+v,k) = \frac{\operatorname{nc}(u,k)\operatorname{nc}(v,k)+\operatorname{sc}(u,k)\operatorname{dc}(u,k)\operatorname{sc}(v,k)\operatorname{dc}(v,k)}{1-k'^2\operatorname{sc}^2(u,k)\operatorname{sc}^2(v,k)}",
    on=on,
    says=dlmf("22.8.8"),
)

section.identity(
    "22.8.9",
    r"\operatorname{sc}(u+v,k) = \frac{\operatorname{sc}(u,k)\operatorname{dc}(v,k)\operatorname{nc}(v,k)+\operatorname{sc}(v,k)\operatorname{dc}(u,k)\operatorname{nc}(u,k)}{1-k'^2\operatorname{sc}^2(u,k)\operatorname{sc}^2(v,k)}",
    on=on,
    says=dlmf("22.8.9"),
)

section.identity(
    "22.8.10",
    r"\operatorname{ns}(u+v,k) = \frac{\operatorname{ns}(u,k)\operatorname{ds}(v,k)\operatorname{cs}(v,k)-\operatorname{ns}(v,k)\operatorname{ds}(u,k)\operatorname{cs}(u,k)}{\operatorname{cs}^2(v,k)-\operatorname{cs}^2(u,k)}",
    on=on,
    says=dlmf("22.8.10"),
)

section.identity(
    "22.8.11",
    r"\operatorname{ds}(u+v,k) = \frac{\operatorname{ds}(u,k)\operatorname{cs}(v,k)\operatorname{ns}(v,k)-\operatorname{ds}(v,k)\operatorname{cs}(u,k)\operatorname{ns}(u,k)}{\operatorname{cs}^2(v,k)-\operatorname{cs}^2(u,k)}",
    on=on,
    says=dlmf("22.8.11"),
)

section.identity(
    "22.8.12",
    r"\operatorname{cs}(u+v,k) = \frac{\operatorname{cs}(u,k)\operatorname{ds}(v,k)\operatorname{ns}(v,k)-\operatorname{cs}(v,k)\operatorname{ds}(u,k)\operatorname{ns}(u,k)}{\operatorname{cs}^2(v,k)-\operatorname{cs}^2(u,k)}",
    on=on,
    says=dlmf("22.8.12"),
)

section.identity(
    "22.8.13",
    r"\operatorname{sn}(u+v,k) = \frac{\operatorname{sn}^2(u,k)-\operatorname{sn}^2(v,k)}{\operatorname{sn}(u,k)\operatorname{cn}(v,k)\operatorname{dn}(v,k)-\operatorname{sn}(v,k)\operatorname{cn}(u,k)\operatorname{dn}(u,k)}",
    on=on,
    says=dlmf("22.8.13"),
)

section.identity(
    "22.8.14",
    r"\operatorname{sn}(u+v,k) = \frac{\operatorname{sn}(u,k)\operatorname{cn}(u,k)\operatorname{dn}(v,k)+\operatorname{sn}(v,k)\operatorname{cn}(v,k)\operatorname{dn}(u,k)}{\operatorname{cn}(u,k)\operatorname{cn}(v,k)+\operatorname{sn}(u,k)\operatorname{dn}(u,k)\operatorname{sn}(v,k)\operatorname{dn}(v,k)}",
    on=on,
    says=dlmf("22.8.14"),
)

section.identity(
    "22.8.15",
    r"\operatorname{cn}(u+v,k) = \frac{\operatorname{sn}(u,k)\operatorname{cn}(u,k)\operatorname{dn}(v,k)-\operatorname{sn}(v,k)\operatorname{cn}(v,k)\operatorname{dn}(u,k)}{\operatorname{sn}(u,k)\operatorname{cn}(v,k)\operatorname{dn}(v,k)-\operatorname{sn}(v,k)\operatorname{cn}(u,k)\operatorname{dn}(u,k)}",
    on=on,
    says=dlmf("22.8.15"),
)

section.identity(
    "22.8.16",
    r"\operatorname{cn}(u+v,k) = \frac{1-\operatorname{sn}^2(u,k)-\operatorname{sn}^2(v,k)+k^2\operatorname{sn}^2(u,k)\operatorname{sn}^2(v,k)}{\operatorname{cn}(u,k)\operatorname{cn}(v,k)+\operatorname{sn}(u,k)\operatorname{dn}(u,k)\operatorname{sn}(v,k)\operatorname{dn}(v,k)}",
    on=on,
    says=dlmf("22.8.16"),
)

section.identity(
    "22.8.17",
    r"\operatorname{dn}(u+v,k) = \frac{\operatorname{sn}(u,k)\operatorname{cn}(v,k)\operatorname{dn}(u,k)-\operatorname{sn}(v,k)\operatorname{cn}(u,k)\operatorname{dn}(v,k)}{\operatorname{sn}(u,k)\operatorname{cn}(v,k)\operatorname{dn}(v,k)-\operatorname{sn}(v,k)\operatorname{cn}(u,k)\operatorname{dn}(u,k)}",
    on=on,
    says=dlmf("22.8.17"),
)

section.identity(
    "22.8.18",
    r"\operatorname{dn}(u+v,k) = \frac{\operatorname{cn}(u,k)\operatorname{dn}(u,k)\operatorname{cn}(v,k)\operatorname{dn}(v,k)+k'^2\operatorname{sn}(u,k)\operatorname{sn}(v,k)}{\operatorname{cn}(u,k)\operatorname{cn}(v,k)+\operatorname{sn}(u,k)\operatorname{dn}(u,k)\operatorname{sn}(v,k)\operatorname{dn}(v,k)}",
    on=on,
    says=dlmf("22.8.18"),
)

of_sum_zero = section.lemma("22.8.19", "z_4=-(z_1+z_2+z_3)", "https://dlmf.nist.gov/22.8.E19")
four = replace(on, variables=("z_1", "z_2", "z_3")).defining(of_sum_zero)

section.identity(
    "22.8.20",
    r"\begin{vmatrix}\operatorname{sn}(z_1,k)&\operatorname{cn}(z_1,k)&\operatorname{dn}(z_1,k)&1\\\operatorname{sn}(z_2,k)&\operatorname{cn}(z_2,k)&\operatorname{dn}(z_2,k)&1\\\operatorname{sn}(z_3,k)&\operatorname{cn}(z_3,k)&\operatorname{dn}(z_3,k)&1\\\operatorname{sn}(z_4,k)&\operatorname{cn}(z_4,k)&\operatorname{dn}(z_4,k)&1\end{vmatrix}=0",
    on=four,
    says=dlmf("22.8.20"),
)

section.identity(
    "22.8.21",
    r"k'^2-k'^2k^2\operatorname{sn}(z_1,k)\operatorname{sn}(z_2,k)\operatorname{sn}(z_3,k)\operatorname{sn}(z_4,k)+k^2\operatorname{cn}(z_1,k)\operatorname{cn}(z_2,k)\operatorname{cn}(z_3,k)\operatorname{cn}(z_4,k)-\operatorname{dn}(z_1,k)\operatorname{dn}(z_2,k)\operatorname{dn}(z_3,k)\operatorname{dn}(z_4,k)=0",
    on=four,
    says=dlmf("22.8.21"),
)

quarter = section.lemma(
    "quarter-22.8",
    r"\operatorname{sn}(K,k)=1, \quad \operatorname{cn}(K,k)=0, \quad \operatorname{dn}(K,k)=k'",
    "https://dlmf.nist.gov/22.5.T1: the values at the quarter period",
)
shifted = section.lemma(
    "22.8.26", r"z_3=z_1-K, \quad z_4=z_2-K", "what follows from https://dlmf.nist.gov/22.8.E26"
)
by_quarters = (
    replace(on, variables=("z_1", "z_2")).having(constants=("K",)).taking(quarter).defining(shifted)
)

section.identity(
    "22.8.27",
    r"\operatorname{dn}(z_1,k)\operatorname{dn}(z_3,k)=\operatorname{dn}(z_2,k)\operatorname{dn}(z_4,k)=k'",
    on=by_quarters,
    says=dlmf("22.8.27"),
)
