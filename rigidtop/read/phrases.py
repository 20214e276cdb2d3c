"""The words that say something of a formula, in English, German and French, and what they say.

In them § stands for a letter or another formula, and ¶ for the end of a title.
"""

from __future__ import annotations

from enum import Enum, auto

from rigidtop.read.words import (
    AND,
    BEING,
    CIRCUMSTANCE,
    FIXED,
    LARGE,
    LARGER,
    LIKE,
    NOUN,
    OF_SEVERAL,
    PLACE,
    POINTING,
    POSITION,
    QUANTITY,
    SMALL,
    SMALLER,
    START,
    THE,
    WORD,
)


class Cue(Enum):
    """One thing that words say of a formula."""

    MOMENT = auto()
    """It holds at one moment or place only: "at the start", "where § = 0"."""
    CASE = auto()
    """It is supposed of what follows: "suppose", "for a horizontal top"."""
    DEFINED = auto()
    """It gives something a name: "with", "let", "we call"."""
    CONSTANT = auto()
    """The letter, or the left side, is constant."""
    SMALL = auto()
    """It holds for small angles, or to first order."""
    LARGE = auto()
    """It holds for what is large, as the spin of a fast top."""
    APPROXIMATED = auto()
    """An = in it is meant approximately, since something was said to be small before."""
    GENERAL = auto()
    """A case or an approximation is taken back: "in general", "exactly", "for all times"."""
    CONDITION = auto()
    """An inequality that something rests on: "if § ≠ 0"."""
    ASKED = auto()
    """It is asked or denied: "show that", "it is wrong that"."""
    DERIVED = auto()
    """It follows from what was said: "hence"."""
    GIVEN = auto()
    """It is taken from elsewhere: "according to", "experiment shows"."""
    EXCEPTED = auto()
    """It is excluded: "not at the poles, where"."""
    ORIGIN = auto()
    """It says where a letter counts from: "§ is the lowest position"."""
    RANGE = auto()
    """It says where something begins, or where it ends: "from § to §"."""
    ANEW = auto()
    """It is what something is after a change: "the new energy is"."""
    REPEATED = auto()
    """It has been said before: "as stated above"."""
    DIVISOR = auto()
    """Something is divided by it."""
    CONSERVED = auto()
    """Since the statement before it is said that energy is conserved."""
    KEPT = auto()
    """Since the statement before it is said that what that speaks of is conserved."""
    MOMENTUM_KEPT = auto()
    """The same of a momentum."""
    LANDING = auto()
    """Something arrives at a place: "back on the ground"."""
    TURNING = auto()
    """Something does not move for a moment: "at the highest point"."""
    STOPPING = auto()
    """Something has come to rest by then: "it stops after the way"."""
    ELSEWHERE = auto()
    """It is said of what has been changed, or of another place: "on the moon"."""
    OTHER = auto()
    """It is said of another body: "for a second cart"."""
    CIRCUMSTANCE = auto()
    """Its sentence begins with circumstances that words alone tell: "On a greased table it has"."""
    LEAST = auto()
    """It is the smallest one of several."""
    GREATEST = auto()
    """It is the largest one of several."""
    SEVERAL = auto()
    """It is one of several of its kind: "the frequencies are"."""
    COMPONENTS = auto()
    """It is a component of what stands above."""
    THERE = auto()
    """It is so at the moment of which was spoken before: "from there on"."""
    VANISHING = auto()
    """What was spoken of before vanishes there: "it is zero for"."""
    EXTREME = auto()
    """What was spoken of before is greatest or least there."""
    POSITIVE = auto()
    """It is the positive one of two roots."""
    NEGATIVE = auto()
    """It is the negative one."""
    PARTICULAR = auto()
    """It is one of several motions, and not the one from the start."""
    EQUAL_MASSES = auto()
    """It holds for equal masses."""
    BOTH_EQUAL = auto()
    """The last two things that have been given a name are equal."""
    NEARLY_EQUAL = auto()
    """It holds where two things are nearly equal: "for coils that are almost alike"."""
    LITTLE = auto()
    """The letter is much smaller than another one: "much heavier than the planet §"."""
    CONSTRAINT = auto()
    """It is kept by a force that is not known yet: "with a multiplier for"."""
    CIRCLE = auto()
    """It holds on a circle."""
    OSCILLATION = auto()
    """It says how fast something oscillates: "the period is"."""
    BALANCE = auto()
    """It says which forces are equal: "the attraction is just what the circle needs"."""
    EQUILIBRIUM = auto()
    """It holds in an equilibrium."""
    REST = auto()
    """Words since the formula before say that everything begins at rest: "released"."""


