"""Notes audited: as they are, and with one thing changed in one equation."""

import random
import re
from itertools import islice
from pathlib import Path

import pytest
import sympy
from sympy import Symbol, cos, sin

from rigidtop.derivations import PAGES
from rigidtop.mark import audit as home
from rigidtop.mark import ruling
from rigidtop.mark.audit import Memo, audit
from rigidtop.mark.audited import UNKNOWN, UNREAD
from rigidtop.proof.equation import Equation, Rate, Underbrace, value
from rigidtop.proof.page import Assumption, Check, Correction, Definition, Page, claim
from rigidtop.proof.verdict import judge
from rigidtop.read.document import lines, numbered
from rigidtop.read.equations import equations as read
from rigidtop.read.equations import kind
from rigidtop.theory.symbols import (
    F_k,
    Omega,
    T,
    Tdot,
    const,
    omega_vec,
    phidot,
    r_k,
    theta,
)

SOURCE = Path(__file__).with_name("notes.md").read_text("utf-8")
NUMBERS = [group.number for group in numbered(SOURCE)]
WHOLE = Path(__file__).parents[3] / "shared" / "notes" / "lecture-notes.md"
CLAIMS = {each.name: each for page in PAGES for each in page.claims}


@pytest.fixture(scope="module")
def memo():
    return Memo()


@pytest.fixture(scope="module")
def unchanged(memo):
    return audit(SOURCE, PAGES, memo=memo)


def one(formula, number, memo=None, pages=PAGES):
    """The audit of a file with one equation."""
    (found,) = audit(f"$${formula}$$\n({number})\n", pages, memo=memo)
    return found


# --- as they are ---------------------------------------------------------------------------------


def test_every_numbered_equation_is_read_in_its_place(unchanged):
    assert [each.number for each in unchanged] == NUMBERS
    assert [f"3.{n}" for n in range(33, 58)] == NUMBERS
    rows = SOURCE.split("\n")
    for each in unchanged:
        assert all(placed.equation is not None for placed in each.placed)
        beginnings = [rows[placed.line - 1][placed.column - 1 :] for placed in each.placed]
        assert all(re.match(r"\S", text) for text in beginnings), beginnings
    places = [placed for each in unchanged for placed in each.placed]
    assert [p.line for p in places] == sorted(p.line for p in places)


@pytest.mark.parametrize("number", NUMBERS)
def test_unchanged_notes_agree_with_the_check_of_the_lecture(number, unchanged):
    (found,) = [each for each in unchanged if each.number == number]
    expected = judge(CLAIMS[number])
    assert expected.passed
    assert (found.verdict, found.passed) == (expected.verdict.value, True)


@pytest.mark.skipif(not WHOLE.exists(), reason="the whole notes do not lie beside the checkout")
def test_the_whole_file_gets_the_same_verdicts(memo, unchanged):
    found = audit(WHOLE.read_text("utf-8"), PAGES, memo=memo)
    assert [(e.number, e.verdict, e.note) for e in found if "line" not in e.note] == [
        (e.number, e.verdict, e.note) for e in unchanged if "line" not in e.note
    ]
    assert [e.verdict for e in found] == [e.verdict for e in unchanged]


# --- one thing changed ---------------------------------------------------------------------------

CHANGES = (
    ("sign", r"[+-]", lambda m: "-" if m[0] == "+" else "+"),
    ("index", r"(?<=_)[123]|(?<=_\{)[123]", lambda m: {"1": "2", "2": "3", "3": "1"}[m[0]]),
    (
        "index",
        r"(?<=_)\\(phi|psi|theta)\b|(?<=_\{)\\(phi|psi|theta)\b",
        lambda m: {r"\phi": r"\psi", r"\psi": r"\theta", r"\theta": r"\phi"}[m[0]],
    ),
    ("function", r"\\(sin|cos)\b", lambda m: r"\cos" if m[1] == "sin" else r"\sin"),
    ("factor", r"\\lambda|MgR|\\mathbf\{[LFR]\}|\\Omega", lambda m: f"2 {m[0]}"),
    ("dot", r"\\dot", lambda m: ""),
    ("dots", r"\\ddot", lambda m: r"\dot"),
    ("prime", r"'", lambda m: ""),
    ("exponent", r"(?<=\^)2", lambda m: "3"),
)
"""Slips of the pen: a pattern in the TeX of a formula, and what stands there instead."""


