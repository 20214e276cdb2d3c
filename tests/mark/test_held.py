"""What notes say in passing, in the letters of the lecture, held against its models."""

from math import inf

import pytest

from rigidtop.judge.text import judged
from rigidtop.mark.held import held
from rigidtop.mark.task import top

SAID = {
    "vertical": (
        r"We use $\hat{\mathbf z} = \cos\theta\,\mathbf e_3 - \sin\theta\,\mathbf e_1'$.",
        ("- \\sin", "+ \\sin", "another sign before sin θ e₁′"),
    ),
    "fast": (
        r"For very large $\omega_3$ we find "
        r"$\Omega_+ = \frac{\lambda_3\omega_3}{\lambda_1\cos\theta}$.",
        (r"{\lambda_1", r"{2\lambda_1", "no factor 2"),
    ),
    "slow": (
        r"For very large $\omega_3$ we find $\Omega_- = \frac{MgR}{\lambda_3\omega_3}$.",
        (r"{\lambda_3", r"{\lambda_1", "λ₃ in place of λ₁"),
    ),
    "space": (
        r"In this frame the frequency is $\Omega_s = L/\lambda_1$.",
        (r"\lambda_1", r"\lambda_3", "λ₁ in place of λ₃"),
    ),
    "period": (r"One period takes $\tau_b = 2\pi/\Omega_b$.", (r"2\pi", r"\pi", "2 times as much")),
    "both": (
        r"We reach $\ddot{\omega}_{1,2} = -\Omega_b^2 \omega_{1,2}$.",
        ("= -", "= ", "another sign"),
    ),
}


def outcome(text):
    [*_, row] = held(judged(text), top(), inf)
    return row.outcome


@pytest.mark.parametrize("name", SAID)
def test_what_is_right_follows_and_a_slip_is_named(name):
    text, (old, new, slip) = SAID[name]
    assert outcome(text).passed
    wrong = outcome(text.replace(old, new))
    assert (wrong.verdict, wrong.slip) == ("false", slip)


def test_what_no_model_knows_stays_as_the_text_leaves_it():
    text = "We have $q = 3 b u$."
    assert outcome(text) == judged(text)[-1].outcome


def test_a_special_case_is_not_condemned():
    assert outcome(r"If $\Omega_s = L/\lambda_3$, the body is a sphere.").verdict != "false"
