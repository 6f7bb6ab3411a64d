r"""4.35. Identities of hyperbolic functions."""

from kowalevski_cas.paper.derivation import Section

from .setting import REAL, complex_argument, dlmf, with_root

section = Section("4.35", "Identities of hyperbolic functions", copied=False)

of_complex = complex_argument(section)

section.identity(
    "4.35.1", r"\sinh(u\pm v)=\sinh u\cosh v\pm\cosh u\sinh v", on=REAL, says=dlmf("4.35.1")
)

section.identity(
    "4.35.2", r"\cosh(u\pm v)=\cosh u\cosh v\pm\sinh u\sinh v", on=REAL, says=dlmf("4.35.2")
)

section.identity(
    "4.35.3",
    r"\tanh(u\pm v)=\frac{\tanh u\pm\tanh v}{1\pm\tanh u\tanh v}",
    on=REAL,
    says=dlmf("4.35.3"),
)

section.identity(
    "4.35.4",
    r"\coth(u\pm v)=\frac{\pm\coth u\coth v+1}{\coth u\pm\coth v}",
    on=REAL,
    says=dlmf("4.35.4"),
)

section.identity(
    "4.35.5",
    r"\sinh u+\sinh v = 2\sinh(\frac{u+v}{2})\cosh(\frac{u-v}{2})",
    on=REAL,
    says=dlmf("4.35.5"),
)

section.identity(
    "4.35.6",
    r"\sinh u-\sinh v = 2\cosh(\frac{u+v}{2})\sinh(\frac{u-v}{2})",
    on=REAL,
    says=dlmf("4.35.6"),
)

section.identity(
    "4.35.7",
    r"\cosh u+\cosh v = 2\cosh(\frac{u+v}{2})\cosh(\frac{u-v}{2})",
    on=REAL,
    says=dlmf("4.35.7"),
)

section.identity(
    "4.35.8",
    r"\cosh u-\cosh v = 2\sinh(\frac{u+v}{2})\sinh(\frac{u-v}{2})",
    on=REAL,
    says=dlmf("4.35.8"),
)

section.identity(
    "4.35.9",
    r"\tanh u\pm\tanh v=\frac{\sinh(u\pm v)}{\cosh u\cosh v}",
    on=REAL,
    says=dlmf("4.35.9"),
)

section.identity(
    "4.35.10",
    r"\coth u\pm\coth v=\frac{\sinh(v\pm u)}{\sinh u\sinh v}",
    on=REAL,
    says=dlmf("4.35.10"),
)

section.identity("4.35.11", r"\cosh^2 z-\sinh^2 z = 1", on=REAL, says=dlmf("4.35.11"))

section.identity("4.35.12", r"\operatorname{sech}^2 z = 1-\tanh^2 z", on=REAL, says=dlmf("4.35.12"))

section.identity("4.35.13", r"\operatorname{csch}^2 z = \coth^2 z-1", on=REAL, says=dlmf("4.35.13"))

section.identity(
    "4.35.14", r"2\sinh u\sinh v = \cosh(u+v)-\cosh(u-v)", on=REAL, says=dlmf("4.35.14")
)

section.identity(
    "4.35.15", r"2\cosh u\cosh v = \cosh(u+v)+\cosh(u-v)", on=REAL, says=dlmf("4.35.15")
)

section.identity(
    "4.35.16", r"2\sinh u\cosh v = \sinh(u+v)+\sinh(u-v)", on=REAL, says=dlmf("4.35.16")
)

section.identity(
    "4.35.17", r"\sinh^2 u-\sinh^2 v = \sinh(u+v)\sinh(u-v)", on=REAL, says=dlmf("4.35.17")
)

section.identity(
    "4.35.18", r"\cosh^2 u-\cosh^2 v = \sinh(u+v)\sinh(u-v)", on=REAL, says=dlmf("4.35.18")
)

section.identity(
    "4.35.19", r"\sinh^2 u+\cosh^2 v = \cosh(u+v)\cosh(u-v)", on=REAL, says=dlmf("4.35.19")
)

with_root(
    section,
    "4.35.20",
    r"\sinh\frac{z}{2}=\sqrt{\frac{\cosh z-1}{2}}",
    r"\sqrt{\frac{\cosh z-1}{2}}",
)

