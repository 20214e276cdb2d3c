"""Formulas with their scopes, sentences and the words around them."""

import time

import pytest

from rigidtop.read.declared import Word, declared
from rigidtop.read.passages import passages
from rigidtop.read.phrases import Cue


def names(source, **how):
    """The cues of each formula with a relation or on a line of its own."""
    return [
        " ".join(sorted(cue.name for cue in passage.cues))
        for passage in passages(source, **how)
        if passage.display or "=" in passage.text or "<" in passage.text or "ne" in passage.text
    ]


@pytest.mark.parametrize(
    ("source", "scopes"),
    [
        ("$a$\n# A\n$a$\n## B\n$a$\n# C\n$a$", [(), (1,), (1, 2), (3,)]),
        (r"\section{A} $a$ \subsection*{B} $a$ \section{C} $a$", [(1,), (1, 2), (3,)]),
        ("A\n===\n\n$a$\n\nB\n---\n\n$a$\n\n---\n\n$a$", [(1,), (1, 2), (1, 2, 3)]),
        ("**One.** $a$\n\n$b$\n\n**Two.** $a$\n\n# C\n\n$a$", [(1,), (1,), (2,), (3,)]),
        ("We see **this.**\n**Not** a title, $a$", [()]),
        ("$$a$$\n\\textbf{Rod} $a$\n\\paragraph{Ball,} $a$", [(), (1,), (2,)]),
        ("1. $a$\n2. $a$\n   - $a$\n\nText $a$", [(-1,), (-2,), (-2, -3), ()]),
        (
            r"\begin{enumerate}\item $a$ \textbf{B} $a$ \item $a$\end{enumerate} $a$",
            [(1, -2), (1, -2), (1, -3), ()],
        ),
        (r"\begin{example}$a$ \paragraph{A} $a$\end{example} $a$", [(1,), (1, 2), ()]),
        (r"\begin{defi}$a$\end{defi} \begin{tikzpicture}$a$\end{tikzpicture} $a$", [(1,), ()]),
        ("Exercise 1. $a$\n\n(a) $a$\n\n(b) $a$\n\nExercise 2. $a$", [(1,), (1, 2), (1, 3), (4,)]),
        ("Case 1: $a$\n\nCase 2: $a$", [(1,), (2,)]),
        ("\\section{A}\n    a) $a$\n\n    b) $a$", [(1, 2), (1, 3)]),
        ("$$a\n- b$$ $a$\n`\n# no\n` $a$", [(), (), ()]),
    ],
)
def test_a_passage_stands_in_a_scope(source, scopes):
    assert [passage.scope for passage in passages(source)] == scopes


@pytest.mark.parametrize(
    ("source", "sentences"),
    [
        ("One $a$. Two $b$. three $c$", [0, 1, 1]),
        ("So that $$a$$ and\n\n$$b.$$\n\nThen $$c$$", [0, 0, 1]),
        ("At rest\n\n$$a$$\n\n$$b$$\n\nNow $$c$$", [0, 0, 1]),
        ("With $a$, i.e. $b$, see Eq. $c$.", [0, 0, 0]),
        ("One $$a.$$ and $$b.$$ Two $c$", [0, 0, 1]),
        ("One $a$\n# Two $b$\nThree $c$", [0, 1, 2]),
        ("**Held.** Then $a$. Now $b$", [1, 2]),
    ],
)
def test_a_passage_stands_in_a_sentence(source, sentences):
    first, *rest = [passage.sentence for passage in passages(source)]
    assert [first, *rest] == sentences


def test_what_stands_before_a_document_is_no_formula():
    source = "\\documentclass{a}\n\\newcommand{\\x}{{$a=b$}}\n\\begin{document}\n$c=d$\n"
    assert [passage.text for passage in passages(source)] == ["c=d"]


def test_a_word_behind_a_formula_is_its_last_side():
    first, second = passages("So $E = $ const. and $p=$ small")
    assert (first.text, second.text) == (r"E = \text{const}", "p=")


