"""Numbers as people write them: in sentences, in lists of answers, in the columns of a table."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from decimal import ROUND_HALF_UP, Decimal

from rigidtop.report import blocks as b
from rigidtop.report import plain
from rigidtop.typeset.nodes import Digits, Infix, Node, Superscript, decimal, negated
from rigidtop.typeset.words import printed_unit

DIGITS = 6
"""Of a number in print."""

TABLE_DIGITS = 4
"""Of a number in a table."""

GIVEN_DIGITS = 7
"""As many as anybody measures."""

SMALLEST_ANGLE = 1e-4
"""Smaller angles say nothing in degrees (rad)."""

DAY = 86400.0
"""In seconds."""


def shown(value: float | str, digits: int = DIGITS, *, kept: bool = False) -> str | Node:
    """A cell as it is printed; zeros at its end are `kept`, so that its digits can be counted.

    >>> from rigidtop.typeset.text import text
    >>> text(shown(-0.25)), shown("waves")
    ('−0.25', 'waves')
    >>> [text(shown(x, 4, kept=True)) for x in (12.0961, 14.0, 0.0)]
    ['12.10', '14.00', '0.000']
    """
    if isinstance(value, str):
        return value
    node = decimal(abs(value), digits, kept=kept)
    return negated(node) if value < 0 else node


def written(value: float | str, unit: str, *, angles: bool = True, digits: int = DIGITS) -> b.Rich:
    """A number with its unit; `angles` in degrees, small ones in seconds of arc.

    It is rounded to so many significant `digits`.

    >>> written(0.5235987755982988, "rad"), written(4.84813681e-07, "rad")
    ((Digits(text='30'), UprightUnit(letters='°')), (Digits(text='0.1'), UprightUnit(letters='″')))
    """
    if not isinstance(value, str) and unit == "rad" and angles:
        small = 0 < abs(value) < SMALLEST_ANGLE
        value = math.degrees(value) * (3600 if small else 1)
        unit = "″" if small else "°"
    number = shown(value, digits, kept=digits == TABLE_DIGITS)
    return (number,) if isinstance(value, str) or unit == "1" else (number, b.UprightUnit(unit))


def given(value: float, unit: str) -> b.Rich:
    """A setting in the unit in which it has fewest digits: 30°, but 0.5 rad (28.65°); 180 rpm."""
    columns = [written(value, unit, angles=angles, digits=GIVEN_DIGITS) for angles in (True, False)]
    if unit == "rad/s":
        slow = abs(value) < SMALLEST_ANGLE
        other = math.degrees(value) * DAY if slow else value * 30 / math.pi
        columns.append((shown(other, GIVEN_DIGITS), b.UprightUnit("°/day" if slow else "rpm")))
    best = min(columns, key=_significant)
    if best is not columns[1] or abs(value) < SMALLEST_ANGLE:
        return best
    # The solution has degrees.
    return (*best, " (", *written(value, unit, digits=TABLE_DIGITS), ")")


def _significant(pieces: b.Rich) -> int:
    """How many digits of a number say something, zeros at either end left out.

    >>> [_significant(written(value, "m")) for value in (0.0105, -2700.0, 7.29e-05)]
    [3, 2, 3]
    """
    digits = re.sub(r"\D", "", plain.rich(pieces[:1]).partition("×")[0])
    return len(digits.strip("0"))


def apart(value: float | str, unit: str) -> tuple[str | Node, str]:
    """A number and its unit for two columns, with as many digits as in tables."""
    if isinstance(value, str):
        return value, ""
    number, *rest = written(value, unit, digits=TABLE_DIGITS)
    assert not isinstance(number, b.Cited | b.UprightUnit)
    return number, printed_unit(rest[0].letters) if rest and isinstance(
        rest[0], b.UprightUnit
    ) else "1"


# --- Tables --------------------------------------------------------------------------------------


def cells(rows: Sequence[Sequence[float | str]]) -> tuple[tuple[str | Node, ...], ...]:
    """The rows of a table, the numbers of a column with points one beneath the other.

    >>> from rigidtop.typeset.text import text
    >>> [text(x) for x, in cells([(12.1,), (12.0912,), (0.0,)])]
    ['12.10', '12.09', '0.00']
    >>> [text(x) for x, in cells([(90.0,), (5.625,)])], [text(x) for x, in cells([(3e-05,)])]
    (['90.00', '5.63'], ['3.000 × 10⁻⁵'])
    """
    return tuple(zip(*map(_column, zip(*rows, strict=True)), strict=True))


def _column(values: Sequence[float | str]) -> list[str | Node]:
    sizes = [abs(x) for x in values if not isinstance(x, str) and x]
    if not sizes or not all(map(math.isfinite, sizes)):
        return [shown(x, TABLE_DIGITS) for x in values]
    short = [f"{x:.{TABLE_DIGITS}g}" for x in sizes]
    # Powers of ten of the largest number and of the smallest, as they are printed.
    rounded = [math.floor(math.log10(float(x))) for x in short]
    large, small = max(rounded), min(rounded)
    if large < LEAST or large - small > (SPAN // 2 if small < LEAST else SPAN):
        return [x if isinstance(x, str) else _power(x) for x in values]
    # All digits of the largest number, and three at least of the smallest.
    wanted = max(TABLE_DIGITS - 1 - large, 2 - small, 0)
    there = max(len(f"{float(x):.{wanted}f}".rstrip("0").partition(".")[2]) for x in short)
    return [x if isinstance(x, str) else _number(x, min(wanted, there)) for x in values]


SPAN = 4
"""Over more powers of ten each number has its own, and over half as many where some are small."""

LEAST = -4
"""Numbers below this power of ten are small."""


def _number(value: float, decimals: int) -> Node:
    """A number with so many decimals, a half rounded up: 5.63 for 5.625."""
    exact = Decimal(repr(float(value))).quantize(Decimal(1).scaleb(-decimals), ROUND_HALF_UP)
    node = Digits(f"{abs(exact):f}")
    return negated(node) if exact < 0 else node


def _power(value: float) -> Node:
    """A number times a power of ten, but of those of the size of one."""
    digits, _, power = f"{abs(value):.{TABLE_DIGITS - 1}e}".partition("e")
    node: Node = Digits(digits if value else "0")
    if int(power):
        size = Digits(str(abs(int(power))))
        node = Infix(
            "×", node, Superscript(Digits("10"), size if int(power) > 0 else negated(size))
        )
    return negated(node) if value < 0 else node


def in_degrees(head: str, column: Sequence[float | str]) -> tuple[str, Sequence[float | str]]:
    """A column of a table, angles in degrees.

    >>> in_degrees("tilt (rad)", ("none", math.pi))
    ('tilt ($°$)', ['none', 180.0])
    """
    if not head.endswith("(rad)"):
        return head, column
    turned = [x if isinstance(x, str) else math.degrees(x) for x in column]
    return f"{head.removesuffix('(rad)')}($°$)", turned


def cleaned(column: Sequence[float | str]) -> list[float | str]:
    """Numbers of a column, those zero that rounding alone keeps from it.

    >>> cleaned(("axis", 0.5, 3e-17))
    ['axis', 0.5, 0.0]
    """
    largest = max((abs(x) for x in column if not isinstance(x, str)), default=0.0)
    return [x if isinstance(x, str) or abs(x) > NOISE * largest else 0.0 for x in column]


NOISE = 1e-14
"""What is smaller beside the largest number of its column is rounding."""
