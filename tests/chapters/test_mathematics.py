"""What the mathematics of a lecture needs besides: each with its conditions, refused without."""

from __future__ import annotations

import json

import pytest

from rigidtop.cli import main

TABLE = r"""# 1 A trial

| letter | meaning | unit | kind |
| --- | --- | --- | --- |
| $m$ | a mass | kg | positive |
| $k$ | a stiffness | N/m | positive |
| $x$ | a place | m | coordinate |
| $y$ | another place | m | coordinate |
| $\phi$ | an angle | rad | coordinate |
| $r$ | a distance | m | positive coordinate |
| $u$ | a length | m | |
| $u_0$ | a length at the start | m | number |
| $a_1$ | a share | 1 | number |
| $a_2$ | another share | 1 | number |
| $\alpha$ | a ratio | 1 | number |
| $V$ | a potential energy | J | |
| $\omega$ | a frequency | 1/s | positive |
| $\varepsilon$ | a small ratio | 1 | number |
| $\mathbf i$, $\mathbf j$, $\mathbf n$ | axes | | fixed frame |
| $\mathbf w$ | a velocity | m/s | vector |

## Laws

Given. Along the motion, the oscillation:

$$\frac{d^2u}{d\phi^2} = -u$$

Given. Along the motion, the slow one:

$$\frac{d^2u}{d\phi^2} = -\alpha u + \frac{\dot x}{\dot\phi}$$

Given. The pair:

$$\begin{pmatrix}1 & \alpha\\ \alpha & 1\end{pmatrix}\begin{pmatrix}a_1\\ a_2\end{pmatrix} = 0$$

Given. The potential:

$$V = \tfrac12kr^2\left(1 - \cos\frac xr\right)$$

Given. The frequency:

$$\omega^2 = \frac km$$

Given. The ratio:

$$\varepsilon = \frac{m\omega^2}k$$

Given. The velocity:

$$\mathbf w = \dot x\mathbf i + \dot y\mathbf j$$

## A part

"""

RIGHT = {
    "over another letter": (
        r"Integrate the oscillation over $\phi$ from $u = u_0$ and $\frac{du}{d\phi} = 0$",
        r"u = u_0\cos\phi",
    ),
    "eliminated": (r"Eliminate $a_1$ and $a_2$ from the pair", r"1 - \alpha^2 = 0"),
    "a power": (r"Solve the frequency for $\omega^2$", r"\omega^2 = \frac km"),
    "a product": (r"Solve the ratio for $m\omega^2$", r"m\omega^2 = k\varepsilon"),
    "a root put in": (r"Substitute the frequency into the ratio", r"\varepsilon = 1"),
    "a frame": (
        r"Take the vector product of $\mathbf n$ with the velocity",
        r"\mathbf n\times\mathbf w = \dot x\mathbf j - \dot y\mathbf i",
    ),
}
WRONG = {
    "another solution": (
        r"Integrate the oscillation over $\phi$ from $u = u_0$ and $\frac{du}{d\phi} = 0$",
        r"u = u_0\cos2\phi",
        "they become",
    ),
    "another start": (
        r"Integrate the oscillation over $\phi$ from $u = u_0$ and $\frac{du}{d\phi} = 0$",
        r"u = u_0\cos\phi + u_0\sin\phi",
        "does not start there",
    ),
    "a start that is not said": (
        r"Integrate the oscillation over $\phi$ from $u = u_0$",
        r"u = u_0\cos\phi",
        "starts is not said",
    ),
    "what is no function of it": (
        r"Integrate the slow one over $\phi$ from $u = u_0$ and $\frac{du}{d\phi} = 0$",
        r"u = u_0\cos\phi",
        "as a function of φ",
    ),
    "over what does not change": (
        r"Integrate the oscillation over $m$ from $u = u_0$ and $\frac{du}{d\phi} = 0$",
        r"u = u_0\cos\phi",
        "as a function of m",
    ),
    "one equation for two": (
        r"Eliminate $a_1$, $a_2$ and $\alpha$ from the pair",
        r"1 - \alpha^2 = 0",
        "as many equations as letters",
    ),
    "a frame turned over": (
        r"Take the vector product of $\mathbf n$ with the velocity",
        r"\mathbf n\times\mathbf w = \dot y\mathbf i - \dot x\mathbf j",
        "does not arrive",
    ),
    "another determinant": (
        r"Eliminate $a_1$ and $a_2$ from the pair",
        r"1 + \alpha^2 = 0",
        "does not arrive",
    ),
}


