"""What a text claims and no verdict covers: sentences that state something, and formulas."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import NamedTuple

from kowalevski_cas.reading.text import MARK, Prose
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.source.expanded import Expanded
from kowalevski_cas.source.text import Source
from kowalevski_cas.source.tokens import tokens_of

SAYS_NOTHING = (
    r"(?:(?:\w+ly|also|then|thus|often|sometimes|here|now|therefore|not)\s+)*(?:[\\§(]|(?:called|known"
    r"|named|termed|denoted|given|found|obtained|derived|used|useful|needed|seen|shown|proved|proven"
    r"|verified|checked|considered|studied|discussed|discovered|due|clear|obvious|eas[yi]\w*|evident"
    r"|well|true|to|been|the|an?|our|its|their|nothing|just|hard|difficult|convenient|important"
    r"|interesting|new|worth|possible|natural|sufficient|enough|usual|written|expressed|represented"
    r"|defined|determined|introduced|chosen|taken|immediate|meant|left|neglected|similar|analogous|as"
    r"|in\s+(?:fact|accordance|agreement)|of\s+(?:interest|importance|the\s+form))\b)"
)
"""How words go on behind “it is” that state nothing."""

LONGEST = 500
"""Characters of a sentence that are kept."""

STATES: dict[str, str] = {
    "stability": r"""
        \b(?:un)?stable\b \binstability\b (?:positive|negative)(?:ly)?[\s-]+definite
        \bsaddles?\b \bof\s+(?:focus|node|cent(?:re|er))\s+type\b
        \b(?:is|are|be)\s+(?:an?\s+)?(?:\w+\s+)?(?:cent(?:re|er)s?|foc(?:us|i)|nodes?|spirals?|sinks?|sources?)\b(?!\s+of\b)
        \bс[её]дл\w+ устойчив\w* неустойчив\w+
        (?:положительно|отрицательно)[\s-]+определ[её]н\w+""",
    "period": r"""
        \bperiod\s+(?:is|equals|becomes)\b \bperiod\s+(?:of\s+[^.$]*)?\$[^$=]*=
        \bпериод\w*\s+(?:[^.$]*)?\$[^$=]*= \bperiod\s+(?:of\s+)?\$[^$=]*(?:\\pi|\d)
        \bпериод\w*\s+\$[^$=]*(?:\\pi|\d)""",
    "one alone": r"""
        \b(?:the\s+only|a\s+unique|the\s+unique|a\s+single|the\s+single)\s+(?:\w+\s+){0,2}(?:integral|invariant|solution)s?\b
        \bonly\s+one\s+(?:\w+\s+)?(?:integral|invariant|solution)s?\b
        \bno\s+other\s+(?:\w+\s+)?(?:integral|invariant|solution)s?\b
        \band\s+the\s+only\s+(?:such\s+)?one\b
        \bединственн\w+\s+(?:\w+\s+)?(?:интеграл|инвариант|решени)\w*
        \bдруг\w+\s+(?:интеграл|решени)\w+\s+нет\b""",
    "every one": r"""
        \b(?:all|any|every|each)\s+(?:\w+\s+){0,2}(?:combinations?|choices?)\s+of\s+(?:the\s+)?signs?\b
        \bindependent\s+signs\b
        \bsigns\s+(?:are|being)\s+independent\b
        \b(?:все|люб\w+|всевозможн\w+)\s+(?:\w+\s+){0,2}(?:сочетани|комбинаци)\w+\s+знаков
        \b(?:every|any|each)\s+(?:\w+\s+){0,2}function\b(?=[^.;]*\b(?:integral|constant|conserved|invariant)\b)
        \b(?:любая|всякая|каждая)\s+(?:\w+\s+)?функци\w+(?=[^.;]*(?:интеграл|сохраня|постоян))""",
    "value": r"""
        \b(?:constant|conserved|integral),?\s+(?:and|which\s+is|that\s+is)\s+(?:\w+\s+)?equal(?:s)?\s+(?:to\s+)?(?=\$\s*-?(?:\d|\\[td]?frac\s*\{?\d)[^$A-Za-z]*\$|zero\b|one\b|unity\b)
        \b(?:постоян(?:на|но|ен)|сохраняется),?\s+и\s+рав(?:на|но|ен|няется)\s+(?=\$\s*-?\d[^$A-Za-z]*\$|нулю\b|единице\b)""",
    "in involution": r"""
        \bin\s+involution\b(?![^.]*\\\{) \b(?:Poisson[\s-]+)?commute\b(?![^.]*\\\{)
        \bв\s+инволюции\b(?![^.]*\\\{)""",
    "tends": r"""
        \\to(?![A-Za-z])[^$]*\$\s*(?:as|when|for|при|когда)\s*\$[^$]*\\to(?![A-Za-z])""",
    "orbit": r"""
        \bclosed\s+(?:orbit|trajector|path|loop)\w* \blimit\s+cycles?\b \b(?:attract|repel)\w*
        замкнут\w+\s+(?:орбит|траектор)\w+ предельн\w+\s+цикл\w* притягива\w+ отталкива\w+""",
    "motion": r"""
        \bperiodic\w* \basymptotic\w+ \b(?:un)?bounded\b \bescapes?\b \bmonoton\w+
        периодич\w+ асимптотич\w+ (?:не)?ограничен\w+ монотонн\w+""",
    "independence": r"""
        \b(?:functionally\s+)?independent\b \bindependence\b (?<!-)\bdependent\b
        \bdepends?\s+on\s+(?:each\s+other|one\s+another)\b
        независим(?:ы|ость)\w* \bзависим\w+""",
    "otherwise": r"""
        \bfor\s+no\s+other\b \bceas\w+\s+to\s+be\b \b(?:does|do)\s+not\s+hold\s+for\b
        \b(?:it|this)\s+is\s+not[,.;] \bconversely\b \bvice\s+versa\b \bno\s+longer\b
        \b(?:unlike|in\s+contrast\s+(?:to|with)|as\s+opposed\s+to|contrary\s+to)\s+(?:\w+\s+){0,3}(?=\$)
        \bfor\s+(?:all\s+|any\s+)?other\s+(?:values\b|choices\b|cases\b|(?=\$))
        \b(?:this|it|that|which|the\s+(?:assertion|statement|result))\s+(?:also\s+|still\s+)?(?:remains|stays|is|holds)\s+(?:also\s+|still\s+)?(?:true|valid|correct|good)\s+(?:also\s+|even\s+|still\s+)?(?:for|if|when|without)\b
        \bв\s+отличие\s+от\s+(?:\w+\s+){0,2}(?=\$) \bи\s+обратно\b \bобратно,
        \bthe\s+same\s+(?:is\s+(?:true|valid)|holds)\s+(?:for|if|when)\b
        \b(?:assumption|condition)\s+is\s+(?:not\s+necessary|unnecessary|superfluous|essential)\b""",
    "all rest": r"""
        \b(?:only|all|exactly|single|unique|no)\s+(?:\w+\s+){0,2}(?:equilibri\w+|(?:states?|points?)\s+of\s+rest)
        \b(?:equilibri\w+|(?:states?|points?)\s+of\s+rest)\b[^.;]*\b(?:alone|only|exactly|precisely|requires?|no\s+(?:others?|more|further)|nothing\s+else|that\s+is\s+all|in\s+number|is\s+not)\b
        \b(?:equilibri\w+|(?:states?|points?)\s+of\s+rest)\s+(?:are\s+the\s+(?:two|three|four|five)|form\s+the)\b
        \b(?:exhausts?|complete\s+list|set)\s+(?:of\s+)?(?:the\s+|all\s+)?(?:equilibri\w+|(?:states?|points?)\s+of\s+rest)
        \b(?:the|its)\s+(?:equilibria|(?:equilibrium|rest|singular|stationary|fixed)\s+(?:points|positions|states)|(?:states|points)\s+of\s+rest)(?:\s+of\s+[^.;$]{1,40}?)?\s+(?:are|form|fill|make\s+up|consist\s+of|fall\s+into)\b(?=[^.;]*(?:\$|\\\[|\\begin))
        \b(?:equilibria|(?:equilibrium|rest|singular|stationary|fixed)\s+(?:points|positions|states))\s*:(?=[^.;]*\$)
        (?:единственн\w+|все|всякое)\s+(?:\w+\s+){0,2}равновеси\w+""",
    "integral": r"""
        \binvariants?\s+(?:of|under)\s+(?:the\s+|this\s+|our\s+)?(?:\w+\s+)?map(?:ping)?\b
        \bintegral(?:s\b|\b(?!\s+(?:equation|curve|sign))) \bconserved\b \bpreserved\b
        (?:is|are|remains?|stays?)\s+(?:\w+\s+)?constant\b(?!\s+values?\s+of)
        \bdo(?:es)?\s+not\s+(?:con|pre)serve\b
        constant\s+(?:along|on)\b integrable интеграл\w* сохраня\w+ постоян(?:на|но|ны|ен)\b""",
    "invariant": r"""
        \binvarian\w+ инвариантн\w+""",
    "rest": r"""
        \bequilibri\w+ states?\s+of\s+rest равновеси\w+""",
    "dimension": r"""
        dimension(?!al\s+(?:system|motion|problem|oscillator|particle|space|case|potential))\w*
        \b\w+-?\s*parametri?c\w* \bmanifold\b двумерн\w* трехмерн\w* четырехмерн\w*
        размерност\w+ параметрическ\w+ многообрази\w+""",
    "number": r"""
        \bonly\b \bexactly\b \bunique\w* \bat\s+(?:most|least)\b \balmost\s+all\b \bevery\b
        \ball\s+(?:\w+\s+)?(?:points|motions|solutions|trajectories|values|integrals|zeros|roots)\b
        \b(?:each|any)\s+(?:\w+\s+)?(?:point|motion|solution|orbit|trajectory|initial)\b
        \bwhatever\b \bregardless\s+of\b кажд\w+\s+(?:движен|решен|орбит|траектор)\w+ при\s+люб\w+
        каковы\s+бы только ровно единственн\w+ не\s+более почти\s+вс\w+""",
    "existence": r"""
        there\s+(?:is|are|exists?|does\s+not\s+exist)\b \bexists?\b (?:has|have)\s+no\b
        \bno\s+other\b \bnever\b существу\w+ \bнет\b не\s+име\w+""",
    "sameness": r"""
        which\s+(?:is|are)\s+(?:not\s+)?the\s+same \bequivalen\w+ \bcoincid\w+
        \bif\s+and\s+only\s+if\b \bthe\s+same\s+as\b эквивалентн\w+ равносильн\w+ совпада\w+
        тогда\s+и\s+только""",
    "level": r"""
        \blevels?\b \bcritical\b \bdegenerat\w+ \bsingular\w* \bbifurcation\w* \bzeros?\b уровн\w+
        критическ\w+ вырожд\w+ особ\w+""",
    "reality": r"""
        purely\s+imaginary \breal\b \bcomplex\b \bpositive\b \b(?:non-?)?negative\b веществен\w+
        мним\w+ действительн\w+ положительн\w+ отрицательн\w+""",
    "degree": r"""
        \b(?:linear|quadratic|cubic|quartic|(?<!characteristic\s)polynomial|rational|elliptic(?!\s+(?:coordinate|function|cylind)|al)|homogeneous(?!\s+(?:\w+\s+){0,2}(?:fields?|rods?|spheres?|balls?|bod(?:y|ies)|dis[ck]s?|cylinders?|plates?|rings?|medium|fluid|liquid|gravity)\b))\b
        \b(?:algebraic|transcendental)\b \bdegree\b линейн\w+ квадратичн\w+ степен\w+ полином\w+
        эллиптическ\w+(?!\s+(?:координат|функци))""",
    "limit": r"""
        \bgenerali[sz]\w+(?!\s+(?:coordinate|moment|velocit|force|potential))
        \breduces?\s+to\b \btends?\s+to\b \bspecial\s+case\b обобща\w+
        стрем\w+ся частн\w+\s+случа\w+""",
    "method": r"""
        \bquadratures?\b \bseparat\w+ \bhamiltonian\s+system\b \bcommut\w+ \binvolution\b
        квадратур\w+ раздел\w+ инволюци\w+""",
    "shape": r"""
        \b(?:is|are|being|along|describes?|traces?)\s+(?:an?\s+|the\s+)?(?:\w+\s+){0,2}(?:hyperbola[se]?|parabola[se]?|ellips(?:e|es|oids?)|cycloids?|conics?|spirals?|helix|circles?|lines?)\b
        \btor(?:us|i)\b \b(?:non-?)?compact\b \bconvex\b \bconcave\b \bdense(?:ly)?\b
        \b(?:is|are)\s+(?:hyperbolic|elliptic|parabolic)\b
        \b(?:гипербол|парабол|эллипс)(?:ой|ою|ом|ами?)\b \b(?:не)?компактн\w+ \bвыпукл\w+
        \bвогнут\w+""",
    "extremum": r"""
        \b(?:maxim|minim)(?:um|a|al)\b
        \b(?:is|are)\s+(?:\w+\s+)?(?:largest|smallest|greatest|least|highest|lowest)\b
        \b(?:мак|ми)[сн]имум\w* \b(?:максимал|минимал)\w+""",
    "grade": r"""
        \b(?:is|are|being)\s+(?:(?:also|even|both|all|an?)\s+)*(?:linear|quadratic|cubic|quartic|polynomial|rational|homogeneous|even|odd|algebraic|transcendental)\b
        \b(?:linear|quadratic|cubic|quartic|even|odd|homogeneous)\s+in\b
        (?<!terms\s)(?<!equation\s)(?<!equations\s)\bof\s+(?:the\s+)?(?:zeroth|first|second|third|fourth|fifth|sixth)\s+(?:order|degree)\b
        \b(?:линеен|линейн(?:а|ы|о)|квадратич(?:ен|на|ны|но)|однород(?:ен|на|ны))\b
        \b(?:перв|втор|треть|четв[её]рт)\w+\s+(?:порядка|степени)\b""",
    "course": r"""
        (?<!the\s)(?<!\ba\s)(?<!an\s)(?<!of\s)(?<!its\s)(?<!to\s)(?<!this\s)\b(?:grows?|increases?|decreases?|decays?|shrinks?|changes|varies|converges?|diverges?|precess(?:es)?|drifts?|rotates?)\b
        \bgo(?:es)?\s+to\s+infinity\b \b(?:in|de)creasing\b \bfinite\s+time\b
        \blyapunov\s+functions?\b
        \b(?:period|frequenc\w+|amplitude|velocity|speed|energy|angle)\s+(?:does\s+not\s+depend|depends|is\s+independent)\b(?!\s+on\s+(?:the\s+)?time)
        \b(?:is|are)\s+multiplied\s+by\b \bmodul(?:us|i)\s+(?:one|1)\b
        \bleaves?\s+(?:it|them|the\s+\w+)\b(?!\s+(?:\w+\s+)?invariant)
        \bвозраста\w+ \bубыва\w+ \bраст[её]т\b \bрастут\b""",
    "direction": r"""
        \bparallel\b \borthogonal\b \bperpendicular\b \btangent\b \bobtuse\b \bacute\b
        \b(?:is|are|not|always)\s+(?:collinear|coplanar)\b \bpoints?\s+(?:to|towards|along)\b
        \b(?:is|are)\s+directed\b \bintersects?\b
        \bcontains?\s+(?=§|the\s+(?:origin|point|vector|axis|line)\b)
        \bпараллельн\w+ \bортогональн\w+ \bперпендикулярн\w+ \bпересека\w+""",
    "symmetry": r"""
        \bgenerates?\s+(?:the|an?)\b \bпорожда\w+ \b(?:is|are|in)\s+(?:\S+\s+)?resonan(?:t|ce)\b
        \b(?:preserves?|conserves?|contracts?)\b
        \bcorresponds?\s+to\s+(?:the\s+|an?\s+)?(?:invarian|symmetr|translation|rotation|shift)\w*
        \b(?:is|are)\s+(?:not\s+)?(?:\w+ly\s+)?(?:canonical|symplectic|cyclic|ignorable|autonomous|reversible|symmetric|non-?degenerate|hamiltonian)\b
        \bha(?:s|ve)\s+the\s+cyclic\b \bderives?\s+from\b
        (?<!не\s)\bсохраняет\s+(?!ся)""",
    "equality": r"""
        \b(?:is|are|ha(?:s|ve))\s+(?:always\s+|all\s+|both\s+)?(?:equal|the\s+same|identical|opposite|twice|half)\b
        \bha(?:s|ve)\s+(?:an?\s+)?constant\b \b(?:they|both|the\s+two)\s+coincide\b
        \bdiffers?\s+from\b
        \bconstant\s+(?:\w+\s+)?(?:acceleration|velocity|speed)\b
        \bодинаков\w+ \bравны\b(?!\s+нулю)""",
    "range": r"""
        \btakes?\s+(?:on\s+)?(?:all|any|every|only|no)\b \bin\s+the\s+whole\b \beverywhere\b
        \b(?:it|they|which)\s+(?:is|are)\s+(?:always\s+|never\s+)?(?:positive|negative|real|imaginary|non-?zero)\b
        \bof\s+(?:unit\s+length|length\s+\w+)\b \bseparately\b
        \bdepends?\s+(?:\S+\s+){0,3}explicitly\b \bexplicitly\s+depends?\b""",
    "place": r"""
        \b(?:vanish(?:es)?|rests?)\s+(?:\w+\s+)?(?:at|for|when|if|below|above)\b
        \b(?:acceleration|force|velocity|speed|torque|rate|moment\w*)\s+vanish(?:es)?\b
        \b(?:is|are)\s+(?:reached|attained|assumed)\s+(?:at|for|when|if)\b
        \b(?:lies?|is|are)\s+(?:situated\s+)?at\s+(?=\$)
        \bturning\s+points?\b \bобраща\w+\s+в\s+нуль\s+(?:при|в)\b""",
    "further": rf"""
        (?:[,;§]|\b(?:and|but|so|while|whereas)\b)[\s,]*(?:so\s+(?:is|are)|(?:it|they|which|both|(?:its|their|whose)\s+(?:\w+\s+){{1,3}}?)\s*\b(?:is|are|has|have)\b(?!\s+{SAYS_NOTHING}))
        (?:[,;]|\b(?:and|but|so)\b)\s*(?:each|every|all)\s+(?:\w+\s+){{1,4}}?(?:is|are|has|have)\b
        [,;]\s*(?:the|its|their)\s+(?:\w+\s+){{1,5}}too\b
        \b(?:integrals?|conserved|constant|invariants?)\s+and\s+an?\s+\w+
        \b(?:integral|invariant)s?\s+(?:of\s+degree\b|without\b|having\b|with\s+(?:an?|no|two|three)\b|that\s+(?:is|has|vanishes)\b(?!\s+been))
        \bwhose\s+(?!(?:mass|length|radius|coordinates?|charge|value|form|proof|axis|origin)\b)(?:\w+\s+){{1,3}}?(?:(?:never|always|not)\s+)?\w+s\b""",
}
"""Words that state something of a kind, in English and in Russian; spaces stand between them."""

BESIDE = (
    "shape", "extremum", "grade", "course", "direction", "symmetry", "equality", "range",
    "place", "further",
)  # fmt: skip
"""The kinds that are told where words neither lead up to what is read nor suppose something."""

ALONE = (
    "stability", "period", "one alone", "every one", "value", "in involution", "tends", "orbit",
    "motion", "independence", "otherwise", "all rest",
)  # fmt: skip
"""The kinds that no claim of a formula states: they are told beside what is judged, too."""

ALL_EIGENVALUES = "all eigenvalues: “eigenvalues are”"
"""What is told of a list of eigenvalues with fewer than there are."""

SAYS_MORE = "more: “another thing than is judged”"
"""What is told of a formula whose words say another thing than is judged."""

OF_EXPRESSION = "expression: “nothing is stated”"
"""What is told of an expression of which words say something, and nothing is judged."""

OF_LAW = "law: “equations for new letters”"
"""What is told of equations of motion in letters that nothing ties to those before."""

_KINDS = {
    kind: re.compile("|".join(words.split()), re.IGNORECASE) for kind, words in STATES.items()
}
_BRACED = r"\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}"
_APART = re.compile(
    rf"\\(?:title|author|date|thanks|address|keywords|cite|label|ref|eqref|begin|end|bibitem"
    rf"|(?:sub)*section|chapter|paragraph)\b\*?\s*(?:\[[^\]]*\])?\s*{_BRACED}"
)
"""What states nothing: headings, names and labels."""

_CLOSED = re.compile(r"(?:[\s.,;]|\\[\])]|\${1,2}(?=\s)|\\end\s*\{\w+\*?\}|\\label\s*\{[^{}]*\})*")
"""What belongs to the display before a sentence."""


_DISPLAY = re.compile(r"\\begin\b|\\\[|\$\$")
_REFERENCE = re.compile(r"\\(?:eq)?ref\s*\{([^{}]*)\}")
_MACRO = re.compile(r"\\[A-Za-z]+\*?\s*")


class Uncovered(NamedTuple):
    """A sentence or a formula that no verdict covers: where it begins, and what it states."""

    line: int
    words: str
    kind: str

    @property
    def cue(self) -> str:
        """The words that state it."""
        return self.kind.partition("“")[2].removesuffix("”")

    def read(self, number: Callable[[str], str] = str) -> str:
        """The words up to a display, with mathematics between dollars, and no other TeX.

        Args:
            number: what the author's label of an equation stands for.
        """
        shown = _DISPLAY.split(self.words)[0]
        parts = _REFERENCE.sub(lambda of: f"({number(of[1])})", shown).split("$")
        parts[::2] = [
            re.sub(r"[{}]", "", _MACRO.sub("", part.replace("~", " "))) for part in parts[::2]
        ]
        read = "$".join(parts).strip()
        return read if shown == self.words else f"{read} …"


def sentences(
    prose: Prose,
    source: Source,
    expanded: Expanded,
    covered: Iterable[tuple[int, int]],
    leads: Iterable[tuple[int, int]] = (),
) -> Iterator[tuple[tuple[int, int], str, Uncovered]]:
    """The sentences that state something of a kind, in none of some intervals of the text.

    Each comes with its interval and its kind; or with several, if one of these stands alone.
    In the intervals ``leads`` words lead up to what is read.
    """
    apart = (found.span() for found in _APART.finditer(prose.text, prose.start))
    spans = sorted([*covered, *apart])
    led = sorted([*spans, *leads])
    for start, end in zip(prose.stops, [*prose.stops[1:], len(prose.text)], strict=True):
        words = prose.text[start:end]
        within = [(a - start, b - start) for a, b in spans]
        leading = [(a - start, b - start) for a, b in led if a < end and start < b]
        stated = _stated(words, expanded.text[start:end], within, leading)
        if not stated or words.rstrip().endswith("?"):  # a question states nothing
            continue
        if any(part.title == "thebibliography" for part in prose.path(start)):
            continue
        for kind, said in stated.items():
            told = f"{kind}: “{said}”"
            yield (start, end), kind, passage_at((start, end), told, source, expanded)


def passage_at(
    sentence: tuple[int, int], kind: str, source: Source, expanded: Expanded
) -> Uncovered:
    """The sentence in an interval of the text, as no verdict covers it."""
    start, end = sentence
    closed = _CLOSED.match(expanded.text, start, end)
    begin = closed.end() if closed is not None else start
    printed = " ".join(expanded.text[begin:end].split())
    short = printed if len(printed) <= LONGEST else f"{printed[: LONGEST - 1]}…"
    return Uncovered(source.line(expanded.origin(begin, begin + 1)[0]), short, kind)


def _stated(
    words: str, printed: str, spans: Sequence[tuple[int, int]], leads: Sequence[tuple[int, int]]
) -> dict[str, str]:
    """The first kind of what some words state outside of some intervals, and those that are alone.

    These may be told by formulas, which are ``printed`` among the words. Each comes with the words
    that tell it. Of the kinds that are told beside what is judged, too, the first one is taken that
    stands outside of what leads up to it.
    """
    found: dict[str, str] = {}
    for kind, cues in _KINDS.items():
        alone = kind in (*ALONE, *BESIDE)
        if (not alone and not {*found} <= {*ALONE}) or {*BESIDE} & {*found}:
            continue
        beside = kind in BESIDE
        for match in cues.finditer(printed if alone and not beside else words):
            place = match.end() - 1 if beside else match.start()
            if not any(start <= place < end for start, end in (leads if beside else spans)):
                said = " ".join(match[0].partition("$")[0].replace(MARK, " ").split())
                found[kind] = kind if said.startswith("\\") else said
                break
    return found


def formulas(
    typed: Sequence[TypedFormula],
    covered: Iterable[TypedFormula],
    source: Source,
    expanded: Expanded,
) -> Iterator[Uncovered]:
    """The inline formulas of more than one sign that nothing covers."""
    known = {id(one) for one in covered}
    for one in typed:
        if one.inline and id(one) not in known and says_something(one.tex):
            line = source.line(expanded.origin(one.start, one.start + 1)[0])
            yield Uncovered(line, f"${' '.join(one.tex.split())}$", "formula")


def says_something(tex: str) -> bool:
    """Whether a formula is more than one sign."""
    return len(tokens_of(tex)) != 1


__all__ = ["Uncovered", "formulas", "says_something", "sentences"]
