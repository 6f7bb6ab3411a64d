"""Limits of time, one within another."""

from time import sleep

import pytest

from kowalevski_cas.verify.limits import time_limit

SHORT, LONG = 0.02, 30


def test_a_limit_ends_what_takes_longer():
    with pytest.raises(TimeoutError), time_limit(SHORT):
        sleep(LONG)


def test_a_limit_within_another_one_does_not_outlast_it():
    with pytest.raises(TimeoutError), time_limit(SHORT), time_limit(LONG):
        sleep(LONG)


def test_a_limit_goes_on_after_one_within_it():
    with pytest.raises(TimeoutError), time_limit(SHORT):
        with time_limit(LONG):
            pass
        sleep(LONG)


def test_a_limit_that_passed_within_another_one_is_told_twice():
    with pytest.raises(TimeoutError), time_limit(SHORT):
        with pytest.raises(TimeoutError), time_limit(LONG):
            sleep(LONG)
        sleep(LONG)


def test_what_ends_in_time_is_left_alone():
    with time_limit(LONG):
        pass
    with time_limit(None):
        pass
