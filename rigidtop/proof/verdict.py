"""Verdicts, computed from residuals each time a claim is judged."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from sympy import Symbol

from rigidtop.proof.page import Assumption, Check, Claim, Definition, Measure, Step


class Verdict(StrEnum):
    PROVED = "proved"
    SAMPLED = "sampled"
    ASSUMING = "assuming"
    CONVENTION = "convention"
    FALSE = "false"
    DEFINITION = "definition"
    UNDECIDED = "undecided"


@dataclass(frozen=True)
class Counterexample:
    """Values at which two neighbouring sides of an equation differ, and what the sides are there."""

    values: Mapping[Symbol, Any]
    left: Any
    right: Any


@dataclass(frozen=True)
class TestedAssumption:
    """An assumption with the counterexample that stands when it alone is dropped."""

    assumption: Assumption
    without: Counterexample


@dataclass(frozen=True)
class Finding:
    """What became of one check."""

    check: Check
    verdict: Verdict
    assumptions: tuple[TestedAssumption, ...] = ()
    counterexample: Counterexample | None = None


@dataclass(frozen=True)
class Judgement:
    """A claim with its verdict and everything that its evidence showed, in order."""

    claim: Claim
    section: str
    verdict: Verdict
    items: tuple[Step | Definition | Measure | Finding, ...]
    seconds: float
    passed: bool
    problem: str = ""  # why it did not pass; empty when it did
