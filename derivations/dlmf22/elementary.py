r"""22.6. Elementary identities."""

from kowalevski_cas.paper.derivation import Section

from .setting import dlmf, moduli

section = Section("22.6", "Elementary identities", copied=False)

on = moduli(section)


section.identity(
    "22.6.1",
    r"\operatorname{sn}^2(z,k)+\operatorname{cn}^2(z,k) = k^2\operatorname{sn}^2(z,k)+\operatorname{dn}^2(z,k) = 1",
    on=on,
    says=dlmf("22.6.1"),
)

section.identity(
    "22.6.2",
    r"1+\operatorname{cs}^2(z,k) = k^2+\operatorname{ds}^2(z,k) = \operatorname{ns}^2(z,k)",
    on=on,
    says=dlmf("22.6.2"),
)

section.identity(
    "22.6.3",
    r"k'^2\operatorname{sc}^2(z,k)+1 = \operatorname{dc}^2(z,k) = k'^2\operatorname{nc}^2(z,k)+k^2",
    on=on,
    says=dlmf("22.6.3"),
)

section.identity(
    "22.6.4",
    r"-k^2k'^2\operatorname{sd}^2(z,k) = k^2(\operatorname{cd}^2(z,k)-1) = k'^2(1-\operatorname{nd}^2(z,k))",
    on=on,
    says=dlmf("22.6.4"),
)

section.identity(
    "22.6.5",
    r"\operatorname{sn}(2z,k) = \frac{2\operatorname{sn}(z,k)\operatorname{cn}(z,k)\operatorname{dn}(z,k)}{1-k^2\operatorname{sn}^4(z,k)}",
    on=on,
    says=dlmf("22.6.5"),
)

section.identity(
    "22.6.6",
    r"\operatorname{cn}(2z,k) = \frac{\operatorname{cn}^2(z,k)-\operatorname{sn}^2(z,k)\operatorname{dn}^2(z,k)}{1-k^2\operatorname{sn}^4(z,k)} = \frac{\operatorname{cn}^4(z,k)-k'^2\operatorname{sn}^4(z,k)}{1-k^2\operatorname{sn}^4(z,k)}",
    on=on,
    says=dlmf("22.6.6"),
)

section.identity(
    "22.6.7",
    r"\operatorname{dn}(2z,k) = \frac{\operatorname{dn}^2(z,k)-k^2\operatorname{sn}^2(z,k)\operatorname{cn}^2(z,k)}{1-k^2\operatorname{sn}^4(z,k)} = \frac{\operatorname{dn}^4(z,k)+k^2k'^2\operatorname{sn}^4(z,k)}{1-k^2\operatorname{sn}^4(z,k)}",
    on=on,
    says=dlmf("22.6.7"),
)

section.identity(
    "22.6.8",
    r"\operatorname{cd}(2z,k) = \frac{\operatorname{cd}^2(z,k)-k'^2\operatorname{sd}^2(z,k)\operatorname{nd}^2(z,k)}{1+k^2k'^2\operatorname{sd}^4(z,k)}",
    on=on,
    says=dlmf("22.6.8"),
)

section.identity(
    "22.6.9",
    r"\operatorname{sd}(2z,k) = \frac{2\operatorname{sd}(z,k)\operatorname{cd}(z,k)\operatorname{nd}(z,k)}{1+k^2k'^2\operatorname{sd}^4(z,k)}",
    on=on,
    says=dlmf("22.6.9"),
)

section.identity(
    "22.6.10",
    r"\operatorname{nd}(2z,k) = \frac{\operatorname{nd}^2(z,k)+k^2\operatorname{sd}^2(z,k)\operatorname{cd}^2(z,k)}{1+k^2k'^2\operatorname{sd}^4(z,k)}",
    on=on,
    says=dlmf("22.6.10"),
)

section.identity(
    "22.6.11",
    r"\operatorname{dc}(2z,k) = \frac{\operatorname{dc}^2(z,k)+k'^2\operatorname{sc}^2(z,k)\operatorname{nc}^2(z,k)}{1-k'^2\operatorname{sc}^4(z,k)}",
    on=on,
    says=dlmf("22.6.11"),
)