def test_words_stand_between_statements_and_letters_are_signs_in_them():
    first, letter, second = passages("With $a=b$ the mass $m$ gives\n$$c=d.$$")
    assert (first.before, first.behind) == ("With", "the mass § gives")
    assert (letter.before, letter.behind) == ("the mass", "gives")
    assert (second.before, second.behind) == ("the mass § gives", ".")


CUES = {
    "At $t=0$,\n\n$$x=x_0$$\n\n$$y=0$$": ["MOMENT", "MOMENT", "MOMENT"],
    "At the start $x=0$ and $y=0$, so that for all times $$z=0$$": [
        *("MOMENT", "MOMENT", "DERIVED GENERAL")
    ],
    "the point next to the Sun, where $x=0$,\n$$r=1$$": ["MOMENT", "MOMENT"],
    "When $x=0$ the speed is\n$$v=u$$": ["MOMENT", "MOMENT"],
    "At the bottom its speed is $u$, at the top $v$:\n$$u=2v$$": [""],
    "Im Umkehrpunkt ist $x=0$ und zur Zeit $t=1$": ["MOMENT TURNING", "MOMENT"],
    "À l'instant $t=0$": ["MOMENT"],
    "Lorsque $x=0$": ["MOMENT"],
    "At this point, $v=u$.": ["MOMENT"],
    "La vitesse s'obtient pour $x=0$:\n$$v=u$$": ["MOMENT", "MOMENT"],
    "Die Höhe ergibt sich für $x=0$.": ["DERIVED MOMENT"],
    "For $a=0$ we have $b=c$": ["CASE", "DERIVED"],
    "If a wheel turns then $a=b$": ["CASE DERIVED"],
    "For $a\\ne0$ and $b=0$": ["CONDITION", "CASE"],
    "Setting H = E: $$a=b$$": ["CASE"],
    "Without friction, $a=0$ and\n$$b=c$$": ["CASE", ""],
    "On the horizontal, $a=0$. On the other hand, $b=c$": ["CASE", "GENERAL"],
    "We look at $$x=y$$ The place is at $s=1$.": ["", ""],
    "Suppose $p=q$. Then $$a=b$$": ["CASE", "DERIVED"],
    "For steady precession $x=0$ and $y=c$.": ["CASE", "CASE"],
    "For a parabola, on the other hand, $E=0$, hence $$a=b$$": ["CASE GENERAL", "DERIVED"],
    "On a circle $r=0$": ["CASE CIRCLE"],
    "For a horizontal top $$a=b$$": ["CIRCUMSTANCE"],
    "If $a=0$, $b=c$.": ["CASE", ""],
    "Set $a=1$, $b=2$.": ["CASE DEFINED", "CASE DEFINED"],
    "**It rises with $a=g$.** Then $$N=2$$": ["CASE", "DERIVED"],
    "**The rope is cut.** Then $a=g$ and\n$$N=0$$": [
        "CASE DERIVED ELSEWHERE",
        "DERIVED ELSEWHERE",
    ],
    r"\paragraph{Weak damping,} $a<b$. With $c=d$": ["CONDITION", "DEFINED"],
    "Sei $a=b$.": ["CASE DEFINED"],
    "Soit $a=b$.": ["CASE DEFINED"],
    "With $L=T-V$\n\n$$a=b$$": ["DEFINED", ""],
    "$$E=U$$ with $$U=V.$$": ["", "DEFINED"],
    "no source: $$a=b$$ or, with the derivative taken, $$c=d$$": ["", ""],
    "mit $a=b$": ["DEFINED"],
    "avec $a=b$": ["DEFINED"],
    "The energy $E=T$ is constant: $$a=0$$": ["CONSTANT", ""],
    "$a=b$ and $c=d$ are constants of the motion.": ["", "CONSTANT"],
    "$$a=b$$ does not change.": ["CONSTANT"],
    "There is a constant $$l=m$$": ["CONSTANT"],
    "$a=b$ is not a constant.": [""],
    "We can show that $$a=b$$": [""],
    "$$p=q$$ ist erhalten.": ["CONSTANT"],
    "For small angles $$a=b$$ Exactly $$c=d$$": ["APPROXIMATED SMALL", "GENERAL"],
    "# A\nTo first order $a=b$, moreover $c=d$.\n# B\n$a=b$": [
        *("APPROXIMATED SMALL", "APPROXIMATED", "")
    ],
    "Für kleine Winkel $a=b$": ["APPROXIMATED CASE SMALL"],
    "Pour les petits angles $$a=b$$": ["APPROXIMATED SMALL"],
    "A small block slides, $a=b$": [""],
    "For a fast top $$a=b$$": ["APPROXIMATED CIRCUMSTANCE LARGE"],
    r"For $c\ne0$ $$a=b$$": ["CONDITION", ""],
    r"only if $c\neq0$, otherwise": ["CONDITION"],
    r"we have $a=b$ ($c\ne0$).": ["DERIVED", "CONDITION"],
    "One might think that $a=b$.": ["ASKED"],
    "It is wrong that $$a=b$$": ["ASKED"],
    "Show that $a=b$ and $c=d$.": ["ASKED", "ASKED"],
    "Is $a=b$ true?": ["ASKED"],
    "As $x$ does not occur, $$a=b$$": [""],
    "It is wrong to say that $a=b$ unless $c=d$.": ["ASKED", "ASKED"],
    "On a $a=b$. On en déduit que $c=d$.": ["", "DERIVED"],
    "Wir nehmen an, dass $a=b$. Im Allgemeinen $c=d$.": ["CASE", "GENERAL"],
    "Im Fall $a=b$ gilt $c=d$, und $p$ ist erhalten.": ["CASE", ""],
    "When it passes the lowest point its speed is $v=u$": ["MOMENT"],
    "Hence $a=b$": ["DERIVED"],
    "daraus folgt $a=b$": ["DERIVED"],
    "d'où $a=b$": ["DERIVED"],
    "The moment, from the tables, is $$J=1$$": ["GIVEN"],
    "Laut Messung ist $a=b$": ["GIVEN"],
    "The new total energy is therefore $a=b$": ["ANEW DERIVED"],
    "$x=0$ is the lowest point, and $y=0$ hanging down.": ["ORIGIN", "ORIGIN"],
    "Let $x=0$ be upright.": ["CASE DEFINED ORIGIN"],
    "At the start $x=0$ in the rest position.": ["MOMENT"],
    "For $x=0$ in the rest position $b=c$.": ["CASE", ""],
    "$x=0$ unten": ["ORIGIN"],
    "La position d'équilibre est $x=0$.": ["ORIGIN"],
    "Choose the axes so that $a=0$ and $b=c$. So $d=e$": ["CASE DERIVED"] * 2 + ["DERIVED"],
    "A new problem is harder. There $a=b$": ["MOMENT"],
    "There is $a=b$": [""],
    "In equilibrium $a=b$ with $$c=d$$": ["EQUILIBRIUM", "DEFINED EQUILIBRIUM"],
    "The period of the swing is $$a=b$$": ["OSCILLATION"],
    "Divide both sides by $a<b$. Then $$b=c$$": ["DIVISOR", "DERIVED"],
    "It vanishes at $$b=c$$": ["VANISHING"],
    "It comes to a halt after $$b=c$$": ["STOPPING"],
    "A second body has $$b=c$$": ["CIRCUMSTANCE OTHER"],
    "On the moon it is $$b=c$$": ["CIRCUMSTANCE ELSEWHERE"],
    "On a greased table it has $$b=c$$ $$c=d$$ and so $$d=e$$": ["CIRCUMSTANCE"] * 2 + ["DERIVED"],
    "Without the length of the thread $$b=c$$": [""],
    "For coils that are almost alike $$b=c$$": ["CIRCUMSTANCE NEARLY_EQUAL"],
    "The star is much heavier than the planet $a=b$": ["LITTLE"],
    "The planet $a=b$ is much lighter than the star": ["LITTLE"],
    "The slower of the frequencies is $$b=c$$": ["LEAST OSCILLATION SEVERAL"],
    "The larger one of the roots is $$b=c$$": ["GREATEST SEVERAL"],
    "Its components are $$a=b$$ $$b=c$$": ["COMPONENTS", "COMPONENTS"],
    "From there on $$b=c$$": ["MOMENT THERE"],
    "The positive root is $$b=c$$": ["POSITIVE"],
    "The negative root is $$b=c$$": ["NEGATIVE"],
    "It is greatest for $$b=c$$": ["EXTREME"],
    "For equal masses $$a=b$$": ["CIRCUMSTANCE EQUAL_MASSES"],
    "There both are equal: $$b=c$$": ["BOTH_EQUAL MOMENT"],
    "A particular solution is $$b=c$$": ["PARTICULAR"],
    "It holds (not at the poles, where $a=b$).": ["DEFINED EXCEPTED"],
    "With a multiplier for $a=b$ we have $$b=c$$": ["CONSTRAINT DEFINED", "DERIVED"],
    "On a circle of radius $a$ we have $$b=c$$": ["CIRCLE CIRCUMSTANCE DERIVED"],
    "Energy is conserved. Hence $$b=c$$": ["CONSERVED DERIVED"],
    "It stays the same, so $$b=c$$": ["DERIVED KEPT REPEATED"],
    "Angular momentum is conserved: $$b=c$$": ["MOMENTUM_KEPT"],
    "It falls from $x=a$ to $x=b$ and has $$b=c$$": ["RANGE", "RANGE", ""],
    "From $a=b$ we get $$b=c$$": ["", "DERIVED"],
    "As stated above, $a=b$": ["REPEATED"],
    "Were there no weight, it would be at $a=b$": ["ASKED MOMENT"],
    "It is back on the ground after $$b=c$$": ["LANDING"],
    "It turns back after $$b=c$$": ["TURNING"],
    "And from $L=T-V$ $$b=c$$": ["", ""],
    "Apart from $a=0$ there is $$b=c$$": ["EXCEPTED", ""],
    "The attraction is just what the circle needs, $$b=c$$": ["BALANCE"],
    "If the arms keep their angle, $$b=c$$": ["EQUILIBRIUM"],
    "Let $x$ (from rest) be $a=b$": [""],
    "Thrown from the ground, $r=R$, with $v=u$": ["MOMENT", "DEFINED MOMENT"],
    "A stone is let go. After a while $a=b$ and $c=d$": ["REST", ""],
    "Released at $x=a$ without velocity, it has $$a=b$$": ["MOMENT REST", "MOMENT REST"],
    "If $a=b$ and $c=d$ at the start, $$e=f$$": ["CASE MOMENT", "CASE MOMENT", ""],
}


