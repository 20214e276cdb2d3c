r"""What was left out stays small only while the other letters stay what they are."""

import json
import re

import pytest

from rigidtop.cli import main

LAWS = r"""# 1 What is small

| letter | meaning | unit | kind |
| --- | --- | --- | --- |
| $\varepsilon$ | a small number | 1 | positive |
| $a$ | a number | 1 | positive |
| $u$ | a number | 1 | positive |
| $v$ | a number | 1 | positive |
| $x$ | a number | 1 | variable |
| $y$ | a number | 1 | variable |
| $z$ | a number | 1 | variable |
| $f$ | a number | 1 | variable |
| $q$ | a number | 1 | variable |
| $s$ | a number | 1 | variable |
| $D$ | a number | 1 | variable |

## Laws

Definition. The fraction:

$$y = \frac1{1 + \varepsilon x}$$

Definition. The far one:

$$u = \frac3\varepsilon$$

Definition. The seven:

$$v = 7$$

Definition. The distance:

$$f = |x - a|$$

Definition. The sum of squares:

$$q = x^2 - 2ax + 2a^2$$

Definition. The drag:

$$z = a - \varepsilon x$$

Definition. The logarithm:

$$s = \ln(xz)$$

Definition. The discriminant:

$$D = a^2 - 4u$$

## Lines
"""
EXPANDED = (
    r"Expand the fraction to first order in $\varepsilon$ => y \approx 1 - \varepsilon x" + "\n"
)

REFUSED = {
    "a letter that grows": (
        EXPANDED + r"Set $x = \frac3\varepsilon$ in it => y \approx -2",
        "it changes with ε",
    ),
    "one that grows by its definition": (
        EXPANDED + r"Set $x = u$ in it => y \approx 1 - \varepsilon u",
        "it changes with ε",
    ),
    "one that goes to zero": (
        EXPANDED + r"Set $x = \varepsilon$ in it => y \approx 1 - \varepsilon^2",
        "it changes with ε",
    ),
    "a small one that is as large as another": (
        EXPANDED + r"Set $\varepsilon = 2x$ in it => y \approx 1 - 2x^2",
        "ε is small in small:9, whatever x is",
    ),
    "a small one by another name, which is a number": (
        EXPANDED
        + r"Set $\varepsilon = v$ in it => y \approx 1 - vx"
        + "\n"
        + r"Substitute the seven into it => y \approx 1 - 7x",
        "v is small in small:10: it can't be set",
    ),
    "what would have to be large to hold": (
        EXPANDED + r"Set $y = 0$ in it => 0 \approx 1 - \varepsilon x",
        "this can't hold",
    ),
    "the two sides of a number": (
        r"""Rewrite the distance, for $x > a$ => f = x - a \tag{1.1}
Rewrite the distance, for $x < a$ => f = a - x \tag{1.2}
Add (1.2) to (1.1) => 2f = 0""",
        "this can't hold",
    ),
    "a quadratic without a root": (
        r"Set $q = 0$ in the sum of squares => 0 = x^2 - 2ax + 2a^2",
        "this can't hold",
    ),
    "one condition too many": (
        r"Rewrite the distance, for $x > a$ and $u > 1$ => f = x - a",
        "is a condition without need",
    ),
}
FOLLOWS = {
    "another name for what is small": EXPANDED + r"Set $\varepsilon = v$ in it => y \approx 1 - vx",
    "a division by what is small": EXPANDED
    + r"Divide it by $\varepsilon$ => \frac y\varepsilon \approx \frac1\varepsilon - x",
    "a number for another letter": EXPANDED + r"Set $x = 3$ in it => y \approx 1 - 3\varepsilon",
    "a term with a minus before it": r"Neglect $\varepsilon x$ in the drag, for small "
    r"$\varepsilon$ => z \approx a",
    "a size on one side": r"Rewrite the distance, for $x < a$ => f = a - x",
    "a slope of what a line gives": r"Differentiate the discriminant with respect to $a$ => "
    r"\frac{\partial D}{\partial a} = 2a",
    "two conditions, of which either is enough": r"Rewrite the logarithm, for $x > 0$ and $z > 0$"
    r" => s = \ln x + \ln z",
}


def last(tmp_path, capsys, page):
    """The last line of a page as it is judged."""
    lines = re.sub(r"(.*?) => (.*)", r"\1:\n\n$$\2$$\n", page)
    (tmp_path / "small.md").write_text(f"{LAWS}\n{lines}\n", encoding="utf-8")
    main(["check", str(tmp_path), "--lines", "--json"])
    return json.loads(capsys.readouterr().out)[-1]


@pytest.mark.parametrize(("page", "why"), REFUSED.values(), ids=REFUSED)
def test_what_does_not_follow_is_refused(tmp_path, capsys, page, why):
    line = last(tmp_path, capsys, page)
    assert line["verdict"] == "gap"
    assert why in line["note"]


@pytest.mark.parametrize("page", FOLLOWS.values(), ids=FOLLOWS)
def test_what_follows_is_not_refused(tmp_path, capsys, page):
    line = last(tmp_path, capsys, page)
    assert line["verdict"] == "follows", line["note"]
