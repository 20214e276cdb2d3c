"""The words that every lecture has, in the language that is asked for: Figure, Exercise, Solution.

>>> said("Exercise", "de"), said("Exercise", "fr"), said("Exercise", "en")
('Aufgabe', 'Exercice', 'Exercise')
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from rigidtop.report import blocks as b

_TABLE = """
Figure | Abbildung | Figure | Figura | Figura
Exercise | Aufgabe | Exercice | Ejercicio | Esercizio
Exercises | Aufgaben | Exercices | Ejercicios | Esercizi
Solution | Lösung | Solution | Solución | Soluzione
Solutions of the exercises | Lösungen der Aufgaben | Solutions des exercices \
| Soluciones de los ejercicios | Soluzioni degli esercizi
Laws and definitions | Gesetze und Definitionen | Lois et définitions | Leyes y definiciones \
| Leggi e definizioni
Summary of results | Zusammenfassung der Ergebnisse | Résumé des résultats \
| Resumen de los resultados | Riassunto dei risultati
What rests on what | Was worauf beruht | Ce qui repose sur quoi | Qué se apoya en qué \
| Che cosa poggia su che cosa
List of symbols | Formelzeichen | Liste des symboles | Lista de símbolos | Elenco dei simboli
Equations cited | Zitierte Gleichungen | Équations citées | Ecuaciones citadas | Equazioni citate
Contents | Inhalt | Table des matières | Índice | Indice
Given | Gegeben | Données | Datos | Dati
Questions | Fragen | Questions | Preguntas | Domande
Questions and solutions | Fragen und Lösungen | Questions et solutions \
| Preguntas y soluciones | Domande e soluzioni
Name | Name | Nom | Nombre | Nome
Date | Datum | Date | Fecha | Data
point | Punkt | point | punto | punto
points | Punkte | points | puntos | punti
In the margin, at the last line of each statement of the notes \
| Am Rand, bei der letzten Zeile jeder Aussage des Skripts \
| En marge, à la dernière ligne de chaque énoncé des notes \
| Al margen, en la última línea de cada enunciado de los apuntes \
| A margine, all'ultima riga di ogni enunciato degli appunti
it was shown to hold, in symbols | in Symbolen bewiesen | démontré en symboles \
| demostrado con símbolos | dimostrato in simboli
it holds at random points to 40 digits, and was not shown in symbols \
| gilt an zufälligen Stellen auf 40 Ziffern, in Symbolen nicht bewiesen \
| vrai à 40 chiffres en des points au hasard, non démontré en symboles \
| vale con 40 cifras en puntos al azar, no demostrado con símbolos \
| vale con 40 cifre in punti a caso, non dimostrato in simboli
it holds under the condition beside it, which the notes do not state, or under one that its lines \
say | gilt unter der Bedingung daneben, die im Skript nicht steht, oder unter einer, die in den \
Zeilen steht | vrai sous la condition à côté, que le cours ne dit pas, ou sous une que disent ses \
lignes | vale con la condición de al lado, que los apuntes no dicen, o con una que dicen sus \
líneas | vale con la condizione accanto, che gli appunti non dicono, o con una detta nelle righe
right in content, at odds with the notes’ own definitions \
| dem Inhalt nach richtig, anders als das Skript selbst definiert \
| juste au fond, contraire aux définitions du cours lui-même \
| correcto en el fondo, contrario a las definiciones de los propios apuntes \
| giusto nella sostanza, contrario alle definizioni degli appunti stessi
it does not hold as the notes have it; the right form stands beneath \
| gilt nicht so, wie es im Skript steht; die richtige Form steht darunter \
| faux tel que le cours le donne; la forme juste est au-dessous \
| no vale como está en los apuntes; la forma correcta está debajo \
| non vale come sta negli appunti; la forma giusta sta sotto
What a sentence cites by its name, or by the number of an equation that is not derived here, \
stands under “Laws and definitions” at the end. \
| Was ein Satz beim Namen nennt, oder mit der Nummer einer Gleichung, die hier nicht hergeleitet \
wird, steht am Ende unter „Gesetze und Definitionen“. \
| Ce qu’une phrase cite par son nom, ou par le numéro d’une équation non démontrée ici, se trouve \
à la fin sous « Lois et définitions ». \
| Lo que una frase cita por su nombre, o por el número de una ecuación que aquí no se deduce, está \
al final en «Leyes y definiciones». \
| Ciò che una frase cita per nome, o col numero di un’equazione che qui non si deriva, sta alla \
fine sotto «Leggi e definizioni».
neither shown nor refuted | weder bewiesen noch widerlegt | ni démontré ni réfuté \
| ni demostrado ni refutado | né dimostrato né confutato
as | wie | comme | como | come
above | oben | ci-dessus | arriba | sopra
Results only | Nur Ergebnisse | Résultats seuls | Solo resultados | Solo i risultati
Steps | Schritte | Étapes | Pasos | Passi
Steps and reasons | Schritte und Gründe | Étapes et raisons | Pasos y razones | Passi e ragioni
Light or dark | Hell oder dunkel | Clair ou sombre | Claro u oscuro | Chiaro o scuro
Copy LaTeX | LaTeX kopieren | Copier LaTeX | Copiar LaTeX | Copia LaTeX
Link | Link | Lien | Enlace | Collegamento
symbol | Zeichen | symbole | símbolo | simbolo
meaning | Bedeutung | signification | significado | significato
unit | Einheit | unité | unidad | unità
number | Nummer | numéro | número | numero
equation | Gleichung | équation | ecuación | equazione
what it says | was sie sagt | ce qu'elle dit | lo que dice | che cosa dice
what | was | quoi | qué | che cosa
value | Wert | valeur | valor | valore
continued | Fortsetzung | suite | continuación | continua
Copied | Kopiert | Copié | Copiado | Copiato
"""
_CODES = ("de", "fr", "es", "it")
WORDS: Mapping[str, Mapping[str, str]] = {
    code: {row[0]: row[k] for row in (line.split(" | ") for line in _TABLE.strip().splitlines())}
    for k, code in enumerate(_CODES, 1)
}
"""By the language's code, then by the English words."""