def changed(number, source=SOURCE):
    """The file with one change in the equation of a number; one file for each possible change."""
    for group in numbered(source):
        if group.number != number:
            continue
        for formula in group.formulas:
            for name, pattern, new in CHANGES:
                for match in re.finditer(pattern, formula.text):
                    at, end = formula.start + match.start(), formula.start + match.end()
                    yield f"{name} at {match.start()}", source[:at] + new(match) + source[end:]


def test_the_changed_files_are_many():
    files = [text for number in NUMBERS for _, text in changed(number)]
    assert len(set(files)) == len(files) >= 300
    assert SOURCE not in files


OPEN = {f"3.{n}" for n in (33, 35, 40, 41, 42, 44, 51, 52, 53, 54, 55, 57)}
"""Equations of which one change may come back undecided or unread."""


def some(number):
    """Every fourth change."""
    return islice(changed(number), 0, None, 4)


def test_nearly_all_changes_are_found_false():
    assert 5 * len(OPEN) < sum(1 for number in NUMBERS for _ in some(number))


@pytest.mark.parametrize("number", NUMBERS)
def test_a_change_is_told_at_its_equation_and_nowhere_else(number, memo, unchanged):
    left = 0
    for change, text in some(number):
        found = audit(text, PAGES, memo=memo)
        assert [each.number for each in found] == NUMBERS, change
        for new, old in zip(found, unchanged, strict=True):
            if new.number != number:
                assert (new.verdict, new.passed) == (old.verdict, old.passed), change
            elif says_the_same(old, new):
                assert (new.verdict, new.passed) == (old.verdict, True), change
            else:
                assert new.verdict in ("false", "undecided", UNREAD), (change, new.verdict)
                assert not new.passed, change
                assert new.note, change
                left += new.verdict != "false"
    assert left <= (number in OPEN)


# Whether a change changes anything, found without the claims: by numbers.


def says_the_same(old, new):
    """Whether two readings say the same in numbers, in a body for which the claim is made."""
    before = [placed.equation for placed in old.placed]
    after = [line.equation for line in lines(new.group)]
    if None in after or len(before) != len(after):
        return False
    alike = {
        assumption.condition.lhs: assumption.condition.rhs
        for finding in old.judgement.findings()
        for assumption in finding.check.assuming
        if isinstance(assumption.condition, sympy.Eq) and assumption.condition.rhs.is_Symbol
    }
    pairs = list(zip(before, after, strict=True))
    return all(a.relation == b.relation and equal(a, b, alike) for a, b in pairs)


def equal(one, other, alike):
    """Whether what two equations say to be zero is the same, at two random points."""
    return all(
        residuals(one, alike, seed) == pytest.approx(residuals(other, alike, seed), rel=1e-9)
        for seed in (1, 2)
    )


def residuals(equation, alike, seed):
    meaning = Anything(alike, seed)
    sides = [(a, b) for a, b in zip(equation.sides, equation.sides[1:], strict=False) if b != const]
    braces = sorted(
        set().union(*(side.atoms(Underbrace) for side in equation.sides)), key=sympy.srepr
    )
    found = []
    for left, right in [*sides, *(brace.args for brace in braces)]:
        for side in (left, right):
            got = value(side, meaning)
            found += [float(x) for x in got] if isinstance(got, sympy.MatrixBase) else [float(got)]
    return found


class Anything(dict):
    """A value for whatever is asked for: always the same one, of the shape that it should have."""

    def __init__(self, alike, seed):
        super().__init__()
        self.alike, self.seed = alike, seed

    def __contains__(self, node):
        return isinstance(node, (Symbol, Rate))

    def __missing__(self, node):
        if node in self.alike:
            return self[self.alike[node]]
        rng = random.Random(f"{self.seed} {node}")
        if node == Symbol("k"):
            return [{r_k: vector(rng), F_k: vector(rng)} for _ in range(2)]
        if node == Symbol("d3r"):
            factor = rng.uniform(0.5, 2)
            return lambda integrand: factor * integrand
        shape = kind(node)
        if shape == "matrix":
            return sympy.Matrix(3, 3, [rng.uniform(0.5, 2) for _ in range(9)])
        return vector(rng) if shape == "vector" else sympy.Float(rng.uniform(0.5, 2))

    def __or__(self, more):
        return {**self, **more}

    def keys(self):
        return ()


def vector(rng):
    return sympy.Matrix([rng.uniform(0.5, 2) for _ in range(3)])


