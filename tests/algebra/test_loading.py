import signal

import pytest

from kowalevski_cas import algebra


def test_an_interruption_waits_until_a_library_is_loaded(monkeypatch):
    loaded = []

    def interrupted(name):
        signal.raise_signal(signal.SIGINT)
        loaded.append(name)

    monkeypatch.setattr(algebra, "import_module", interrupted)
    with pytest.raises(KeyboardInterrupt):
        algebra.load("flint")
    assert loaded == ["kowalevski_cas.algebra.flint"]