section.identity(
    "22.6.12",
    r"\operatorname{nc}(2z,k) = \frac{\operatorname{nc}^2(z,k)+\operatorname{sc}^2(z,k)\operatorname{dc}^2(z,k)}{1-k'^2\operatorname{sc}^4(z,k)}",
    on=on,
    says=dlmf("22.6.12"),
)

section.identity(
    "22.6.13",
    r"\operatorname{sc}(2z,k) = \frac{2\operatorname{sc}(z,k)\operatorname{dc}(z,k)\operatorname{nc}(z,k)}{1-k'^2\operatorname{sc}^4(z,k)}",
    on=on,
    says=dlmf("22.6.13"),
)

section.identity(
    "22.6.14",
    r"\operatorname{ns}(2z,k) = \frac{\operatorname{ns}^4(z,k)-k^2}{2\operatorname{cs}(z,k)\operatorname{ds}(z,k)\operatorname{ns}(z,k)}",
    on=on,
    says=dlmf("22.6.14"),
)

section.identity(
    "22.6.15",
    r"\operatorname{ds}(2z,k) = \frac{k^2k'^2+\operatorname{ds}^4(z,k)}{2\operatorname{cs}(z,k)\operatorname{ds}(z,k)\operatorname{ns}(z,k)}",
    on=on,
    says=dlmf("22.6.15"),
)

section.identity(
    "22.6.16",
    r"\operatorname{cs}(2z,k) = \frac{\operatorname{cs}^4(z,k)-k'^2}{2\operatorname{cs}(z,k)\operatorname{ds}(z,k)\operatorname{ns}(z,k)}",
    on=on,
    says=dlmf("22.6.16"),
)

section.identity(
    "22.6.17",
    r"\frac{1-\operatorname{cn}(2z,k)}{1+\operatorname{cn}(2z,k)} = \frac{\operatorname{sn}^2(z,k)\operatorname{dn}^2(z,k)}{\operatorname{cn}^2(z,k)}",
    on=on,
    says=dlmf("22.6.17"),
)

section.identity(
    "22.6.18",
    r"\frac{1-\operatorname{dn}(2z,k)}{1+\operatorname{dn}(2z,k)} = \frac{k^2\operatorname{sn}^2(z,k)\operatorname{cn}^2(z,k)}{\operatorname{dn}^2(z,k)}",
    on=on,
    says=dlmf("22.6.18"),
)

section.identity(
    "22.6.19",
    r"\operatorname{sn}^2(\frac{z}{2},k) = \frac{1-\operatorname{cn}(z,k)}{1+\operatorname{dn}(z,k)} = \frac{1-\operatorname{dn}(z,k)}{k^2(1+\operatorname{cn}(z,k))} = \frac{\operatorname{dn}(z,k)-k^2\operatorname{cn}(z,k)-k'^2}{k^2(\operatorname{dn}(z,k)-\operatorname{cn}(z,k))}",
    on=on,
    says=dlmf("22.6.19"),
)

section.identity(
    "22.6.20",
    r"\operatorname{cn}^2(\frac{z}{2},k) = \frac{-k'^2+\operatorname{dn}(z,k)+k^2\operatorname{cn}(z,k)}{k^2(1+\operatorname{cn}(z,k))} = \frac{k'^2(1-\operatorname{dn}(z,k))}{k^2(\operatorname{dn}(z,k)-\operatorname{cn}(z,k))} = \frac{k'^2(1+\operatorname{cn}(z,k))}{k'^2+\operatorname{dn}(z,k)-k^2\operatorname{cn}(z,k)}",
    on=on,
    says=dlmf("22.6.20"),
)

