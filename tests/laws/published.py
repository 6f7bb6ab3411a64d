r"""Misprints in public lecture notes, and what their authors read in their place.

Each entry has its source (repository, commit), the formulas that stand beside it there (equations of
motion and definitions), what is claimed there, and the formula as it was printed and as it was
mended. The misprint is marked as PRINT where it stands. Names of functions and increments are
written as plain letters. The first half was looked at while rules were made, the second half was
not.
"""

from typing import NamedTuple


class Published(NamedTuple):
    """A correction in its context; the wrong formula is in the display, or it is the claim."""

    repository: str
    commit: str
    display: str
    claims: tuple[str, ...]
    printed: str
    mended: str


NOTES, ORBITS = "dalcde/cam-notes", "bryanwweber/orbital-mechanics-notes"
BOOSTED = r"\dot X=1,\ \dot T=k,\ \gamma=\frac1{\sqrt{1-\frac{v^2}{c^2}}},\ P=\gamma(T-\frac{vX}{c^2}),\ Q=\gamma(X-vT)"
FREE = r"\dot x=1,\ \ddot v=u,\ \dot u=k"

SEEN = (
    Published(
        NOTES, "1f3f63e", r"\dot y=w,\ \dot w=\lambda", (),
        r"y-\lambda\sqrt{1+w^2}-\frac{\lambda w^2}{\sqrt{1+w^2}}=y-\frac\lambda{\sqrt{1+w^2}}",
        r"y-\lambda\sqrt{1+w^2}+\frac{\lambda w^2}{\sqrt{1+w^2}}=y-\frac\lambda{\sqrt{1+w^2}}",
    ),
    Published(
        NOTES, "9e86f0e", BOOSTED, (),
        r"c^2P^2-Q^2=\gamma^2(1-\frac{v^2}{c^2})(c^2T-X^2)",
        r"c^2P^2-Q^2=\gamma^2(1-\frac{v^2}{c^2})(c^2T^2-X^2)",
    ),
    Published(
        NOTES, "9e86f0e", BOOSTED, (r"c^2P^2-Q^2=\gamma^2(1-\frac{v^2}{c^2})(c^2T^2-X^2)",),
        r"c^2P^2-Q^2=c^2T-X^2", r"c^2P^2-Q^2=c^2T^2-X^2",
    ),
    Published(
        NOTES, "8dd730a", r"\dot x=1,\ y=e^{2x}", (),
        r"\ddot y-4y+4y=0", r"\ddot y-4\dot y+4y=0",
    ),
    Published(
        NOTES, "739cb45", r"\dot x=6y(y-x),\ \dot y=-(2x-3y^2)", (),
        r"x^2-3xy^2+3y^3", r"x^2-3xy^2+2y^3",
    ),
    Published(
        NOTES, "4ea52c1", rf"{FREE},\ y=ve^{{2x}}", (r"\dot y=(\dot v+2v)e^{2x}",),
        r"\ddot y=(\ddot v+4\ddot v+4v)e^{2x}", r"\ddot y=(\ddot v+4\dot v+4v)e^{2x}",
    ),
    Published(
        NOTES, "fb14acd", r"\dot x=s\cos\theta,\ \dot y=s\sin\theta,\ \dot\theta=k", (),
        r"(\dot x\sin\theta)^2=(\dot y\sin\theta)^2", r"(\dot x\sin\theta)^2=(\dot y\cos\theta)^2",
    ),
    Published(
        NOTES, "6c786a3", r"M\dot x=Mv,\ v=u-\mu gs,\ w=\frac{5\mu g}{2a}s,\ s=\frac{2u}{7\mu g}",
        (r"v=aw", r"\frac12Mv^2+\frac15Ma^2w^2=\frac5{14}Mu^2"),
        r"v=\frac67u", r"v=\frac57u",
    ),
    Published(
        NOTES, "6c786a3", r"\dot v=a,\ \gamma=\frac1{\sqrt{1-\frac{v^2}{c^2}}},\ P=m\gamma c,\ E=m\gamma c^2",
        (r"E^2=m^2c^4+m^2\gamma^2v^2c^2",),
        r"E=P", r"E=Pc",
    ),
    Published(
        NOTES, "2465386",
        r"\dot w=1,\ \dot s=k,\ y=ws,\ x=\gamma(y+vs),\ z=\gamma(s+\frac v{c^2}y),\ u=\frac xz", (),
        r"u=\frac{u+v}{1+\frac{wv}{c^2}}", r"u=\frac{w+v}{1+\frac{wv}{c^2}}",
    ),
    Published(
        NOTES, "1ef385d", r"I\ddot\theta=-Mg\frac l2\sin\theta,\ I=\frac13Ml^2", (),
        r"\frac12I\dot\Theta^2-Mg\frac l2\cos\theta", r"\frac12I\dot\theta^2-Mg\frac l2\cos\theta",
    ),
    Published(
        NOTES, "1ef385d", r"I\ddot\theta=-Mg\frac l2\sin\theta,\ I=\frac13ml^2",
        (r"\ddot\theta=-\frac{3g}{2l}\sin\theta", r"\frac12I\dot\theta^2-Mg\frac l2\cos\theta"),
        r"I=\frac13ml^2", r"I=\frac13Ml^2",
    ),
    Published(
        NOTES, "4f77296", r"\dot x=1,\ y=\frac13x+\frac5{18}+\frac12e^{4x}", (),
        r"\ddot y-4\dot y+6y=2x+e^{4x}", r"\ddot y-5\dot y+6y=2x+e^{4x}",
    ),
    Published(
        NOTES, "2465386", r"\dot u=a,\ \gamma=\frac1{\sqrt{1-\frac{u^2}{c^2}}},\ E=\mu\gamma c^2",
        (r"E^2=m^2c^4+m^2\gamma^2u^2c^2",),
        r"E=\mu\gamma c^2", r"E=m\gamma c^2",
    ),
    Published(
        NOTES, "fb99e1d", r"\dot x=1,\ \dot y=k,\ f=x^2+e^{xy^2}", (),
        r"\frac{\partial f}{\partial y}=2x+y^2e^{xy^2}", r"\frac{\partial f}{\partial x}=2x+y^2e^{xy^2}",
    ),
    Published(
        ORBITS, "0cd8395",
        r"\ddot x=\frac{Gm(u-x)}{r^3},\ \ddot y=\frac{Gm(v-y)}{r^3},\ "
        r"\ddot u=\frac{Gn(u-x)}{r^3},\ \ddot v=-\frac{Gn(v-y)}{r^3},\ r=\sqrt{(u-x)^2+(v-y)^2}",
        (r"n\ddot x+m\ddot u=0", r"\ddot u-\ddot x=-\frac{G(m+n)(u-x)}{r^3}"),
        r"\ddot u=\frac{Gn(u-x)}{r^3}", r"\ddot u=-\frac{Gn(u-x)}{r^3}",
    ),
    Published(
        ORBITS, "6e9ae37",
        r"\dot\nu=k,\ v=\frac\mu h(1+e\cos\nu),\ w=\frac\mu he\sin\nu", (),
        r"\frac wv=\frac{e\sin\theta}{1+e\cos\nu}", r"\frac wv=\frac{e\sin\nu}{1+e\cos\nu}",
    ),
    Published(
        ORBITS, "b7987bc", r"\ddot x=-\frac{\mu x}{r^3},\ \ddot y=-\frac{\mu y}{r^3},\ r=\sqrt{x^2+y^2}",
        (), r"\frac{\dot x^2+\dot y^2}2-\frac{mu}r", r"\frac{\dot x^2+\dot y^2}2-\frac\mu r",
    ),
)  # fmt: skip

