r"""Letters in plain type between angles are vectors: :math:`\langle A^{-1}x,y\rangle`."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

GREEN = (Verdict.PROVED, Verdict.CONDITIONAL)
SPHERE = r"""Put $A=\operatorname{diag}(a,b,c)$. The equations of motion are
\[ \dot u=v,\qquad \dot v=-\langle v,v\rangle u-k(Au-\langle Au,u\rangle u) . \] """
GEODESIC = r"""Put $A=\operatorname{diag}(a,b,c)$. A point moves by
\[ \dot u=v,\qquad \dot v=-m A^{-1}u,\qquad m=\frac{\langle A^{-1}v,v\rangle}{\langle A^{-2}u,u\rangle} . \] """


@pytest.mark.parametrize(
    "text",
    [
        GEODESIC + r"The function $\langle A^{-2}u,u\rangle\langle A^{-1}v,v\rangle$ is constant on"
        r" the set $\langle A^{-1}u,v\rangle=0$.",
        GEODESIC + r"Hence \[ \frac{d}{dt}\langle A^{-1}u,u\rangle=2\langle A^{-1}u,v\rangle . \]",
        SPHERE + r"Hence \[ \frac d{dt}\langle u,u\rangle=2\langle u,v\rangle . \]",
    ],
)
def test_they_are_multiplied(text):
    found = [*verdicts(text).values()]
    assert found and {*found} <= {*GREEN}


@pytest.mark.parametrize(
    "text",
    [
        GEODESIC + r"Hence \[ \frac{d}{dt}\langle A^{-1}u,u\rangle=\langle A^{-1}u,v\rangle . \]",
        GEODESIC + r"The function $\langle A^{-1}u,u\rangle\langle A^{-1}v,v\rangle$ is constant.",
        GEODESIC + r"Hence \[ \frac{d}{dt}\langle v,v\rangle=0 . \]",
        SPHERE + r"Hence \[ \frac d{dt}\langle u,u\rangle=2\langle v,v\rangle . \]",
        SPHERE + r"The function $\langle v,v\rangle+k\langle Au,v\rangle$ is an integral.",
    ],
)
def test_false_products_are_not_proved(text):
    found = [*verdicts(text).values()]
    assert found and not {*found} & {*GREEN}
