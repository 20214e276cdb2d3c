"""Integrals and sums without an end: their values, and where they have none."""

from pathlib import Path

import pytest

from rigidtop.collection import built_in
from rigidtop.commands.notes import audited
from rigidtop.read.project import TextFile


def last(text):
    """What becomes of the last formula."""
    return audited([TextFile(Path("notes.md"), text)], built_in()).findings[-1].record


RIGHT = [
    r"\int_0^\infty e^{-a x}\,dx = \frac1a",
    r"\int_{-\infty}^\infty e^{-a x^2}\,dx = \sqrt{\frac{\pi}{a}}",
    r"\int_{-\infty}^0 e^{a x}\,dx = \frac1a",
    r"\int_0^\infty x^3 e^{-a x}\,dx = \frac{6}{a^4}",
    r"\int_0^\infty \frac{dx}{a^2 + x^2} = \frac{\pi}{2a}",
    r"\int_a^\infty \frac{dx}{x^2} = \frac1a",
    r"\int_0^\infty \frac{x^3}{e^x - 1}\,dx = \frac{\pi^4}{15}",
    r"\sum_{n=0}^\infty x^n = \frac{1}{1 - x}",
    r"\sum_{n=1}^\infty n x^n = \frac{x}{(1 - x)^2}",
    r"\sum_{k=1}^\infty \frac{1}{k^2} = \frac{\pi^2}{6}",
    r"\sum_{k=1}^N k = \frac{N(N + 1)}{2}",
    r"\sum_{k=1}^4 k^2 = 30",
    r"\sum_{n=0}^N x^n = \frac{1 - x^{N + 1}}{1 - x}",
]
WRONG = {
    r"\int_0^\infty e^{-a x}\,dx = \frac2a": "½ times as much",
    r"\int_{-\infty}^\infty e^{-a x^2}\,dx = \sqrt{\pi a}": "",
    r"\int_a^\infty \frac{dx}{x^2} = -\frac1a": "another sign",
    r"\sum_{n=1}^\infty x^n = \frac{1}{1 - x}": "x times as much",
    r"\sum_{k=1}^N k = \frac{N(N - 1)}{2}": "another sign before 1",
    r"\sum_{k=1}^4 k^2 = 25": "another number",
    r"\sum_{n=0}^N x^n = \frac{1 - x^N}{1 - x}": "x times x^N",
}
OPEN = {
    r"\int_0^\infty \sin x\,dx = 1": "an integral that is not seen to converge",
    r"\int_0^\infty x\,dx = a": "an integral that is not seen to converge",
    r"\int_0^\infty e^{a x}\,dx = -\frac1a": "an integral that is not seen to converge",
    r"\sum_{k=1}^\infty \frac1k = 7": "a series whose value is not found",
    r"\sum_{i=1}^\infty m_i = M": "a sum without an end",
}


@pytest.mark.parametrize("line", RIGHT)
def test_the_value_of_what_converges_follows(line):
    assert last(f"$$ {line} $$").get("passed") is True


@pytest.mark.parametrize(("line", "slip"), WRONG.items())
def test_another_value_is_a_slip(line, slip):
    record = last(f"$$ {line} $$")
    assert (record["passed"], record["slip"]) == (False, slip)


@pytest.mark.parametrize(("line", "reason"), OPEN.items())
def test_what_has_no_value_is_open(line, reason):
    record = last(f"$$ {line} $$")
    assert (record["verdict"], record["note"]) == ("undecided", reason)


def test_what_a_sum_is_for_one_value_alone_does_not_follow():
    assert last(r"$$ \sum_{n=0}^N x^n = N + 1 $$")["passed"] is None  # it is so where x = 1


def test_a_letter_is_integrated_as_far_as_infinity_from_a_time():
    text = (
        "With $i = i_1 e^{-R(t - t_1)/L}$\n$$ \\int_{t_1}^\\infty R i^2\\,dt = \\frac12 L i_1^2 $$"
    )
    assert last(text)["passed"] is True
    assert last(text.replace(r"\frac12 L", r"\frac13 L"))["passed"] is False
