"""Kinds of words that several phrases have: articles, quantities, places, what is small.

Each is the text of a regular expression; § stands for a letter or another formula.
"""

from __future__ import annotations

THE = r"(?:the|an?|its|our|their|some|der|die|das|dem|den|eine?[mnrs]?|les?|la|une?|l')"
NOUN = rf"(?: {THE})?(?: [\w'-]+){{0,4}}"
START = r"(?:^|[,;:.(–¶] ?|\b(?:and|while|but|or|so|that|now|then|we|us|I|und|wir|et|dass|que) )"
BEING = r"(?:is|are|be|being|remains?|stays?|ist|sind|bleib(?:t|en)|est|sont|reste(?:nt)?)"
WORD = r"(?!(?:not|never|no|nicht|nie|keine?|pas|jamais)\b)\w+"
"""A word that does not deny what follows."""
AND = r"(?:,? ?(?:and|und|et|,) §)*,? ?"
FIXED = (
    r"(?:constant|const\b|conserved|fixed|unchanged|the same|konstant|erhalten|fest|unverändert"
    r"|constante?s?|conservée?s?)"
)
MEASURE = (
    r"(?:(?:kinetic |potential )?energ(?:y|ies)|moment(?:a|um|s)?|veloci\w+|speed"
    r"|accelerations?|forces?|torques?|frequenc\w+|periods?|angles?|rates?|times?|Lagrangian"
    r"|Hamiltonian|action|tensor|matri\w+|equations?|components?|coordinates?|potential|amplitudes?"
    r"|work|power|distance|positions?|ratio|first|second|third|last|next|rest|sake|same|purposes?"
    r"|solutions?|derivatives?|constants?|tension|mass|density|radius|length|height|sum|axes|axis)\b"
)
"""Words for what a letter stands for, not for the body that has it."""
QUANTITY = rf"(?:[\w-]+ ){{0,3}}{MEASURE}"
PLACE = (
    r"(?:start|beginning|top|bottom|end|edge|(?:turning|lowest|highest|foremost|nearest) point"
    r"|point (?:next|nearest|closest|furthest|farthest)[^,;:§]{0,30}|(?:same |first |last )?moment"
    r"|instant|(?:peri|ap)helion|perigee|apogee|(?:peri|apo)cent(?:re|er)|maximum|minimum|middle|cent(?:re|er)|wall|surface|axis|rim)"
)
OF_SEVERAL = r" (?:of|one|mode|root|frequency|frequencies|eigen\w+|value|moment)\b"
LIKE = r"(?:equal|alike|the same|identical|egal|as (?:\w+) as)\b"
SMALL = (
    r"(?:small(?:ness of)? (?:§|angles?|oscillations?|vibrations?|displacements?|deviations?"
    r"|swings?"
    r"|amplitudes?|motions?|perturbations?|disturbances?|deflections?|things|quantities|terms)"
    r"|(?:first|second|lowest|leading|linear) order|approximately|roughly"
    rf"|(?:nearly|almost)(?! {LIKE})|tiny|minute(?= \(|\Z|,)"
    r"|linear(?:is|iz)"
    r"|neglect|dropping|(?:I|we) drop|slightly"
    r"|kleinen? (?:§|Winkeln?|Schwingung(?:en)?|Auslenkung(?:en)?|Ausschläge|Störung(?:en)?)"
    r"|(?:erster|zweiter|führender) Ordnung|näherungsweise|ungefähr|vernachlässig"
    r"|fast (?:konstant|null|senkrecht)"
    r"|petite?s? (?:§|angles?|oscillations?|mouvements?|déplacements?)|premier ordre|approximative"
    r"|environ|presque|néglig)"
)
LARGE = (
    r"(?:large(?:st)? §|§ (?:is )?(?:very )?large\b|fast (?:\w+ )?(?:top|spin|wheel|gyroscope"
    r"|rotation)"
    r"|rapidly|(?:very|is) (?:large|fast)\b|(?:schnelle[rns]?) (?:\w+ )?(?:Kreisel|Rotation)"
    r"|gro(?:ß|ss)es? §"
    r"|toupie rapide|grande?s? (?:§|vitesses?))"
)

SMALLER = r"(?:small|light|slow|short|weak|low)er\b"
LARGER = r"(?:larg|great|bigg|heavi|fast|quick|long|strong|high|stiff)er\b"

CIRCUMSTANCE = (
    r"(?:(?:and|but|so|then|now|und|aber|et|mais),? )?"
    r"(?:on|with|without|after|as soon as|where|while|if|when|once|under|behind|during|an?|another"
    r"|for|auf|ohne|nach|sobald|während|wenn|unter|hinter|eine?|sur|sans|après|dès que|pendant|si"
    r"|quand|sous|une?)"
    r" (?!this|that|these|those|its?\b|them|the (?:same|other)|general|both|our|small|large|which"
    r"|particular|us|all|each|every|any|beide|diese|all|les deux|cela|ce\b|en\b)"
)
"""Words with which circumstances begin, and not what is done with the equations."""

POSITION = (
    r"(?:(?:(?:rest|equilibrium|lowest|highest|hanging|upright|vertical|horizontal|initial) )?"
    r"(?:position|configuration|point|direction)|equilibrium|bottom|top|origin|vertical"
    r"|horizontal|level|ground|ceiling|floor|(?:Ruhe|Gleichgewichts|Null)(?:lage|punkt)"
    r"|(?:tiefste|höchste)[nr]? (?:Lage|Stelle|Punkt)|(?:Senk|Waage)rechte|Gleichgewicht"
    r"|Vertikale|Horizontale|(?:la )?(?:position|verticale|horizontale)(?: d['’]équilibre"
    r"| de repos| (?:la )?plus basse| initiale)?|point le plus bas|équilibre|repos|origine)"
)
"""Words for a place from which a coordinate counts."""
POINTING = (
    r"(?:(?:(?:hanging|hangs|pointing|points|straight|vertically|directly) ){0,2}"
    r"(?:hanging|down(?:wards?)?|up(?:wards?|right)?|vertical(?:ly)?|horizontal(?:ly)?|below|above)"
    r"|(?:(?:senkrecht|hängend|ganz|nach) ){0,2}(?:unten|oben|hängend|senkrecht|waagerecht)"
    r"|(?:vers le|en) (?:bas|haut))\b"
)
"""Words for a direction in which something lies or hangs."""
