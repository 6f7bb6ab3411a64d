r"""What each LaTeX macro is to a reader of formulas.

A macro that is not listed is a letter, as ``\omega`` is; whether the letter is known
is for the vocabulary to say.
"""

from __future__ import annotations

from collections.abc import Mapping

from kowalevski_cas.notation import functions
from kowalevski_cas.notation.decorations import ACCENTS, RAISED, Accent, RaisedSign


def _table(**rows: str) -> dict[str, str]:
    return {"\\" + name: action for action, names in rows.items() for name in names.split()}


def _names(decorations: Mapping[str, Accent | RaisedSign]) -> str:
    """The macros for decorations; a sign of the keyboard is none."""
    own = [name.removeprefix("\\") for name in decorations if name.startswith("\\")]
    return " ".join((*own, *(one.spelled for one in decorations.values())))


# The letters that a macro prints, in Unicode.
GREEK: dict[str, str] = {
    "\\" + name: letter
    for name, letter in zip(
        """alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa
        varkappa lambda mu nu xi pi varpi rho varrho sigma varsigma tau upsilon phi varphi chi psi
        omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega ell hbar imath jmath wp
        varGamma varDelta varTheta varLambda varXi varPi varSigma varUpsilon varPhi varPsi varOmega
        """.split(),
        "αβγδϵεζηθϑικϰλμνξπϖρϱσςτυϕφχψωΓΔΘΛΞΠΣΥΦΨΩℓℏıȷ℘𝛤𝛥𝛩𝛬𝛯𝛱𝛴𝛶𝛷𝛹𝛺",
        strict=True,
    )
}

# What the scanner does when it meets the macro.
ACTIONS: dict[str, str] = _table(
    blank="""displaystyle textstyle scriptstyle scriptscriptstyle mathstrut strut nonumber notag
    limits nolimits mathop mathord mathrel mathbin mathopen mathclose hfill
    hfil hline noindent relax allowbreak nobreak protect thinspace medspace thickspace negthinspace
    normalsize small footnotesize large it normalfont displaylimits allowdisplaybreaks""",
    size="""left right middle big Big bigg Bigg bigl Bigl biggl Biggl bigr Bigr biggr Biggr bigm
    Bigm biggm Biggm""",
    skip="phantom hphantom vphantom label tag tag* hspace hspace* vspace vspace* mspace",
    glue="hskip vskip kern mkern mskip raise lower",
    text="text mbox hbox textrm textit textbf textup intertext shortintertext",
    font="""mathbf boldsymbol bm bs pmb mathrm operatorname operatorname* mathcal mathbb mathfrak
    mathsf mathit mathnormal mathscr mathbfit symbfit mathbfup symbf symup mathup symit""",
    diacritic=_names(ACCENTS),
    switch="bf rm cal boldmath sf",
    over="over",
    stack="substack",
    sum="sum",
    product="prod",
    plusminus="pm mp",
    bar="vert Vert",
    accent="dot ddot dddot ddddot bar overline",
    gap="quad qquad",
    row="cr newline tabularnewline",
    frac="frac tfrac dfrac cfrac",
    sqrt="sqrt",
    times="cdot times wedge",
    star=_names(RAISED),
    dots="ldots dots cdots dotsb dotsc dotsm",
    prime="prime",
    relation="""coloneqq eqqcolon coloneq eqcolon equiv ne neq leq le leqslant leqq lt geq ge
    geqslant geqq gt ll gg approx simeq sim cong propto in notin not= subset to perp parallel
    rightarrow longrightarrow mapsto Rightarrow Longrightarrow Leftrightarrow
    Longleftrightarrow iff implies""",
    open="lparen lbrace lbrack langle lgroup lvert lVert",
    close="rparen rbrace rbrack rangle rgroup rvert rVert",
    operator="Re Im diag",
    const="const",
    begin="begin",
    end="end",
    number="eqno leqno",
) | {
    "\\" + sign: action
    for action, signs in {
        "blank": ",;:!> /\n\t",
        "bar": "|",
        "shift": "()[]",
        "open": "{",
        "close": "}",
    }.items()
    for sign in signs
}