BEFORE: dict[Cue, tuple[str, ...]] = {
    Cue.MOMENT: (
        rf"(?<!acts )(?<!fixed )(?<!held )(?<!hinged )(?<!attached )(?<!applied )(?<!sits )"
        rf"\b(?:at|in|near|passes|reaches) (?:(?:the|its|this|that) )?{PLACE}\b[^§]*",
        r"(?:^|[.;¶] ?)(?:there(?! (?:is|are|was|were|exists?|remains?|must|can|will|has)\b)"
        r"|dort|là)\b[^§]*",
        r"(?:^|[.;¶] ?)(?:the )?(?:lowest|highest|foremost|nearest) point\b[^§]*",
        r"\bat the (?:time|moment|instant) §[^§]*|\b(?:moment|instant) with|(?:^|[.;¶] ?)start ?:",
        r"\bfrom (?:then|there|that moment) on\b[^§]*|\bvon da an\b[^§]*|\bdès lors\b[^§]*",
        r"\bat (?:this|that) (?:point|place|time|instant|stage|height|angle)\b[^§]*",
        r"\b(?:rotation|motion|body|top) (?:starts|begins) (?:about|around|along|with)\b.{0,40}",
        r"\b(?:initially|at first|(?<!hangs )(?<!is )(?<!are )(?<!lies )at rest)\b[^§,]*,?",
        r"\b(?:am (?:Anfang|Ende|Boden)|[ai]m (?:Perihel|Aphel|Perigäum|Apogäum|Umkehrpunkt"
        r"|Scheitel|tiefsten Punkt|höchsten Punkt"
        r"|Moment)|oben|unten|zur Zeit|zum Zeitpunkt|anfangs|zu Beginn)\b[^§]*",
        r"(?:\b|^)(?:à l['’](?:instant|apogée|aphélie)|au (?:début|départ|sommet|périgée|périhélie"
        r"|point le plus (?:haut|bas))|initialement"
        r"|au moment où)\b[^§]*",
    ),
    Cue.CASE: (
        rf"{START}(?:suppos(?:e|ing)|assum(?:e|ing)|let)(?: (?:now|that|us|also|first))*{NOUN},?",
        rf"{START}(?:set(?:ting)?|put(?:ting)?|tak(?:e|ing)|try)(?: (?:now|also|first|as))*",
        r"\blet [^§.;]{1,60}:(?: § [^§.;]{1,30},)*",
        rf"{START}set(?:ting)? [^§=.;:]{{1,40}} = [^§=.;:]{{1,40}}",
        r"\b(?:choos(?:e|ing)|chosen|wähl(?:e|en|t)|gewählt|choisi\w*) [^§.;:]{1,50}"
        r"(?:such|so|sodass|dass|that|que)(?: that| dass)?",
        r"\bI (?:assume|take|suppose)(?: that)?",
        rf"{START}(?:an?|the) [\w-]+ (?:that|which) (?:only|just|merely|simply) [\w-]+,?",
        r"\b(?:choose|put|take|lay|turn|lege(?:n)?|wähle(?:n)?)\b[^.;]{0,40}"
        r" (?:along|parallel to|entlang|parallel zu) (?:it|this|that|§|ihm|ihn)",
        rf"\b(?:angenommen|nimm an|nehmen (?:wir )?an|sei(?:en)?|sind nun"
        rf"|setze(?:n wir)?),?(?: nun| dass)*{NOUN}",
        rf"\b(?:supposons|soi(?:t|ent)|posons|on pose|prenons)(?: que| alors)*{NOUN}",
    ),
    Cue.DEFINED: (
        rf"(?:^|[,;:.(¶–] ?|\band )(?:with|mit|avec)(?! the (?:solution|result|help|aid)){NOUN}",
        rf"\b(?:let|where|defin(?:e|ing)|call(?:ing)?|denot(?:e|ing)(?: by)?|writ(?:e|ing)"
        rf"|introduc(?:e|ing)|abbreviat(?:e|ing)|namely|i\. ?e\.){NOUN}",
        rf"{START}(?:set(?:ting)?|put(?:ting)?|tak(?:e|ing))(?: (?:now|also|first|as))*",
        r"\bI write|\bwe (?:write|call|define|introduce|put|set)(?: it)?",
        rf"\b(?:wobei|sei(?:en)?|setze(?:n wir)?|definiere(?:n wir)?|nenne(?:n wir)?){NOUN}",
        rf"\b(?:(?<!d')où|soi(?:t|ent)|on pose|posons|on note|notons|appelons){NOUN}",
    ),
    Cue.SMALL: (r"\b(?:small|kleine[nrms]?|petite?s?)",),
    Cue.LARGE: (r"\b(?:large|gro(?:ß|ss)e[nrms]?|grande?s?)",),
    Cue.LITTLE: (
        rf"\bmuch {LARGER} than{NOUN}",
        r"\bviel (?:größer|schwerer|schneller|länger|stärker) als(?: [\w-]+){0,2}",
        r"\bbeaucoup plus (?:grande?|lourde?|rapide|longue?) que(?: [\w-]+){0,2}",
    ),
    Cue.CONSTRAINT: (
        r"\b(?:multipliers?|Multiplikator(?:en)?|multiplicateurs?) (?:for|für|pour)"
        r"(?: [\w'-]+){0,3}",
    ),
    Cue.CONSTANT: (
        r"(?<!§ is )(?<!^is )\b(?:an?|the|another|one) (?:(?:\w+ )?constant(?: of (?:the )?motion)?"
        r"|conserved (?:quantity|momentum|energy)|constant \w+)(?: is)?",
        r"(?:Konstante|Erhaltungsgröße)(?: ist)?|(?:une|la) (?:constante"
        r"|quantité conservée)(?: est)?",
        r"\b(?:constant|conserved|fixed|konstante[mnrs]?|feste[mnrs]?) (?:\w+ )?",
    ),
    Cue.ASKED: (
        r"\b(?:not|nicht|pas)(?: (?:true|the case|have|get|so|that|equal|wahr|dass|vrai|que|,))*",
        r"\b(?:unless|es sei denn(?:,? dass)?|sauf si|à moins que)",
        r"\b(?:might|could|would) (?:think|expect|guess|believe|hope)(?: that)?",
        r"\b(?:goals?|aims?|objectives?|Ziel) (?:is|are|will be|was|ist)\b[^.]{0,40}",
        r"\b(?:wrong|false|no longer true|untrue|incorrect|a mistake|falsch|faux)(?: (?:that"
        r"|to \w+(?: that)?)"
        r"|,? dass| que)?",
        r"(?:(?<!can )(?<!to )(?<!easily )(?<!may )(?<!will )(?<!could )\b(?:show|prove|verify)\b"
        r"|\b(?:is it true|why is|zeigen (?:Sie|wir)|zeige(?=,? da(?:ss|ß))|beweisen?(?: Sie)?"
        r"|d?é?montre[rz]|est-ce))(?: that|,? dass| que)?[^.]{0,60}",
    ),
    Cue.DIVISOR: (
        r"\b(?:divid(?:e|es|ed|ing)|teil(?:en|t)|dividier(?:en|t)|divis(?:e|ons|ant))"
        r"(?: [\w'-]+){0,3} (?:by|durch|par)",
    ),
    Cue.ORIGIN: (
        rf"\b{POSITION} (?:{BEING}|has|hat|a|corresponds to|entspricht|correspond à)"
        r"(?: (?:at|bei|en|à))?",
        r"\b(?:measured|counted|counts|gemessen|gezählt|zählt|mesurée?|comptée?) "
        r"(?:from|von|ab|à partir de)",
    ),
    Cue.ANEW: (
        r"\b(?:new|changed|neue[ns]?|nouvel(?:le)?) (?:[\w'-]+ ){1,4}(?:is|becomes|ist|wird"
        r"|est|devient)"
        r"(?: (?:now|then|thus|therefore|hence|nun|dann|daher|also|alors|donc))?",
        r"\b(?:turns|changes|transforms|converts) (?:this|it|that|§) (?:in)?to",
        r"\b(?:for (?:it|him|her|them|this one|that one)|für (?:ihn|sie|es)|pour (?:lui|elle))"
        r"(?: (?:is|we have|one has|ist|gilt|on a))?",
    ),
    Cue.GIVEN: (
        r"\b(?:according to|from the tables?|(?:Newton|Hooke|Kepler|Coulomb)['’]?s? (?:\w+ )?law"
        r"|experiments? shows?|measured|by measurement|as (?:\w+ ){1,4}says|it is known|laut|gemäß"
        r"|Gesetz|Messung|selon|d['’]après|loi de)\b[^§]*",
        r"\b(?:(?:no|not|without) (?:slip(?:ping)?|slide|skid)\b|ohne (?:zu )?(?:gleiten|rutschen)"
        r"|(?:rutsch|gleit)\w* nicht|sans gliss\w+|ne glisse\w* pas)[^§.]*",
    ),
}
"""The words directly in front of a formula, behind which no more stands than a comma."""

