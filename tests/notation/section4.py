"""Formulas from the papers that continue the story: separation, Lax pair, critical sets."""

from kowalevski_cas.notation import Vocabulary

WORDS = Vocabulary(
    scalars=frozenset(
        r"""a b c d g h k m n p r s i \ell \psi \mu \kappa \sigma A B C D G H K X c_1 c_2
        x_1 x_2 y_1 y_2 z_1 z_2 w_1 w_2 s_1 s_2 S_1 S_2 f_1 f_2 u_1 u_2 u_i U_1 U_2 F_1 R_1 R_2
        \tau_3 \xi \omega_1 \omega_2 \omega_3 \alpha_1 \alpha_2 \alpha_3 \beta_1 \beta_2 \beta_3
        \gamma_1 \gamma_2 \gamma_3 \mathrm{sn}""".split()
    ),
    vectors=frozenset([r"\alpha", r"\beta", r"\gamma"]),
    matrices=frozenset(["L", "M"]),
    functions=frozenset([r"\varphi", r"\det"]),
    times=frozenset(["t", r"\tau"]),
)

FORMULAS = r"""
G = (\omega_1\alpha_1+\omega_2\alpha_2+\tfrac12\omega_3\alpha_3)^2+(\omega_1\beta_1+\omega_2\beta_2+\tfrac12\omega_3\beta_3)^2 +\omega_3(\omega_1\gamma_1+\omega_2\gamma_2+\tfrac12\omega_3\gamma_3)-b^2\alpha_1-a^2\beta_2+c(\alpha_2+\beta_1), \quad \gamma=\alpha\times\beta
2G - p^2H = \tfrac12(U_1+U_2) - \tfrac12F_1^2
c_1c_2K = U_1U_2
L' = LM - ML
L = \begin{pmatrix} 0 & x_2/\kappa & -2w_2 & z_2/\kappa\\ -x_1/\kappa & 0 & -z_1/\kappa & 2w_1\\ -2w_1 & z_2/\kappa & -2\omega_3 & -y_1/\kappa-4\kappa\\ -z_1/\kappa & 2w_2 & y_2/\kappa+4\kappa & 2\omega_3\end{pmatrix}
M = \begin{pmatrix} -\omega_3/2 & 0 & w_2/2 & 0\\ 0 & \omega_3/2 & 0 & -w_1/2\\ w_1/2 & 0 & \omega_3/2 & \kappa\\ 0 & -w_2/2 & -\kappa & -\omega_3/2\end{pmatrix}
\det(L-\mu) = \mu^4+(16\kappa^2-8H+2p^2/\kappa^2)\mu^2+16K+8(2G-p^2H)/\kappa^2+c_1c_2/\kappa^4
m = \frac{1}{c_2}\frac{x_2}{x_1}(w_1^2+x_1), \qquad \ell = \frac{1}{\sqrt{x_1x_2}}\left[w_1w_2+(x_1x_2+z_1z_2)m\right]
k = r^4m^2, \qquad 2g-p^2h = r^4m, \qquad \ell^2 = 2p^2m^2+2hm+1
s_1 = \frac{x_1x_2+z_1z_2+r^2}{2\sqrt{x_1x_2}}, \qquad s_2 = \frac{x_1x_2+z_1z_2-r^2}{2\sqrt{x_1x_2}}
\varphi(s) = 4ms^2-4\ell s+(\ell^2-1)/m
4\dot s_1^2 = -(s_1^2-a^2)\varphi(s_1), \qquad 4\dot s_2^2 = (b^2-s_2^2)\varphi(s_2)
\alpha_1 = \frac{(s_1s_2-a^2)\psi+S_1S_2f_1f_2}{2d^2},\quad \alpha_2 = \frac{(s_1s_2-a^2)f_1f_2-S_1S_2\psi}{2d^2},\quad \alpha_3 = \frac{rS_1}{d}
\beta_1 = -\frac{(s_1s_2-b^2)f_1f_2-S_1S_2\psi}{2d^2},\quad \beta_2 = \frac{(s_1s_2-b^2)\psi+S_1S_2f_1f_2}{2d^2},\quad \beta_3 = \frac{rS_2}{d}
\omega_1 = \frac{r(\ell-2ms_1)f_2}{2d},\quad \omega_2 = \frac{r(\ell-2ms_2)f_1}{2d},\quad \omega_3 = -\frac{S_2f_1+S_1f_2}{d},\qquad \dot s_1 = \tfrac12S_1f_1,\quad \dot s_2 = \tfrac12S_2f_2
s_1 = \frac{B-C\kappa\,{\rm sn}^2}{1-\kappa\,{\rm sn}^2}, \qquad s_2 = \frac{D(A-C)+A(C-D)\,{\rm sn}^2}{(A-C)+(C-D)\,{\rm sn}^2}
R_1 = w_2A-w_1B = 0, \qquad R_2 = 2w_1w_2\left(\frac{A}{w_1}-\frac{B}{w_2}\right)' = 0
h = \frac{p^2-\tau_3}{2s}+s, \quad k = \frac{\tau_3^2-2p^2\tau_3+r^4}{4s^2}+\tau_3, \quad g = \frac{p^4-r^4}{4s}+\frac{(p^2-\tau_3)s}{2},
(u_1-u_2)^2\,\dot u_i^2 = \frac{1}{2s\tau_3}(u_i^2-\sigma)(u_i^2-4s^2k)\left((u_i+\tau_3)^2-r^4\right)
""".strip().splitlines()