def test_numbers_tell_what_says_the_same():
    def says(a, b, alike=()):
        return equal(read(a)[0].equation, read(b)[0].equation, dict(alike))

    lambda1, lambda2 = Symbol("lambda1", positive=True), Symbol("lambda2", positive=True)
    assert says(r"T = \frac{1}{2}\lambda_1\omega_1^2", r"T = \omega_1\lambda_1\omega_1/2")
    assert not says(r"T = \lambda_1\omega_1", r"T = \lambda_2\omega_1")
    assert says(r"T = \lambda_1\omega_1", r"T = \lambda_2\omega_1", {lambda2: lambda1})
    assert not says(r"0 = \mathbf{L} \times \mathbf{N}", r"0 = \mathbf{N} \times \mathbf{L}")
    assert not says(
        r"T = \underbrace{\omega_1}_{=\omega_2}", r"T = \underbrace{\omega_1}_{=\omega_3}"
    )


# --- what else can stand there -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("number", "formula", "verdict", "said"),
    [
        ("3.99", "T = T", UNKNOWN, "no claim of this number"),
        ("3.44", r"T = \qux", UNREAD, r"column 7: the command \qux is not known"),
        ("3.38", r"\boldsymbol{\omega} = [\omega_0, 0, \omega_3]", "false", "a vector and a row"),
        ("3.40", r"\Omega_b = \omega_3 \lambda_2", "false", "λ₂ = 1, ω₃ = 2: the left side is 0"),
        (
            "3.54",
            r"\lambda_2\ddot\theta = \lambda_1\dot\phi^2\sin\theta\cos\theta"
            r" - \lambda_3(\dot\psi + \dot\phi\cos\theta)\dot\phi\sin\theta + MgR\sin\theta",
            "undecided",
            "it holds where λ₂ = λ₁, which the claim does not say",
        ),
        ("3.33", r"\dot{\mathbf L} = \mathbf{e}_1", "undecided", "does not say what e₁ is"),
        ("3.41", r"\boldsymbol{\omega} = \mathbf{L}", "false", "at M = 1, R = 1"),
        ("3.40", r"\Omega_b = \text{const}", "undecided", "no meaning in this claim"),
        ("3.40", r"\Omega_b \approx \omega_3", "undecided", "no meaning in this claim"),
        ("3.55", r"p_\phi = \lambda_3", "false", "the claim has p_φ ="),
        # ψ̇ is in the claim and ψ is not: the angle may have any value.
        ("3.56", r"p_\psi = \lambda_3(\psi + \dot\phi\cos\theta)", "false", "the claim has p_ψ"),
    ],
)
def test_what_does_not_pass_says_why(number, formula, verdict, said, memo):
    found = one(formula, number, memo)
    assert (found.verdict, found.passed) == (verdict, False)
    assert said in found.note


@pytest.mark.parametrize(
    ("number", "formula"),
    [
        ("3.44", r"T = \mathbf{L}"),
        ("3.46", r"\mathbf{r}' = O^T"),
        ("3.41", r"\boldsymbol{\omega} = \mathbf{L}^2"),
    ],
)
def test_what_is_no_equation_at_all_is_refused_in_words(number, formula, memo):
    found = one(formula, number, memo)
    assert (found.verdict, found.passed) in (("false", False), (UNREAD, False))
    assert "vector" in found.note


@pytest.mark.parametrize(
    ("number", "formula", "verdict"),
    [
        # The same multiplied out: nothing is divided by, so nothing need be assumed.
        ("3.45", r"\lambda_1\dot\phi\sin^2\theta = L_z - L_3\cos\theta", "proved"),
        ("3.44", r"2T = \lambda_1\dot\phi^2 - \lambda_1\dot\phi^2\cos^2\theta"
         r" + \lambda_1\dot\theta^2 + \lambda_3(\dot\psi + \dot\phi\cos\theta)^2", "proved"),
        ("3.36", r"\dot\omega_2 = \frac{\lambda_3 - \lambda_1}{\lambda_2}\omega_3\omega_1",
         "proved"),
        ("3.57", r"MgR = \lambda_3\omega_3\Omega - \lambda_1\cos\theta\,\Omega^2", "assuming"),
        ("3.41", r"\boldsymbol{\omega} = \dot\phi\hat{\mathbf z} + \dot\theta\mathbf{e}_2'"
         r" + \dot\psi\mathbf{e}_3 + 0\lambda_2\mathbf{e}_3", "proved"),
    ],
)  # fmt: skip
def test_another_way_to_write_it_is_upheld(number, formula, verdict, memo):
    found = one(formula, number, memo)
    assert (found.verdict, found.passed) == (verdict, True), found.note


@pytest.mark.parametrize("number", [n for n in NUMBERS if n != "3.38"])
def test_nothing_is_not_the_equation_of_a_number(number, memo):
    found = one("0 = 0", number, memo)
    assert (found.verdict, found.passed) == ("undecided", False)


