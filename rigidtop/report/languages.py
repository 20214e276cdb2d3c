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
    *("Link", "Copy LaTeX", "Copied"),
)
"""What the buttons of a page say."""


def said(words: str, language: str) -> str:
    """The words in a language; as they are where it has no others for them."""
    return WORDS.get(language, {}).get(words, words)


def translated(document: b.Document) -> b.Document:
    """The document with its fixed words in its language; what authors wrote is theirs."""
    language = document.look.language
    if language not in WORDS:
        return document
    blocks = tuple(_block(block, language) for block in document.blocks)
    return replace(document, blocks=blocks, subtitle=said(document.subtitle, language))


def _block(block: b.Block, language: str) -> Any:
    match block:
        case b.Heading(number=""):
            return replace(block, title=said(block.title, language))
        case b.Subhead():
            return replace(block, words=said(block.words, language))
        case b.Figure():
            return replace(block, kind=said("Figure", language))
        case b.ExerciseHead():
            count, _, unit = block.points.partition(" ")
            points = f"{count} {said(unit, language)}".strip()
            return replace(block, kind=said("Exercise", language), points=points)
        case b.NameLine():
            return replace(block, words=tuple(said(words, language) for words in block.words))
        case b.Legend():
            return replace(block, head=said(block.head, language))
        case b.Symbols() | b.Results() | b.Quantities():
            return replace(block, head=tuple(said(words, language) for words in block.head))
        case b.Paragraph():
            return replace(block, label=said(block.label, language))
    return block
