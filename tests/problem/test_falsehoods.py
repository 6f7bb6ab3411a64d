"""What is false is never certified, whatever is given as evidence."""

import random

import pytest

from kowalevski_cas.problem import checker

from .falsehoods import FALSE, TRUE, VACUOUS, Draw, attempts, rightly


def rejected(statement, statements, each=40):
    """How many attempts are rejected; all have to be, and because of what they say."""
    count = 0
    for seed in range(statements):
        draw = Draw(random.Random(f"{statement.__name__} {seed}"))
        for text in attempts(draw, statement, each):
            with pytest.raises(checker.Rejected) as why:
                checker.check(text)
            assert "malformed" not in str(why.value), text
            count += 1
    return count


@pytest.mark.parametrize("statement", [*FALSE, *TRUE], ids=lambda one: one.__name__)
def test_no_evidence_gives_the_wrong_sign(statement):
    assert rejected(statement, 1) >= 5


@pytest.mark.slow
def test_thousands_of_them(capsys):
    counts = {statement.__name__: rejected(statement, 60) for statement in (*FALSE, *TRUE)}
    with capsys.disabled():
        print(f"\n{60 * len(counts)} statements, {sum(counts.values())} attempts: {counts}")
    assert sum(counts.values()) > 30_000


@pytest.mark.parametrize("statement", [*FALSE, *TRUE], ids=lambda one: one.__name__)
def test_the_right_sign_is_certified_unless_the_statement_is_vacuous(statement):
    for seed in range(5):
        text = rightly(Draw(random.Random(f"{statement.__name__} {seed}")), statement)
        if statement in VACUOUS:
            with pytest.raises(checker.Rejected):
                checker.check(text)
        else:
            assert checker.check(text).sign == ("denied" if statement in FALSE else "holds")
