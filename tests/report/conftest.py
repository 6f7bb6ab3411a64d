import pytest

from kowalevski_cas.report import pdf


@pytest.fixture(autouse=True)
def without_latex(monkeypatch: pytest.MonkeyPatch) -> None:
    """Typst is faster."""
    monkeypatch.setattr(pdf, "has_latex", lambda: False)
