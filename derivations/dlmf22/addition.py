r"""22.8. Addition theorems."""

from dataclasses import replace

from kowalevski_cas.paper.derivation import Scene, Section

from .setting import dlmf, moduli

section = Section("22.8", "Addition theorems", copied=False)

on = moduli(section)

NOT_COMPARED = ", whose print was not at hand: this form is not compared with it"


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
at_half_period = section.lemma(
    "half-22.8",
    r"\operatorname{sn}(2K,k)=0, \quad \operatorname{cn}(2K,k)=-1, \quad \operatorname{dn}(2K,k)=1",
    "what follows from the values at the quarter period",
)
of_sum_half_period = section.lemma(
    "22.8.22", "z_4=2K-(z_1+z_2+z_3)", "https://dlmf.nist.gov/22.8.E22"
)

section.identity(
    "22.8.23",
    r"\begin{vmatrix}\operatorname{sn}(z_1,k)\operatorname{cn}(z_1,k)&\operatorname{sn}(z_1,k)\operatorname{dn}(z_1,k)&\operatorname{cn}(z_1,k)&\operatorname{dn}(z_1,k)\\\operatorname{sn}(z_2,k)\operatorname{cn}(z_2,k)&\operatorname{sn}(z_2,k)\operatorname{dn}(z_2,k)&\operatorname{cn}(z_2,k)&\operatorname{dn}(z_2,k)\\\operatorname{sn}(z_3,k)\operatorname{cn}(z_3,k)&\operatorname{sn}(z_3,k)\operatorname{dn}(z_3,k)&\operatorname{cn}(z_3,k)&\operatorname{dn}(z_3,k)\\\operatorname{sn}(z_4,k)\operatorname{cn}(z_4,k)&\operatorname{sn}(z_4,k)\operatorname{dn}(z_4,k)&\operatorname{cn}(z_4,k)&\operatorname{dn}(z_4,k)\end{vmatrix}=0",
    on=replace(four, definitions={})
    .having(constants=("K",))
    .taking(quarter, at_half_period)
    .defining(of_sum_half_period),
    says=dlmf("22.8.23") + NOT_COMPARED,
)

# κ = dn(2K/3) as in 22.9.7; three times this argument is 2K, which gives the other values and k.
by_third = section.lemma(
    "third-22.8",
    r"k^2=\frac{(1-\kappa)(1+\kappa)^3}{1+2\kappa}, \quad \sigma^2=1+2\kappa",
    r"the modulus by $\kappa=\mathrm{dn}(2K/3,k)$",
)
at_third = section.lemma(
    "thirds-22.8",
    r"\operatorname{sn}(\frac{2K}{3},k)=\frac{\sigma}{1+\kappa}, \quad \operatorname{cn}(\frac{2K}{3},k)=\frac{\kappa}{1+\kappa}, \quad \operatorname{dn}(\frac{2K}{3},k)=\kappa, \quad \operatorname{sn}(\frac{4K}{3},k)=\frac{\sigma}{1+\kappa}, \quad \operatorname{cn}(\frac{4K}{3},k)=-\frac{\kappa}{1+\kappa}, \quad \operatorname{dn}(\frac{4K}{3},k)=\kappa",
    "what follows from those at 2K",
)
by_thirds = section.lemma(
    "22.8.24",
    r"z_2=z_1-\frac23K, \quad z_3=z_1-\frac43K",
    "what follows from https://dlmf.nist.gov/22.8.E24",
)

section.identity(
    "22.8.25",
    r"\frac{d}{dz_1}\frac{(\operatorname{dn}(z_2,k)+\operatorname{dn}(z_3,k))(\operatorname{dn}(z_3,k)+\operatorname{dn}(z_1,k))(\operatorname{dn}(z_1,k)+\operatorname{dn}(z_2,k))}{\operatorname{dn}(z_1,k)+\operatorname{dn}(z_2,k)+\operatorname{dn}(z_3,k)+\operatorname{dn}(z_1,k)\operatorname{dn}(z_2,k)\operatorname{dn}(z_3,k)}=0",
    on=Scene("by thirds", constants=("K", r"\kappa"), time="z_1")
    .solving("k", by_third[1])
    .solving(r"\sigma", by_third[2])
    .taking(at_half_period, at_third)
    .defining(by_thirds),
    says=dlmf("22.8.25") + NOT_COMPARED,
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
