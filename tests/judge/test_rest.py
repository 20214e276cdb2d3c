"""A motion that begins where nothing changes stays there, and no other does."""

from pathlib import Path

import pytest

from rigidtop.collection import built_in
from rigidtop.commands.notes import audited
from rigidtop.read.project import TextFile


def passed(text):
    """What becomes of the last formula."""
    return audited([TextFile(Path("notes.md"), text)], built_in()).findings[-1].record["passed"]


PENDULUM = "$$ L = \\frac12 m l^2\\dot\\theta^2 + m g l\\cos\\theta $$ "


@pytest.mark.parametrize(
    ("laws", "start", "line", "expected"),
    [
        (PENDULUM, r"$\theta = 0$ and $\dot\theta = 0$", r"\theta = 0", True),
        (PENDULUM, r"$\dot\theta = 0$", r"\dot\theta = 0", None),
        (r"$$ \dot x = y z, \quad \dot y = -x z $$ ", r"$x = 0$ and $y = 0$", "x = 0", True),
        (r"$$ \dot x = y z, \quad \dot y = -x z $$ ", r"$x = 0$", "x = 0", None),
        # where the time is named, what vanishes now moves later
        (r"$$ \ddot x = 2 g t $$ ", r"$x = 0$ and $\dot x = 0$", "x = 0", None),
    ],
)
def test_what_vanishes_at_the_start_stays_where_nothing_moves_it(laws, start, line, expected):
    text = f"{laws}\n\nAt $t = 0$ we have {start}.\n\nSo at all times\n$$ {line} $$\n"
    assert passed(text) is expected
