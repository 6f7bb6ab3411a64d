"""What a quick run looks at: a sample of the items of a test, the same in every run."""

import random
from collections.abc import Callable, Iterable

import pytest


def sampled(
    items: Iterable[object], many: int, seed: int = 0, id: Callable[[object], str] | None = None
):
    """Items as parameters of a test; all but a sample are left to the slow run.

    An item that is a tuple has a value for each of several parameters.
    """
    items = list(items)
    quick = random.Random(len(items) + seed).sample(range(len(items)), many)
    return [
        pytest.param(
            *(item if isinstance(item, tuple) else (item,)),
            marks=[] if place in quick else [pytest.mark.slow],
            id=None if id is None else id(item),
        )
        for place, item in enumerate(items)
    ]