WITHIN: dict[Cue, tuple[str, ...]] = {
    Cue.REPEATED: (
        r"\b(?:as (?:[\w-]+ ){0,4}(?:above|before|stated|measured|said|given|found)|indeed|still"
        r"|the same|wie (?:oben|gesagt|zuvor)|noch immer|nach wie vor|comme (?:plus haut|ci-dessus"
        r"|avant)|toujours)\b",
    ),
    Cue.ASKED: (r"\b(?:would (?:be|have|move|go|fall|fly|turn|run)|wäre|würde|serait|irait)\b",),
    Cue.LANDING: (
        r"\b(?:(?:back )?(?:on|at|to) the (?:ground|floor)|lands|hits the|fallen|am Boden|landet"
        r"|au sol|retombe)\b",
    ),
    Cue.TURNING: (
        r"\b(?:(?:highest|turning) point|turns (?:back|round)|stops|comes to rest"
        r"|höchste[nr]? Punkt|Umkehrpunkt|kehrt um|bleibt stehen|point le plus haut|s'arrête)\b",
    ),
    Cue.SMALL: (rf"\b{SMALL}",),
    Cue.LARGE: (rf"\b{LARGE}",),
    Cue.EQUILIBRIUM: (
        r"\bstands? (?:still|at a (?:fixed|constant)\b)",
        r"\bkeeps? (?:its|their|the same|a (?:fixed|constant)) "
        r"(?:\w+ )?(?:angles?|inclinations?|places?|positions?|distances?|heights?)\b",
        r"\b(?:hangs?|hanging) (?:\w+ )?(?:at rest|still|in equilibrium)\b",
        r"\bthere (?:is|are) (?:another|a second|two more)(?: ones?| rest\w*)?,",
        r"(?:^|[.;¶] ?)(?:at rest|in Ruhe|au repos)\b",
        r"\b(?:equilibri(?:um|a)|(?:can|could) (?:stay|rest|remain)|(?:stays|rests|remains) at"
        r"|Gleichgewicht\w*|Ruhelagen?|équilibre)\b",
    ),
    Cue.BALANCE: (
        r"\b(?:balances?|balanced by|provid(?:es|ed by)|suppli(?:es|ed by)|counteracts?"
        r"|(?:is|are) (?:just |exactly |precisely )?what (?:the|an?|it|is)\b[^.;:§]{0,20}"
        r"\bneed\w*|(?:centripetal|centrifugal) (?:force|acceleration)"
        r"|(?:keeps?|holds?) (?:it|him|them|the \w+) (?:on|in) (?:the|its|their|an?) "
        r"(?:circle|orbit|path|track)"
        r"|hält\w*[^.;:§]{0,20} das Gleichgewicht|(?:Zentripetal|Zentrifugal|Flieh)kraft"
        r"|compense|force centri\w+)\b",
    ),
    Cue.STOPPING: (
        r"\b(?:comes? to (?:a stop|a halt|rest)|stops?|is stopped|halts?"
        r"|kommt zur Ruhe|bleibt (?:stehen|liegen)|Bremsweg|s'arrête)\b",
    ),
    Cue.ELSEWHERE: (
        r"(?:^|§[ ,]*)(?:if|when|for|falls|wenn|für|si|pour) [^.;:§]*,? (?:or|oder|ou)[ ,:]*\Z",
        r"\b(?:(?:its|the|their) mean|mean (?:speed|value|velocity|of)|average|half[ -]?way"
        r"|half lives?|the middle between|clamped|motor|driven|excited|disturbed|instead(?! of)"
        r"|twice as|doubled?|\w+ times (?:as|the)|halved?|half of"
        r"|an? (?:third|quarter|fifth|sixth|tenth) of"
        r"|(?:stiffer|weaker|heavier|lighter|longer|shorter)(?! than)"
        r"|different|exchanged|replaced|relative (?:motion|distance)|drift\w*|removed"
        r"|shorten\w*|cut|torn|taken off|loaded|glued|blocked|unloaded)\b",
        r"\b(?:in (?:a row|series|parallel)|side by side|next to each other|seen (?:from|by)"
        r"|observer|in the frame|cent(?:re|er) of mass|moon|vacuum|under water|lift that"
        r"|(?:turning|rotating|moving|accelerating) (?:\w+ )?(?:axes|frame|disc|table|train|car)"
        r"|upside down|(?<!is )(?<!are )lets? go|burn-?out|on (?:its|the) way (?:up|down|back)"
        r"|earlier|later|behind the|carousel|twins?|held (?:fast|still|fixed)|is held"
        r"|in step|in phase|out of phase|against each other|numbered"
        r"|(?:keeps?|has|with) (?:its|the) (?:natural )?length)\b",
    ),
    Cue.CIRCUMSTANCE: (rf"^{CIRCUMSTANCE}(?!the {QUANTITY})[\w'-]+ [\w'-]+",),
    Cue.OTHER: (
        r"\b(?:second|third|other|next|another|neighbouring) (?!one|hand|root|mode|law|side"
        r"|equation|solution|frequenc|eigen|value|component|coordinate|line|term|derivative|two"
        r"|to|and|time)\w+",
        r"\b(?:ander(?:e[nmrs]?) (?:Körper|Masse|Kugel)|Mond|autre (?:corps|masse))\b",
    ),
    Cue.LEAST: (rf"\b(?:lower|lowest|slow(?:er|est)?|smaller|smallest|least){OF_SEVERAL}",),
    Cue.GREATEST: (
        rf"\b(?:higher|highest|fast(?:er|est)?|greater|greatest|larger|largest){OF_SEVERAL}",
    ),
    Cue.SEVERAL: (
        r"\b(?:frequencies|modes|eigen(?:values|frequencies)|roots|solutions|Frequenzen|Wurzeln"
        r"|Eigen(?:werte|frequenzen)|Lösungen|valeurs propres|pulsations|racines)\b",
    ),
    Cue.COMPONENTS: (
        r"\b(?:components?|coordinates?|componentwise|Komponenten?|Koordinaten?|composantes?)\b",
    ),
    Cue.THERE: (r"\b(?:from (?:then|there|that moment) on|by then|this is|von da an|dès lors)\b",),
    Cue.VANISHING: (
        r"\b(?:it|this|that|they|(?:the|this|its) [\w-]+(?: force)?|sie|er|es|dies|die(?:se)? \w+"
        r"|elle|il|cela|ceci|cette \w+) (?:vanish(?:es)?|(?:is|becomes) zero|verschwindet"
        r"|(?:ist|wird) null|s'annule)(?:,? (?:at|for|if|when|where|i\. ?e\.|that is|bei|für|wenn"
        r"|das heißt|pour|quand|si)\b|,|\Z)",
        r"\b(?:leaves|loses (?:contact|touch)|lifts off|detaches)\b[^§.;:]{0,40}"
        r" (?:when|if|where)\b",
        r"\b(?:does|do) not (?:move|roll|slide|turn|accelerate)(?: at all)? (?:if|for)\b",
        r"\b(?:stays|remains|is|bleibt|reste) (?:at rest|in Ruhe|au repos)[^§.;:]{0,40}"
        r" (?:if|for|wenn|für|si|pour)\b",
    ),
    Cue.EXTREME: (
        r"\b(?:greatest|largest|highest|maximum|maximal|smallest|least|lowest|minimum|minimal"
        r"|farthest|furthest|widest|longest|shortest|quickest|fastest|slowest|best)"
        r"(?! (?:point|position|lage))"
        r"(?:(?: [\w'-]+){0,6} (?:at|for|if|when|where|is at|occurs?)\b|:?\Z)",
        r"\b(?:derivative|slope)(?: [\w'§-]+){0,5} (?:vanishes|is zero|be zero|equal to zero)\b",
        r"\b(?:stationary|extremal|optim\w+|minimi[sz]e\w*|maximi[sz]e\w*)\b",
        r"\b(?:größte\w*|maximal\w*|kleinste\w*|minimal\w*|Maximum|Minimum)(?: [\w'-]+){0,4}"
        r" (?:bei|für|wenn|wo)\b",
        r"\b(?:l[ea] plus (?:grande?|petite?)|maximale?|minimale?|maximum|minimum)"
        r"(?: [\w'-]+){0,4} (?:pour|quand|si|en)\b",
    ),
    Cue.POSITIVE: (
        r"\bpositive(?:[rn]? (?:Wurzel|Lösung)| (?:root|solution|value))"
        r"|\b(?:racine|solution) positive\b",
    ),
    Cue.NEGATIVE: (
        r"\bnegative(?:[rn]? (?:Wurzel|Lösung)| (?:root|solution|value))"
        r"|\b(?:racine|solution) négative\b",
    ),
    Cue.PARTICULAR: (
        r"\b(?:particular|special) (?:solution|integral)|\b(?:spezielle|partikuläre) Lösung"
        r"|\bsolution particulière",
    ),
    Cue.EQUAL_MASSES: (
        r"\b(?:(?:for|with|between|if the) (?:two )?(?:equal|identical)(?: [\w-]+)?"
        r" (?:masses|bodies|balls|weights|loads|pucks|particles|carts)"
        r"|gleiche[nr]? Massen|masses égales)\b",
    ),
    Cue.BOTH_EQUAL: (
        r"\b(?:both|the two|these two|they)(?: (?:forces|torques|energies|sides|moments))?"
        r" (?:are|must be|have to be|become) equal\b"
        r"(?! (?:but|and opposite|in (?:size|magnitude)))",
        r"\bbeide(?: Kräfte)? (?:sind )?(?:gleich(?: groß)?|einander gleich)\b",
        r"\bles deux(?: forces)? sont égale?s?\b",
    ),
    Cue.NEARLY_EQUAL: (
        rf"\b(?:nearly|almost) {LIKE}|\bfast (?:gleich|ebenso)|\bpresque (?:égale?s?|les mêmes)",
    ),
    Cue.CIRCLE: (r"\b(?:on an? (?:\w+ )?circle|circular|Kreisbahn\w*|circulaire)\b",),
    Cue.OSCILLATION: (
        r"\b(?:\w*(?:frequen[cz]|fréquen|pulsation|oscill|vibrat|swing|schwing|librat|hunting)"
        r"|periods?\b|Perioden?\b|périodes?\b)",
    ),
    Cue.GENERAL: (
        r"(?:^|[.;¶] ?)(?:otherwise|sonst|andernfalls|sinon)\b"
        r"|\b(?:in general|generally"
        r"|(?<!lands )(?<!back )(?<!stops )(?<!rises )(?<!falls )(?<!§ )again"
        r"|exact(?:ly)?|without (?:the |this )?approximations?"
        r"|on the other hand|(?:for|at|in) (?:any|all|every|each)(?: other)?(?:\Z| (?:times?|t\b|§"
        r"|moments?|points?|places?|positions?|distances?|angles?|instants?|motions?))"
        r"|(?<!the same )everywhere|throughout|all the way|(?:on|during|along) the whole \w+"
        r"|überall|partout|(?<!as )always"
        r"|(?:im )?allgemein(?:en)?|wieder|exakt|genau|andererseits|jederzeit|zu jeder Zeit|stets"
        r"|en général|à nouveau|exactement|d['’]autre part|à tout instant|toujours)\b",
    ),
    Cue.DERIVED: (
        r"\b(?:hence|so(?! far)|therefore|thus|then|it follows|gives?|(?:we|I|one) (?:gets?|sees?"
        r"|finds?|obtains?|have|has)"
        r"|becomes?|consequently|yields?|leads? to|that is|from (?:this|these|which|it)|implies"
        r"|daher|daraus|das ist|das heißt|folgt|somit|ergibt|dann|liefert"
        r"|(?:man|wir) (?:erh[aä]lt(?:en)?|bekommt?)|d['’]où|donc|ainsi|alors|donne|c['’]est-à-dire"
        r"|on (?:obtient|trouve|en déduit))\b|, also\b",
    ),
}
"""Words anywhere in front of a formula, since the one before."""

