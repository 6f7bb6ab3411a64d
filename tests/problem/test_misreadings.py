"""Formulas mean the same in whatever order a space defines its names, and grants fractions of them."""

import json
import random

import pytest

from kowalevski_cas.problem import checker
from kowalevski_cas.problem.examine import Unproved

from .judges import judged
from .misreadings import ZERO, Setting, certificates, divided, misreading, true, value


def settings(statement, seeds):
    """Settings, each with certificates for a statement in it."""
    for seed in seeds:
        setting = Setting(random.Random(f"{statement.__name__} {seed}"))
        for text in certificates(setting, statement):
            yield setting, text


def need_condition(setting, text):
    """Whatever is accepted of what is false at the point has a condition that fails there."""
    try:
        (theorem,) = checker.check(text).theorems
    except checker.Rejected:
        return
    assert any(value(tree, setting.at) == ZERO for tree in theorem.divisors), text


def test_a_name_stands_for_what_defines_it():
    """Nothing is said against it but that a norm of what is granted may vanish at the point."""
    accepted = 0
    for _, text in settings(true, range(60)):
        try:
            checker.check(text)
        except checker.Rejected as error:
            assert "a condition fails at the point" in str(error)
            continue
        judged(json.loads(text))
        accepted += 1
    assert accepted > 50


def test_a_name_stands_for_nothing_else():
    for setting, text in settings(misreading, range(150)):
        need_condition(setting, text)


def test_no_judge_takes_one_for_another():
    for _, text in settings(misreading, range(40)):
        with pytest.raises(Unproved):
            judged(json.loads(text))


@pytest.mark.slow
def test_what_is_divided_by_is_a_condition():
    for setting, text in settings(divided, range(3)):
        need_condition(setting, text)


@pytest.mark.slow
@pytest.mark.parametrize(("statement", "many"), [(misreading, 3000), (divided, 150)])
def test_thousands_of_them(statement, many):
    for setting, text in settings(statement, range(many)):
        need_condition(setting, text)