@pytest.mark.parametrize("source", CUES)
def test_words_are_cues(source):
    assert names(source) == CUES[source]


def test_every_cue_has_an_example():
    heard = {name for listed in CUES.values() for cues in listed for name in cues.split()}
    assert heard == {cue.name for cue in Cue}


PLAIN = {
    "so L = λ₃ω₃e₃ and R_CM = R e₃, g = −g ẑ: yes": ["L = λ₃ω₃e₃", "R_CM = R e₃", "g = −g ẑ"],
    "moment:\n\nL_{1'} = $a=b$\n": [r"L_{1'} =  a=b"],
    "d/dt(∂L/∂θ̇) = ∂L/∂θ\n\n$x=y$ => done": ["d/dt(∂L/∂θ̇) = ∂L/∂θ", "x=y"],
    "F = ma, as v = (a, b, 0).": ["F = ma", "v = (a, b, 0)"],
    "- theta'' = -g/l sin(theta)\n2. if k > 0": ["theta'' = -g/l sin(theta)", "k > 0"],
    "see <a href='x=1'>this</a>, https://a.org/?b=c, a -> b, `a = b`": [],
    "\\begin{document}\n\\textbf{Also} a = \\sin b \\end{document}": [r"a = \sin b"],
    "the mass = 3": [],
    "it falls (with a = b), (c = d) and (a + b)/c = d": ["a = b", "c = d", "(a + b)/c = d"],
}