BEHIND: dict[Cue, tuple[str, ...]] = {
    Cue.CONSTANT: (
        rf",? ?(?:which |that |die |der |qui )?{BEING} (?:{WORD} )?(?:an? |the |une? |eine? )?"
        rf"{FIXED}",
        rf"{AND}(?:are|remain|stay|sind|bleiben|sont|restent) (?:{WORD} )?(?:the |des )?{FIXED}",
        rf"{AND}(?:both |all )?(?:fixed|const(?:ant)?|konst(?:ant)?|constante?s?|conserved|fest)"
        r"\b",
        rf"{AND}(?:does|do) not (?:change\b(?! under| with| if)|depend on (?:the )?time)",
        r",? ?(?:which )?(?:ändert sich nicht|ne (?:change|varie) pas|bleibt erhalten)",
        rf"{AND}(?:keeps? (?:its|their) values?|behalten (?:ihren|ihre) Werte?"
        r"|gardent leurs? valeurs?)",
    ),
    Cue.SMALL: (
        rf",? ?\(?(?:for|if|when|to|in|up to|für|bis|pour|au) [^§.;]{{0,20}}?{SMALL}",
        rf"{AND}(?:{BEING} )?(?:very |sehr |très )?(?:small|klein|petite?s?)\b",
    ),
    Cue.LARGE: (
        rf",? ?\(?(?:for|if|when|für|pour) (?:an? |the )?{LARGE}",
        rf"{AND}(?:{BEING} )?(?:very |sehr |très )?(?:large|groß|gross|grande?s?)\b",
    ),
    Cue.LITTLE: (
        rf",? ?{BEING} (?:so |very )?much {SMALLER} than\b",
        r",? ?ist (?:so |sehr )?viel (?:kleiner|leichter|langsamer|kürzer|schwächer) als\b",
        r",? ?est beaucoup plus (?:petite?|légère?|lente?|courte?) que\b",
    ),
    Cue.ORIGIN: (
        rf",? ?\(?(?:(?:{BEING}|for|as|als|comme|when|where|if|wenn|wo|si|means|heißt"
        rf"|corresponds to|entspricht|correspond à|denotes|marks) )?"
        rf"(?:(?:it|he|she|er|sie|es|elle|il) )?(?:hangs )?"
        rf"(?:(?:at|in|bei|im|à|au|en) )?(?:{THE} ?)?(?:{POSITION}\b|{POINTING})",
    ),
    Cue.MOMENT: (rf",? ?(?:at|in|near) the {PLACE}\b|,? ?(?:initially|am Anfang|au début)\b",),
    Cue.GENERAL: (r",? ?(?:for all (?:times?|t|§)|at (?:any|all) times?|always|stets|toujours)\b",),
    Cue.ASKED: (
        r"[^.]*\?",
        r",? ?(?:would be|is|are|was) (?:wrong|false|not true|no longer)|,? ?does not hold",
        r"[^.;:§]{0,40}\b(?:would(?: not| no longer| never|n't)|ne (?:serait|pourrait) (?:pas|plus)"
        r"|(?:würde|wäre|könnte)n? [^.;:§]{0,20}(?:nicht|nie|kein\w*))\b",
        r",? ?(?:is|are|ist|est) (?:no|not an?|keine?|pas une) (?:solution|root|Lösung|racine)",
    ),
}
"""The words directly behind a formula."""