@pytest.mark.parametrize(
    ("number", "formula"),
    [
        # True whatever the symbols mean, true of other things, true of one component only, …
        ("3.41", r"\boldsymbol\omega = \boldsymbol\omega"),
        ("3.52", r"\hat{\mathbf z}\cdot\hat{\mathbf z} = 1"),
        ("3.45", r"\sin^2\theta + \cos^2\theta = 1"),
        ("3.40", r"\Omega_b = \Omega_b"),
        ("3.41", r"\hat{\mathbf z}\cdot\boldsymbol\omega = \dot\phi + \dot\psi\cos\theta"),
        ("3.51", r"\dot{\mathbf e}_3 = \mathbf\Omega\times\mathbf e_3"),
        ("3.56", r"p_\psi = \lambda_3(\dot\psi + \dot\phi\cos\theta)"),
        ("3.56", r"p_\psi = \text{const}"),
    ],
)
def test_what_says_less_is_not_the_equation_of_a_number(number, formula, memo):
    found = one(formula, number, memo)
    assert (found.verdict, found.passed) == ("undecided", False)
    assert "says less than the equation of that number; the claim has" in found.note


def test_lines_say_together_what_the_claim_says(memo):
    first = r"\lambda_1\dot\omega_1 = (\lambda_2 - \lambda_3)\omega_2\omega_3"
    second = r"\lambda_2\dot\omega_2 = (\lambda_3 - \lambda_1)\omega_3\omega_1"
    third = r"\lambda_3\dot\omega_3 = (\lambda_1 - \lambda_2)\omega_1\omega_2"
    in_any_order = rf"{third} \\ {first} \\ {second}"
    assert one(in_any_order, "3.36", memo).verdict == "proved"
    with_nothing = one(rf"{first} \\ 0 = 0 \\ {third}", "3.36", memo)
    assert [each.verdict for each in with_nothing.placed] == ["proved", "undecided", "proved"]
    more = one(rf"{in_any_order} \\ \omega_1 = \omega_1", "3.36", memo)
    assert (more.verdict, more.passed) == ("undecided", False)
    assert "the claim has no such line: ω₁ = ω₁" in more.note
    split = (
        r"\dot{\mathbf e}_3 = \frac{MgR}{\lambda_3\omega_3}\hat{\mathbf z}\times\mathbf e_3"
        r" \\ \dot{\mathbf e}_3 = \mathbf\Omega\times\mathbf e_3"
    )
    assert one(split, "3.51", memo).passed


def test_a_rate_is_told_that_is_visibly_not_0(memo):
    (placed,) = one(r"\lambda_3\dot\psi = \text{const}", "3.56", memo).placed
    found = placed.ruling.finding
    said = ruling.refutation(found, found.counterexample)
    assert abs(found.counterexample.left) > 1e-9
    assert "10⁻" not in said
    assert re.search(r"what is to be constant changes at the rate −?\d", said)


def test_the_corrected_matrix_is_right(memo):
    (group,) = [group for group in numbered(SOURCE) if group.number == "3.47"]
    text = group.formulas[0].text
    found = one(text.replace("O^{T}", "O"), "3.47", memo)
    assert (found.verdict, found.passed) == ("proved", True)


def test_a_slip_in_what_is_at_odds_with_a_definition_is_refuted_where_it_is(memo):
    (group,) = [group for group in numbered(SOURCE) if group.number == "3.47"]
    text = group.formulas[0].text
    found = one(text.replace(r"-c_{\psi}s_{\theta}", r"c_{\psi}s_{\theta}"), "3.47", memo)
    assert (found.verdict, found.passed) == ("false", False)
    # −cos ψ sin θ is the entry that was changed, whichever way O goes.
    counter = found.placed[0].ruling.finding.counterexample
    assert counter.left == -counter.right != 0


def test_lines_that_are_left_out_or_added_are_said(memo):
    found = one(r"\lambda_3\dot\omega_3 = (\lambda_1 - \lambda_2)\omega_1\omega_2", "3.36", memo)
    assert (found.verdict, found.passed) == ("proved", True)
    assert found.note == ("not among the file's lines: λ₁ω̇₁ = (λ₂ − λ₃)ω₂ω₃, λ₂ω̇₂ = (λ₃ − λ₁)ω₃ω₁")
    true, false = (rf"\Omega_b = {sign}(\lambda_1 - \lambda_3)\omega_3/\lambda_1" for sign in "+-")
    first = r"\Omega_b = \frac{(\lambda_1 - \lambda_3)\omega_3}{\lambda_1}, \tau_b = 2\pi/\Omega_b"
    assert one(rf"{first}, {true}", "3.40", memo).verdict == "assuming"
    more = one(rf"{first}, {false}", "3.40", memo)
    assert (more.verdict, more.passed) == ("undecided", False)
    assert "the claim has no such line" in more.note


