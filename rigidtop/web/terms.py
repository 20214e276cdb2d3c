"""The equations of motion as the notes print them, taken apart into terms with names and values.

The terms are those of the equations that the derivations prove; here are the words for them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from sympy import Add, Expr, Matrix

from rigidtop.derivations import eulers_equations, lagrange_formalism
from rigidtop.proof.equation import Equation, value
from rigidtop.proof.page import Check, Claim
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.euler import OMEGA, OMEGA_DOT, body_accelerations
from rigidtop.theory.rotation import Z_AXIS, quaternion_matrix
from rigidtop.typeset.layout import layout
from rigidtop.typeset.mathml import labelled
from rigidtop.typeset.text import text

GRAVITY = top.gravity_torque(quaternion_matrix(Matrix(top.QUATERNION)).T * Z_AXIS)
TORQUE = GRAVITY - top.friction * Matrix(OMEGA)
"""Of gravity, in body components (N m)."""

MEANING: Mapping[Any, Any] = {
    s.thetaddot: top.symmetric_top_accelerations()[0],
    **dict(zip((s.N1, s.N2, s.N3), TORQUE, strict=True)),
}
"""What is no coordinate, velocity, momentum or parameter, by what was derived.

The momenta are those that the motion has, L_z and L₃, so that the sides of (3.55) and (3.56) say
something of each other.
"""


@dataclass(frozen=True)
class Term:
    """One term of an equation, with its sign."""

    expression: Expr
    name: str
    unit: str
    arrow: str = ""
    """The page's arrow of what it is a component of, if there is one."""

    @property
    def text(self) -> str:
        """The term as plain text, as the notes print it."""
        return text(self.expression)


@dataclass(frozen=True)
class TermsOf:
    """An equation of motion, and what its terms are called, in the order in which they stand."""

    function: str
    """Of the page's module of equations, which returns the values of the terms."""

    title: str
    equation: Equation
    names: tuple[str, ...]
    unit: str
    meaning: Mapping[Any, Any]
    arrows: tuple[str, ...] = ()

    @cached_property
    def terms(self) -> tuple[Term, ...]:
        """The terms of both sides; what says only that a quantity is constant is none."""
        terms = [term for side in self.equation.sides for term in _terms(side)]
        arrows = self.arrows or ("",) * len(terms)
        return tuple(
            Term(each, name, self.unit, arrow)
            for each, name, arrow in zip(terms, self.names, arrows, strict=True)
        )

    @property
    def values(self) -> tuple[Expr, ...]:
        """The values of the terms, in coordinates, velocities and parameters."""
        return tuple(value(term.expression, self.meaning) for term in self.terms)

    @property
    def mathml(self) -> str:
        """The equation as MathML, with ``data-term`` on each of its terms."""
        first = 0
        sides = []
        for side in self.equation.sides:
            count = len(_terms(side))
            sides.append((tuple(map(layout, _summands(side))), first if count else None))
            first += count
        return labelled(sides, text(self.equation))


def _terms(side: Expr) -> tuple[Expr, ...]:
    return () if side == s.const else _summands(side)


def _summands(side: Expr) -> tuple[Expr, ...]:
    """Sums that are kept as typed are sums of sums."""
    if not isinstance(side, Add):
        return (side,)
    return tuple(term for part in side.args for term in _summands(part))


def _printed(claim: Claim) -> list[Equation]:
    """The equations that a claim types, each once."""
    return list(dict.fromkeys(e.claimed for e in claim.evidence() if isinstance(e, Check)))


def heavy() -> tuple[TermsOf, ...]:
    """(3.54), (3.55) and (3.56) of the symmetric top."""
    (theta,) = _printed(lagrange_formalism.theta_equation)
    (p_phi,) = _printed(lagrange_formalism.momentum_phi)
    (p_psi,) = _printed(lagrange_formalism.momentum_psi)
    return (
        TermsOf(
            "thetaTerms",
            "the tilt θ",
            theta,
            (
                "moment λ₁ times how fast θ̇ changes",
                "centrifugal term of the precession: it drives the axis towards the horizontal",
                "gyroscopic term: the precession turns the angular momentum of the spin",
                "torque of gravity: it pulls the centre of mass down",
            ),
            "N m",
            MEANING,
            ("", "", "", "torque"),
        ),
        TermsOf(
            "pPhiTerms",
            "φ does not occur in the Lagrangian: p_φ = L_z is constant",
            p_phi,
            (
                "momentum conjugate to φ: the vertical component of L",
                "what the precession of the tilted axis brings to L_z",
                "the vertical part of p_ψ, the angular momentum along e₃",
            ),
            "J s",
            MEANING,
            ("L", "", ""),
        ),
        TermsOf(
            "pPsiTerms",
            "ψ does not occur either: p_ψ = L₃ is constant",
            p_psi,
            (
                "momentum conjugate to ψ: the component of L along e₃",
                "λ₃ω₃: the rotation ψ̇ about e₃ and the part of the precession along e₃",
            ),
            "J s",
            MEANING,
            ("L", ""),
        ),
    )


def general() -> tuple[TermsOf, ...]:
    """Euler's equations with the torques of gravity and friction, for any heavy body."""
    return _eulers(_printed(eulers_equations.with_torque), torque=True)


def free() -> tuple[TermsOf, ...]:
    """(3.36): the page's functions are those of a heavy body, here without weight."""
    return _eulers(_printed(eulers_equations.euler_equations), torque=False)


def _eulers(equations: list[Equation], *, torque: bool) -> tuple[TermsOf, ...]:
    rates = top.body_accelerations_with(TORQUE) if torque else body_accelerations()
    meaning = {**MEANING, **dict(zip(OMEGA_DOT, rates, strict=True))}
    return tuple(
        TermsOf(
            f"euler{axis}",
            f"along e{sub}",
            equation,
            (
                f"how fast L{sub} = λ{sub}ω{sub} changes, seen from the body",
                f"−(ω × L){sub}: what the turning of the body itself does to L{sub}",
                *([f"torque of gravity and friction about e{sub}"] if torque else []),
            ),
            "N m",
            meaning,
            ("", "", *(["torque"] if torque else [])),
        )
        for axis, sub, equation in zip((1, 2, 3), "₁₂₃", equations, strict=True)
    )
