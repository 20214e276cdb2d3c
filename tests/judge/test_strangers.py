"""What passed, was condemned or made the judge fail in texts that nobody here wrote, shortened."""

from pathlib import Path

import pytest

from rigidtop.collection import built_in
from rigidtop.commands.notes import audited
from rigidtop.read.project import TextFile

PENDULUM = "The pendulum obeys $m l^2\\ddot\\theta + m g l\\sin\\theta = 0$. "
OSCILLATOR = "It obeys $\\ddot x = -\\omega^2 x$. Its solution is "


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        # A new letter that would have to vanish is not brought.
        (
            PENDULUM + r"$$E = \frac12 m l^2\dot\theta^2 - m g l\cos\theta$$ "
            r"$$\dot E = m l^2\dot\theta\ddot\theta + \dot\theta m g l\sin\theta = 7 u\dot\theta$$",
            False,
        ),
        # A bound at the end of a chain is no part of what the chain shows, unless it always holds.
        (r"Let $a = L/I$ and $b = J/I$. $$\frac ab = \frac LJ < 1$$", None),
        (r"Let $a = L/I$ and $b = J/I$. $$\frac ab = \frac LJ > 0$$", True),
        # What is aimed at is not so.
        (r"$$\ddot q = u$$ Our goal is to bring $\dot q = 0$. Then $$u = 0$$", None),
        # One solution, and twice as much with the same letters.
        (
            OSCILLATOR + r"$$x(t) = A\cos\omega t$$ and also $$x(t) = 2 A\cos\omega t$$",
            None,
        ),
        # Where the sides vanish by what stands above, ≈ asks how the one becomes the other.
        (
            r"$$0 = \ddot s + w^2(\sin s\cos f + \cos s\sin f)$$ For small $f$ "
            r"$$w^2(\sin s\cos f + \cos s\sin f) \approx w^2(\sin s + f\cos s)$$",
            True,
        ),
        # What its letter depends on is no link of a chain.
        (
            r"It is on $y = \frac{x^2}{2p}$. $$\mathbf r = x\mathbf i + y\mathbf j$$ "
            r"$$\mathbf r = \mathbf r(q_1, q_2) = x\mathbf i + y\mathbf j$$",
            True,
        ),
        # sec² behind a number is no second.
        (r"$$a = 2\sec^2\dfrac b2$$ So $$a\cos^2\frac b2 = 2$$", True),
    ],
)
def test_what_becomes_of_the_last_formula(text, expected):
    rows = audited([TextFile(Path("notes.md"), text)], built_in()).findings
    assert rows[-1].record["passed"] is expected, rows[-1].record["note"]


def test_a_sum_over_small_steps_is_no_failure_of_ours():
    text = r"$$W = \sum_{i=0}^{n} F_i\Delta x_i$$ For $n\to\infty$ and $\Delta x_i\to 0$."
    rows = audited([TextFile(Path("notes.md"), text)], built_in()).findings
    assert not any("fails" in row.record["note"] for row in rows)