VECTORS = r"\mathbf r=(x,y,z),\ \mathbf F=(f,g,h)"

UNSEEN = (
    Published(
        NOTES, "e0979c0", r"\dot x=x,\ \dot y=xp,\ \dot p=xq,\ \dot q=xs", (r"\dot y=xp",),
        r"a^2\ddot y+(b-a)\dot y+cy=ax^2q+bxp+cy", r"a\ddot y+(b-a)\dot y+cy=ax^2q+bxp+cy",
    ),
    Published(
        NOTES, "44a2bee", rf"m\ddot{{\mathbf r}}=\mathbf F,\ T=\frac12m\dot{{\mathbf r}}^2,\ {VECTORS}",
        (r"\dot T=m\dot{\mathbf r}\cdot\ddot{\mathbf r}",),
        r"\dot T=\mathbf F\cdot\mathbf r", r"\dot T=\mathbf F\cdot\dot{\mathbf r}",
    ),
    Published(
        NOTES, "579c7a8", r"\dot x=1,\ \dot y=k,\ i^2=-1,\ z=x+iy,\ w=c+id", (),
        r"(p+iq)(z-w)=p(x-c)-q(y-d)+i(q(x-c)+p(y-c))",
        r"(p+iq)(z-w)=p(x-c)-q(y-d)+i(q(x-c)+p(y-d))",
    ),
    Published(
        NOTES, "959d5ff",
        r"\dot{\mathbf a}=\mathbf b,\ \dot{\mathbf b}=\mathbf c,\ \dot{\mathbf c}=\mathbf a,\ "
        r"\mathbf a=(a_1,a_2,a_3),\ \mathbf b=(b_1,b_2,b_3),\ \mathbf c=(c_1,c_2,c_3)", (),
        r"(\mathbf a\times\mathbf b)\cdot(\mathbf b\times\mathbf c)="
        r"(\mathbf a\cdot\mathbf a)(\mathbf b\cdot\mathbf c)-(\mathbf a\cdot\mathbf b)(\mathbf a\cdot\mathbf c)",
        r"(\mathbf a\times\mathbf b)\cdot(\mathbf a\times\mathbf c)="
        r"(\mathbf a\cdot\mathbf a)(\mathbf b\cdot\mathbf c)-(\mathbf a\cdot\mathbf b)(\mathbf a\cdot\mathbf c)",
    ),
    Published(
        NOTES, "8c1bd02", r"\dot x=1,\ y=Ae^{(2+\varepsilon)x}+Be^{(2-\varepsilon)X}",
        (r"\ddot y-4\dot y+(4-\varepsilon^2)y=0",),
        r"y=Ae^{(2+\varepsilon)x}+Be^{(2-\varepsilon)X}", r"y=Ae^{(2+\varepsilon)x}+Be^{(2-\varepsilon)x}",
    ),
    Published(
        NOTES, "d44570c", r"m\ddot x=-kx,\ T=\frac12m\dot x,\ V=\frac12kx^2", (r"T+V", r"\dot V=kx\dot x"),
        r"T=\frac12m\dot x", r"T=\frac12m\dot x^2",
    ),
    Published(
        NOTES, "e90a677", r"\dot a=b,\ \dot b=k,\ i^2=-1,\ z=a+ib,\ w=c+id", (),
        r"z+w=(a+c)+(b+d)", r"z+w=(a+c)+i(b+d)",
    ),
    Published(
        NOTES, "95f2b58", r"\dot x=y,\ \dot y=z,\ \dot z=x,\ s=x^2+y^2+z^2", (),
        r"\gamma^2(x^2+y^2+z^2)=(\gamma^2-1)x^2+s", r"\gamma^2x^2+y^2+z^2=(\gamma^2-1)x^2+s",
    ),
    Published(
        NOTES, "39ffcfc", r"\dot R=1,\ \dot S=1,\ \dot U=1,\ W=\frac{q_1q_1}{4\pi\varepsilon R},\ "
        r"V=\frac{q_3}{4\pi\varepsilon}(\frac{q_1}S+\frac{q_2}U)",
        (r"W+V=\frac1{4\pi\varepsilon}(\frac{q_1q_2}R+\frac{q_1q_3}S+\frac{q_2q_3}U)",),
        r"W=\frac{q_1q_1}{4\pi\varepsilon R}", r"W=\frac{q_1q_2}{4\pi\varepsilon R}",
    ),
    Published(
        NOTES, "39ffcfc", r"\dot R=1,\ \dot S=1,\ \dot U=1,\ W=\frac{q_1q_2}{4\pi\varepsilon R},\ "
        r"V=\frac{q_3}{4\pi\varepsilon}(\frac{q_1}S-\frac{q_2}U)",
        (r"W+V=\frac1{4\pi\varepsilon}(\frac{q_1q_2}R+\frac{q_1q_3}S+\frac{q_2q_3}U)",),
        r"V=\frac{q_3}{4\pi\varepsilon}(\frac{q_1}S-\frac{q_2}U)",
        r"V=\frac{q_3}{4\pi\varepsilon}(\frac{q_1}S+\frac{q_2}U)",
    ),
    Published(
        NOTES, "6c786a3",
        r"m\ddot x=-kx,\ m\ddot y=-ky,\ V=\frac12k(x^2+y^2),\ E=\frac12m(\dot x^2+\dot y^2)+V", ("E",),
        r"\dot E=\frac d{dt}(\frac12(\dot x^2+\dot y^2)+V)", r"\dot E=\frac d{dt}(\frac12m(\dot x^2+\dot y^2)+V)",
    ),
    Published(
        NOTES, "bfb9b32", r"\ddot x=-2\kappa\dot x-x,\ \lambda=-\kappa+\sqrt{\kappa^2-1}", (),
        r"\lambda+2\kappa\lambda+1=0", r"\lambda^2+2\kappa\lambda+1=0",
    ),
    Published(
        NOTES, "7a3ba0e", r"\ddot u=\frac k{h^2}-u", (),
        r"\frac12mh^2(\dot u+u^2)-mku", r"\frac12mh^2(\dot u^2+u^2)-mku",
    ),
    Published(
        NOTES, "7287642", r"\dot s=1,\ u=\frac{qEs}{\sqrt{m^2q^2E^2s^2/c^2}}",
        (r"\frac{m^2u^2}{1-\frac{u^2}{c^2}}=q^2E^2s^2",),
        r"u=\frac{qEs}{\sqrt{m^2q^2E^2s^2/c^2}}", r"u=\frac{qEs}{\sqrt{m^2+q^2E^2s^2/c^2}}",
    ),
    Published(
        NOTES, "2465386", r"\dot\theta=\frac h{r^2},\ r=\frac l{1+e\cos\theta},\ x=r\cos\theta,\ y=r\sin\theta,\ "
        r"a=\frac l{e^2-1},\ b=\frac l{\sqrt{e^2-1}}", (),
        r"\frac{(x-ea)^2}{a^2}+\frac{y^2}{b^2}=1", r"\frac{(x-ea)^2}{a^2}-\frac{y^2}{b^2}=1",
    ),
    Published(
        NOTES, "2dbbefb", r"\dot\theta=\frac h{r^2},\ r=\frac l{1+e\cos\theta},\ h=\sqrt{kl}", (),
        r"\frac12m(\dot r^2+r^2\dot\theta^2)-\frac{mk}r=\frac{mk^2}{2l}(e^2-1)",
        r"\frac12m(\dot r^2+r^2\dot\theta^2)-\frac{mk}r=\frac{mk}{2l}(e^2-1)",
    ),
    Published(
        NOTES, "25e0936",
        rf"m\ddot{{\mathbf r}}=\mathbf F,\ \mathbf L=m\mathbf r\times\dot{{\mathbf r}},\ {VECTORS}",
        (r"\dot{\mathbf L}=\mathbf r\times\mathbf F",),
        r"\dot{\mathbf L}=m+\mathbf r\times\ddot{\mathbf r}", r"\dot{\mathbf L}=m\mathbf r\times\ddot{\mathbf r}",
    ),
    Published(
        ORBITS, "a64feae", r"\ddot x=-\frac{\mu x}{r^3},\ \ddot y=-\frac{\mu y}{r^3},\ r=\sqrt{x^2+y^2}",
        (), r"\frac{\dot x^2+\dot y^2}2+(C-\frac{mu}r)", r"\frac{\dot x^2+\dot y^2}2+(C-\frac\mu r)",
    ),
)  # fmt: skip
