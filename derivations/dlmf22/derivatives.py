r"""22.13. Derivatives and differential equations."""

from dataclasses import replace

from kowalevski_cas.paper.derivation import Section

from .setting import dlmf, moduli

section = Section("22.13", "Derivatives and differential equations", copied=False)

on_z = replace(moduli(section), variables=(), time="z")


section.identity(
    "22.13.1",
    r"(\frac{d}{dz}\operatorname{sn}(z,k))^2 = (1-\operatorname{sn}^2(z,k))(1-k^2\operatorname{sn}^2(z,k))",
    on=on_z,
    says=dlmf("22.13.1"),
)

section.identity(
    "22.13.2",
    r"(\frac{d}{dz}\operatorname{cn}(z,k))^2 = (1-\operatorname{cn}^2(z,k))(k'^2+k^2\operatorname{cn}^2(z,k))",
    on=on_z,
    says=dlmf("22.13.2"),
)

section.identity(
    "22.13.3",
    r"(\frac{d}{dz}\operatorname{dn}(z,k))^2 = (1-\operatorname{dn}^2(z,k))(\operatorname{dn}^2(z,k)-k'^2)",
    on=on_z,
    says=dlmf("22.13.3"),
)

section.identity(
    "22.13.4",
    r"(\frac{d}{dz}\operatorname{cd}(z,k))^2 = (1-\operatorname{cd}^2(z,k))(1-k^2\operatorname{cd}^2(z,k))",
    on=on_z,
    says=dlmf("22.13.4"),
)

section.identity(
    "22.13.5",
    r"(\frac{d}{dz}\operatorname{sd}(z,k))^2 = (1-k'^2\operatorname{sd}^2(z,k))(1+k^2\operatorname{sd}^2(z,k))",
    on=on_z,
    says=dlmf("22.13.5"),
)

section.identity(
    "22.13.6",
    r"(\frac{d}{dz}\operatorname{nd}(z,k))^2 = (\operatorname{nd}^2(z,k)-1)(1-k'^2\operatorname{nd}^2(z,k))",
    on=on_z,
    says=dlmf("22.13.6"),
)

section.identity(
    "22.13.7",
    r"(\frac{d}{dz}\operatorname{dc}(z,k))^2 = (\operatorname{dc}^2(z,k)-1)(\operatorname{dc}^2(z,k)-k^2)",
    on=on_z,
    says=dlmf("22.13.7"),
)

section.identity(
    "22.13.8",
    r"(\frac{d}{dz}\operatorname{nc}(z,k))^2 = (k^2+k'^2\operatorname{nc}^2(z,k))(\operatorname{nc}^2(z,k)-1)",
    on=on_z,
    says=dlmf("22.13.8"),
)

section.identity(
    "22.13.9",
    r"(\frac{d}{dz}\operatorname{sc}(z,k))^2 = (1+\operatorname{sc}^2(z,k))(1+k'^2\operatorname{sc}^2(z,k))",
    on=on_z,
    says=dlmf("22.13.9"),
)

section.identity(
    "22.13.10",
    r"(\frac{d}{dz}\operatorname{ns}(z,k))^2 = (\operatorname{ns}^2(z,k)-k^2)(\operatorname{ns}^2(z,k)-1)",
    on=on_z,
    says=dlmf("22.13.10"),
)

section.identity(
    "22.13.11",
    r"(\frac{d}{dz}\operatorname{ds}(z,k))^2 = (\operatorname{ds}^2(z,k)-k'^2)(k^2+\operatorname{ds}^2(z,k))",
    on=on_z,
    says=dlmf("22.13.11"),
)

section.identity(
    "22.13.12",
    r"(\frac{d}{dz}\operatorname{cs}(z,k))^2 = (1+\operatorname{cs}^2(z,k))(k'^2+\operatorname{cs}^2(z,k))",
    on=on_z,
    says=dlmf("22.13.12"),
)

section.identity(
    "22.13.13",
    r"\frac{d^2}{dz^2}\operatorname{sn}(z,k) = -(1+k^2)\operatorname{sn}(z,k)+2k^2\operatorname{sn}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.13"),
)

section.identity(
    "22.13.14",
    r"\frac{d^2}{dz^2}\operatorname{cn}(z,k) = -(k'^2-k^2)\operatorname{cn}(z,k)-2k^2\operatorname{cn}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.14"),
)

section.identity(
    "22.13.15",
    r"\frac{d^2}{dz^2}\operatorname{dn}(z,k) = (1+k'^2)\operatorname{dn}(z,k)-2\operatorname{dn}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.15"),
)

section.identity(
    "22.13.16",
    r"\frac{d^2}{dz^2}\operatorname{cd}(z,k) = -(1+k^2)\operatorname{cd}(z,k)+2k^2\operatorname{cd}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.16"),
)

section.identity(
    "22.13.17",
    r"\frac{d^2}{dz^2}\operatorname{sd}(z,k) = (k^2-k'^2)\operatorname{sd}(z,k)-2k^2k'^2\operatorname{sd}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.17"),
)

section.identity(
    "22.13.18",
    r"\frac{d^2}{dz^2}\operatorname{nd}(z,k) = (1+k'^2)\operatorname{nd}(z,k)-2k'^2\operatorname{nd}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.18"),
)

section.identity(
    "22.13.19",
    r"\frac{d^2}{dz^2}\operatorname{dc}(z,k) = -(1+k^2)\operatorname{dc}(z,k)+2\operatorname{dc}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.19"),
)

section.identity(
    "22.13.20",
    r"\frac{d^2}{dz^2}\operatorname{nc}(z,k) = (k^2-k'^2)\operatorname{nc}(z,k)+2k'^2\operatorname{nc}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.20"),
)

section.identity(
    "22.13.21",
    r"\frac{d^2}{dz^2}\operatorname{sc}(z,k) = (1+k'^2)\operatorname{sc}(z,k)+2k'^2\operatorname{sc}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.21"),
)

section.identity(
    "22.13.22",
    r"\frac{d^2}{dz^2}\operatorname{ns}(z,k) = -(1+k^2)\operatorname{ns}(z,k)+2\operatorname{ns}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.22"),
)

section.identity(
    "22.13.23",
    r"\frac{d^2}{dz^2}\operatorname{ds}(z,k) = (k^2-k'^2)\operatorname{ds}(z,k)+2\operatorname{ds}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.23"),
)

section.identity(
    "22.13.24",
    r"\frac{d^2}{dz^2}\operatorname{cs}(z,k) = (1+k'^2)\operatorname{cs}(z,k)+2\operatorname{cs}^3(z,k)",
    on=on_z,
    says=dlmf("22.13.24"),
)