SHOWN = (
    *("Results only", "Steps", "Steps and reasons", "Light or dark"),
    *("Link", "Copy LaTeX", "Copied", "continued"),
)
"""What the buttons of a page and the headings of slides say."""


def said(words: str, language: str) -> str:
    """The words in a language; as they are where it has no others for them."""
    return WORDS.get(language, {}).get(words, words)


def translated(document: b.Document) -> b.Document:
    """The document with its fixed words in its language; what authors wrote is theirs."""
    language = document.look.language
    if language not in WORDS:
        return document
    blocks = tuple(_block(block, language) for block in document.blocks)
    subtitle = ", ".join(_counted(words, language) for words in document.subtitle.split(", "))
    return replace(document, blocks=blocks, subtitle=subtitle)


def _counted(words: str, language: str) -> str:
    """Fixed words, or so many of something.

    >>> _counted("10 points", "de"), _counted("Questions and solutions", "de")
    ('10 Punkte', 'Fragen und Lösungen')
    """
    count, between, unit = words.partition(" ")
    whole = said(words, language)
    return whole if whole != words else count + between + said(unit, language)


def _block(block: b.Block, language: str) -> Any:
    match block:
        case b.Heading(number=""):
            return replace(block, title=said(block.title, language))
        case b.Subhead():
            return replace(block, words=said(block.words, language))
        case b.Figure():
            return replace(block, kind=said("Figure", language))
        case b.ExerciseHead():
            points = _counted(block.points, language)
            return replace(block, kind=said("Exercise", language), points=points)
        case b.NameLine():
            return replace(block, words=tuple(said(words, language) for words in block.words))
        case b.Legend():
            rows = tuple((verdict, said(words, language)) for verdict, words in block.rows)
            return replace(block, head=said(block.head, language), rows=rows)
        case b.Symbols() | b.Results() | b.Quantities():
            return replace(block, head=tuple(said(words, language) for words in block.head))
        case b.Paragraph():
            mark = _referring(block.mark, language)
            only = block.content if len(block.content) == 1 else ()
            fixed = tuple(said(x, language) for x in only if isinstance(x, str)) or block.content
            return replace(block, content=fixed, label=said(block.label, language), mark=mark)
        case b.Display():
            marked = (replace(row, mark=_referring(row.mark, language)) for row in block.rows)
            return replace(block, rows=tuple(marked))
    return block


def _referring(mark: b.Mark | None, language: str) -> b.Mark | None:
    """A mark whose note refers to another has fixed words alone: as above."""
    if mark is None or mark.note[:1] != ("as ",):
        return mark
    rest = (said(x, language) if isinstance(x, str) else x for x in mark.note[1:])
    return replace(mark, note=(f"{said('as', language)} ", *rest))
