"""Work on several items at once: the results in order, errors as if it were one process."""

import os

import pytest

from kowalevski_cas.cli.exits import CommandError
from kowalevski_cas.cli.parallel import each


def test_results_come_in_the_order_of_the_items():
    assert each(lambda n: n * n, [3, 1, 2]) == [9, 1, 4]
    assert each(str, []) == []


def test_each_further_item_has_a_process_of_its_own():
    first, *others = each(lambda _: os.getpid(), range(3))
    assert first == os.getpid()
    assert len({first, *others}) == 3


@pytest.mark.parametrize("bad", [0, 2])
def test_the_error_of_an_item_is_raised_with_its_exit_code(bad):
    def work(item):
        if item == bad:
            raise CommandError(f"item {item} is wrong", 6)
        return item

    with pytest.raises(CommandError, match=f"item {bad} is wrong") as caught:
        each(work, [0, 1, 2])
    assert caught.value.code == 6


def test_a_process_that_dies_is_an_error_and_no_result():
    with pytest.raises(CommandError, match="worked on 1 has died"):
        each(lambda item: os._exit(0) if item else item, [0, 1])


def test_an_interrupt_here_ends_the_others():
    def work(item):
        if item == 0:
            raise KeyboardInterrupt
        import time

        time.sleep(60)

    with pytest.raises(KeyboardInterrupt):
        each(work, [0, 1])
