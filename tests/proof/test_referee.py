"""What a hostile referee tries: lines that seem to follow, and lines that do, with conditions.

Each kind has lines that must fall, with the words that say why, and lines beside them that follow.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from rigidtop.collection import letters_of
from rigidtop.notation import Notation
from rigidtop.proof.lecture import Lecture
from rigidtop.read.page import read_lecture
from rigidtop.report.lines import conditions
from rigidtop.report.ways import reason
from rigidtop.theory import symbols
from rigidtop.theory.lettered import in_order, positive, real
from rigidtop.theory.symbols import Glyph

POSITIVE, REAL = "a b c d h k l m n g κ", "f p q r s u v w x y z θ φ ε δ η S W"
RATES = "x y z r s φ θ u"


def _alphabet() -> Notation:
    rates = [
        real(f"{x}{accent}", Glyph(x, accent=accent), f"a rate of {x}", "1")
        for x in RATES.split()
        for accent in ("ddot", "dot")
    ]
    vectors = [
        real(f"{x}vec", Glyph(x, bold=True), "a vector", "") for x in ["p", "v", "F", "e", "n"]
    ]
    plain = [positive(x, Glyph(x), "a positive number", "1") for x in POSITIVE.split()]
    plain += [real(x, Glyph(x), "any number", "1") for x in REAL.split()]
    letters = in_order(
        *plain[: len(POSITIVE.split())],
        positive("omega", Glyph("ω"), "a frequency", "rad/s"),
        real("T", Glyph("T"), "an energy", "1"),
        real("Tdot", Glyph("T", accent="dot"), "its rate", "1"),
        real("L", Glyph("ℒ"), "a Lagrangian", "1"),
        *rates,
        *plain[len(POSITIVE.split()) :],
        *vectors,
    )
    glyphs = {x: x.quantity.glyph for x in letters} | {
        symbols.const: Glyph("const"),
        symbols.t: Glyph("t"),
    }
    return Notation("referee", glyphs, {})


ALPHABET = _alphabet()
LETTERS = replace(letters_of(ALPHABET), units={})  # what is tried here has pure numbers alone


def read(laws: str, page: str) -> Lecture:
    """A page with laws, each a line "name: equation"; "~" before it: along the motion."""
    stated = "".join(
        f"Given. {'Along the motion, the' if law.startswith('~') else 'The'} {name.strip('~ ')}:"
        f"\n\n$${equation.strip()}$$\n\n"
        for law in laws.strip().splitlines()
        for name, _, equation in [law.strip().partition(":")]
    )
    moves = "".join(
        f"{sentence.strip()}:\n\n$${equation.strip()}$$\n\n"
        for line in page.strip().splitlines()
        for sentence, _, equation in [line.strip().partition(" => ")]
    )
    source = f"# Page\n\n## Laws\n\n{stated}## Lines\n\n{moves}"
    lecture = read_lecture([("page", source)], LETTERS, ALPHABET)
    assert not list(lecture.unread()), list(lecture.unread())
    assert not list(lecture.faults())
    return lecture


def last(laws: str, page: str) -> tuple[str, list[str]]:
    """Why the last line does not follow, or nothing; and its conditions."""
    lecture = read(laws, page)
    *before, judged = map(lecture.judged, lecture.lines)
    assert all(each.follows for each in before), [str(each.problem) for each in before]
    why = "" if judged.follows else reason(judged, LETTERS, ALPHABET)
    return why, conditions(judged.known, ALPHABET)


FOLLOWS = {
    "a vector is set": (
        r"push: \mathbf F = m\mathbf v",
        r"Set $\mathbf v = 0$ at all times in the push => \mathbf F = 0",
        "v = 0",
    ),
    "what was set for a vector is inherited": (
        r"""push: \mathbf F = m\mathbf v
        power: f = \mathbf F\cdot\mathbf v""",
        r"""Set $\mathbf v = 0$ at all times in the push => \mathbf F = 0
        Put it into the power => f = 0""",
        "v = 0",
    ),
    "one unit vector along another, with its length": (
        r"""spin: s = \mathbf e\cdot\mathbf p
        length: \mathbf e\cdot\mathbf e = 1
        sum: f = s + a\,\mathbf e\cdot\mathbf n""",
        r"Set $\mathbf e = \mathbf n$ in the sum, with the spin and the length => "
        r"f = \mathbf n\cdot\mathbf p + a",
        "e − n = 0",
    ),
    "one unit vector along another that alone stands there": (
        r"torque: f = \mathbf n\cdot\mathbf p",
        r"Set $\mathbf e = \mathbf n$ in the torque => f = \mathbf e\cdot\mathbf p",
        "n − e = 0",
    ),
    "differentiated by a letter that nothing ties": (
        r"""spring: \mathcal L = \tfrac12m\dot x^2 - \tfrac12kx^2
        equal springs: k = c""",
        r"Differentiate the spring by $k$ => \frac{\partial\mathcal L}{\partial k} = -\tfrac12x^2",
        "",
    ),
    "differentiated by two letters": (
        r"spring: \mathcal L = \tfrac12m\dot x^2 + \tfrac12m\dot y^2",
        r"Differentiate the spring by $\dot x$ and $\dot y$ => "
        r"\frac{\partial\mathcal L}{\partial\dot x} = m\dot x, \quad"
        r"\frac{\partial\mathcal L}{\partial\dot y} = m\dot y",
        "",
    ),
    "a fraction is brought in": (
        "difference: y = x - 2",
        r"Rewrite the difference => y = \frac{x^2 - 4}{x + 2}",
        "2 + x ≠ 0",
    ),
    "an expansion divides": (
        r"fraction: y = \frac a{v + x}",
        r"Expand the fraction to first order in $x$ => y \approx \frac av - \frac{ax}{v^2}",
        "v ≠ 0",
    ),
    "the order of an expansion is told": (
        r"sine: y = \sin x",
        r"Expand the sine to first order in $x$ => y \approx x",
        "x small, with an error of order O(x²)",
    ),
    "a logarithm of what is kept": (
        r"logarithm: y = \ln(v + x)",
        r"Expand the logarithm to first order in $x$ => y \approx \ln v + \frac xv",
        "v > 0",
    ),
    "a small ratio with a prefactor of its own letters": (
        r"root: y = \frac{kh}2(1 - \sqrt{1 - 4\kappa})",
        r"""Call the small one => \varepsilon = \frac{mg}{kh}
        Expand the root to first order in $\kappa$ => y \approx kh\kappa""",
        "κ small",
    ),
    "terms whose size is not known are neglected": (
        r"sum: y = mx + s",
        r"Neglect $s$ in the sum, for large $m$ => y \approx mx",
        "s/(mx) ≪ 1",
    ),
    "a solution of the second order": (
        r"~ drop: \ddot x = g",
        r"Integrate the drop from $x = h$ and $\dot x = a$ => x = h + at + \tfrac12gt^2",
        "ẋ − a = 0 at the start",
    ),
    "a swing": (
        r"~ swing: \ddot y = -\omega^2y",
        r"Integrate the swing from $y = 0$ and $\dot y = a$ => y = \frac a\omega\sin\omega t",
        "y = 0 at the start",
    ),
    "two equations cited apart": (
        r"""~ first: \dot x = \omega y
        ~ second: \dot y = -\omega x""",
        r"Integrate the first and the second from $x = 0$ and $y = a$ => "
        r"x = a\sin\omega t, \quad y = a\cos\omega t",
        "y − a = 0 at the start",
    ),
    "a solution as far as its pole": (
        r"~ growth: \dot x = kx^2",
        r"Integrate the growth from $x = b$ => x = \frac b{1 - kbt}",
        "1 − bkt > 0",
    ),
    "an integral solved for one letter": (
        r"~ power: \dot T = -kr\dot r",
        r"Integrate the power from $T = 0$ and $r = a$ => T = \tfrac12k(a^2 - r^2)",
        "T = 0 at the start",
    ),
    "a time by a primitive that nobody has listed": (
        r"~ fall: \dot x = -k(a^2 + x^2)",
        r"Integrate the fall from $x = a$ to $x = 0$ => t = \frac\pi{4ka}",
        "x − a = 0 at the start",
    ),
    "a time that stays an integral": (
        r"~ speed: \dot x = \sqrt{2a(\cos x - \cos b)}",
        r"Integrate the speed from $x = 0$ to $x = b$ => "
        r"t = \int_0^bdx\,\frac1{\sqrt{2a}\sqrt{\cos x - \cos b}}",
        "x = 0 at the start",
    ),
    "a root with its condition": (
        r"square: (u - a)^2 = b^2",
        r"Solve the square for $u$, for $u > a$ => u = a + b",
        "u − a > 0",
    ),
    "a momentum that is constant, solved for a rate": (
        r"~ momentum: s = mr^2\dot\phi = \text{const}",
        r"Solve the momentum for $\dot\phi$ => \dot\phi = \frac s{mr^2}",
        "r ≠ 0",
    ),
    "a root of a square": (
        r"square: w^2 = (u - v)^2",
        r"Take the root of the square, for $w > 0$ and $u > v$ => w = u - v",
        "u − v > 0",
    ),
    "a root under a condition": (
        r"root: y = \sqrt{a^2 - a^2\cos^2\theta}",
        r"Rewrite the root, for $\sin\theta > 0$ => y = a\sin\theta",
        "sin θ > 0",
    ),
    "nested roots": (
        r"root: y = \sqrt{a + b + 2\sqrt{ab}}",
        r"Rewrite the root => y = \sqrt a + \sqrt b",
        "",
    ),
    "logarithms that exist": (
        r"logarithms: y = \ln u - \ln v",
        r"Rewrite the logarithms => y = \ln\frac uv",
        "u > 0",
    ),
    "large numbers cancel": (
        r"difference: y = u((10^8 + x)^2 - 10^{16} - 2\cdot10^8x)",
        "Rewrite the difference => y = ux^2",
        "",
    ),
    "a factor that is no small ratio": (
        r"product: 997x = 1994y",
        "Rewrite the product => x = 2y",
        "",
    ),
    "a factor that is a root": (
        r"product: \sqrt3x = \sqrt{12}y",
        "Rewrite the product => x = 2y",
        "",
    ),
    "a root whose sign a condition says": (
        r"energy: f = \tfrac12m\dot x^2 + \tfrac12kx^2",
        r"Solve the energy for $\dot x$, for $\dot x > 0$ => \dot x = \sqrt{\frac{2f - kx^2}m}",
        "ẋ > 0",
    ),
    "an integral with the time in it": (
        r"~ growth: \frac{\dot y}y = \omega",
        r"Integrate the growth from $y = a$ => \ln y = \omega t + \ln a",
        "y − a = 0 at the start",
    ),
    "an inequality turned round": (
        "bound: u > v",
        "Multiply the bound by $-2$ => -2u < -2v",
        "",
    ),
    "a tangent, as far as a quarter turn": (
        r"~ push: \dot u = \omega(1 + u^2)",
        r"Integrate the push from $u = 0$ => u = \tan\omega t",
        "½π − ωt > 0",
    ),
    "a root squared": (
        r"root: \sqrt u = v",
        "Square the root => u = v^2",
        "v ≥ 0",
    ),
    "a start that is set": (
        r"""momentum: s = mr^2\dot\phi
        ~ rest: \dot s = 0""",
        r"Set $r = a$ and $\dot\phi = \omega$ at the start in the momentum, with the rest => "
        r"s = ma^2\omega",
        "φ̇ − ω = 0 at the start",
    ),
}


@pytest.mark.parametrize("kind", FOLLOWS)
def test_a_right_line_follows_under_its_condition(kind: str) -> None:
    laws, page, condition = FOLLOWS[kind]
    why, told = last(laws, page)
    assert why == ""
    assert any(condition in each for each in told) or not condition, told


FALLS = {
    "what is set stands on neither side": (
        r"torque: f = \mathbf F\cdot\mathbf p",
        r"Set $\mathbf e = \mathbf n$ in the torque => f = \mathbf F\cdot\mathbf p",
        "does not stand in",
    ),
    "what was set for vectors contradicts itself": (
        r"torque: f = \mathbf e\cdot\mathbf p",
        r"""Set $\mathbf e = \mathbf n$ in the torque => f = \mathbf n\cdot\mathbf p
        Set $\mathbf e = -\mathbf n$ in the torque => f = -\mathbf n\cdot\mathbf p
        Add it to $f$ => 2f = 0""",
        "",
    ),
    "differentiated by what was set": (
        r"spring: \mathcal L = \tfrac12m\dot x^2 - \tfrac12kx^2",
        r"""Set $k = 0$ in the spring => \mathcal L = \tfrac12m\dot x^2
        Differentiate it by $k$ => \frac{\partial\mathcal L}{\partial k} = 0""",
        "k is set, or tied",
    ),
    "differentiated by what a law ties": (
        r"""spring: \mathcal L = \tfrac12m\dot x^2 - \tfrac12kx^2
        frequency: k = m\omega^2""",
        r"""Put the frequency into the spring => \mathcal L = \tfrac12m(\dot x^2 - \omega^2x^2)
        Differentiate it by $m$ => \frac{\partial\mathcal L}{\partial m} = \tfrac12\dot x^2
        - \tfrac12\omega^2x^2""".replace("\n        - ", " - "),
        "m is set, or tied",
    ),
    "differentiated where a definition hides it": (
        r"spring: \mathcal L = \tfrac12m\dot x^2 - \tfrac12mlgx^2",
        r"""Call the ratio => \kappa = lg
        Put it into the spring => \mathcal L = \tfrac12m\dot x^2 - \tfrac12m\kappa x^2
        Differentiate it by $l$ => \frac{\partial\mathcal L}{\partial l} = 0""",
        "tied to other letters",
    ),
    "expanded in what stands for a kept term": (
        r"sum: y = 3ab + ck\frac{ab}{ck}",
        r"""Call the share => \varepsilon = \frac{ab}{ck}
        Put it into the sum => y = 3ab + ck\varepsilon
        Expand it to zeroth order in $\varepsilon$ => y \approx 3ab""",
        "what is left out is not small beside",
    ),
    "expanded in what a law gives": (
        r"""square: \delta = \eta^2
        sum: y = \eta^2 + \delta""",
        r"Expand the sum to zeroth order in $\delta$ => y \approx \eta^2",
        "what is left out is not small beside",
    ),
    "expanded in what another letter hides": (
        r"""square: \delta = \eta^2
        sum: y = \eta^2 + \delta""",
        r"Expand the sum to first order in $\eta$ => y \approx \delta",
        "is defined by",
    ),
    "neglected, and it grows as well": (
        r"""line: y = mx + S
        share: S = ax""",
        r"Neglect $S$ in the line, for large $x$ => y \approx mx",
        "is defined by",
    ),
    "what is small is set to a number": (
        r"sine: y = \sin x",
        r"""Expand the sine to first order in $x$ => y \approx x
        Set $x = 10$ in it => y \approx 10""",
        "is small in",
    ),
    "starts that contradict each other": (
        r"""energy: T = \tfrac12m(\dot r^2 + r^2\dot\phi^2)
        ~ power: \dot T = -kr\dot r""",
        r"""Integrate the power from $T = 0$ and $r = a$ => T + \tfrac12kr^2 = \tfrac12ka^2
        Integrate the power from $T = 0$ and $r = b$ => T + \tfrac12kr^2 = \tfrac12kb^2
        Subtract it from $T$ => 0 = \tfrac12k(a^2 - b^2)""",
        "",
    ),
    "a division by what is set to zero": (
        r"~ fall: \dot s = -g",
        r"""Set $g = 0$ in the fall => \dot s = 0
        Multiply it by $g$ => g\dot s = 0
        Divide it by $g$ => \dot s = 0""",
        "a division by 0",
    ),
    "a division by what two laws say is zero": (
        r"""ratio: sx = ux
        name: x = r
        zero: r = 0""",
        r"""Divide the ratio by $x$ => s = u
        Add the name to it => s + x = u + r
        Put the zero into it => s + x = u""",
        "",
    ),
    "a pole is set": (
        r"pole: xw = vx\frac1x",
        "Set $x = 0$ in the pole => v = 0",
        "a division by 0",
    ),
    "a solution through its start only": (
        r"~ swing: \ddot y = -\omega^2y",
        r"Integrate the swing from $y = a$ => y = a\cos\omega t",
        "where ẏ starts is not said",
    ),
    "a solution of another frequency": (
        r"~ swing: \ddot y = -\omega^2y",
        r"Integrate the swing from $y = a$ and $\dot y = 0$ => y = a\cos2\omega t",
        "does not satisfy",
    ),
    "a time through a pole": (
        r"~ growth: \dot x = kx^2",
        r"Integrate the growth from $x = -a$ to $x = a$ => t = -\frac2{ka}",
        "does not arrive",
    ),
    "a time beyond the turn": (
        r"~ swing: \dot x = \omega\sqrt{a^2 - x^2}",
        r"Integrate the swing from $x = 0$ to $x = 2a$ => t = \frac\pi{2\omega}",
        "does not arrive",
    ),
    "a root without its condition": (
        r"square: (u - a)^2 = b^2",
        r"Solve the square for $u$ => u = a + b",
        "another root",
    ),
    "the other root": (
        r"square: (u - a)^2 = b^2",
        r"Solve the square for $u$, for $u > a$ => u = a - b",
        "does not arrive",
    ),
    "a sign that a law denies": (
        r"""square: w^2 = b^2
        negative one: w = -u^2""",
        r"""Take the root of the square, for $w > 0$ => w = b
        Put it into the negative one => b = -u^2""",
        "this can't hold",
    ),
    "a condition against what is set": (
        r"square: w^2 = (u - v)^2",
        r"""Take the root of the square, for $w > 0$ and $u > v$ => w = u - v
        Set $v = u + a$ in it => w = -a""",
        "this can't hold",
    ),
    "a logarithm of what is negative": (
        r"""copy: u = v
        negative one: v = -w^2""",
        r"""Take the logarithm of the copy => \ln u = \ln v
        Put the negative one into it => \ln u = \ln(-w^2)""",
        "",
    ),
    "nested roots of the wrong sign": (
        r"root: y = \sqrt{a + b - 2\sqrt{ab}}",
        r"Rewrite the root => y = \sqrt a - \sqrt b",
        "does not arrive",
    ),
    "a tiny number is something": (
        "copy: y = x",
        r"Rewrite the copy => y = x + 10^{-50}",
        "does not arrive here: it gives y = x",
    ),
    "a tiny factor is something": (
        "copy: y = x",
        r"Rewrite the copy => y = (1 + 10^{-13})x",
        "does not arrive",
    ),
    "a power of which the exponent is not known": (
        "power: y = x^n",
        r"Expand the power to fourth order in $x$ => y \approx 0",
        "no order in x is known",
    ),
    "a growth beside a power": (
        r"sum: y = \cosh x + x",
        r"Neglect $\cosh x$ in the sum, for large $x$ => y \approx x",
        "is no power of x",
    ),
    "what a law makes as small": (
        r"""sum: y = a + Sx
        share: S = \frac bx""",
        r"Neglect $a$ in the sum, for large $x$ => y \approx Sx",
        "is not small beside",
    ),
    "what a solution makes as small": (
        r"""sum: y = a + Sx
        share: Sx^2 = bx""",
        r"""Solve the share for $S$ => S = \frac bx
        Neglect $a$ in the sum, for large $x$ => y \approx Sx""",
        "is not small beside",
    ),
    "what is large is set": (
        "line: y = a - bx",
        r"""Neglect $a$ in the line, for large $x$ => y \approx -bx
        Set $x = \frac ab$ in it => y \approx -a""",
        "x is large in",
    ),
    "nothing, divided by what is as small": (
        r"gap: f = 1 - \cos x",
        r"""Expand the gap to first order in $x$ => f \approx 0
        Divide it by $x^2$ => \frac f{x^2} \approx 0""",
        "the error is as large as what stands there",
    ),
    "a small letter that stands for one over a kept one": (
        r"""share: \varepsilon = \frac1S
        one: y = 1 + \varepsilon S""",
        r"Expand the one to zeroth order in $\varepsilon$ => y \approx 1",
        "what is left out is not small beside",
    ),
    "small letters that a product ties": (
        r"""product: \delta\eta = a
        sum: y = b + \delta\eta""",
        r"Expand the sum to zeroth order in $\delta$ => y \approx b",
        "what is left out is not small beside",
    ),
    "a time through a pole of the rate": (
        r"~ rate: \dot x = \frac{ka}x",
        r"Integrate the rate from $x = -a$ to $x = 2a$ => t = \frac{3a}{2k}",
        "rests, turns back or goes the other way",
    ),
    "a tangent beyond a quarter turn": (
        r"~ push: \dot u = \omega(1 + u^2)",
        r"""Integrate the push from $u = 0$ => u = \tan\omega t
        Set $t = \frac\pi\omega$ in it => u = 0""",
        "this can't hold",
    ),
    "a rate where a letter is held": (
        r"~ growth: \dot y = ky",
        r"Set $y = h$ at all times in the growth => \dot y = kh",
        "stands there still",
    ),
    "set to what a law denies": (
        """zero: x = 0
        line: u = x + b""",
        "Set $x = a$ in the line, with the zero => u = a + b",
        "x is set to a, and what is cited says 0",
    ),
    "two laws that can't both hold": (
        """bad: x = y
        worse: y = x + 1""",
        "Subtract the bad from the worse => y - x = x + 1 - y",
        "this can't hold",
    ),
    "a negative square of a vector": (
        r"""square: \mathbf p\cdot\mathbf p = -a
        push: \mathbf F = k\mathbf p""",
        r"Square the push, with the square => \mathbf F\cdot\mathbf F = -k^2a",
        "this can't hold",
    ),
    "a root of what is negative": (
        r"root: y = \sqrt x",
        r"Set $x = -1$ in the root => y = 1",
        "of what is negative",
    ),
    "constancy called for": (
        "line: y = ax",
        r"Call the constant => S = \text{const}",
        "not known to be constant",
    ),
    "a component differs": (
        r"push: \mathbf F = m\mathbf v + k\mathbf p",
        r"Multiply the push by $2$ => 2\mathbf F = 2m\mathbf v + k\mathbf p",
        "along p it gives 2k, the line has k",
    ),
}


@pytest.mark.parametrize("kind", FALLS)
def test_a_wrong_line_falls(kind: str) -> None:
    laws, page, said = FALLS[kind]
    why, _ = last(laws, page)
    assert why
    assert said in why


def test_what_breaks_in_one_line_is_said_there_and_judged_beside_it(monkeypatch) -> None:
    from rigidtop.proof import lecture as module

    def broken(line, letters, above):
        if line.move is not None and line.move.verb == "square":
            raise ZeroDivisionError("by zero")
        return judge(line, letters, above)

    judge = module.judge_line
    monkeypatch.setattr(module, "judge_line", broken)
    laws, page = "copy: y = x", "Square the copy => y^2 = x^2\nMultiply the copy by $2$ => 2y = 2x"
    _, square, double = map(read(laws, page).judged, read(laws, page).lines)
    assert str(square.problem) == (
        "rigidtop breaks here, please report it: ZeroDivisionError: by zero"
    )
    assert double.follows


def test_what_has_no_layout_is_told_all_the_same(monkeypatch) -> None:
    def text(_: object) -> str:
        raise TypeError("no layout")

    monkeypatch.setattr("rigidtop.report.ways.text", text)
    why, _ = last("copy: y = x", "Multiply the copy by $2$ => 2y = 3x")
    assert why.startswith("the move does not arrive here: it gives Equation(")
