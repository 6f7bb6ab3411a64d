"""A misprint in what is printed for all values of an index is one misprint, and mended as one."""

import pytest

from kowalevski_cas.audit.patch import repair_source
from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.reading import read
from kowalevski_cas.source.files import decode
from kowalevski_cas.verify.outcome import Verdict
from tests.sample import sampled

OSCILLATORS = r"""With constants $c_1$, $c_2$, $c_3$ the equations of motion are
\begin{equation}\label{law}\dot u_i=v_i,\qquad \dot v_i=-c_iu_i\qquad(i=1,2,3).\end{equation}
Let \begin{equation}\label{def}%s\qquad(i=1,2,3).\end{equation}
"""

SPHERE = r"""With constants $c_1$, $c_2$, $c_3$ the equations of motion are
\begin{equation}\label{law}
\dot u_i=v_i,\qquad \dot v_i=-c_iu_i+\mu u_i\qquad(i=1,2,3),\end{equation} where
\begin{equation}\label{mu}\mu=\sum_k(c_ku_k^2-v_k^2).\end{equation}
On the sphere $u_1^2+u_2^2+u_3^2=1$, and $u_1v_1+u_2v_2+u_3v_3=0$. Let $n_{ij}=u_iv_j-u_jv_i$. The functions
\begin{equation}\label{def}%s\end{equation}
"""

PAPERS = [
    (OSCILLATORS % "K_i=v_i^2-c_iu_i^2" + r"Then $\dot K_i=0$.", "def", r"v_1^2 + c_1u_1^2"),
    (OSCILLATORS % "K_i=v_i^2+2c_iu_i^2" + r"Then $\dot K_i=0$.", "def", r"v_1^2 + c_1u_1^2"),
    (
        SPHERE % r"K_i=u_i^2+\sum_{j\ne i}\frac{n_{ij}^2}{c_j-c_i}"
        + r"are integrals, $\dot K_i=0$.",
        "def",
        "",
    ),
]


@pytest.mark.parametrize(("text", "label", "mended"), sampled(PAPERS, 1))
def test_what_several_claims_share_is_blamed_once_for_all_values_of_the_index(text, label, mended):
    source = decode("paper.tex", (r"\begin{document}" + text + r"\end{document}").encode())
    found = audit_reading(ReadingSession(read(source), timeout=20))
    failing = [one for one in found.formulas if one.verdict == Verdict.REFUTED]
    assert len(failing) == 3
    for one in failing:
        assert [found.location(cause).split()[0] for cause in one.causes] == [f"({label})"]
    blamed = {o.correction.words: o.correction for o in found.outcomes.values() if o.correction}
    assert not blamed  # it is told at the formula that is wrong
    suspects = [one for one in found.formulas if one.label == label and one.verdict == "suspect"]
    assert len(suspects) == 1 and mended in suspects[0].message


def test_the_patch_types_it_once_and_no_range_that_stands_elsewhere():
    text = OSCILLATORS.replace("(i=1,2,3).", "", 2) % "K_i=v_i^2-c_iu_i^2" + r"Then $\dot K_i=0$."
    text = "Here $i=1,2,3$. " + text.replace(r"\qquad\end", r".\end")
    source = decode("paper.tex", (r"\begin{document}" + text + r"\end{document}").encode())
    mended = repair_source(audit_reading(ReadingSession(read(source), timeout=20))).text
    assert mended == source.text.replace("v_i^2-c_iu_i^2", "v_i^2+c_iu_i^2")