INLINE: dict[Cue, tuple[str, ...]] = {
    Cue.MOMENT: (
        r"(?<!look )(?<!arrive )(?<!is )(?<!are )(?<!lies )(?<!sits )(?<!located )(?<!acts )"
        r"(?<!fixed )(?<!held )(?<!attached )(?<!placed )(?<!stands )"
        r"\b(?:at|at (?:the )?(?:time|moment|instant|place|point)|when|whenever)",
        r"\b(?:there|point|place|moment|instant|time|angle)\b[^§.;:]{0,30} where(?: now)?",
        r"\b(?:hits?|meets?|reach(?:es)?|touch(?:es)?|cross(?:es)?|lands?|arrives?)\b[^.;:§]{0,30}"
        r" (?:where|when|as soon as)",
        r"\b(?:comes? (?:down|back|to rest|to a stop)|returns?|lands?|hits? the \w+"
        r"|begins? to (?:roll|slip|slide)|lifts? off|turns? back|stops?)(?: again)?,",
        r"\b(?:turns? back|stops?|lands?|gets? over the top)(?: again)?(?:,? where|,? at)",
        r"\b(?:bei|sobald|zur Zeit|zum Zeitpunkt)|, wo",
        r"(?:^|[.;¶] ?)(?:where|wo|là où) [^,;:.§]{1,40},",
        r"\bstands? still,|\b(?:bleibt|steht) still,|\bs'arrête,",
        r"(?:^|[.;¶] ?)(?:the case|der Fall|le cas)(?: of| où)?",
        r"\b(?:en|(?<!rapport )à|lorsque|quand|à l'instant)",
        r"(?:^|[.;¶] ?)(?:when|once|as soon as|wenn|sobald|quand|lorsque|dès que) [^,;:.§]{0,40}"
        r"\b(?:has|have|reach\w*|arrives?|comes?|stops?|hat|ist|erreicht|ankommt|atteint|arrive"
        r"|s'arrête|a|(?:is|are) (?:used up|gone|burnt|burned|spent|over|left|unwound|verbraucht))"
        r"\b[^,;:.§]{0,40},",
        r"\b(?:obtained|reached|found|follows|occurs|happens|ergibt sich|erreicht|folgt|gilt"
        r"|s'obtient|atteinte?) (?:for|für|pour)",
        r"\b(?:thrown|launched|shot|fired|projected|geworfen|lancée?)\b[^.;:§]{0,30}"
        r"\b(?:from|with|at|von|mit|de|avec)\b[^.;:§]{0,20}",
    ),
    Cue.EXCEPTED: (
        r"\b(?:not (?:at|on|near|for)|except(?:ed)?|away from|nicht (?:bei|für|an)|außer|sauf)"
        r"[^.;:§]{0,40} (?:where|when|if|for|wo|wenn|für|où|si|pour)",
        r"\b(?:apart from|aside from|other than|except(?: for)?|leaving aside|disregarding"
        r"|abgesehen von|außer|bis auf|hormis|excepté|à part|sauf)"
        r"(?: (?:the|der|dem|la)(?: \w+)? (?:case|solution|root|Fall|Lösung|Wurzel|solution))?",
    ),
    Cue.RANGE: (r"\b(?:from|between|von|zwischen|de|entre)(?: § (?:to|and|bis|und|à|et))?",),
    Cue.DEFINED: (r"(?<!agrees )(?<!compare )(?<!comparing )\b(?:with|mit|avec)",),
    Cue.CASE: (
        r"\b(?:if|only if|in (?:the|this|a)(?: \w+)? case[^§.;:]{0,50}"
        r"|provided(?: that)?|as long as|falls|sofern|solange|wenn|im Fall(?:e)?(?: dass)?"
        r"|si|pourvu que|dans le cas)",
        rf"{START}(?:for|on|during|für|pour|sur)"
        r"(?! (?:example|instance|comparison|convenience|short|simplicity"
        r"|its|his|their|this|that|which|it|all"
        r"|each|every|any|both|our|en|trouve|obtient|pose|note|voit)\b| an?[ ,]*\Z)(?: (?!the\b"
        r"|at\b)[\w'-]+){1,5}"
        r"(?:, [^,;:.(§]{1,24})?",
        rf"{START}for the(?! {QUANTITY})(?: (?!the\b|at\b)[\w'-]+){{1,5}}",
        rf"{START}(?:for|für|pour|special case(?: of)?)",
        r"(?:^|[.;¶] ?)(?:special cases?|Sonderf[aä]lle?|cas particuliers?)\b[^.;§]{0,60}[,:]",
        r"(?:^|[.¶] ?)(?:when|if|wenn|falls|si|lorsque|quand) [^,;:.§]{1,60},",
        rf"{START}(?:without|ohne|sans) [^,;:.§]{{1,30}},?",
        r"\b(?:if|when|wenn|falls|si|lorsque) [^.;:]{1,150}[ ,](?:then|dann|alors)",
        r"\b(?:if|when|suppose|place|put|choose) [^.;:§]{1,80}\b(?:so|such) that",
        rf"{START}on the (?!other|one)[\w -]{{1,20}},",
        rf"{START}while an? [^,;:.(§]{{1,30}},",
        rf"{START}in (?:steady|uniform|circular|equilibrium|free) [^,;:.§]{{0,30}}\(?",
    ),
    Cue.CONDITION: (r"\(|\b(?:for|für|pour|where|with)",),
}
"""The words directly in front of a formula within the line, which stands beside the sentence.

What they suppose of an inequality is a condition; a display is what the sentence says itself.
"""
TITLED = (r"[^¶]*\w[^¶]*¶[ ,.:–-]*", r"[^§]*\w[^§]*¶ ?(?:then|now|dann|nun|alors)")
"""In front of a formula: it stands directly behind a title, which says what is supposed."""
