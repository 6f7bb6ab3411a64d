"""Words that say what a formula is, in English and in Russian: one table for all rules."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache

_OF_MAP = r"""
        \binvariants?\s+(?:of|under)\s+(?:the\s+|this\s+|our\s+)?(?:\w+\s+)?map(?:ping)?\b
        \bmap(?:ping)?\s+(?:has|admits|possesses)\s+(?:the|an)\s+(?:\w+\s+)?invariants?\b
        \b(?:preserves|conserves)\s+the\s+(?:functions?|quantit(?:y|ies)|polynomials?)\b
        инвариант\w*\s+отображени\w+"""
"""What is constant under a map."""

_NO_SLIP = r"""
        \broll\w*\s+without\s+(?:slipping|sliding|slip)\b
        \broll(?:s|ing)?\s+(?:on|along|over|down|inside)\b
        (?:\bno|\bnot|never|cannot)\s+(?:slip|skid)\w*
        (?:\bnot|never|cannot)\s+(?:slide|move)\s+sideways без\s+(?:проскальзыван|скольжен)\w+
        не\s+(?:скольз|проскальз)\w+"""
"""How a body that rolls, or slides along a blade, does not move."""

_SUCH = (
    r"(?:(?:an?|the)\s+(?:\w+\s+){0,2}(?:integral|constant|invariant|solution)s?"
    r"|integrals|constants?|conserved|preserved|invariants?|true|correct|valid|right)\b"
)
"""What may be said of a formula: that it is an integral, or holds."""

_NEGLECTED = r"""
        (?<!not\s)(?<!not\sbe\s)\b(?:neglect|ignor|disregard)\w*
        \b(?:omit|drop|discard)(?:s|ping|ting|ped|ted|ing|ed)?\s+(?:the\s+)?(?:\w+\s+)?(?:§|friction|damping|drag|terms?|it|them)\b
        \blet\s+§\s+(?:vanish|tend|go)\b \bset\w*\s+(?:\w+\s+)?aside\b
        \b(?:to|in|at)\s+(?:the\s+)?zero(?:th|eth)?[\s-]+order\b \bzeroth\b \bof\s+order\s+zero\b
        \b(?:were\s+it|it\s+were)\s+not\s+for\b
        \bif\s+(?:§|friction|damping)\s+were\s+(?:absent|zero)\b
        (?<!нельзя\s)\bпренебре\w* \bне\s+учитыва\w+ \bотбрасыва\w+
        \bв\s+нулев\w+\s+(?:приближени|порядк)\w+
        \bvernachl(?:ä|\\"a)ssig\w* \bn(?:é|\\'e)glige\w*"""
"""What is left out, so that something else moves than what is printed."""

_FOLLOWING = (
    r"\b(?:in\s+what\s+follows|in\s+the\s+sequel|henceforth|hereafter|from\s+(?:now|here)\s+on(?:wards)?"
    r"|in\s+all\s+that\s+follows|everywhere\s+below|(?:всюду|везде)\s+(?:далее|ниже|в\s+дальнейшем)"
    r"|в\s+дальнейшем|впредь)\b"
)
"""Words for all that follows."""
_HENCEFORTH = rf"{_FOLLOWING}[\s,~]*$"
"""These words, right before what is so there."""

CUES: dict[str, str] = {
    "integral": rf"""
        {_OF_MAP}
        (?:first|partial|additional|second|third|fourth|new|energy|area|geometric\w*|the)\s+integrals?
        integrals?\s+of\s+(?:the\s+)?(?:motion|energy|areas?|second|third|fourth|degree)
        \bthe\s+(?!(?:elliptic|hyperelliptic|abelian|definite|indefinite|line|action|path|contour|general|same|double|last|following)\b)\w+\s+integral\s+(?:has\s+the\s+form|takes\s+the\s+form|reads|is)
        integrals?\b conserved constants?\s+of\s+(?:the\s+)?motion
        (?:have|has|obtain|find|get)\s+(?:the|an?)\s+(?:second|third|further|other)\s+constant[\s:]*$
        (?:is|are|remains?|stays?)\s+(?:a\s+|also\s+)?(?:constants?|preserved|conserved)
        (?<!not\s)(?<!n't\s)\b(?:con|pre)serv(?:es?|ing)\b(?=(?:[\s~]+(?!measures?|volumes?|areas?|brackets?|forms?|structure)\w+){{0,4}}[\s~]*(?:§|$))
        do(?:es)?\s+not\s+(?:change|depend\s+on\s+(?:the\s+)?time) интеграл\w* сохраня\w+
        (?:is|are|has|have|admits?|possesses|becomes?)\s+(?:then\s+|also\s+)?(?:an?|the)\s+(?:(?!adiabatic|relative|integral)[\w–-]+\s+){{0,2}}invariants?(?=[\s~]*(?:[.,;:§]|$|of\s+(?:the\s+)?(?:motion|flow|system|equations?|dynamics)))
        \b(?:an?|the)\s+(?:(?!adiabatic|relative|integral)[\w–-]+\s+){{1,2}}invariant\s+(?:of\s+(?:the\s+)?(?:motion|flow|system|equations?)\s+)?(?:is|reads|has\s+the\s+form|takes\s+the\s+form)(?=[\s:~]*(?:§|$))
        постоян(?:на|но|ны|ен)\b не\s+меня\w+""",
    "restated": r"""
        \bin\s+(?:(?:the|their|its)\s+)?(?:cartesian\s+|scalar\s+)?components?\b \bcomponentwise\b
        \bfor\s+the\s+components\b \bin\s+(?:component|scalar|real)\s+(?:form|notation)\b
        \bin\s+full\b
        \bexplicit(?:ly)?\b(?!\s+(?:solution|function|dependence|time)) \bwritten\s+out\b
        \bwrit\w+\s+(?:\w+\s+){0,4}out\b \bin\s+other\s+words\b
        \bв\s+(?:компонентах|проекциях|скалярн\w+\s+(?:виде|форме)|развёрнут\w+\s+виде)
        \bпокомпонентно\b
        \bв\s+явном\s+виде\b
        \bin\s+Komponenten\b \bexplizit\b \bausgeschrieben\b \ben\s+composantes\b""",
    "that is": r"""
        \bi\.\s*e\. \bthat\s+is\b \bnamely\b
        \bт\.\s*е\. \bто\s+есть\b \bd\.\s*h\. \bc['’]est-(?:à|\\`a)-dire\b""",
    "energy": r"""
        (?<!instead\sof\sthe\s)(?<!kinetic\s)(?<!potential\s)\benergy\b(?!\s+levels?)(?:\s+(?!satisf|chang|equation)\w+){0,5}[\s:,]*$
        (?<!етическ..\s)(?<!нциальн..\s)\bэнерги[яи]\b(?:\s+\w+){0,4}[\s:,—-]*$""",
    "its constant": r"""
        (?<=\w)(?<!\band)\s+with\s+the\s+constants?[\s:]*$
        (?<=\w)(?<!\bи)\s+с\s+постоянн(?:ой|ыми)[\s:]*$""",
    "of a map": _OF_MAP,
    "symplectic": r"""
        \bsymplectic\w* \bcanonical\b \bbrackets?\b \bintegrab\w+ симплектическ\w+ канонич\w+
        скоб\w+ интегрируем\w+""",
    "invariant": r"""
        invariant keeps?\s+the (?:leaves?|leaving)\s+(?:it|them|the\s+\w+)\s+invariant
        no\s+(?:motion|trajectory|orbit|solution)\s+leaves
        \b(?:is|are)\s+(?:an?\s+)?(?:orbits?|trajector(?:y|ies))
        \bconsists?\s+of\s+(?:\w+\s+)?(?:orbits|trajectories|solutions)
        состо[ия]т\s+из\s+(?:\w+\s+)?(?:траекторий|решений|движений) satisfied\s+by инвариантн\w+
        удовлетворя\w+""",
    "equilibrium": r"""
        equilibri\w+ (?:states?|points?)\s+of\s+(?:rest|libration)
        (?:rest|libration)\s+points? (?<!quasi-)\bsteady\s+states?
        (?:singular|stationary|fixed|critical)\s+points? stationary\s+(?:states?|solutions?)
        равновеси\w+ стационарн\w+ особ\w+\s+точ\w+ точ\w+\s+либрации""",
    "suppose": rf"""
        {_HENCEFORTH}
        suppos\w+ assum\w+ \blet\b \btake\b \bmake\b \bif\b \bwhen\b \bgiven\s+that\b
        \bimpos(?:e|ing)\b \b(?:we|us|now)\s+(?:require|demand)\b \brequiring\b
        \bsubject\s+to\s+(?:the|a)\s+(?:\w+\s+)?(?:relation|condition|restriction|requirement)s?\b
        \bfor(?:\s+(?:the\s+)?(?:\w+\s+){{0,2}}\w+)?\s*$ \bput(?:ting)?\b(?!\s+together) \bsetting\b
        (?:we|us|and|now|^\s*)\s*set\s*$
        provided choos\w+ choice as\s+long\s+as
        \bunder\b in\s+the\s+case \bcase\b restrict\w+ \bconsider\b
        (?<!involution\s)(?<!commutes\s)(?<!coincides\s)(?<!agrees\s)(?<!identical\s)\bwith\b(?!\s+respect)
        on\s+the\s+(?:\w+\s+)?levels? пусть предполож\w+ полага\w+ если при\s*$ допуст\w+
        \bположи(?:м|в|вши|ть)\b
        \bпотребуем\b \bтребуя\b \bналож(?:им|ив)\b \bналагая\b \bподчиним\b
        в\s+случае \bпока\b будем\s+считать считая возьм\w+ выбер\w+ \bпри\b""",
    "ansatz": r"""
        \btr(?:y|ied|ying|ial)\b \bseek\b \bsought\b look(?:ing)?\s+for ansatz \bguess\w*
        particular\s+(?:integral|solution) ищем \bискать\b подстановк\w+ частн\w+\s+решени\w+""",
    "when": r"""
        \bif\b \bwhen\b \bsuppos\w+ \blet\b \bесли\b \bкогда\b \bпусть\b""",
    "define": r"""
        \blet\b denot\w+ defin\w+ introduc\w+ \bput\b(?!\s+together) \bset\b notation
        \bwrite\b \bwhere\b \bhere\b \bcall(?:ed)?\b new\s+variables? in\s+the\s+variables?
        abbreviat\w+ stands?\s+for \bwith\s+the\b обознач\w+ введ\w+ вводя пусть \bгде\b
        \bположи(?:м|в|вши|ть)\b \bздесь\b определ\w+ в\s+переменных
        \b(?:putting|setting|letting|writing|полагая)\b(?=[\s~]*(?:§|$))""",
    "in this part": r"""
        \bin\s+this\s+(?:section|chapter|subsection|part|case) \bhere\b
        в\s+эт(?:ом|ой)\s+(?:разделе|параграфе|главе|пункте|случае) \bздесь\b
        in\s+diesem\s+(?:Abschnitt|Kapitel|Fall\w*) dans\s+cette\s+section
        dans\s+ce\s+(?:paragraphe|chapitre|cas)""",
    "to the end": rf"""
        \b(?:rest|remainder)\s+of\s+(?:the|this|our)\s+(?:paper|article|note|work|text|chapter|lecture)s?\b
        {_FOLLOWING}
        \bthroughout(?=\s+(?:the|this|our)\s+(?:paper|article|note|work|text)|\s*(?:[,.;§]|$|we\b))
        \bthroughout\s+(?:let|suppose|assume|take|put)\b
        \bв\s+остальной\s+части\s+(?:статьи|работы) \bim\s+Folgenden\b \bdans\s+la\s+suite\b""",
    "lasting": rf"""
        {_HENCEFORTH}
        \blet\b suppos\w+ assum\w+ пусть предполож\w+""",
    "for": r"""
        \bfor\b(?:\s+(?:the\s+)?(?:\w+\s+){0,2}\w+)?\s*(?:§[^§]*)*$
        \bпри\b(?:\s+\w+){0,2}\s*(?:§[^§]*)*$""",
    "where": r"""
        \bwhere\b \bhere\b(?!\s+(?:are|is)\b) (?<!\bcase\s)(?<!\bone\s)(?<!\bthat\s)\bin\s+which\b
        \bгде\b \bздесь\b""",
    "claim": r"""
        therefore hence thus follow\w* whence we\s+(?:have|find|get|obtain)
        one\s+(?:has|finds|gets|obtains) (?:so|such)\s+that consequently lead\w*\s+to gives?
        yields? impl(?:y|ies) becom\w+ turns?\s+into show\w* prov\w+ obtain\w* satisf\w+ holds?
        because \bthen\b there\s+is indeed takes?\s+the\s+form identit\w+ arriv\w+ reduc\w+ \bis\b
        equals? следовательно следу\w+ отсюда поэтому получ\w+ имеем име\w+\s+место \bтогда\b
        \bзначит\b вытека\w+ прим\w+\s+вид удовлетвор\w+ тождеств\w+ доказ\w+ выполн\w+
        справедлив\w+ да[её]т приход\w+ находим""",
    "further": r"""
        \balso\b moreover besides furthermore in\s+addition likewise \bтакже\b кроме\s+того
        более\s+того""",
    "then": r"""
        \bthen\b \bтогда\b \bто\b""",
    "initially": r"""
        (?:is|be|was)\s+(?:pushed|struck|kicked|thrown|launched|set\s+in\s+motion|projected|hit)\b
        \b(?:толкнули|бросили|ударили|толкнут|брошен)\w*
        \binitial(?:ly)?\b \breleas\w+ \bdropped\b \blet\s+go\b \bthrown\b \blaunch\w+
        \bstart(?:s|ed|ing)?\b \bat\s+the\s+(?:beginning|outset)\b
        \bначальн\w+ \bв\s+начале\b отпу[щс]\w+ \bброш\w+ запущен\w* начина\w+\s+движ\w+""",
    "at rest": r"""
        \b(?:at|from)\s+rest\b \bdropped\b \breleased\b \blet\s+go\b отпущен\w*
        \bno\s+(?:speed|velocity)\b \bwithout\s+(?:an?\s+)?(?:initial\s+)?velocity\b
        из\s+(?:состояния\s+)?покоя \bпокоится\b без\s+начальной\s+скорости""",
    "special motion": r"""
        \b(?:stead|stationar|permanent|special|circular|conical|periodic|equilibri|separatri)\w*
        \buniform(?:ly)?\b(?!\s+(?:\w+\s+)?(?:fields?|gravit\w+|rods?|dis[ck]s?|spheres?|bod\w+|density))
        (?<!\bin\s)\bparticular\b \b(?:homo|hetero)clinic\w* \b(?:relative|at)\s+rest\b
        \bat\s+the\s+(?:lowest|highest|top|bottom|turning|point)\b
        \b(?:равномерн|стационарн|установивш|перманентн|частн(?!ост)|кругов|коническ|периодическ)\w*
        \b(?:равновеси|поко[йяею]|сепаратрис)\w*""",
    "follows": r"""
        follow\w* therefore hence thus consequently whence \bfrom\b substitut\w+ eliminat\w+
        so\s+that because\s+of by\s+virtue using \bon\s+(?:it|this|them|these)\b there\b
        under\s+(?:the|these)\s+condition taking\s+into\s+account imply lead отсюда из\s
        следовательно подстав\w+ исключ\w+ в\s+силу с\s+учётом с\s+учетом поэтому учитывая""",
    "deduced": r"""
        therefore hence thus consequently whence follow\w* substitut\w+ eliminat\w+ differentiat\w+
        by\s+virtue because\s+of becom\w+ takes?\s+the\s+form turns?\s+into reduc\w+
        \b(?:we|one)\s+(?:have|has|finds?|gets?|obtains?)
        следовательно отсюда подстав\w+ исключ\w+ в\s+силу поэтому получ\w+ имеем прим\w+\s+вид
        привод\w+ вытека\w+""",
    "here": r"""
        (?:\bon|\bif|\bwhen|\bfor|\bat|\bwhere|\bна|\bпри|\bесли)\s+(?:the\s+)?(?:\w+\s+){0,2}(?:§[\s,]*)*$""",
    "on a set": r"""
        \b(?:on|at|на)(?:\s+the\s+\w+)?[\s~]*$""",
    "either root": r"""
        signs?\s+of\s+(?:the\s+|this\s+)?(?:square\s+)?(?:roots?|radicals?) either\s+sign
        (?:roots?|radicals?)\s+(?:has|have|takes?|is|are)\s+(?:taken\s+with\s+)?(?:the|either|that|both)\s+signs?
        either\s+(?:value|branch)\s+of\s+the\s+(?:square\s+)?(?:root|radical)
        знак\w*\s+(?:\w+\s+)?(?:корня|корней|радикал\w*)""",
    "places": r"""
        planes lines axes points surfaces sets circles плоскост(?:и|ей) прям(?:ые|ых) ос(?:и|ей)\b
        точ(?:ки|ек)""",
    "derived": r"""
        \b(?:we|one)\s+(?:have|has|finds?|gets?|obtains?) becom\w+ takes?\s+the\s+form reduc\w+
        получ\w+ имеем прим\w+\s+вид привод\w+""",
    "place": r"""
        \bnear\b in\s+the\s+(?:\w+\s+)?(?:cases?|ones?)\b \bcases?\s+\( neighbou?rhood
        \bat\s+(?:this|these|that|those|such)\b вблизи окрестност\w+
        в\s+(?:\w+\s+)?случа(?:е|ях)\b""",
    "on it": r"""
        \bon\s+(?:it|this|them|these|that|which)\b \bthere\b на\s+н[её][мй]?\b на\s+них
        на\s+котор(?:ом|ой|ых)\b""",
    "on them": r"""
        \bon\s+(?:them|these)\b \bthere\b на\s+(?:них|этих)""",
    "restricted": r"""
        restrict\w+\s+to\b
        \bon\s+(?:the\s+|this\s+)?(?:\w+\s+)?(?:sets?|manifolds?|submanifolds?|levels?|surfaces?|spheres?)\b
        ограничен\w+\s+на\b
        на\s+(?:\w+\s+)?(?:множеств|многообрази|поверхност|уровн|сфер)\w+""",
    "level": r"""
        levels? manifold relations? \bsets?\b surfaces? submanifold уровн\w+ многообрази\w+
        соотношени\w+ поверхност\w+ множеств\w+ уровен\w+""",
    "constraint": r"""
        constrain\w+
        (?:lie|stay|move|remain|slide)s?\s+(?:\w+\s+){0,2}on\s+(?:the|an?)\s+(?:\w+\s+){0,4}(?:sphere|circle|surface|curve|line|parabol\w+|ellipse|ellipsoid|cylinder|cone|cycloid|helix|wire|hoop)\b
        (?:lie|stay|move|remain|slide)s?\s+(?:\w+\s+){0,2}along\s+(?:the|an?)\s+(?:\w+\s+){0,4}(?:circle|curve|line|parabola|ellipse|cycloid|helix|wire|hoop)\b
        (?:движ|скольз)\w+\s+(?:\w+\s+){0,2}по\s+(?:\w+\s+){0,2}(?:сфер|окружност|поверхност|крив|парабол|эллипс|цилиндр|конус|циклоид|проволок)\w*
        (?:\bon|\b(?:bound|confined|tied|attached)\s+to)\s+(?:the|an?)\s+(?:\w+\s+){0,4}(?:sphere|circle|surface|curve|line|paraboloid|ellipsoid|cylinder|cone)\s*$
        \bна\s+(?:\w+\s+){0,2}(?:сфер|окружност|поверхност|крив|параболоид|эллипсоид|цилиндр|конус)\w*\s*$
        connected\s+by subject\s+to связ(?:ь|и|ью|ями)\b стеснен\w+""",
    "frame": r"""
        frames? observers? Lorentz\w* Galile\w* систем\w+\s+отсч[её]та наблюдател\w+""",
    "approximate": r"""
        terms?\s+of\s+(?:the\s+)?(?:first|second|higher|lowest)\s+order
        (?:to|in)\s+(?:the\s+)?(?:first|lowest|leading)\s+order
        (?:first|linear|crude|rough)\s+approximation approximat\w+
        lineari[sz]\w+
        neglect\w*\s+(?:\w+\s+){0,3}(?:terms|orders?|powers|squares|products|quantities)
        (?:terms|orders?|powers|squares|products|quantities)\s+(?:\S+\s+){0,6}?neglect\w*
        small\s+(?:§|angle|deviation|oscillation|motion|perturbation|amplitude|parameter|rotation|variation|displacement|vibration|quantit)\w*
        (?:§|angles?|deviations?|displacements?|amplitudes?)[\s,]*(?:is|are|being|remains?)\s+small\b
        (?:§|angles?|deviations?|displacements?|amplitudes?)\s+(?:to\s+be\s+)?(?:very\s+)?small\b
        (?:§|уг(?:ол|лы)|отклонени[ея]|амплитуд[уы])\s+(?:\w+\s+)?мал(?:ым|ыми|ой|ы)\b
        линейн\w+\s+член\w*
        petites\s+oscillations kleine\w*\s+(?:Schwingung|Ausschl|Winkel)\w*
        (?:keep|retain)\w*\s+(?:only\s+)?(?:the\s+)?(?:linear|first-order|leading)\s+terms
        (?:сохран|удерж|оставл)\w+\s+(?:только\s+|лишь\s+)?(?:линейные|главные)\s+члены
        \bup\s+to\s+(?:terms|quantities|errors?|corrections)\s+of
        \bwith\s+an?\s+error\s+of \broughly\b
        \b(?:almost|nearly)\b(?!\s+(?:all|every|any|surely|periodic\w*|integrable))
        \bto\s+(?:an?\s+)?(?:good|high|great|fair|sufficient)\s+(?:accuracy|precision|approximation)
        \bonly\s+(?:the\s+)?(?:leading|lowest|principal|main)\s+terms \bпрактически\b
        \bпочти\b(?!\s+(?:вс|кажд|периодич))
        \bс\s+точностью\s+до\b(?!\s+(?:множител|постоянн|знака))
        \bn\S{1,3}herungsweise\b \bapproximativement\b \bpresque\b(?!\s+(?:tou|chaque))
        first\s+variation asymptotic(?:ally\s+equal|\s+(?:expansion|formula|series|equation))
        infinitesimal\w* перв\w+\s+приближени\w+ приближ[её]нн\w+
        линеариз\w+ пренебрег\w+\s+(?:\w+\s+){0,3}(?:член|слагаем|степен|квадрат|величин)\w+
        мал\w+\s+(?:§|уг(?:ол|л)|колебани|движени|отклонени|возмущени|параметр|амплитуд)\w*
        бесконечно\s+мал\w+
        член\w+\s+(?:перв|втор|высш)\w+\s+порядк\w+""",
    "linear": r"""
        first\s+(?:order|approximation|variation) lineari[sz]\w*
        linear\s+(?:equation|system|approximation)
        (?:keep|retain)\w*\s+(?:only\s+)?(?:the\s+)?(?:linear|first-order)\s+terms
        small\s+(?:angle|deviation|oscillation|motion|displacement|vibration)\w* infinitesimal\w*
        перв\w+\s+(?:порядк|приближени)\w+ линеариз\w+ линейн\w+\s+(?:уравнени|систем)\w+
        мал\w+\s+(?:колебани|отклонени)\w+""",
    "linear part": r"""
        \blinear\s+(?:parts?|terms?) линейн\w+\s+(?:част|член)\w*""",
    "small": r"""
        small\s+(?:angle|oscillation|vibration|deviation|displacement)\w*
        (?:angles?|deviations?|displacements?)[\s,]*(?:is|are|being|remains?)\s+small\b
        мал\w+\s+(?:уг(?:ол|л)|колебани|отклонени)\w*""",
    "denied": rf"""
        \bfar\s+from\s+(?:being\s+)?{_SUCH}
        \b(?:hardly|scarcely|barely|seldom|rarely)\s+(?:ever\s+)?(?:be\s+)?{_SUCH}
        \b(?:by\s+no\s+means|in\s+no\s+way|anything\s+but|nowhere\s+near|not\s+(?:at\s+all|even|quite|exactly|really|strictly|always|necessarily))\s+{_SUCH}
        \b(?:ceas|stop)\w*\s+(?:to\s+be|being)\s+{_SUCH}
        §[\s,]*(?:is|are)\s+(?:lost|destroyed|violated)\b
        \b(?:едва|вряд)\s+ли\s+(?!можно|нужно|стоит|надо|очевидн|удивит)
        \b(?:отнюдь|далеко|вовсе|никак|совсем)\s+не\s+(?!очевидн|просто|сразу|тривиальн|ясно|удивит)
        \bпереста\w+\s+быть\b
        \bnot\s+(?:true|an?\s+integral|constant|conserved|the|valid|hold|correct|preserved|in\s+general)
        do(?:es)?\s+not\s+(?:hold|vanish|follow|satisfy|have|obtain|get|find)
        (?:is|are)\s+not\s+(?:\w+\s+){{0,2}}§
        §[\s,]*(?:\w+\s+){{0,3}}(?:is|are)\s+(?:not|impossible)\b \bno\s+longer\b
        never\b(?!\s+(?:in|de)creas|\s+grow)
        \b(?:on|along|for|by)\s+no\b wrong\w* incorrect\w* erroneous\w* false\b
        mistak\w+ misprint\w* \b(?:error|fallacy)\s+(?:is|was|lies?|lay|consist\w*)\s+(?:in|that)\b
        (?<!on\sthe\s)contrary impossible\s+that\b невозможно
        instead\s+of\s*(?:§|$) contradict\w+ if\s+it\s+were \bwere\b
        would\s+(?:be|have|follow|give|mean) fails?\b cannot\b
        \b(?:no|without)\s+(?:\w+\s+){{0,2}}integrals?(?:\s+\w+){{0,3}}\s*§ refut\w+
        §[\s,]*(?:\w+\s+){{0,2}}(?:no|without)\s+(?:\w+\s+){{0,2}}integrals?
        \b(?:without|dropping)\s+(?:the\s+)?(?:restriction|condition|assumption|hypothesis)\w*\s*(?:§|$)
        \bбез\s+(?:ограничени|услови|предположени)\w+\s*(?:§|$)
        \b(?:not|never)\s+(?:(?:put|set|take)\s*)?(?:§|$) \bexclud\w+\s+(?:the\s+case\s+)?(?:§|$)
        \bисключ(?:им|аем|ая)\s+(?:случай\s+)?(?:§|$)
        \b(?:not|never|without)\s+(?:suppos|assum|requir|impos|demand)\w*\s+(?:that\s+)?(?:§|$)
        \bне\s+(?:предполага|требу|допуска)\w*,?\s+(?:что\s+)?(?:§|$)
        §[\s,]*(?:is|are|was|were)\s+(?:\w+\s+)?(?:excluded|ruled\s+out|rejected|discarded|left\s+(?:out|aside))
        in\s+place\s+of\s*(?:§|$) \bneither\b ^\s*nor\s*§ ^\s*ни\s*§
        \bневер\w+ \bошиб\w+ \bложн\w+ опечат\w+
        вместо\s*(?:§|$) противореч\w+ не\s+явля\w+ не\s+(?:сохраня|постоян)\w+ нельзя
        не\s+выполн\w+ неправильн\w+ не\s+верно не\s+име\w+\s+мест""",
    "so it is not": r"""
        [;.,]\s*(?:\\\w+\{)?(?:but\s+)?(?:this|that|which)\s+is\s+(?:wrong|false|incorrect|absurd)
        [;.,]\s*(?:but\s+)?(?:this|that|which)\s+is\s+not\s+(?:true|so|correct)
        [;.,]\s*(?:but|however,?)\s+(?:it|this|they)\s+(?:is|are|does|do)\s+not\s*(?:[.;,]|so\b|$)
        ,\s*(?:но|однако)\s+это\s+не\s+так
        (?:это|что)\s+неверно
        \b(?:constant|conserved|preserved)\b(?:(?!\b(?:if|when)\b)[^.;]){0,30}\b(?:and|but|then)\s+(?:(?:it|then|later|afterwards)\s+)*(?:grow|increas|decreas|decay|chang|var(?:y|ies)|jump|oscillat)\w*
        \b(?:постоян(?:на|но|ен)|сохраняется)\b(?:(?!\b(?:если|при)\b)[^.;]){0,30}\b(?:и|а|но|затем)\s+(?:затем\s+|потом\s+)?(?:раст|убыва|меня|возраста)\w*""",
    "timeless": r"""
        \bintegral\s+(?:that|which)\s+(?:does\s+not|never)\s+(?:explicitly\s+)?depend\s+(?:explicitly\s+)?on\s+(?:the\s+)?time\b
        \b(?:autonomous|time-independent)\s+(?:first\s+)?integral
        \bintegral\s+(?:that\s+is\s+)?(?:independent\s+of|without|free\s+of)\s+(?:the\s+)?time\b
        \bинтеграл\w*,?\s+не\s+завися\w+\s+(?:явно\s+)?от\s+времени""",
    "quoted": r"""
        \b(?:students?|beginners|engineers|physicists|many|some|most|others)\s+(?:\w+\s+)?(?:say|think|believe|maintain|imagine|write)\b
        \b(?:студенты|многие|некоторые|иногда)\s+(?:\w+\s+)?(?:говор|дума|счита|пиш|полага)\w+
        \b(?:allegedly|supposedly|ostensibly)\b \bякобы\b
        \b(?:was|were|been)\s+(?:written|stated|said)\s+that
        \baccording\s+to\s+(?-i:(?!Theor|Lemma|Prop|Coroll|Eq|Sect|Newton|Hamilton|Euler|Liouv)[A-Z])
        \b(?:authors|textbooks|people|papers)\s+(?:\w+\s+)?(?:write|state|say|print|give|use)\b
        \bclaims?\s+that \bclaimed\b \basserted?\b \bwrites\b \bconjectur\w+
        \bwas\s+(?:printed|asserted|believed)\b было\s+(?:написано|сказано)
        (?:one|we|you|readers?)\s+(?:might|may|could|would)\s+(?:\w+\s+)?(?:think|expect|hope|guess|suspect|believe)
        tempting \bimagine\b(?:\s+for\s+a\s+(?:moment|while))?,?\s+that\b
        \bit\s+(?:seem(?:s|ed)|(?:may|might|would|could)\s+(?:seem|appear))\s+(?:(?:at\s+first|now)\s+)?(?:that|as)\b
        (?:^\W*|[,;:]\s*)at\s+(?:a\s+)?first\s+(?:sight|glance),?\s+(?:(?!that\b)\w+\s+){0,3}§
        \b(?:guess|expectation|hope|impression|temptation|suspicion)\s+(?:\w+\s+)?(?:is|was|(?:would|might|may)\s+be)\s+that\b
        \b(?:nobody|no\s+one)\s+(?:has\s+|had\s+)?(?:(?:ever|yet)\s+)?(?:shown|proved|proven|verified|checked|demonstrated)\b
        \bникто\s+(?:\w+\s+)?не\s+(?:показал|доказал|проверил) \bможет\s+показаться
        \b(?:кажется|вообразим|представим\s+себе),?\s+что\b
        (?:^\W*|[,;:]\s*)на\s+первый\s+взгляд,?\s+(?:(?!что\b)\w+\s+){0,3}§
        можно\s+(?:было\s+бы\s+)?(?:подумать|ожидать|надеяться) казалось\s+бы \bbelieve[sd]?\b
        it\s+is\s+said утвержда\w+ по\s+мнению
        предположительно гипотез\w+""",
    "compared": r"""
        \b(?:unlike|(?:as\s+)?opposed\s+to|contrary\s+to|in\s+(?:\w+\s+)?contrast\s+(?:to|with)|rather\s+than|as\s+distinct\s+from|in\s+distinction\s+(?:to|from))(?:\s+\w+){0,3}\s*$
        \b(?:в\s+отличие\s+от|в\s+противоположность|im\s+Gegensatz\s+zu|contrairement\s+.{1,4}|.{1,4}\s+la\s+diff.{1,4}rence\s+d[eu])(?:\s+\w+){0,3}\s*$
        ,\s+а\s+не(?:\s+\w+)?\s*$""",
    "in the mean": r"""
        \bon\s+(?:the\s+)?(?:average|mean)\b \bin\s+the\s+(?:mean|average)\b \bin\s+average\b
        \bstatistically\b в\s+среднем\b""",
    "another-law": r"""
        (?:\bif|\bwhen|\bfor|even|also)\b(?:(?!\bintegral)[^.;])*\bfunctions?\s+of\s+(?:the\s+)?time
        (?:\bif|\bwhen|even|also)\b(?:(?!\bintegral)[^.;])*\bdepends?\s+on\s+(?:the\s+)?time
        (?:\bесли|\bкогда|\bпри)\b[^.;]*(?:функци\w+\s+времени|завис\w+\s+от\s+времени)""",
    "a constant": r"""
        \bconstants?\b \bparameters?\b \bcoefficients?\b \bnumbers?\b \beigenvalues?\b
        постоянн\w+ параметр\w* коэффициент\w* числ(?:о|а)\b""",
    "no slip": _NO_SLIP,
    "rolling": rf"""
        {_NO_SLIP}
        (?:slip|skid)s?\s+sideways non-?holonomic\w* knife[\s-]edge неголономн\w+""",
    "normalised": r"""
        \bnormali[sz]\w+\b(?!\s+(?:coordinates?|vectors?|form)) \bmass[\s-]+shell\b
        \bfour-?(?:velocity|momentum)\b \b4-(?:velocity|momentum)\b
        \bunit[\s-]+speed\b \bproper\s+time\b \barc[\s-]*length\b
        \b(?:light|photons?|massless|null|light-?like|time-?like|space-?like|massive)\b
        \bнормиров\w+ \b4-скорост\w+ \bчетыр[её]хмерн\w+\s+скорост\w+
        \bсобственн\w+\s+врем\w+ \bдлин\w+\s+дуги
        \b(?:свет(?!ил)\w*|фотон\w*|изотропн\w+|времениподобн\w+|безмассов\w+)\b""",
    "stable": r"""
        \b(?:un|in)?stab(?:le|il)\w* \b(?:не)?устойчив\w*""",
    "of light": r"""
        \b(?:light|photons?|massless|null|light-?like)\b
        \b(?:свет(?!ил)\w*|фотон\w*|изотропн\w+|безмассов\w+)\b""",
    "force": r"""
        \bfriction\w* \bdamp(?:s|ed|er|ers|ing)\b \bdissipat\w+ \bviscous\w* \bviscosity\b \bdrag\b
        \b(?:air|aerodynamic)\s+resistance\b \bresist(?:ing|ance\s+of\s+the)\b
        \brayleigh\S*\s+(?:dissipat\w+\s+)?function function\s+of\s+rayleigh
        \bnon-?conservative\b \bnon-?potential\b
        \bgenerali[sz]ed\s+forces? \bfollower\s+(?:forces?|loads?|thrusts?) \bcirculatory\b
        (?:additional|further|extra|added|driving)\s+(?:forces?|torques?)
        (?:besides|in\s+addition|moreover|also)[^.]*?\b(?:force|torque)s?\b[^.]*?\bacts?\b
        \bReibung\w* \bD(?:ä|\\"a)mpfung\w* \bfrottements?\b \bamortissement\b
        \bтрени(?:е|я|ю|ем|и)\b сопротивлени\w+ диссипати\w+ демпф\w+ вязк\w+ непотенциальн\w+
        неконсервативн\w+ обобщ[её]нн\w+\s+сил\w+""",
    "no force": r"""
        \b(?:no|without|absen\w+|neglect\w*|neglig\w*|ignor\w*|disregard\w*|vanish\w*|exclud\w*|free\s+of)\b
        \bnot\s+(?:considered|included|present|taken)\b
        \bfrictionless\b \bundamped\b \bnon-?dissipative\b \bif\b \bwere\b
        \bбез\b отсутств\w+ пренебрег\w+ \bнет\b \bесли\b""",
    "central": r"""
        (?<!\bnot\s)(?<!\bno\s)(?<!\bnon-)(?<!\bnever\s)\bcentral\s+(?:\w+\s+)?(?:forces?|fields?|potentials?)\b
        (?<!\bне\s)\bцентральн\w+\s+(?:сил|пол|потенциал)\w+""",
    "multiplier": r"""
        \bmultipliers?\b множител\w+""",
    "system": r"""
        equations?\s+of\s+motion equations?\s+(?:are|read|take|have) \bsystem\b \bmodel\b
        \bthe\s+equations[\s~]*$ \bуравнения[\s~]*$
        now\s+consider reduced\s+(?:system|equations) in\s+polar\s+coordinates another\s+system
        \b(?:adjoin\w*|append\w*|supplement\w*)\s+(?:\w+\s+){0,4}?equations?[\s~]*$
        присоедин\w+\s+(?:\w+\s+)?уравнени\w+[\s~]*$
        obey\w* governed\s+by described\s+by \bmoves?\s+(?:by|according\s+to)[\s~]*$
        euler\w*\s+equations hamilton\w*\s+equations
        уравнени\w+\s+движени\w+ систем\w+ уравнени\w+ описыва\w+""",
    "another system": r"""
        now\s+(?:\w+\s+){0,2}consider \breduced\b \blimit\b polar\s+coordinates
        another\s+(?:system|problem|example) second\s+(?:system|example|problem)
        \bconsider\s+(?:now|also|next|the) next\s+example \bturn\s+to\b
        \b(?:is|are)\s+added\b \badd(?:ing)?\s+(?:to\b|a\b|the\b) \bperturbed\b \bfriction\b
        \blet\b[^.;]*§\s+(?:satisfy|obey|solve|be\s+(?:a\s+|the\s+)?solutions?\s+of)[\s:]*$
        \bпусть\b[^.;]*§\s+(?:удовлетворя\w+|подчиня\w+|явля\w+\s+решени\w+)[^§]*$
        \bdamping\b \bdrag\b \brelaxation\b теперь\s+рассмотр\w+
        рассмотрим\s+(?:теперь|также) друг\w+\s+(?:систем|задач|пример)\w+
        приведенн\w+ полярн\w+ добав\w+ трени(?:е|я|ем)\b""",
    "averaged": r"""
        (?<!\bwithout\s)(?<!\bbefore\s)\baveraging\b \bslow[\s-]+flow\b
        \baveraged\s+(?:\w+\s+){0,2}(?:equations?|systems?|models?|problems?|dynamics|flow|motion)\b
        (?<!\bбез\s)(?<!\bдо\s)\bусреднени\w+ \bусредн(?:яя|ив)\b
        \bусредн[её]нн\w+\s+(?:\w+\s+)?(?:уравнени|систем|задач|движени)\w+""",
    "neglected": _NEGLECTED,
    "ideal case": rf"""
        {_NEGLECTED}
        \bwithout\b \babsence\b \babsent\b \bun(?:damped|forced|driven|perturbed)\b \bconservative\b
        \blinear\s+(?:oscillator|pendulum|system|case|problem) \bfree\s+(?:of|from)\b
        friction(?:less|\s+is\s+absent) \blossless\b \bbetween\s+(?:the|two)\b
        on\s+(?:the\s+)?average averag(?:ed|ing) \bideal(?:i[sz]ed|ly)?\b
        \b(?:fixed|inertial|space|absolute)\s+frame\b неподвижн\w+\s+(?:систем|осях)\w*
        \bбез\b отсутств\w+ консервативн\w+ незатух\w+
        линейн\w+\s+(?:осциллятор|маятник|систем|случа)\w* \bмежду\b в\s+среднем идеальн\w+""",
    "another case": r"""
        \bcases?\b \bbecom(?:es?|ing)\b \bchang(?:es|ed)\b (?:is|are|be|been)\s+added \badding\b
        modif\w+ replac\w+ \binstead\b in\s+place\s+of perturb\w+ \bdriv(?:en|ing)\b
        \bforc(?:ed|ing)\b resist\w+ \bdrag\b \bviscous\b
        \banother\s+(?:system|law|problem|force|equation) случа\w+ становит\w+ добав\w+
        \bunits?\b dimensionless non-?dimension\w+ \brescal\w+ \bscal(?:ed|ing)\b normali[sz]\w+
        \bfor\s+(?:an?|the)\s+(?:\w+\s+)?\w+\s+at\s+rest\b \bпри\s+неподвижн\w+
        \brevers\w+ \bbackwards?\b averag\w+ neglect\w* \bignor\w+ \bregime\b \bframe\b
        безразмерн\w+ единиц\w* обра[щт]\w+ усредн\w+ пренебре\w+ режим\w* масштаб\w* нормир\w+
        измен[еия]\w+ замен[яи]\w+ вместо возмущ[её]н\w+ вынужд\w+
        \bдруг\w+\s+(?:систем|задач|закон|сил|уравнени)\w+""",
    "hamiltonian": r"""
        \bhamilton\w* canonical\w* \blagrang\w* гамильтон\w* каноническ\w+ лагранж\w*""",
    "map": r"""
        \bmaps?\b mapping\w* \bimages?\b отображени\w+""",
    "solution": r"""
        solved\s+by solutions?\b \bsolves\b direct\s+substitution решени\w+ подстанов\w+""",
    "a solution": r"""
        (?:is|are|gives?|form)\s+(?:\w+\s+){0,2}solutions? частн\w+\s+решени\w+
        (?:particular|special|exact|periodic)\s+solutions? (?:явля|да[её]т)\w*\s+решени\w+""",
    "free of": r"""
        \bfree\s+of\s*$ (?:not|never)\s+(?:depending\s+on|containing|involving)\s*$
        \b(?:independent\s+of|without)\s*$ не\s+(?:завис\w+\s+от|содерж\w+)\s*$""",
    "except": r"""
        \b(?:except(?:ing)?|unless|exception\s+of)(?:\s+(?:for|when|if|where|at|in\s+the\s+cases?(?:\s+of)?|that))*\s*$
        \bnot\s+(?:for|when|if|where|in\s+the\s+cases?(?:\s+of)?)\s*$ \bне\s+(?:при|когда|если)\s*$
        \b(?:кроме|за\s+исключением)\s+(?:случа\w+(?:,?\s+когда)?|того,?\s+когда)\s*$""",
    "excepted": r"""
        \b(?:except(?:ing)?|unless)(?:\s+(?:for|when|if|where|at|in\s+the\s+cases?(?:\s+of)?|that))*\s*§
        \bnot\s+(?:for|when|if|where|in\s+the\s+cases?(?:\s+of)?)\s*§ \bне\s+(?:при|когда|если)\s*§
        \b(?:кроме|за\s+исключением)\s+(?:случа\w+(?:,?\s+когда)?|того,?\s+когда)\s*§""",
    "region": r"""
        \b(?:region|domain|interval|strip|half-?(?:plane|space|line|axis)|quadrant|octant|orthant|sector|where|in|within)\s*$
        \b(?:at|in)\s+(?:all|every|each|any)\s+points?\s*$ \beverywhere\s+(?:in|on)\s*$
        (?:област\w+|интервал\w*|полос\w+|полу(?:плоскост|пространств|прям|ос)\w+|квадрант\w*|октант\w*|сектор\w*|где)\s*$
        \b(?:всех|каждой|любой)\s+точ(?:ках|ке|ек)\s*$ \bвсюду\s+(?:в|на)\s*$""",
    "family": r"""
        (?:^|[.,;:]|\b(?:that|where|and|the|of|both|all)\b)\W*(?:coordinate\s+)?(?:lines|curves|surfaces|circles|planes|spheres|cones|cylinders|rays|levels)\s*$
        (?:^|[.,;:]|\b(?:что|где|и|семейств\w+)\b)\W*(?:координатн\w+\s+)?(?:линии|линий|кривые|кривых|поверхност(?:и|ей)|окружност(?:и|ей)|плоскост(?:и|ей)|сферы|конусы|цилиндры|лучи)\s*$""",
    "of motions": r"""
        \b(?:trajector\w+|orbits?|solutions?|motions?|invariant|integrals?|stream\s*lines?|conserved|flow|remains?|stays?|preserved)\b
        \b(?:траектор\w+|орбит\w+|решени\w+|движени\w+|инвариантн\w+|интегральн\w+|лини\w+\s+тока|сохран\w+)\b""",
    "condition": r"""
        \b(?:if|when|provided(?:\s+that)?|for)\s*$
        \bin\s+the\s+(?:\w+\s+)?case(?:\s+(?:of|when))?\s*$
        \bunder\s+the\s+conditions?\s*$ \bon\s+condition\s+that\s*$
        (?:если|когда|при(?:\s+\w+)?|в\s+случае|при\s+условии)\s*$""",
    "either": r"""
        \beither\b(?!\s+(?:of|sign|case|direction|way)\b)[^.;:§]*$
        \beither\b(?!\s+(?:of|sign|case|direction|way)\b)[^.;:§]*(?:§[^.;:§]*\bor\b[^.;:§]*)+$
        \bлибо\b[^.;:§]*$ \bentweder\b[^.;:§]*$ \bentweder\b[^.;:§]*§[^.;:§]*\boder\b[^.;:§]*$""",
    "only if": r"""
        \b(?:only|exactly|precisely|solely)\s+(?:if|when(?:ever)?|for|in\s+the\s+(?:\w+\s+)?case)\b
        \biff\b
        \bjust\s+(?:if|when|in\s+the\s+case|for\s*§) \bnone\s+of\b
        \bnecessary\s+(?:and\s+sufficient|conditions?|that|for|in\s+order)\b
        \bнеобходим\w+\s+(?:и\s+достаточн\w+|услови\w+) \bни\s+одн\w+\s+из\b
        \bif,?\s+(?:and|but),?\s+only\s+if\b
        \b(?:only|exactly|precisely|just|at\s+most)\s+one\s+of\b \bnot\s+both\b \balmost\s+no\b
        \b(?:and|but)\s+(?:not\s+otherwise|otherwise\s+not)\b \bnowhere\s+else\b
        \b(?:and|but)\s+(?:for|in|at|on)\s+no\s+other\w*
        \bbut\s+not\s+(?:(?:for|on|in|at)\s+)?(?:all|every|each|any|always|everywhere|elsewhere|general)\b
        (?<!equation\s)(?<!equations\s)(?<!system\s)\b(?:for|if|when|on|at|in)\s+(?:(?:all|very|some|sufficiently|small|large|positive|negative|the|level|curve|set|case)\s+)*§[\s,]*(?:only|alone)\b
        \b(?:becomes?|is|are)\s+(?:then\s+)?(?:invalid|spoiled|broken)\b
        \badiabatic\w*\s+(?:invarian|conserv)\w+
        \bonly\s+(?:an?\s+integral|constant|conserved|preserved|valid|true)\b
        \b(?:integrals?|constant|conserved|preserved|invariant|holds?|valid|true)\s+only\b
        \b(?:if|when|whenever|provided(?:\s+that)?)\s+(?:its|the)\s+(?:\w+\s+){0,2}(?:derivative|rate|bracket)s?\b[^.;§]*\b(?:vanish\w*|zero)
        ^\W*only\s+(?:on|along|at|in|during|near|by|rarely|seldom|sometimes|exceptionally)\b
        \bfor\s+(?:\w+\s+){0,3}(?:motions|solutions|orbits|trajectories|conditions|data|values)\s+(?:only|alone)\b
        \b(?:few|hardly\s+any|almost\s+no)\s+(?:\w+\s+)?(?:motions?|solutions?|orbits?|trajector\w+|initial)\b
        \b(?:ровно|только|лишь)\s+одн\w+\s+из\b \bно\s+не\s+об[ае]\b
        \bв\s+точности\s+(?:при|тогда)\b
        \bи\s+(?:нигде|никогда|ни\s+при\s+каких)\s+(?:более|больше|друг\w+)\b
        \bадиабатическ\w+\s+инвариант\w*
        тогда\s+и\s+только (?:только|лишь)\s+(?:если|при|для|вдоль|иногда|изредка)\b
        \b(?:интеграл\w*|постоян(?:на|но|ны|ен)|сохраня\w+)\s+(?:только|лишь)\b
        ^\W*(?:только|лишь)\s+(?:на|в)\b \bнемног\w+\s+(?:движени|решени|орбит|траектори)\w+""",
    "if": r"""
        \bif\s*$ \bwhen\s*$ \bif\s+(?:and\s+only\s+if\s*)?$ если\s*$ когда\s*$""",
}
"""Patterns by the cue that they give; spaces stand between them."""


_CITED = re.compile(r"[\s~]*(?:[^\W\d]+[\s~]*)?\(?\\(?:eq|c|C|auto)?ref(?![A-Za-z])")
"""A citation behind words: they say what is cited, and nothing of what follows."""

_MAP = re.compile(r"\bmap(?:ping)?$|отображени\w+$", re.IGNORECASE)
_VERB = re.compile(r"lineari[sz](?:ing|e)|neglecting|differentiating|линеаризу\w+", re.IGNORECASE)
"""Words that do something with what is cited behind them."""

_OF = re.compile(r"[\s~]*(?:of|for|in|to|системы|уравнений|для)\b", re.IGNORECASE)
"""Words behind which a citation says to what the words before belong."""


@cache
def _pattern(cue: str) -> re.Pattern[str]:
    return re.compile("|".join(CUES[cue].split()), re.IGNORECASE)


def cues(name: str, words: str, start: int = 0) -> Iterator[re.Match[str]]:
    """The places, from an offset on, at which some words give a cue."""
    for found in _pattern(name).finditer(words, start):
        cited = _CITED.match(words, found.end()) and not _OF.match(words, found.end())
        cited = cited and not _MAP.search(found[0])  # an invariant of a map that is cited
        if not cited or _VERB.match(found[0]):
            yield found


def cue(name: str, words: str) -> str:
    """The first of some words that give a cue; empty if none do."""
    return next((found[0].strip() for found in cues(name, words)), "")


def last_cue(name: str, words: str) -> int:
    """Where the last words stand that give a cue; -1 if none do."""
    return max((found.start() for found in _pattern(name).finditer(words)), default=-1)


_CLAUSE = re.compile(
    r"[.;]|,?\s*\b(?:but|while|whereas|yet|however|но|однако|зато)\b", re.IGNORECASE
)


def force_told(words: str) -> str:
    """The words that tell a force which has no potential; empty if there is none.

    What does not act in one clause says nothing of another one.
    """
    clauses = (clause for clause in _CLAUSE.split(words) if not cue("no force", clause))
    return next(filter(None, (cue("force", clause) for clause in clauses)), "")
