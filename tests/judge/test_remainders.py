"""Terms that are left out, with their order: what is of it follows, and what is larger does not."""

import pytest

from rigidtop.judge.outcome import ASSUMING, FALSE, UNDECIDED
from rigidtop.judge.text import judged


def rows(source):
    return [row.outcome for row in judged(source)]


@pytest.mark.parametrize(
    "formula",
    [
        r"\sin x = x + O(x^3)",
        r"\sin x = x - \frac{x^3}{6} + \mathcal{O}(x^5)",
        r"\cos x = 1 + O(x^2)",
        r"\sqrt{1 + x} = 1 + \frac{x}{2} + O(x^2)",
        r"\frac{1}{1 - a x} = 1 + a x + O(x^2)",
        r"e^{x} - 1 = O(x)",
        r"(1 + \epsilon)^n = 1 + n \epsilon + O(\epsilon^2)",
    ],
)
def test_what_is_of_the_order_that_is_written_follows(formula):
    assert rows(f"So we have\n\n$$\n{formula}\n$$\n")[0].verdict == ASSUMING


@pytest.mark.parametrize(
    ("formula", "slip"),
    [
        (r"\cos x = 1 + \frac{x^2}{2} + O(x^4)", "another sign before x²/2"),
        (r"\sqrt{1 + x} = 1 - \frac{x}{2} + O(x^2)", "another sign before x/2"),
        (r"\sin x = x - \frac{x^3}{3} + O(x^5)", "½ times x³/3"),
    ],
)
def test_a_slip_beside_an_order_is_named(formula, slip):
    [outcome] = rows(f"So we have\n\n$$\n{formula}\n$$\n")
    assert outcome.verdict == FALSE
    assert outcome.slip == slip


def test_an_order_that_is_too_high_is_not_passed():
    [outcome] = rows("So we have\n\n$$\n\\sin x = x + O(x^4)\n$$\n")
    assert outcome.verdict == UNDECIDED
    assert "O(x⁴)" in outcome.why