@pytest.mark.parametrize("source", PLAIN)
def test_an_answer_has_formulas_outside_of_dollars(source):
    taken = passages(source, plain=True)
    assert [passage.text for passage in taken] == PLAIN[source]
    for passage in taken:
        assert source[passage.start :].lstrip("$").startswith(passage.text[:3])


DECLARED = {
    "a bead of mass $m$ and the angle $\\theta$": {"m": "MASS", r"\theta": "ANGLE"},
    "where $I_1$ is the moment of inertia about $e$": {"I_1": "INERTIA"},
    "with $\\mathbf i$ and $\\mathbf j$ fixed": {r"\mathbf i": "FIXED", r"\mathbf j": "FIXED"},
    "The unit vectors $\\hat x$ (up) and $\\hat y = z$ are fixed": {
        r"\hat x": "FIXED UNIT_VECTOR",
        r"\hat y": "FIXED UNIT_VECTOR",
    },
    "a complex constant $c$; $a\\ (a > 0)$": {"c": "COMPLEX CONSTANT", "a": "POSITIVE"},
    "I write $\\theta_t$, $\\phi_t$ for the time derivatives": {
        r"\theta_t": "DERIVATIVE",
        r"\phi_t": "DERIVATIVE",
    },
    "turns with the constant rate $\\Omega$": {r"\Omega": "CONSTANT RATE"},
    "the position vector $r$ of the mass $m$, the inertia tensor $I$": {
        "r": "POSITION VECTOR",
        "m": "MASS",
        "I": "INERTIA MATRIX",
    },
    "the centre of mass $X$": {"X": "POSITION"},
    "$p$ and $q$ are conserved, $\\phi$ is cyclic": {
        "p": "CONSTANT",
        "q": "CONSTANT",
        r"\phi": "CYCLIC",
    },
    "mit der Masse $m$, wobei $r$ der Ortsvektor ist": {"m": "MASS"},
    "wobei $\\omega$ konstant ist, der Winkel $a$": {r"\omega": "CONSTANT", "a": "ANGLE"},
    "avec la masse $m$ et le rayon $R$": {"m": "MASS", "R": "LENGTH"},
    "the rates $u, v$ and a function $V(x)$": {"u": "RATE", "v": "RATE", "V": "FUNCTION"},
    "Its moment about that axis is $J$": {"J": "INERTIA"},
    "With $L=T-V$ the energy is $E=T$, not constant $k$": {"E": "ENERGY"},
}


