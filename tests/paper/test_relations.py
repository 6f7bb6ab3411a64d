"""Relations of constants: solved for one of them, and read again."""

import pytest

from kowalevski_cas import System


@pytest.mark.parametrize(
    ("relation", "true", "false"),
    [
        (r"a\tan\alpha=b+a", r"\dot x=(b+a)x", r"\dot x=(b-a)x"),
        (r"a\tan\alpha+a=b\cos\alpha", r"\dot x=(b\cos\alpha-a)x", r"\dot x=(b\cos\alpha+a)x"),
        (
            r"a\cos\alpha+a=b\sin\alpha",
            r"\dot x\cos\alpha=(b\sin\alpha-a)x\tan\alpha",
            r"\dot x\cos\alpha=(b\sin\alpha+a)x\tan\alpha",
        ),
    ],
)
def test_a_relation_with_sines_is_solved_for_a_constant_and_can_be_read(relation, true, false):
    law = System(r"\dot x=ax\,\tan\alpha").where(relation)
    assert law.identity(true).verdict.green
    assert law.identity(false).verdict == "refuted"
