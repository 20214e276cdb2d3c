"""The words that every lecture has, in the language that is asked for: Figure, Exercise, Solution.

>>> said("Exercise", "de"), said("Exercise", "fr"), said("Exercise", "en")
('Aufgabe', 'Exercice', 'Exercise')

Numbers keep their decimal points: they stand in sentences, tables and figures whose text stays
English, where a comma parts items (1, 2, 2.9), and a work has one decimal sign throughout.
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
The conditions of the marks stand in the text, with these statements. \
| Die Bedingungen der Zeichen stehen im Text, bei diesen Aussagen. \
| Les conditions des signes sont dans le texte, avec ces énoncés. \
| Las condiciones de los signos están en el texto, con estos enunciados. \
| Le condizioni dei segni sono nel testo, con questi enunciati.
What rests on what | Was worauf beruht | Ce qui repose sur quoi | Qué se apoya en qué \
| Che cosa poggia su che cosa
Notation | Notation | Notation | Notación | Notazione
Written otherwise | Anders geschrieben | Autre notation | Notación distinta | Notazione diversa
here | hier | ici | aquí | qui
in the notes | im Skript | dans le cours | en los apuntes | negli appunti
Symbols, letter by letter in the order of first use \
| Formelzeichen, nach Buchstaben in der Reihenfolge ihres Auftretens \
| Symboles, par lettres dans l’ordre d’apparition \
| Símbolos, por letras en orden de aparición \
| Simboli, per lettere in ordine di apparizione
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
In the margin, at each statement of the notes | Am Rand, bei jeder Aussage des Skripts \
| En marge, à chaque énoncé du cours | Al margen, en cada enunciado de los apuntes \
| A margine, a ogni enunciato degli appunti
it was shown to hold, in symbols | symbolisch bewiesen | démontré par le calcul formel \
| demostrado simbólicamente | dimostrato simbolicamente
it holds at random points to 40 digits, and was not shown in symbols \
| gilt an zufälligen Punkten auf 40 Stellen, symbolisch nicht bewiesen \
| vérifié à 40 chiffres en des points pris au hasard, non démontré par le calcul formel \
| se cumple con 40 cifras en puntos al azar, sin demostración simbólica \
| vale con 40 cifre in punti presi a caso, senza dimostrazione simbolica
it holds under the condition noted with it, which the notes do not state, or under one that \
stands in its lines | gilt unter der Bedingung daneben, die im Skript nicht steht, oder unter \
einer, die seine Zeilen nennen | vrai sous la condition ci-contre, que le cours n’énonce pas, ou \
sous une condition que ses lignes énoncent | se cumple con la condición de al lado, que los \
apuntes no mencionan, o con una que mencionan sus líneas | vale sotto la condizione accanto, che \
gli appunti non dicono, o sotto una che le sue righe dicono
right in content, at odds with the notes’ own definitions \
| inhaltlich richtig, aber im Widerspruch zu den Definitionen des Skripts \
| juste sur le fond, mais contraire aux définitions du cours \
| correcto en el fondo, pero contrario a las definiciones de los propios apuntes \
| giusto nella sostanza, ma contrario alle definizioni degli appunti stessi
it does not hold as the notes have it; the right form stands beneath \
| gilt nicht so, wie es im Skript steht; die richtige Form steht darunter \
| faux tel que le cours l’énonce, la forme juste est en dessous \
| no se cumple tal como está en los apuntes; debajo está la forma correcta \
| non vale così come sta negli appunti; la forma giusta è sotto
The notes say | Im Skript steht | Le cours dit | Los apuntes dicen | Gli appunti dicono
This is false | Das ist falsch | Cela est faux | Esto es falso | Questo è falso
This is at odds with the notes’ own definitions | Das widerspricht den Definitionen des Skripts \
| Cela contredit les définitions du cours | Esto contradice las definiciones de los apuntes \
| Questo contraddice le definizioni degli appunti
at | für | pour | para | per
if | falls | si | si | se
would be | wäre | serait | sería | sarebbe
the equation | die Gleichung | l’équation | la ecuación | l’equazione
as the notes print it | wie im Skript | telle que dans le cours | como en los apuntes \
| come negli appunti
in component | in Komponente | à la composante | en la componente | nella componente
in row | in Zeile | à la ligne | en la fila | nella riga
column | Spalte | colonne | columna | colonna
It should be | Richtig ist | La forme juste est | Debería ser | Dovrebbe essere
We have shown | Wir haben gezeigt | Nous avons montré | Hemos mostrado | Abbiamo mostrato
and | und | et | y | e
section | Abschnitt | section | sección | sezione
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
what it says | Aussage | énoncé | enunciado | enunciato
what | Größe | grandeur | magnitud | grandezza
value | Wert | valeur | valor | valore
→ ← a line, ↓ ↑ a slide, a all of it, f full screen\
 | → ← eine Zeile, ↓ ↑ eine Folie, a alles, f ganzer Schirm\
 | → ← une ligne, ↓ ↑ une diapositive, a tout, f plein écran\
 | → ← una línea, ↓ ↑ una diapositiva, a todo, f pantalla completa\
 | → ← una riga, ↓ ↑ una diapositiva, a tutto, f schermo intero
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
    "→ ← a line, ↓ ↑ a slide, a all of it, f full screen",
)
"""What the buttons of a page and the headings of slides say."""


def said(words: str, language: str) -> str:
    """The words in a language; as they are where it has no others for them.

    Stops, blanks and numbers around them stay.

    >>> said(", in row ", "de"), said("2.5 points", "de")
    (', in Zeile ', '2.5 Punkte')
    """
    known = WORDS.get(language, {})
    core = words if words in known else words.strip(" ,;:.(0123456789")
    return words.replace(core, known.get(core, core), 1)


def translated(document: b.Document) -> b.Document:
    """The document with its fixed words in its language; what authors wrote is theirs."""
    language = document.look.language
    if language not in WORDS:
        return document

    def other(part: Any, _: str) -> Any:
        return said(part, language) if isinstance(part, b.Fixed) else part

    return replace(document, blocks=b.walked(document.blocks, other))
