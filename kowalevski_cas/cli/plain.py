"""LaTeX as plain text for a terminal: Greek letters, indices, exponents, roots and fractions."""

from __future__ import annotations

import re
from functools import cache

_LETTERS = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "varepsilon": "ε",
    "zeta": "ζ", "eta": "η", "theta": "θ", "vartheta": "ϑ", "kappa": "κ", "lambda": "λ",
    "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ", "sigma": "σ", "tau": "τ",
    "phi": "φ", "varphi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω", "Gamma": "Γ", "Delta": "Δ",
    "Theta": "Θ", "Lambda": "Λ", "Sigma": "Σ", "Phi": "Φ", "Psi": "Ψ", "Omega": "Ω", "ell": "ℓ",
    "times": "×", "cdot": "·", "equiv": "≡", "ne": "≠", "to": "→", "dots": "…", "ldots": "…",
}  # fmt: skip
_LOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_HIGH = str.maketrans("0123456789-+", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺")
_GROUP = r"\{((?:[^{}]|\{[^{}]*\})*)\}"
_DROPPED = re.compile(
    r"\\(?:left|right|displaystyle|textstyle|nolimits|limits|rm|bf|mathrm|mathop|boldsymbol|mathbf"
    r"|bs|quad|qquad|cr|phantom\s*\{[^{}]*\}|begin\s*\{[^{}]*\}(?:\{[^{}]*\})?|end\s*\{[^{}]*\}"
    r"|[,;!:]|\\(?:\s*\[[^\]]*\])?)(?![A-Za-z])"
)


@cache
def plain(tex: str) -> str:
    """The formula as one line of text; what has no plain form stays as it is.

    In words with formulas between dollar signs only these are changed.
    """
    if "$" in tex:
        parts = tex.split("$")
        return "".join(plain(part) if k % 2 else part for k, part in enumerate(parts))
    text = _DROPPED.sub(" ", tex)
    text = re.sub(r"\s+", " ", text)
    for _ in range(6):
        before = text
        text = re.sub(rf"\\[td]?frac\s*{_GROUP}\s*{_GROUP}", _fraction, text)
        text = re.sub(rf"\\sqrt\s*{_GROUP}", lambda m: f"√({m[1].strip()})", text)
        text = re.sub(rf"\\overline\s*{_GROUP}", lambda m: f"conj({m[1].strip()})", text)
        text = re.sub(rf"\\dot\s*(?:{_GROUP}|(\\?\w+))", lambda m: f"{m[1] or m[2]}˙", text)
        if text == before:
            break
    text = re.sub(
        r"\\([A-Za-z]+)(?: (?![-+=≠/]))?", lambda m: _LETTERS.get(m[1], f"\\{m[1]} "), text
    )
    text = re.sub(r" ?_ ?(?:\{(\d+)\}|(\d))", lambda m: (m[1] or m[2]).translate(_LOW), text)
    text = re.sub(r" ?\^ ?(?:\{([\d+-]+)\}|(\d))", lambda m: (m[1] or m[2]).translate(_HIGH), text)
    text = re.sub(r"√\(([^\W\d]|\d+)\)", r"√\1", text)
    text = re.sub(r"(?<![\w(/])(\d+/\d+)(?=[^\W\d]|√)", r"(\1)", text)
    return re.sub(r"\s+", " ", text.replace("{", "").replace("}", "").replace("~", " ")).strip()


def _fraction(match: re.Match[str]) -> str:
    above, below = (_bracketed(part.strip()) for part in match.groups())
    return f"{above}/{below}"


def _bracketed(text: str) -> str:
    simple = re.fullmatch(r"-?\d+|\\?[A-Za-z]+(?:_\w)?(?:\^\w)?|√?\([^()]*\)", text)
    return text if simple else f"({text})"