def told(tmp_path, capsys, *steps):
    """What becomes of the last of some lines on the page."""
    page = tmp_path / "trial"
    page.mkdir()
    lines = "\n\n".join(f"{said}:\n\n$${shown}$$" for said, shown in steps)
    (page / "trial.md").write_text(f"{TABLE}{lines}\n", "utf-8")
    main(["check", f"{page}/", "--lines", "--json"])
    return json.loads(capsys.readouterr().out)[-1]


@pytest.mark.parametrize(("said", "shown"), RIGHT.values(), ids=RIGHT)
def test_it_follows(tmp_path, capsys, said, shown):
    line = told(tmp_path, capsys, (said, shown))
    assert line["verdict"] != "gap", line["note"]


@pytest.mark.parametrize(("said", "shown", "why"), WRONG.values(), ids=WRONG)
def test_it_does_not(tmp_path, capsys, said, shown, why):
    line = told(tmp_path, capsys, (said, shown))
    assert line["verdict"] == "gap"
    assert why in line["note"]


def test_what_a_slope_divides_by_is_a_condition(tmp_path, capsys):
    line = told(
        tmp_path,
        capsys,
        ("Define a length", r"u = 2x"),
        (
            r"Differentiate with respect to $\phi$ along the motion",
            r"\frac{du}{d\phi} = 2\frac{dx}{d\phi}",
        ),
    )
    assert line["verdict"] != "gap", line["note"]
    assert any("φ̇" in str(each) for each in line["conditions"])


EXPANDED = (r"Expand the potential to second order in $x$", r"V \approx \tfrac14kx^2")


@pytest.mark.parametrize(
    ("shown", "follows"),
    [
        (r"\frac{\partial V}{\partial x} \approx \tfrac12kx", True),
        (r"\frac{\partial V}{\partial x} = \tfrac12kx", False),
        (r"\frac{\partial V}{\partial x} \approx kx", False),
    ],
)
def test_what_was_expanded_may_be_differentiated(tmp_path, capsys, shown, follows):
    line = told(tmp_path, capsys, EXPANDED, ("Differentiate it with respect to $x$", shown))
    assert (line["verdict"] != "gap") is follows, line["note"]


def test_a_derivative_is_known_to_one_order_less(tmp_path, capsys):
    once = ("Differentiate in time", r"\dot V \approx \tfrac12kx\dot x")
    line = told(tmp_path, capsys, EXPANDED, once)
    assert line["verdict"] != "gap", line["note"]


LAW = r"\frac{d}{dt}\frac{\partial V}{\partial\dot r} = \frac{\partial V}{\partial r}"


@pytest.mark.parametrize(
    ("called", "shown", "known"),
    [
        ("Lagrange's equation for $r$", LAW, True),
        ("Lagrange's equation for $r$", LAW.replace("= ", "= -"), False),
        ("Lagrange's equation for $r$", LAW.replace(r"{\partial r}", r"{\partial x}"), False),
        ("Hamilton's equation for $r$", LAW, False),
    ],
)
def test_a_law_of_the_lecture_needs_no_source(tmp_path, capsys, called, shown, known):
    page = tmp_path / "trial"
    page.mkdir()
    law = f"{called}:\n\n$${shown}$$\n\n## A part"
    (page / "trial.md").write_text(TABLE.replace("## A part", law) + "\nWords.\n", "utf-8")
    code = main(["check", f"{page}/"])
    assert ("has no source" not in capsys.readouterr().out) is known
    assert (code == 0) is known