with_root(
    section,
    "4.35.21",
    r"\cosh\frac{z}{2}=\sqrt{\frac{\cosh z+1}{2}}",
    r"\sqrt{\frac{\cosh z+1}{2}}",
)

with_root(
    section,
    "4.35.22",
    r"\tanh\frac{z}{2}=\sqrt{\frac{\cosh z-1}{\cosh z+1}}",
    r"\sqrt{\frac{\cosh z-1}{\cosh z+1}}",
)

section.identity(
    "4.35.22-rest",
    r"\tanh\frac{z}{2}=\frac{\cosh z-1}{\sinh z}=\frac{\sinh z}{\cosh z+1}",
    on=REAL,
    says=dlmf("4.35.22"),
)

section.identity("4.35.23", r"\sinh(-z) = -\sinh z", on=REAL, says=dlmf("4.35.23"))

section.identity("4.35.24", r"\cosh(-z) = \cosh z", on=REAL, says=dlmf("4.35.24"))

section.identity("4.35.25", r"\tanh(-z) = -\tanh z", on=REAL, says=dlmf("4.35.25"))

section.identity(
    "4.35.26",
    r"\sinh(2z) = 2\sinh z\cosh z = \frac{2\tanh z}{1-\tanh^2 z}",
    on=REAL,
    says=dlmf("4.35.26"),
)

section.identity(
    "4.35.27",
    r"\cosh(2z) = 2\cosh^2 z-1 = 2\sinh^2 z+1 = \cosh^2 z+\sinh^2 z",
    on=REAL,
    says=dlmf("4.35.27"),
)

section.identity(
    "4.35.28", r"\tanh(2z) = \frac{2\tanh z}{1+\tanh^2 z}", on=REAL, says=dlmf("4.35.28")
)

section.identity("4.35.29", r"\sinh(3z) = 3\sinh z+4\sinh^3 z", on=REAL, says=dlmf("4.35.29"))

section.identity("4.35.30", r"\cosh(3z) = -3\cosh z+4\cosh^3 z", on=REAL, says=dlmf("4.35.30"))

section.identity(
    "4.35.31", r"\sinh(4z) = 4\sinh^3 z\cosh z+4\cosh^3 z\sinh z", on=REAL, says=dlmf("4.35.31")
)

section.identity(
    "4.35.32", r"\cosh(4z) = \cosh^4 z+6\sinh^2 z\cosh^2 z+\sinh^4 z", on=REAL, says=dlmf("4.35.32")
)

section.identity(
    "4.35.34", r"\sinh z = \sinh x\cos y+i\cosh x\sin y", on=of_complex, says=dlmf("4.35.34")
)

section.identity(
    "4.35.35", r"\cosh z = \cosh x\cos y+i\sinh x\sin y", on=of_complex, says=dlmf("4.35.35")
)

section.identity(
    "4.35.36",
    r"\tanh z = \frac{\sinh(2x)+i\sin(2y)}{\cosh(2x)+\cos(2y)}",
    on=of_complex,
    says=dlmf("4.35.36"),
)

section.identity(
    "4.35.37",
    r"\coth z = \frac{\sinh(2x)-i\sin(2y)}{\cosh(2x)-\cos(2y)}",
    on=of_complex,
    says=dlmf("4.35.37"),
)

section.identity(
    "4.35.38",
    r"\lvert \sinh z\rvert=\sqrt{\sinh^2x+\sin^2y}=\sqrt{\frac{1}{2}(\cosh2x-\cos2y)}",
    on=of_complex.adjoining(r"\sqrt{\sinh^2x+\sin^2y}"),
    says=dlmf("4.35.38"),
)

section.identity(
    "4.35.39",
    r"\lvert \cosh z\rvert=\sqrt{\sinh^2x+\cos^2y}=\sqrt{\frac{1}{2}(\cosh2x+\cos2y)}",
    on=of_complex.adjoining(r"\sqrt{\sinh^2x+\cos^2y}"),
    says=dlmf("4.35.39"),
)

section.identity(
    "4.35.40",
    r"\lvert \tanh z\rvert=\sqrt{\frac{\cosh2x-\cos2y}{\cosh2x+\cos2y}}",
    on=of_complex.adjoining(r"\sqrt{\frac{\cosh2x-\cos2y}{\cosh2x+\cos2y}}"),
    says=dlmf("4.35.40"),
)
