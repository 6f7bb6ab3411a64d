"""Words that speak of another system than the one of which the equations are printed.

What is said “of the damped system”, “if we add friction”, or “of the discretization”, is said of
equations that stand nowhere, unless words call the printed ones so, or these have what it is about.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

from kowalevski_cas.notation import Derivative, Name
from kowalevski_cas.paper.implied import HAMILTONIANS
from kowalevski_cas.reading.degrees import degrees, is_linear
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.rows import is_row
from kowalevski_cas.reading.statements import SourceStatement


class _Sort(NamedTuple):
    """A sort of systems: what they are called, what acts there, and which laws are of it."""

    called: str
    acting: str
    near: str
    """Words beside a law that say, of whatever there is, that it is of this kind."""
    has: Callable[[Law, Known], bool] = lambda law, known: False


_THING = (
    r"(?:systems?|equations?|oscillators?|oscillations?|vibrations?|pendul(?:um|a)s?|problems?|motions?|cases?|models?|dynamics|flow"
    r"|bod(?:y|ies)|tops?|particles?|chains?|lattices?|rotors?|circuits?|maps?|rods?|strings?"
    r"|(?:систем|уравнени|осциллятор|маятник|задач|движени|колебани|случа|модел|точк|частиц|цепочк|тел|волчк)\w*)\b"
)
_FORCE = (
    r"(?:(?:periodic|constant|external|additional|random|driving|disturbing|perturbing|dissipative|tidal|extra|further|stochastic)"
    r"\s+(?:\w+\s+)?(?:forces?|forcing|torques?|excitations?|fields?)"
    r"|(?:периодическ|постоянн|внешн|дополнительн|случайн|вынуждающ|возмущающ)\w+\s+(?:\w+\s+)?(?:сил|момент|пол)\w*)"
)
_WITH = (
    r"\b(?:with|if|when|once|after|under|add(?:s|ed|ing)?|includ\w+|presence|subject\w*|tak(?:e|es|ing)|allow\w*|despite|spite|introduc\w+"
    r"|let|suppose|assum\w+|consider|пусть|рассмотр\w+|предполож\w+"
    r"|при|с|если|когда|добав\w+|уч[её]т\w*|учит\w+|действи\w+|присутстви\w+|вве[сд]\w+|включ\w+)\s"
)


def _is_damped(law: Law, known: Known) -> bool:
    """Whether the highest rate of a name is given by what is derived once less."""
    for row in law.rows:
        for name, order in row.rates.items():
            nodes = [node for member in row.members for node in member.nodes()]
            rates = [node for node in nodes if isinstance(node, Derivative)]
            found = sum(name in node.names() for node in rates)
            same = nodes.count(Name(name))
            if (order == 1 and same > found) or (order > 1 and found > order):
                return True
    return False


def _is_loaded(law: Law, known: Known) -> bool:
    """Whether a term of a law is constant, or has no degree in what moves."""
    return any(0 in degrees(member, known) for row in law.rows for member in row.members)


def _mentions(*letters: str) -> Callable[[Law, Known], bool]:
    """Whether equations have one of some letters, or what is given by them."""

    def has(law: Law, known: Known) -> bool:
        return any(not {*letters}.isdisjoint(known.below(name)) for name in law.mentions)

    return has


_KINDS = (
    _Sort(
        r"damped|dissipative|viscous|затухающ\w*|демпфированн\w*|диссипативн\w*",
        r"friction|damping|dissipation|viscosity|drag|(?:air\s+)?resistance|трени\w+|затухани\w+|демпфировани\w+|сопротивлени\w+",
        r"fricti|\bdamp|dissip|viscos|\bdrag|resist|трени|затуха|демпф|диссип|вязк|сопротивл",
        _is_damped,
    ),
    _Sort(
        r"forced|driven|kicked|вынужденн\w*",
        rf"{_FORCE}|forcing",
        rf"\bforced|forcing|driv|excit|kick|external|вынужд|внешн|{_FORCE}",
        lambda law, known: _mentions("t", "F")(law, known) or _is_loaded(law, known),
    ),
    _Sort(
        r"perturbed|возмущ[её]нн\w*",
        r"perturbations?|возмущени\w+",
        r"perturb|возмущ",
        _mentions(r"\varepsilon", r"\epsilon", r"\mu", r"\delta"),
    ),
    _Sort(
        r"lineari[sz]ed|линеаризованн\w*",
        r"lineari[sz]ation",
        r"lineari[sz]|small|линеариз|мал|approxim|приближ",
        is_linear,
    ),
    _Sort(r"delayed|запаздывающ\w*", r"delays?|запаздывани\w+", "delay|retard|запазд"),
    _Sort(r"noisy|stochastic|стохастическ\w*", r"noise|шум\w*", "nois|stochast|random|шум|стохаст"),
    _Sort(r"relativistic|релятивистск\w*", r"relativistic\s+\w+", "relativi|релятив"),
    _Sort(r"quantum|квантов\w*", r"quantum\s+\w+", "quant|квант"),
    _Sort(
        r"(?:time-)?discreti[sz]ed|discrete|дискретн\w*|дискретизованн\w*|разностн\w*",
        r"discreti[sz]ation",
        r"discret|differenc|дискрет|разност|\bmap|отображ",
        lambda law, known: bool(law.images),
    ),
    _Sort("coupled", r"coupling", "coupl|связ", lambda law, known: len(law.variables) > 2),
)  # fmt: skip
_SIGNED = (
    r"(?:potential|forces?|fields?|springs?|charges?|interaction|coupling|mass|non-?linear\w*|cubic"
    r"|terms?|gravity|hamiltonian)"
)
_SIGNED_RU = (
    r"(?:потенциал|сил|пол|жёсткост|жесткост|заряд|взаимодействи|слагаем|член|гамильтониан)\w*"
)
_TURNED = r"(?:chang|revers|flip|invert|switch|alter)\w*"
_CHANGED = (
    rf"\bof\s+(?:an?other|(?:some\s+)?other|a\s+different)\s+(?:\w+\s+)?{_THING}",
    r"\bдруг(?:ой|их)\s+(?:\w+\s+)?(?:систем|уравнени|задач)\w+",
    r"\b(?:discreti[sz]ation|(?:difference|numerical|leap-?frog|midpoint|Runge\S*|Verlet|Euler(?:'s)?)\s+(?:scheme|integrator)s?"
    r"|дискретизаци\w+|(?:разностн|численн)\w+\s+схем\w+|схем\w+\s+Эйлера)\b",
    rf"\b{_TURNED}\s+(?:of\s+)?(?:the\s+|its\s+)?(?:signs?|directions?)\s+of\s+(?:the\s+|its\s+|this\s+)?(?:\w+\s+)?{_SIGNED}\b",
    rf"\bsigns?\s+of\s+(?:the\s+|its\s+|this\s+)?(?:\w+\s+)?{_SIGNED}\s+(?:is|are|be|were|was)\s+(?:\w+\s+)?{_TURNED}",
    rf"\b(?:with|for)\s+(?:the\s+)?opposite\s+sign\s+of\s+the\s+{_SIGNED}\b",
    rf"\b{_SIGNED}\s+(?:with|of)\s+(?:the\s+)?opposite\s+sign\b",
    r"\b(?:replac|chang|modif|alter|deform)\w*\s+(?:the|its|this)\s+(?:\w+\s+)?(?:potential|springs?|law\s+of\s+force|force\s+law)\b(?!\s+by\s+its)",
    r"\b(?:remov|drop|omit|delet|switch\w*\s+off|turn\w*\s+off)\w*\s+(?:the|this|its)\s+(?:non-?linear|cubic|quartic|quadratic|coupling|gravit\w+)"
    r"\s*(?:terms?|force|potential|part|field)?\b",
    r"\bwithout\s+the\s+(?:non-?linear|cubic|quartic|quadratic|coupling|gravitational)\s+(?:terms?|force|part|potential)\b",
    rf"\b(?:измен|смен|обра[тщ]|перемен|поменя)\w*\s+знак\w*\s+(?:\w+\s+)?{_SIGNED_RU}",
    rf"\bзнак\w*\s+{_SIGNED_RU}\s+(?:измен|смен|обра[тщ])\w+",
)
_MEDIUM = (
    r"\bin\s+(?:an?|the)\s+(?:resisting|viscous|dissipative|damping|noisy)\s+(?:medium|fluid|liquid|environment)\b"
    r"|\bmedium\s+with\s+(?:\w+\s+)?resistance\b|\bв\s+(?:сопротивляющ|вязк)\w+\s+(?:сред|жидкост)\w+"
)
_NAMES = (
    r"(?:Duffing|van\s+der\s+Pol|Lorenz|Lotka|Volterra|Toda|H\S{1,3}non|Li\S{1,3}nard|Emden|Painlev\S{1,3}"
    r"|Дюффинг|Ван[\s-]дер[\s-]Пол|Лоренц|Лотк|Вольтерр|Тод|Льенар|Пенлеве|Эмден)"
)
_NAMED = re.compile(
    rf"\b{_THING}\s+(?:of\s+)?{_NAMES}(?![\s,]*§)|\b{_NAMES}(?:['’]s)?(?:\s*[-–]+\s*\w+)?\s+{_THING}(?![\s,]*§)",
    re.IGNORECASE,
)
"""Systems that are not linear, by the names of those who found them."""


def _pattern(kind: _Sort) -> re.Pattern[str]:
    """What speaks of a kind of systems, if no value stands behind it."""
    return re.compile(
        rf"\b(?:{kind.called})(?:\s+[\w-]+){{0,2}}?\s+{_THING}"
        rf"|{_WITH}[^§.;]*?\b(?:{kind.acting})\b(?!\s*(?:coefficient|constant|parameter)s?\s*§)"
        + (rf"|{_MEDIUM}" if kind.has is _is_damped else ""),
        re.IGNORECASE,
    )


_PATTERNS = tuple((kind, _pattern(kind), re.compile(kind.near, re.IGNORECASE)) for kind in _KINDS)
_ANEW = re.compile("|".join(_CHANGED), re.IGNORECASE)
_NOT_THERE = re.compile(
    r"\b(?:no|not|never|without|absen\w+|neglect\w*|neglig\w*|ignor\w*|disregard\w*|unlike|contrast|opposed|free\s+of|free\s+from"
    r"|vanish\w*|exclud\w*|zero|than|like|as|similar\w*|before|без|нет|не|отсутств\w+|пренебр\w+|отличие|исключ\w+|как)\b",
    re.IGNORECASE,
)
"""Words that say that something is not there, or only compare."""
_PART = re.compile(
    r"[.;]|,\s*(?:and|so|и|а)\b|\b(?:but|while|whereas|yet|however|но|однако)\b", re.IGNORECASE
)
"""What ends a clause that has a subject of its own."""
_SETS_UP = re.compile(
    r"^\W*(?:(?:now|next|then|also|if|и|а|теперь)\b\W*)*(?:we|let|suppose|assume|add|consider|take|introduce|replace|change|reverse"
    r"|пусть|добавим|рассмотрим|изменим|сменим|уч?т[её]м|введ[её]м|предположим|заменим|включим)\b",
    re.IGNORECASE,
)
"""How a sentence begins that sets up another case for those behind it."""
_GOES_ON = re.compile(
    r"\W*(?:then|hence|thus|therefore|so|consequently|it\s+follows|тогда|отсюда|поэтому|следовательно|значит)\b",
    re.IGNORECASE,
)
"""How a sentence begins that goes on from the one before."""
_ELSEWHERE = re.compile(
    r"\b(?:section|chapter|appendix|later|below|elsewhere|next\s+\w+|shall|will|раздел\w*|глав\w+|ниже|далее)\b|\\(?:cite|ref)|\[\d",
    re.IGNORECASE,
)
_BACK = re.compile(
    r"\b(?:return|back|original|printed|above|un(?:damped|forced|perturbed|driven)|free|исходн\w+|верн[её]мся)\b",
    re.IGNORECASE,
)
"""Words for the system that is printed."""
_CALLS = re.compile(
    r"\b(?:call(?:ed)?|(?:this|it|that|these|they)\s+(?:is|are)|known\s+as|describes?|models?|terms?|represents?|stands?\s+for"
    r"|here|coefficients?|parameters?|называ\w+|это|описыва\w+|член\w*|слагаем\w+|здесь|коэффициент\w*|параметр\w*)\b",
    re.IGNORECASE,
)
"""Words that say what has been printed."""


_ALIKE = (
    r"comparison|auxiliary|dual|adjoint|conjugate|truncated|simplified|undamped|unforced|unperturbed|inverse|reversed?|homogeneous"
    r"|generating|free|limit(?:ing)?|linear(?:i[sz]ed)?|harmonic|physical|mathematical|сопряж[её]нн\w+|вспомогательн\w+"
    r"|двойственн\w+|укороченн\w+|упрощ[её]нн\w+|невозмущ[её]нн\w+|обратн\w+|однородн\w+|порождающ\w+|свободн\w+"
    r"|предельн\w+|линейн\w+|линеаризованн\w+|физическ\w+|математическ\w+"
)
_ARE = (
    r"(?:\b(?:is|are|reads?|becomes?|gives?|yields?|leads?\s+to|(?:takes?|has|have)\s+the\s+form|gets?|obtain|have|find"
    r"|прим\w+\s+вид|име\w+(?:\s+вид)?|есть|получ\w+)\b|[-—:])"
)
_ALSO_RATES = re.compile(
    rf"(?:\b(?P<alike>{_ALIKE})(?:\s+[\w-]+){{0,2}}?\s+(?:{_THING}|parts?\b|част\w+)(?:\s+(?:of|for|to|with|in)\s[^.;:,§]*|\s+\w+)?\s*"
    r"|\b(?:in|в)\s+(?:the\s+)?(?:dimension(?:al|less)|physical|original|reversed|inverse|(?:без)?размерн\w+|физическ\w+|обращ[её]нн\w+)"
    r"\s+(?:form|units?|variables?|time|форме|виде|единицах|переменных|времени)\b[^.;§]*?"
    r"|\b(?:interchang|exchang|swap|permut|перестав|переставл|обмен|меняя\s+местами)\w*\s[^.;]*?"
    r"|\b(?:revers|invert|обра[тщ])\w*\s+(?:(?:the|of)\s+)*(?:direction\s+of\s+(?:the\s+)?)?(?:time|motion|flow|arrow|врем\w+|движени\w+)\b[^.;§]*?"
    r"|\b(?P<flow>flow|vector\s+field|поток|equations?|уравнени\w+)\s+(?:(?:of|by|with|for|generated|defined|the|function|Hamiltonian|функции|с|гамильтонианом)\s+)+§\s*"
    r"|§\s*generates?\s+the\s+(?P<generated>(?:\w+\s+)?(?:flow|field|equations))\s*"
    rf"){_ARE}?(?:\s+(?:then|now|simply|given\s+by|тогда))?[\s:,~]*(?:§(?:[\s,;~]|\b(?:and|и)\b)*)*$",
    re.IGNORECASE,
)
"""How words end behind which the rates of a related law are printed: in the same letters."""


_COMES_OUT = re.compile(
    r"\b(?:an?|two|three|four|several|becom\w+|reduc\w+|gets?|obtain\w*|ha(?:s|ve)|gives?|yields?|if|when|for\s+§"
    r"|при|если|когда|получ\w+|переход\w+|сводится)\b[^.;]*$",
    re.IGNORECASE,
)
"""Words by which what is like it comes out of the printed law, as where a constant is zero."""


def of_related_law(item: SourceStatement, known: Known) -> str:
    """The words that give rates to another law than the printed one, to which it is related."""
    laws = [law for law in known.laws if law.order <= item.order]
    found = _ALSO_RATES.search(item.before) if laws else None
    if found is None or any(one in law.rows for law in laws for one in known.cited(item)):
        return ""
    if found["flow"] or found["generated"]:
        beside = [one for one in known.of_sentence(item.sentence) if one.order < item.order]
        given = [one for one in beside if known.varying(one.names) and not one.derives][-1:]
        heads = {
            one.formula.name if isinstance(one.formula, Name) else next(iter(one.bare), "")
            for one in given
        }
        own = {name for law in laws for name in (*law.mentions, *law.variables)} | {*HAMILTONIANS}
        return "flow of another function" if given and not heads & own else ""
    alike = found["alike"]
    if alike is not None and _COMES_OUT.search(item.before, 0, found.start("alike")):
        return ""
    around = _named_so(item, known, max(row.sentence[1] for law in laws for row in law.rows))
    called = alike is not None and re.search(rf"\b{re.escape(alike)}", around, re.IGNORECASE)
    linear = alike is not None and re.match("linear|лине", alike, re.IGNORECASE)
    if called or (linear and all(is_linear(law, known) for law in laws)):
        return ""
    return found[0].partition("§")[0].strip(" :,")


_OF_IT = re.compile(
    r"\W*(?:(?:it|its|they|their)\b|(?:for|by|of)\s+(?:it|them)\b|(?:this|these|the\s+latter|эт\w+)\s|(?:оно|он|она|его|её|их)\b)"
    r"|[^.;]*\b(?:its|their|latter|его|её|их)\b",
    re.IGNORECASE,
)
"""How a sentence begins that goes on to speak of what stood before it."""


def _behind_related_law(item: SourceStatement, known: Known) -> str:
    """The words for a related law of which a claim is made: in its sentence, or in the next."""
    before = (one for one in known.items if one.order < item.order and one.section is item.section)
    rows = [one for one in before if is_row(one) and known.roles[one].kind == "another-law"]
    found = _ALSO_RATES.search(rows[-1].before) if rows else None
    if found is None:
        return ""
    own = rows[-1].sentence == item.sentence
    next_to = rows[-1].sentence[1] == item.sentence[0] and _OF_IT.match(item.before)
    named = found["alike"] and re.search(rf"\b{found['alike']}", item.words, re.IGNORECASE)
    return found[0].partition("§")[0].strip(" :,") if own or next_to or named else ""


def of_another_system(item: SourceStatement, known: Known) -> str:
    """The words by which a claim is made of a system that is not printed; empty if it is not.

    They stand in its clause, in sentences before it in its paragraph that set another system up,
    or over its section.
    """
    laws = [law for law in known.laws if law.order <= item.order]
    if not laws or any(one in law.rows for law in laws for one in known.cited(item)):
        return ""
    if _is_of_its_constants(item, known):
        return ""
    if said := _behind_related_law(item, known):
        return said
    end = max(row.sentence[1] for law in laws for row in law.rows)
    own = f"{_PART.split(item.before)[-1]} § {_PART.split(item.after, maxsplit=1)[0]}"
    around = _named_so(item, known, end)
    told = ""
    for words in _sets_up(item, known, end):
        said = _said(words, around, laws, known)
        told = said or ("" if _BACK.search(words) else told)
    if told and not _BACK.search(item.words):
        return told
    return _said(own, around, laws, known)


def _is_of_its_constants(item: SourceStatement, known: Known) -> bool:
    """Whether nothing moves in an equation, and its sentence gives what is compared in it."""
    if item.derives or known.varying(item.names):
        return False
    given = {name: known.definition(name, item) for name in item.names if known.is_defined(name)}
    here = (one is not None and one.sentence == item.sentence for one in given.values())
    return bool(given) and any(here)


def _named_so(item: SourceStatement, known: Known, end: int) -> str:
    """What the text has up to the sentence of a law, and what says behind it what this is."""
    prose = known.paper.prose
    found = [prose.text[:end]]
    while end < item.sentence[0]:
        start, end = prose.sentence(end)
        words = prose.text[start:end]
        found += [words] if _CALLS.search(words) else []
    return " ".join(found)


def _sets_up(item: SourceStatement, known: Known, end: int) -> Iterator[str]:
    """The heading of a section behind a law, and the sentences before a claim in its paragraph."""
    prose = known.paper.prose
    yield from (f" {one.title} " for one in item.sections if one.start >= end)
    start = max(item.paragraph, item.section.start, end)
    if _GOES_ON.match(item.before) and start < item.sentence[0]:
        before = prose.sentence(item.sentence[0] - 1)
        if not _prints_rates(before, known):
            yield prose.between(*before)
    for at in prose.stops:
        if start <= at < item.sentence[0]:
            words = prose.between(*prose.sentence(at))
            if _prints_rates(prose.sentence(at), known):
                continue
            if _SETS_UP.search(words) and not _ELSEWHERE.search(words):
                yield words
            elif _BACK.search(words):
                yield " original "


def _prints_rates(sentence: tuple[int, int], known: Known) -> bool:
    """Whether equations of motion stand in a sentence: then the system is printed."""
    return any(map(is_row, known.of_sentence(sentence)))


def _said(words: str, around: str, laws: list[Law], known: Known) -> str:
    """The words that speak of a system of a kind of which no law is."""
    for kind, pattern, near in _PATTERNS:
        there = any(kind.has(law, known) for law in laws) or _speaks(near, around)
        if not there and (said := _speaks(pattern, words)):
            return said
    if not any(law.images for law in laws) and not _ANEW.search(around):
        if said := _speaks(_ANEW, words):
            return said
    linear = all(is_linear(law, known) for law in laws)
    return _speaks(_NAMED, words) if linear and not _NAMED.search(around) else ""


def _speaks(pattern: re.Pattern[str], words: str) -> str:
    """The first of some words beside which nothing in their clause says that this is not there."""
    for found in pattern.finditer(words):
        before = _PART.split(words[max(0, found.start() - 40) : found.start()])[-1]
        behind = _PART.split(words[found.end() : found.end() + 30], maxsplit=1)[0]
        own = "" if pattern is _ANEW else found[0]
        beside = f"{before.rpartition('§')[2]}{own}{behind.partition('§')[0]}"
        if len(_NOT_THERE.findall(beside)) % 2 == 0:
            return found[0].strip()
    return ""
