"""Chains of equalities in what cannot be read."""

import pytest

from kowalevski_cas.notation import NotationError, split_display
from kowalevski_cas.paper.chains import without_new_names


@pytest.mark.parametrize("tex", [r"i=1,2\quad x=\frac{1}{", "x=y=}"])
def test_what_cannot_be_split_is_left_to_its_reader(tex):
    with pytest.raises(NotationError):
        split_display(tex)
    assert without_new_names([tex]) == [tex]
