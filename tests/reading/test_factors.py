"""Names in the factors of a polynomial are its roots."""

from random import Random

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

LAW = r"A particle moves by $$\ddot x=a-3bx^2.$$"
POLYNOMIAL = (
    r"Let $$F(s)=2h+2as-2bs^3,\qquad h=\tfrac12\dot x^2-ax+bx^3.$$ Its roots are real, and"
    r"$$F(s)=-2b(s-s_1)(s-s_2)(s-s_3).$$"
)


@pytest.mark.parametrize(
    ("claim", "green"),
    sampled(
        [
            (r"s_1+s_2+s_3=0", True),
            (r"s_1s_2s_3=\frac hb", True),
            (r"s_1s_2+s_2s_3+s_3s_1=-\frac ab", True),
            (r"s_1+s_2+s_3=3a", False),
            (r"s_1s_2s_3=-\frac hb", False),
            (r"s_1s_2+s_2s_3+s_3s_1=\frac ab", False),
        ],
        2,
    ),
)
def test_coefficients_are_those_of_the_roots(claim, green):
    found = verdicts(rf"{LAW} {POLYNOMIAL} Hence $${claim}.$$")
    assert found[claim].green is green
    assert Verdict.REFUTED not in found.values()


@pytest.mark.parametrize("seed", sampled(range(12), 2))
def test_roots_of_any_quadratic_have_its_sum_and_product(seed):
    random = Random(seed)
    lead, shift, sign = random.choice((1, 2, 3)), random.randint(-3, 3), random.choice("+-")
    law = r"The motion is $$\dot u=v,\qquad \dot v=-c u.$$"
    text = rf"""{law} Let $$G(z)={lead}z^2{shift:+}z-c.$$ With its roots,
    $$G(z)={lead}(z-\alpha)(z-\beta).$$ Then $$\alpha+\beta={sign}\frac{{{shift}}}{{{lead}}},\qquad
    \alpha\beta=-\frac{{c}}{{{lead}}}.$$"""
    factored, total, product = verdicts(text).values()
    assert factored.green
    assert product.green
    assert total.green is (sign == "-" or not shift)


@pytest.mark.parametrize(
    "factored",
    [
        r"F(s)=-2b(s-s_1)(s-s_2)(s-s_3)",
        r"F(s)=2b(s_1-s)(s-s_2)(s-s_3)",
        r"F(s)=2b(s-s_1)(s_2-s)(s-s_3)",
    ],
)
def test_a_factor_may_have_either_sign(factored):
    text = POLYNOMIAL.replace(r"F(s)=-2b(s-s_1)(s-s_2)(s-s_3)", factored)
    assert verdicts(rf"{LAW} {text} Hence $$s_1+s_2+s_3=0.$$")["s_1+s_2+s_3=0"].green


@pytest.mark.slow
def test_another_leading_coefficient_is_wrong_and_the_roots_are_the_same():
    text = POLYNOMIAL.replace("-2b(s-s_1)", "-3b(s-s_1)")
    found = verdicts(rf"{LAW} {text} Hence $$s_1+s_2+s_3=0,\qquad s_1s_2s_3=\frac{{2h}}{{3b}}.$$")
    assert [one.green for one in found.values()] == [False, True, False]


def test_known_names_in_factors_are_claimed_to_be_roots():
    text = rf"{LAW} Let $$F(s)=s^2-3as+2a^2,\qquad d=2a.$$ Then $$F(s)=(s-a)(s-d).$$"
    assert verdicts(text)["F(s)=(s-a)(s-d)"].green
    found = reading(text.replace("d=2a", "d=3a"))
    assert [one.role.kind for one in found.formulas][-1] == "identity"


@pytest.mark.parametrize("seed", sampled(range(12), 2))
def test_a_functional_identity_holds_for_every_argument_or_is_false(seed):
    random = Random(seed)
    one, other = random.sample(range(-4, 5), 2)
    wrong = random.choice((0, 1))
    text = rf"""{LAW} Let $$F(s)=s^2{-(one + other):+}s{one * other:+}.$$ Then
    $$F(s)=(s{-one:+})(s{-other - wrong:+}).$$"""
    (verdict,) = verdicts(text.replace("+0)", ")").replace("-0)", ")")).values()
    assert verdict.green is (not wrong)
