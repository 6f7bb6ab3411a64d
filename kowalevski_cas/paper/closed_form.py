"""What a derivation offers to compute motions with: its formulas, on scenes of its own."""

from __future__ import annotations

from dataclasses import dataclass

from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed


@dataclass(frozen=True, eq=False)
class Values:
    r"""Some values as a function of some names.

    Args:
        scene: where everything is read.
        expressions: what is computed: TeX in the names of the scene, or a printed equation, of
            which it is the right side.
        arguments: the names, in the order in which a caller gives their values.
        supplied: parts of the expressions that a caller knows better than they can be computed,
            as :math:`s_1s_2-a^2`; each is an argument, and a variable of the scene.
    """

    scene: Scene
    expressions: tuple[str | Printed, ...]
    arguments: tuple[str, ...]
    supplied: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class ClosedForm:
    r"""The motions on N⁴ in closed form. A state is (ω, α, β), nine numbers.

    Args:
        equations: the rates of the nine variables, by the state.
        integrals: H, K, a², b², c, G, and the left sides of the two equations of N⁴, by the state.
        constants: :math:`x_1x_2`, :math:`x_1x_2+z_1z_2`, :math:`w_1w_2`, H, G, p², r⁴, by the
            state: polynomials from which m and ℓ are found.
        phase_point: the state by :math:`S_1, S_2, f_1, f_2, d, \psi`, the products
            :math:`s_1s_2-a^2`, :math:`s_1s_2-b^2`, :math:`\ell-2ms_1`, :math:`\ell-2ms_2`,
            :math:`rS_2`, and r; homogeneous of degree zero in those that involve :math:`s_1`
            (with :math:`S_1, f_1, rS_2` and d): a common factor changes nothing.
        complex_variables: the eight complex variables and :math:`\omega_3`, by the state and i.
        across: :math:`F_1, F_2, U_1, U_2`, by those and :math:`\sqrt{x_1x_2}`.
        across_rates: the rates of :math:`F_1, F_2` in the time :math:`\tau=it`, linear in them,
            by :math:`F_1, F_2, U_1, U_2, x_1, x_2` and :math:`\sqrt{x_1x_2}`.
    """

    equations: Values
    integrals: Values
    constants: Values
    phase_point: Values
    complex_variables: Values
    across: Values
    across_rates: Values


@dataclass(frozen=True, eq=False)
class CriticalSets:
    r"""Where the integrals of the top are dependent, and what their values are there.

    Args:
        M4: the two functions that vanish on M⁴, by the complex variables and :math:`\omega_3`.
        N4: the two that vanish on N⁴, by the same.
        O4: the five that vanish on O⁴, by the same and s.
        M4_values: k and :math:`p^2h-2g` on M⁴, by j.
        N4_values: k and :math:`2g-p^2h` on N⁴, by m and r.
    """

    M4: Values
    N4: Values
    O4: Values
    M4_values: Values
    N4_values: Values


@dataclass(frozen=True, eq=False)
class LevelsOnM4:
    r"""The levels of H and J₃ on M⁴.

    Args:
        polynomial: the value at ξ of the polynomial whose real roots count the tori of a level,
            by :math:`\xi, h, j, p, r`.
    """

    polynomial: Values


@dataclass(frozen=True, eq=False)
class HyperellipticForm:
    r"""The motions on O⁴ by two variables on a curve of genus 2, :math:`u_1` and :math:`u_2=n/v`.

    The radicals are :math:`\mu_1, A_1, B_1, K_1`, which belong to :math:`u_1`, and
    :math:`\hat\mu_2, \hat A_2, \hat B_2, \hat K_2`, which belong to n and v.

    Args:
        constants: :math:`s, \tau_3, x_1x_2, x_1x_2+z_1z_2` by the complex variables.
        variables: :math:`q^2`, the numerators of :math:`u_1, u_2`, their denominator and the
            numerator of :math:`u_1u_2`, by :math:`X, \xi, \tau_3, \sigma, q`.
        integrals: h, k, g, by :math:`s, \tau_3, p, r`.
        curvature: the second derivative of the polynomial of which s is a double root, by the same.
        products: of the sum and the difference of :math:`2s, \mu_1` and of :math:`2sv, \hat\mu_2`,
            by :math:`K_1, \hat K_2, s, \tau_3, r`.
        resolvents: :math:`\hat V, \hat d` by these sums and differences, and s.
        parts: :math:`\hat\Pi`, two forms of :math:`\hat Y`, :math:`\hat T, \hat\Lambda, \hat N` by
            v, the radicals, :math:`s, \tau_3, p, r` and :math:`\hat d`.
        quotients: two forms of :math:`\hat E` by :math:`P_1, Q_1, \hat P_2, \hat Q_2,
            \sqrt\sigma, vu_1+n`.
        conjugate_quotients: two forms by :math:`a_1, b_1, a_2, b_2, \rho, vu_1+n`, for
            :math:`\sigma=-\rho^2`.
        phase_point: the state by the radicals, :math:`\hat E`, the parts, :math:`s, \tau_3, r`
            and :math:`vu_1-n`; homogeneous of degree zero in n, v.
    """

    constants: Values
    variables: Values
    integrals: Values
    curvature: Values
    products: Values
    resolvents: Values
    parts: Values
    quotients: Values
    conjugate_quotients: Values
    phase_point: Values