def test_what_stands_under_a_brace_is_judged(memo):
    brace = r"p_\psi = \lambda_3 \underbrace{(\dot\psi + \dot\phi\cos\theta)}_{= %s} = const"
    assert one(brace % r"\dot\phi\cos\theta + \dot\psi", "3.56", memo).verdict == "proved"
    assert one(brace % r"\dot\phi\cos\theta - \dot\psi", "3.56", memo).verdict == "false"
    assert one(brace % r"\omega_3", "3.56", memo).verdict == "undecided"


# --- a lecturer's own collection -----------------------------------------------------------------


def own(*evidence):
    """A collection of one claim, (9.1)."""

    @claim("9.1", "A claim of one's own.")
    def made():
        """As it is."""
        yield from evidence

    return [Page("9", "Own", "A page of one's own.", (made,))]


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        (r"\Omega = \dot\phi\sin\theta", "definition"),
        (r"\dot\phi\sin\theta \equiv \Omega", "definition"),
        (r"\Omega = \dot\phi\cos\theta", "false"),
        (r"\Omega = -\dot\phi\sin\theta", "false"),
        (r"\Omega_b = \dot\phi\sin\theta", "undecided"),
    ],
)
def test_a_definition_must_say_the_same(formula, verdict):
    pages = own(Definition(Equation(Omega, phidot * sin(theta))))
    found = one(formula, "9.1", pages=pages)
    assert (found.verdict, found.passed) == (verdict, verdict == "definition")


def test_a_definition_of_a_vector():
    pages = own(Definition(Equation(omega_vec, Omega * Symbol("zhat", real=True))))
    assert one(r"\boldsymbol\omega = \Omega\hat{\mathbf z}", "9.1", pages=pages).passed
    assert one(r"\boldsymbol\omega = -\Omega\hat{\mathbf z}", "9.1", pages=pages).verdict == "false"


def test_what_the_collection_knows_to_be_false_is_no_failure():
    wrong = Check(Equation(T, cos(theta)), {T: sin(theta)})
    pages = own(wrong, Correction(Equation(T, sin(theta)), {T: sin(theta)}))
    found = one(r"T = \cos\theta", "9.1", pages=pages)
    assert (found.verdict, found.passed) == ("false", True)
    assert one(r"T = \sin\theta", "9.1", pages=pages).verdict == "proved"


def test_a_claim_that_breaks_lets_nothing_pass():
    def broken():
        yield Check(Equation(T, T))
        raise RuntimeError("no")

    pages = own(*[])
    (made,) = pages[0].claims
    pages = [Page("9", "Own", "", (type(made)("9.1", "", broken),))]
    found = one("T = T", "9.1", pages=pages)
    assert (found.verdict, found.passed) == ("undecided", False)
    assert "RuntimeError: no" in found.note


def test_an_assumption_that_is_not_needed_is_left_out():
    need = Assumption(sympy.Ne(sin(theta), 0), "tilted")
    pages = own(Check(Equation(T, Tdot / sin(theta)), {T: Tdot / sin(theta)}, (need,)))
    assert one(r"T = \frac{\dot T}{\sin\theta}", "9.1", pages=pages).verdict == "assuming"
    assert one(r"T\sin\theta = \dot T", "9.1", pages=pages).verdict == "proved"


# --- the memo ------------------------------------------------------------------------------------


def test_what_is_known_is_not_judged_again(memo, unchanged, monkeypatch):
    def no(*_):
        raise AssertionError("judged again")

    monkeypatch.setattr(home, "judge_check", no)
    monkeypatch.setattr(ruling, "judge_check", no)
    monkeypatch.setattr(home, "lines", no)
    moved = audit(f"One line more.\n\n{SOURCE}", PAGES, memo=memo)
    assert [each.line - 2 for each in moved] == [each.line for each in unchanged]
    assert [each.verdict for each in moved] == [each.verdict for each in unchanged]


def test_nothing_is_kept_without_a_memo(monkeypatch):
    formula = r"\mathbf{r}' = O^T\mathbf{r}"
    assert one(formula, "3.46").verdict == "convention"
    monkeypatch.setattr(home, "judge_check", lambda *_: 1 / 0)
    assert one(formula, "3.46").verdict == "undecided"
