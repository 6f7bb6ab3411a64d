"""Words that say what a formula is, in English and in Russian: one table for all rules."""

from __future__ import annotations

import re
from functools import cache

CUES: dict[str, tuple[str, ...]] = {
    "integral": (
        r"(?:first|partial|additional|second|third|fourth|new|energy|area|geometric\w*|the)\s+integrals?",
        r"integrals?\s+of\s+(?:the\s+)?(?:motion|energy|areas?|second|third|fourth|degree)",
        r"integrals?\b", r"conserved", r"constants?\s+of\s+(?:the\s+)?motion",
        r"(?:is|are|remains?|stays?)\s+(?:a\s+|also\s+)?(?:constants?|preserved|conserved)",
        r"do(?:es)?\s+not\s+(?:change|depend\s+on\s+(?:the\s+)?time)",
        r"интеграл\w*", r"сохраня\w+", r"постоян(?:на|но|ны|ен)\b", r"не\s+меня\w+",
    ),
    "invariant": (
        r"invariant", r"keeps?\s+the", r"(?:leaves?|leaving)\s+(?:it|them|the\s+\w+)\s+invariant",
        r"no\s+(?:motion|trajectory|orbit|solution)\s+leaves", r"satisfied\s+by",
        r"инвариантн\w+", r"удовлетворя\w+",
    ),
    "equilibrium": (
        r"equilibri\w+", r"state\w*\s+of\s+rest", r"(?:singular|stationary|fixed|critical)\s+points?",
        r"равновеси\w+", r"стационарн\w+", r"особ\w+\s+точ\w+",
    ),
    "suppose": (
        r"suppos\w+", r"assum\w+", r"\blet\b", r"\btake\b", r"\bmake\b", r"\bif\b", r"\bwhen\b",
        r"\bfor\s+(?:the\s+)?(?:\w+\s+){0,3}$", r"\bput\b", r"\bset(?:ting)?\b", r"provided",
        r"choos\w+", r"choice", r"\bunder\b", r"in\s+the\s+case", r"\bcase\b", r"restrict\w+",
        r"\bconsider\b", r"\bwith\b", r"on\s+the\s+(?:\w+\s+)?levels?",
        r"пусть", r"предполож\w+", r"полож\w+", r"полага\w+", r"если", r"при\s*$", r"допуст\w+",
        r"в\s+случае", r"будем\s+считать", r"считая", r"возьм\w+", r"выбер\w+", r"\bпри\b",
    ),
    "define": (
        r"\blet\b", r"denot\w+", r"defin\w+", r"introduc\w+", r"\bput\b", r"\bset\b", r"notation",
        r"\bwrite\b", r"\bwhere\b", r"\bhere\b", r"\bcall(?:ed)?\b", r"new\s+variables?",
        r"in\s+the\s+variables?", r"abbreviat\w+", r"stands?\s+for", r"\bwith\s+the\b",
        r"обознач\w+", r"введ\w+", r"вводя", r"полож\w+", r"пусть", r"\bгде\b", r"\bздесь\b",
        r"определ\w+", r"в\s+переменных",
    ),
    "where": (r"\bwhere\b", r"\bhere\b", r"\bin\s+which\b", r"\bгде\b", r"\bздесь\b"),
    "claim": (
        r"therefore", r"hence", r"thus", r"follow\w*", r"whence", r"we\s+(?:have|find|get|obtain)",
        r"one\s+(?:has|finds|gets|obtains)", r"(?:so|such)\s+that", r"consequently", r"lead\w*\s+to",
        r"gives?", r"yields?", r"impl(?:y|ies)", r"becom\w+", r"turns?\s+into", r"show\w*", r"prov\w+",
        r"obtain\w*", r"satisf\w+", r"holds?", r"because", r"\bthen\b", r"there\s+is", r"indeed",
        r"takes?\s+the\s+form", r"identit\w+", r"arriv\w+", r"reduc\w+", r"\bis\b", r"equals?",
        r"следовательно", r"следу\w+", r"отсюда", r"поэтому", r"получ\w+", r"имеем", r"име\w+\s+место",
        r"\bтогда\b", r"\bзначит\b", r"вытека\w+", r"прим\w+\s+вид", r"удовлетвор\w+", r"тождеств\w+",
        r"доказ\w+", r"выполн\w+", r"справедлив\w+", r"да[её]т", r"приход\w+", r"находим",
    ),
    "follows": (
        r"follow\w*", r"therefore", r"hence", r"thus", r"consequently", r"whence", r"\bfrom\b",
        r"substitut\w+", r"eliminat\w+", r"so\s+that", r"because\s+of", r"by\s+virtue", r"using",
        r"\bon\s+(?:it|this|them|these)\b", r"there\b", r"under\s+(?:the|these)\s+condition",
        r"taking\s+into\s+account", r"imply", r"lead",
        r"отсюда", r"из\s", r"следовательно", r"подстав\w+", r"исключ\w+", r"в\s+силу", r"с\s+учётом",
        r"с\s+учетом", r"поэтому", r"учитывая",
    ),
    "on it": (r"\bon\s+(?:it|this|them|these|that)\b", r"\bthere\b", r"на\s+н[её][мй]?\b", r"на\s+них"),
    "level": (
        r"levels?", r"manifold", r"relations?", r"\bsets?\b", r"surfaces?", r"submanifold",
        r"уровн\w+", r"многообрази\w+", r"соотношени\w+", r"поверхност\w+", r"множеств\w+",
    ),
    "constraint": (
        r"constraints?", r"connected\s+by", r"subject\s+to", r"связ(?:ь|и|ью|ями)\b", r"стеснен\w+",
    ),
    "approximate": (
        r"terms?\s+of\s+(?:the\s+)?(?:first|second|higher|lowest)\s+order", r"to\s+(?:the\s+)?first\s+order",
        r"(?:first|linear|crude|rough)\s+approximation", r"approximat\w+", r"lineari[sz]\w+", r"neglect\w*",
        r"small\s+(?:§|deviation|oscillation|perturbation|amplitude|parameter|variation|displacement|vibration|quantit)\w*",
        r"first\s+variation", r"asymptotic\w*", r"infinitesimal\w*",
        r"перв\w+\s+приближени\w+", r"приближ[её]нн\w+", r"линеариз\w+", r"пренебрег\w+", r"асимптотич\w+",
        r"мал\w+\s+(?:§|колебани|отклонени|возмущени|параметр|амплитуд)\w*", r"бесконечно\s+мал\w+",
        r"член\w+\s+(?:перв|втор|высш)\w+\s+порядк\w+",
    ),
    "denied": (
        r"\bnot\s+(?:true|an?\s+integral|constant|conserved|the|valid|hold|correct|preserved|in\s+general)",
        r"does\s+not\s+(?:hold|vanish|follow)", r"is\s+not\b", r"are\s+not\b", r"\bno\s+longer\b", r"never\b",
        r"wrong\w*", r"incorrect\w*", r"erroneous\w*", r"false\b", r"mistak\w+", r"misprint\w*", r"contrary",
        r"instead\s+of\s*(?:§|$)", r"contradict\w+", r"if\s+it\s+were", r"\bwere\b", r"would\s+be", r"fails?\b",
        r"cannot\b", r"refut\w+", r"in\s+place\s+of\s*(?:§|$)", r"\bneither\b",
        r"невер\w+", r"ошиб\w+", r"ложн\w+", r"опечат\w+", r"вместо\s*(?:§|$)", r"противореч\w+", r"не\s+явля\w+",
        r"не\s+сохраня\w+", r"нельзя", r"не\s+выполн\w+", r"неправильн\w+", r"не\s+верно", r"не\s+име\w+\s+мест",
    ),
    "quoted": (
        r"\baccording\s+to\b", r"\bclaims?\s+that", r"\bclaimed\b", r"\basserted?\b", r"\bwrites\b",
        r"\bconjectur\w+", r"one\s+might\s+(?:think|expect)", r"\bbelieve[sd]?\b", r"it\s+is\s+said",
        r"утвержда\w+", r"по\s+мнению", r"предположительно", r"гипотез\w+",
    ),
    "system": (
        r"equations?\s+of\s+motion", r"equations?\s+(?:are|read|take|have)", r"\bsystem\b", r"\bmodel\b",
        r"now\s+consider", r"reduced\s+(?:system|equations)", r"in\s+polar\s+coordinates", r"another\s+system",
        r"obey\w*", r"governed\s+by", r"described\s+by", r"euler\w*\s+equations", r"hamilton\w*\s+equations",
        r"уравнени\w+\s+движени\w+", r"систем\w+", r"уравнени\w+", r"описыва\w+",
    ),
    "another system": (
        r"now\s+(?:\w+\s+){0,2}consider", r"\breduced\b", r"\blimit\b", r"polar\s+coordinates", r"another\s+(?:system|problem|example)",
        r"second\s+(?:system|example|problem)", r"\bconsider\s+(?:now|also|next|the)", r"next\s+example", r"\bturn\s+to\b",
        r"теперь\s+рассмотр\w+", r"рассмотрим\s+(?:теперь|также)?", r"друг\w+\s+(?:систем|задач|пример)\w+", r"приведенн\w+", r"полярн\w+",
    ),
    "hamiltonian": (r"\bhamilton\w*", r"canonical\w*", r"гамильтон\w*", r"каноническ\w+"),
    "solution": (
        r"solved\s+by", r"solutions?\b", r"\bsolves\b", r"direct\s+substitution",
        r"решени\w+", r"подстанов\w+",
    ),
    "if": (r"\bif\s*$", r"\bwhen\s*$", r"\bunless\b", r"\bif\s+(?:and\s+only\s+if\s*)?$", r"если\s*$", r"когда\s*$"),
}  # fmt: skip


@cache
def _pattern(cue: str) -> re.Pattern[str]:
    return re.compile("|".join(CUES[cue]), re.IGNORECASE)


def cue(name: str, words: str) -> str:
    """The first of some words that give a cue; empty if none do."""
    found = _pattern(name).search(words)
    return found[0].strip() if found else ""


def last_cue(name: str, words: str) -> int:
    """Where the last words stand that give a cue; -1 if none do."""
    return max((found.start() for found in _pattern(name).finditer(words)), default=-1)