# What a single character of the source is.
MARKS: dict[str, str] = {sign: sign for sign in "{}^_"} | {
    sign: kind
    for kind, signs in {
        "sign": "+-", "relation": "=<>", "open": "([", "close": ")]", "prime": "'", "slash": "/",
        "comma": ",;", "cell": "&", "stop": ".", "shift": "$", "blank": "~", "bar": "|",
        "star": "*",
    }.items()
    for sign in signs
}  # fmt: skip

# Signs of Unicode, as TeX writes them.
TYPED: dict[str, str] = {letter: macro for macro, letter in GREEK.items()} | {
    ":=": "=", "=:": "=", "−": "-", "′": "'",
    "·": r"\cdot", "⋅": r"\cdot", "×": r"\times", "∧": r"\times", "±": r"\pm", "∓": r"\mp",
    "≠": r"\ne", "≡": r"\equiv", "≤": r"\le", "⩽": r"\le", "≥": r"\ge", "⩾": r"\ge",
    "≈": r"\approx", "≪": r"\ll", "≫": r"\gg", "∼": r"\sim", "≃": r"\simeq", "∝": r"\propto",
    "∈": r"\in", "→": r"\to", "∂": r"\partial", "…": r"\ldots", "⋯": r"\cdots",
    "∑": r"\sum", "∏": r"\prod",
    "⟨": r"\langle", "⟩": r"\rangle", "‖": r"\|",
}  # fmt: skip

# The canonical spelling of a sign, a font or a bracket that has several.
SPELLING: dict[str, str] = {
    "\\" + name: spelling
    for spelling, names in {
        "=": "coloneqq eqqcolon coloneq eqcolon", r"\ne": "neq not=", r"\le": "leq leqslant leqq",
        "<": "lt",
        r"\times": "wedge",
        r"\ge": "geq geqslant geqq", ">": "gt", r"\to": "rightarrow longrightarrow",
        r"\boldsymbol": "bs bm pmb boldmath mathbfit symbfit",
        r"\mathrm": "rm operatorname operatorname* symup mathup",
        r"\mathbf": "bf mathbfup symbf", r"\mathsf": "sf", r"\mathcal": "cal",
        "": "mathnormal", r"\mathit": "symit",
        r"\overline": "bar",
        "(": "lparen", ")": "rparen", r"\{": "lbrace", r"\}": "rbrace", "[": "lbrack",
        "]": "rbrack", r"\lvert": "lVert", r"\rvert": "rVert",
        **{name: accent.spelled for name, accent in ACCENTS.items()},
        **{name: raised.spelled for name, raised in RAISED.items()},
    }.items()
    for name in names.split()
}  # fmt: skip

# What cannot be read, and what to write instead.
INSTEAD: dict[str, str] = {
    r"\int": "an integral cannot be read: write the derivative that it has",
    r"\oint": "an integral cannot be read: write the derivative that it has",
    r"\lim": "a limit cannot be read: write the value, or an equation for it",
    r"\nabla": r"print by what it derives, as in \frac{\partial U}{\partial\mathbf{r}}",
    r"\infty": "infinity is no number: write what happens to the inverse",
}

SPELLING |= functions.SPELLING

# Words in upright letters, which the paper's author writes as ``{\rm Re}`` or ``\text{const}``.
WORDS = {"Re": "operator", "Im": "operator", "diag": "operator", "const": "const"}

# Words between two statements that say no more than a comma does.
JOINING = frozenset({"and", "where", "hence", "thus", "so"})

PARTNERS = {
    "(": ")", "[": "]", r"\{": r"\}", r"\langle": r"\rangle", r"\lvert": r"\rvert",
    r"\lgroup": r"\rgroup",
}  # fmt: skip

# How many arguments follow a macro in braces.
ARGUMENTS: dict[str, int] = {"frac": 2, "sqrt": 1, "accent": 1}

MATRICES = frozenset({"matrix", "pmatrix", "bmatrix", "Bmatrix", "smallmatrix", "vmatrix"})

# Environments of which the rows are a block: no formula runs on into them, or out of them.
BLOCKS = frozenset({"array", "cases", "dcases"})

# Environments whose rows are statements, with the number of groups after their name.
LAYOUTS = dict.fromkeys(
    """equation displaymath math eqnarray align aligned flalign gather gathered multline multlined
    split cases dcases subequations""".split(),
    0,
) | {"alignat": 1, "alignedat": 1, "array": 1}