section.identity(
    "22.6.21",
    r"\operatorname{dn}^2(\frac{z}{2},k) = \frac{k^2\operatorname{cn}(z,k)+\operatorname{dn}(z,k)+k'^2}{1+\operatorname{dn}(z,k)} = \frac{k'^2(1-\operatorname{cn}(z,k))}{\operatorname{dn}(z,k)-\operatorname{cn}(z,k)} = \frac{k'^2(1+\operatorname{dn}(z,k))}{k'^2+\operatorname{dn}(z,k)-k^2\operatorname{cn}(z,k)}",
    on=on,
    says=dlmf("22.6.21"),
)

# Row 22 is one for p, q, r in any order of the letters c, d, n.

section.identity(
    "22.6.22cdn",
    r"\operatorname{cd}^2(\frac{z}{2},k) = \frac{\operatorname{cs}(z,k)+\operatorname{ns}(z,k)}{\operatorname{ds}(z,k)+\operatorname{ns}(z,k)} = \frac{\operatorname{cd}(z,k)+\operatorname{nd}(z,k)}{1+\operatorname{nd}(z,k)} = \frac{\operatorname{cn}(z,k)+1}{\operatorname{dn}(z,k)+1}",
    on=on,
    says=dlmf("22.6.22"),
)

section.identity(
    "22.6.22cnd",
    r"\operatorname{cn}^2(\frac{z}{2},k) = \frac{\operatorname{cs}(z,k)+\operatorname{ds}(z,k)}{\operatorname{ns}(z,k)+\operatorname{ds}(z,k)} = \frac{\operatorname{cn}(z,k)+\operatorname{dn}(z,k)}{1+\operatorname{dn}(z,k)} = \frac{\operatorname{cd}(z,k)+1}{\operatorname{nd}(z,k)+1}",
    on=on,
    says=dlmf("22.6.22"),
)

section.identity(
    "22.6.22dcn",
    r"\operatorname{dc}^2(\frac{z}{2},k) = \frac{\operatorname{ds}(z,k)+\operatorname{ns}(z,k)}{\operatorname{cs}(z,k)+\operatorname{ns}(z,k)} = \frac{\operatorname{dc}(z,k)+\operatorname{nc}(z,k)}{1+\operatorname{nc}(z,k)} = \frac{\operatorname{dn}(z,k)+1}{\operatorname{cn}(z,k)+1}",
    on=on,
    says=dlmf("22.6.22"),
)

section.identity(
    "22.6.22dnc",
    r"\operatorname{dn}^2(\frac{z}{2},k) = \frac{\operatorname{ds}(z,k)+\operatorname{cs}(z,k)}{\operatorname{ns}(z,k)+\operatorname{cs}(z,k)} = \frac{\operatorname{dn}(z,k)+\operatorname{cn}(z,k)}{1+\operatorname{cn}(z,k)} = \frac{\operatorname{dc}(z,k)+1}{\operatorname{nc}(z,k)+1}",
    on=on,
    says=dlmf("22.6.22"),
)

section.identity(
    "22.6.22ncd",
    r"\operatorname{nc}^2(\frac{z}{2},k) = \frac{\operatorname{ns}(z,k)+\operatorname{ds}(z,k)}{\operatorname{cs}(z,k)+\operatorname{ds}(z,k)} = \frac{\operatorname{nc}(z,k)+\operatorname{dc}(z,k)}{1+\operatorname{dc}(z,k)} = \frac{\operatorname{nd}(z,k)+1}{\operatorname{cd}(z,k)+1}",
    on=on,
    says=dlmf("22.6.22"),
)

section.identity(
    "22.6.22ndc",
    r"\operatorname{nd}^2(\frac{z}{2},k) = \frac{\operatorname{ns}(z,k)+\operatorname{cs}(z,k)}{\operatorname{ds}(z,k)+\operatorname{cs}(z,k)} = \frac{\operatorname{nd}(z,k)+\operatorname{cd}(z,k)}{1+\operatorname{cd}(z,k)} = \frac{\operatorname{nc}(z,k)+1}{\operatorname{dc}(z,k)+1}",
    on=on,
    says=dlmf("22.6.22"),
)
