r"""4.21. Identities of trigonometric functions."""

from kowalevski_cas.paper.derivation import Scene, Section

from .setting import REAL, complex_argument, dlmf, with_root

section = Section("4.21", "Identities of trigonometric functions", copied=False)

of_complex = complex_argument(section)

section.identity(
    "4.21.1",
    r"\sin u\pm\cos u=\sqrt{2}\sin(u\pm\frac{\pi}{4})=\pm\sqrt{2}\cos(u\mp\frac{\pi}{4})",
    on=REAL,
    says=dlmf("4.21.1"),
)

phase = section.lemma(
    "ph-4.21",
    r"\cos\varphi=\frac{A}{\sqrt{A^2+B^2}}, \quad \sin\varphi=\frac{B}{\sqrt{A^2+B^2}}",
    r"https://dlmf.nist.gov/1.9#i: $\varphi$ is the phase of $A+iB$",
)
section.identity(
    "4.21.1_5",
    r"A\cos u+B\sin u=\sqrt{A^2+B^2}\cos(u-\varphi)",
    on=REAL.having(constants=("A", "B", r"\varphi")).adjoining(r"\sqrt{A^2+B^2}").taking(phase),
    says=dlmf("4.21.1_5"),
)

section.identity(
    "4.21.2", r"\sin(u\pm v)=\sin u\cos v\pm\cos u\sin v", on=REAL, says=dlmf("4.21.2")
)

section.identity(
    "4.21.3", r"\cos(u\pm v)=\cos u\cos v\mp\sin u\sin v", on=REAL, says=dlmf("4.21.3")
)

section.identity(
    "4.21.4", r"\tan(u\pm v)=\frac{\tan u\pm\tan v}{1\mp\tan u\tan v}", on=REAL, says=dlmf("4.21.4")
)

section.identity(
    "4.21.5",
    r"\cot(u\pm v)=\frac{\pm\cot u\cot v-1}{\cot u\pm\cot v}",
    on=REAL,
    says=dlmf("4.21.5"),
)

section.identity(
    "4.21.6",
    r"\sin u+\sin v = 2\sin(\frac{u+v}{2})\cos(\frac{u-v}{2})",
    on=REAL,
    says=dlmf("4.21.6"),
)

section.identity(
    "4.21.7",
    r"\sin u-\sin v = 2\cos(\frac{u+v}{2})\sin(\frac{u-v}{2})",
    on=REAL,
    says=dlmf("4.21.7"),
)

section.identity(
    "4.21.8",
    r"\cos u+\cos v = 2\cos(\frac{u+v}{2})\cos(\frac{u-v}{2})",
    on=REAL,
    says=dlmf("4.21.8"),
)

section.identity(
    "4.21.9",
    r"\cos u-\cos v = -2\sin(\frac{u+v}{2})\sin(\frac{u-v}{2})",
    on=REAL,
    says=dlmf("4.21.9"),
)

section.identity(
    "4.21.10", r"\tan u\pm\tan v=\frac{\sin(u\pm v)}{\cos u\cos v}", on=REAL, says=dlmf("4.21.10")
)

section.identity(
    "4.21.11", r"\cot u\pm\cot v=\frac{\sin(v\pm u)}{\sin u\sin v}", on=REAL, says=dlmf("4.21.11")
)

section.identity("4.21.12", r"\sin^2 z+\cos^2 z = 1", on=REAL, says=dlmf("4.21.12"))

section.identity("4.21.13", r"\sec^2 z = 1+\tan^2 z", on=REAL, says=dlmf("4.21.13"))

section.identity("4.21.14", r"\csc^2 z = 1+\cot^2 z", on=REAL, says=dlmf("4.21.14"))

section.identity("4.21.15", r"2\sin u\sin v = \cos(u-v)-\cos(u+v)", on=REAL, says=dlmf("4.21.15"))

section.identity("4.21.16", r"2\cos u\cos v = \cos(u-v)+\cos(u+v)", on=REAL, says=dlmf("4.21.16"))

section.identity("4.21.17", r"2\sin u\cos v = \sin(u-v)+\sin(u+v)", on=REAL, says=dlmf("4.21.17"))

section.identity(
    "4.21.18", r"\sin^2 u-\sin^2 v = \sin(u+v)\sin(u-v)", on=REAL, says=dlmf("4.21.18")
)

section.identity(
    "4.21.19", r"\cos^2 u-\cos^2 v = -\sin(u+v)\sin(u-v)", on=REAL, says=dlmf("4.21.19")
)

section.identity(
    "4.21.20", r"\cos^2 u-\sin^2 v = \cos(u+v)\cos(u-v)", on=REAL, says=dlmf("4.21.20")
)

with_root(
    section, "4.21.21", r"\sin\frac{z}{2}=\sqrt{\frac{1-\cos z}{2}}", r"\sqrt{\frac{1-\cos z}{2}}"
)

