"""Answers judged by what the models of the lecture say."""

import pytest

from rigidtop.errors import RigidtopError
from rigidtop.mark.answer import mark
from rigidtop.mark.marking import Mark
from rigidtop.mark.task import task


def marking(source, start, goal):
    return mark(source, task(start, goal))


EULER = r"""
\begin{cases}\lambda_1\dot\omega_1 = (\lambda_1-\lambda_3)\omega_2\omega_3\\
\lambda_1\dot\omega_2 = %s(\lambda_1-\lambda_3)\omega_3\omega_1\end{cases}
"""
RIGHT = {
    "complex": (
        r"Let $\eta=\omega_1+i\omega_2$. Then $\dot\eta=-i\Omega_b\eta$ and "
        r"$\eta=\omega_0e^{-i\Omega_bt}$, so $$\omega_1=\omega_0\cos\Omega_b t,\ "
        r"\omega_2=-\omega_0\sin\Omega_b t,\ \omega_3=\text{const}$$",
        "3.37",
        "3.38",
    ),
    "cases": (
        f"$${EULER % '-'}$$ "
        r"$$\dot\omega_1=\Omega_b\omega_2, \dot\omega_2=-\Omega_b\omega_1$$",
        "3.36",
        "3.37",
    ),
    "columns": (
        r"$$\boldsymbol\omega=\dot\phi\begin{pmatrix}-\sin\theta\\0\\\cos\theta\end{pmatrix}"
        r"+\begin{pmatrix}0\\\dot\theta\\\dot\psi\end{pmatrix}"
        r"=\begin{pmatrix}-\dot\phi\sin\theta\\\dot\theta\\\dot\psi+\dot\phi\cos\theta"
        r"\end{pmatrix}$$",
        "3.41",
        "3.42",
    ),
    "primes": (
        r"$$\lambda_1\theta'' = \lambda_1\phi'^2\sin\theta\cos\theta"
        r"-\lambda_3\omega_3\phi'\sin\theta+MgR\sin\theta$$",
        "3.53",
        "3.54",
    ),
    "solved": (
        r"$$\dot\phi=\frac{L_z-L_3\cos\theta}{\lambda_1\sin^2\theta}$$",
        "3.43",
        "3.45",
    ),
}


@pytest.mark.parametrize("name", RIGHT)
def test_a_right_answer_passes(name):
    found = marking(*RIGHT[name])
    assert found.arrives
    assert found.passed, found.summary


WRONG = {
    "sign": (f"$${EULER % ''}$$", "3.36", "3.37"),
    "factor": (
        r"$$\lambda_1\ddot\theta = \frac12\lambda_1\dot\phi^2\sin\theta\cos\theta"
        r"-\lambda_3\omega_3\dot\phi\sin\theta+MgR\sin\theta$$",
        "3.53",
        "3.54",
    ),
    "order": (
        r"$\left(\frac{\partial\mathbf L}{\partial t}\right)_{\text{body}}"
        r"=\boldsymbol\omega\times\mathbf L$",
        "3.35",
        "3.36",
    ),
    "sine": (
        r"$$\mathbf L=-\lambda_1\dot\phi\cos\theta\,\mathbf e_1'+\lambda_1\dot\theta\,\mathbf e_2'"
        r"+\lambda_3(\dot\psi+\dot\phi\cos\theta)\,\mathbf e_3$$",
        "3.42",
        "3.43",
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_line_is_wrong_and_named(name):
    found = marking(*WRONG[name])
    assert found.first_wrong is not None
    assert found.first_wrong.slip
    assert not found.passed


def test_pieces_do_not_arrive():
    source = (
        r"$$\frac{\partial\mathcal L}{\partial\dot\theta}=\lambda_1\dot\theta,\quad"
        r"\frac{d}{dt}\frac{\partial\mathcal L}{\partial\dot\theta}"
        r"=\frac{\partial\mathcal L}{\partial\theta}$$"
    )
    found = marking(source, "3.53", "3.54")
    assert all(line.mark is Mark.FOLLOWS for line in found.lines)
    assert not found.arrives


def test_what_the_lecture_does_not_have_is_said():
    with pytest.raises(RigidtopError, match="no line of the lecture is called"):
        marking("$a=b$", "3.53", "9.99")
