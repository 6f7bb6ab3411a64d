"""Rigid bodies in vectors: tensors of inertia without elements, Hamiltonians without a formula."""

import pytest

from tests.reading.test_reading import verdicts

HEAVY = r"""The Euler--Poisson equations are
\[ \mathbf J\dot{\boldsymbol\omega}+\boldsymbol\omega\times\mathbf J\boldsymbol\omega=m\boldsymbol\nu\times\mathbf a,\qquad
\dot{\boldsymbol\nu}=\boldsymbol\nu\times\boldsymbol\omega .\] """
FREE = r"""With the tensor of inertia $\mathbf A$ \[ \dot{\mathbf G}=\mathbf G\times\mathbf w,\quad
\mathbf G=\mathbf A\mathbf w .\] """
FLUID = r"""Kirchhoff's equations are \[ \dot{\mathbf M}=\mathbf M\times\frac{\partial H}{\partial\mathbf M}
+\mathbf p\times\frac{\partial H}{\partial\mathbf p},\qquad
\dot{\mathbf p}=\mathbf p\times\frac{\partial H}{\partial\mathbf M} .\] """


@pytest.mark.parametrize(
    ("law", "function", "wrong"),
    [
        (HEAVY, r"(\mathbf J\boldsymbol\omega,\boldsymbol\nu)", r"(\boldsymbol\omega,\boldsymbol\nu)"),
        (HEAVY, r"\frac12(\mathbf J\boldsymbol\omega,\boldsymbol\omega)+m(\mathbf a,\boldsymbol\nu)",
         r"\frac12(\mathbf J\boldsymbol\omega,\boldsymbol\omega)-m(\mathbf a,\boldsymbol\nu)"),
        (FREE, r"(\mathbf G,\mathbf w)", r"(\mathbf w,\mathbf w)"),
        (FREE, r"(\mathbf A\mathbf w)^2", r"\mathbf w^2"),
        (FLUID, r"(\mathbf M,\mathbf p)", r"\mathbf M^2"),
    ],
)  # fmt: skip
def test_integrals_for_any_tensor_and_any_hamiltonian(law, function, wrong):
    assert verdicts(law + f"The function ${function}$ is an integral.")[function].green
    assert not verdicts(law + f"The function ${wrong}$ is an integral.")[wrong].green


@pytest.mark.parametrize(
    "text",
    [
        FREE.replace("tensor of inertia", "matrix"),
        FREE + r"Here $\mathbf A$ is the unit matrix. ",
        FREE + r"Here $\mathbf A$ is the scalar moment of inertia. ",
        FREE.replace(r"\mathbf A\mathbf w", r"\mathbf A\mathbf w+\mathbf A"),
    ],
)
def test_other_matrices_are_no_tensors_of_inertia(text):
    assert not any(
        v.green for v in verdicts(text + r"Then $(\mathbf G,\mathbf w)$ is an integral.").values()
    )