with_root(
    section, "4.21.22", r"\cos\frac{z}{2}=\sqrt{\frac{1+\cos z}{2}}", r"\sqrt{\frac{1+\cos z}{2}}"
)

with_root(
    section,
    "4.21.23",
    r"\tan\frac{z}{2}=\sqrt{\frac{1-\cos z}{1+\cos z}}",
    r"\sqrt{\frac{1-\cos z}{1+\cos z}}",
)

section.identity(
    "4.21.23-rest",
    r"\tan\frac{z}{2}=\frac{1-\cos z}{\sin z}=\frac{\sin z}{1+\cos z}",
    on=REAL,
    says=dlmf("4.21.23"),
)

section.identity("4.21.24", r"\sin(-z) = -\sin z", on=REAL, says=dlmf("4.21.24"))

section.identity("4.21.25", r"\cos(-z) = \cos z", on=REAL, says=dlmf("4.21.25"))

section.identity("4.21.26", r"\tan(-z) = -\tan z", on=REAL, says=dlmf("4.21.26"))

section.identity(
    "4.21.27",
    r"\sin(2z) = 2\sin z\cos z = \frac{2\tan z}{1+\tan^2 z}",
    on=REAL,
    says=dlmf("4.21.27"),
)

section.identity(
    "4.21.28",
    r"\cos(2z) = 2\cos^2 z-1 = 1-2\sin^2 z = \cos^2 z-\sin^2 z = \frac{1-\tan^2 z}{1+\tan^2 z}",
    on=REAL,
    says=dlmf("4.21.28"),
)

section.identity(
    "4.21.29",
    r"\tan(2z) = \frac{2\tan z}{1-\tan^2 z} = \frac{2\cot z}{\cot^2 z-1} = \frac{2}{\cot z-\tan z}",
    on=REAL,
    says=dlmf("4.21.29"),
)

section.identity("4.21.30", r"\sin(3z) = 3\sin z-4\sin^3 z", on=REAL, says=dlmf("4.21.30"))

section.identity("4.21.31", r"\cos(3z) = -3\cos z+4\cos^3 z", on=REAL, says=dlmf("4.21.31"))

section.identity(
    "4.21.32", r"\sin(4z) = 8\cos^3 z\sin z-4\cos z\sin z", on=REAL, says=dlmf("4.21.32")
)

section.identity("4.21.33", r"\cos(4z) = 8\cos^4 z-8\cos^2 z+1", on=REAL, says=dlmf("4.21.33"))

half_tangent = section.display("4.21.36", r"t=\tan\frac{z}{2}")
section.identity(
    "4.21.36-rest",
    r"\sin z=\frac{2t}{1+t^2}, \quad \cos z=\frac{1-t^2}{1+t^2}",
    on=REAL.defining(half_tangent),
    says=dlmf("4.21.36"),
)
section.identity(
    "4.21.36-dz",
    r"\frac{dt}{dz}=\frac{1+t^2}{2}",
    on=Scene("z moves", time="z").defining(half_tangent),
    says=dlmf("4.21.36"),
)

section.identity(
    "4.21.37", r"\sin z = \sin x\cosh y+i\cos x\sinh y", on=of_complex, says=dlmf("4.21.37")
)

section.identity(
    "4.21.38", r"\cos z = \cos x\cosh y-i\sin x\sinh y", on=of_complex, says=dlmf("4.21.38")
)

section.identity(
    "4.21.39",
    r"\tan z = \frac{\sin(2x)+i\sinh(2y)}{\cos(2x)+\cosh(2y)}",
    on=of_complex,
    says=dlmf("4.21.39"),
)

section.identity(
    "4.21.40",
    r"\cot z = \frac{\sin(2x)-i\sinh(2y)}{\cosh(2y)-\cos(2x)}",
    on=of_complex,
    says=dlmf("4.21.40"),
)

section.identity(
    "4.21.41",
    r"\lvert \sin z\rvert=\sqrt{\sin^2x+\sinh^2y}=\sqrt{\frac{1}{2}(\cosh2y-\cos2x)}",
    on=of_complex.adjoining(r"\sqrt{\sin^2x+\sinh^2y}"),
    says=dlmf("4.21.41"),
)

section.identity(
    "4.21.42",
    r"\lvert \cos z\rvert=\sqrt{\cos^2x+\sinh^2y}=\sqrt{\frac{1}{2}(\cosh2y+\cos2x)}",
    on=of_complex.adjoining(r"\sqrt{\cos^2x+\sinh^2y}"),
    says=dlmf("4.21.42"),
)

section.identity(
    "4.21.43",
    r"\lvert \tan z\rvert=\sqrt{\frac{\cosh2y-\cos2x}{\cosh2y+\cos2x}}",
    on=of_complex.adjoining(r"\sqrt{\frac{\cosh2y-\cos2x}{\cosh2y+\cos2x}}"),
    says=dlmf("4.21.43"),
)