@pytest.mark.parametrize("source", DECLARED)
def test_words_say_what_a_letter_is(source):
    assert {
        letter.text: " ".join(sorted(word.name for word in letter.words))
        for letter in declared(source)
    } == DECLARED[source]
    for letter in declared(source):
        assert source[letter.start :].startswith(letter.text)


def test_words_of_every_kind_name_themselves():
    assert {word for letter in declared("a unit vector $n$") for word in letter.words} == {
        Word.UNIT_VECTOR
    }


@pytest.mark.parametrize(
    "unit",
    [
        *(
            "$a=b$ and ",
            "$a b$ ",
            "**a ",
            "\n\n**a",
            "\\section{",
            "- a = b\n",
            "| a |\n",
            "a = $b$ ",
        ),
        *(
            "\\\\[",
            "$`a ",
            "{math}`",
            "[stem]\n++++\n",
            ".. math:: a\n   b\n",
            "```{note}\n",
            "x=x ",
        ),
        *(
            "\\begin{enumerate}\\item ",
            "\\begin{example}",
            "for the small ",
            "§ ¶ \f",
            "(a, ",
            "(a) x\n",
        ),
    ],
)
def test_the_time_grows_with_the_length_alone(unit):
    """A text that is four times as long takes four times as long, and not sixteen times."""

    def seconds(length):
        source = unit * (length // len(unit))
        start = time.process_time()
        passages(source, plain=True)
        declared(source)
        return time.process_time() - start

    assert seconds(40_000) < 8 * seconds(10_000) + 0.2
