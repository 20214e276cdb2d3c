"""The right-hand sides that the numeric rooms run, and the module that holds them.

`rigidtop.motion` never loads SymPy, so its right-hand sides are written out, once, into
`rigidtop/motion/equations.py`, from the expressions that `rigidtop.theory` derives.
``python -m rigidtop.codegen`` rewrites that module; `symbolic` runs what is shipped on symbols, so
that a derivation page can show that it equals what was derived.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import sympy
from sympy import Expr, Symbol

from rigidtop.codegen import source
from rigidtop.codegen.numpy import Function, function
from rigidtop.theory import sliding, top
from rigidtop.theory import symbols as s

PATH = Path(__file__).parents[1] / "motion" / "equations.py"
"""The generated module."""


def top_without_spin() -> tuple[Expr, ...]:
    """q̇₀ … q̇₃, ω̇₁, ω̇₂ of the symmetric top in the frame that follows e₃ without turning about it.

    The frame turns by −ω₃ about e₃ against the body, and ω₃ is constant.  q̇ = ½ q∘ω loses ω₃; the
    components of ω in the frame gain ω₃ e₃ × ω.  The symmetry about e₃ lets the equations stand for
    every angle between frame and body when they are written where the two coincide.
    """
    *attitude, rate1, rate2, _ = top.heavy_body_rates().subs(top.SYMMETRIC)
    return (
        *(rate.subs(s.omega3, 0) for rate in attitude),
        rate1 - s.omega3 * s.omega2,
        rate2 + s.omega3 * s.omega1,
    )


def top_by_hamilton() -> tuple[Expr, ...]:
    """θ̇, φ̇, ψ̇, ṗ_θ of the symmetric top; p_φ and p_ψ are constants, as parameters are."""
    *rates, _, _ = top.symmetric_hamilton_equations()
    return tuple(rates)


def body_by_hamilton() -> tuple[Expr, ...]:
    """θ̇, φ̇, ψ̇, ṗ_θ, ṗ_ψ of a heavy body; p_φ is a constant."""
    *rates, _, along = top.body_hamilton_equations()
    return *rates, along


@dataclass(frozen=True)
class RightHandSide:
    """A system ẋ = f(x; parameters) that is shipped."""

    name: str
    about: str
    state: tuple[Symbol, ...]
    parameters: tuple[Symbol, ...]
    derive: Callable[[], Iterable[Expr]]

    expand: bool = True
    """Whether sums are multiplied out, which is fewer operations but loses small differences."""


SHIPPED = (
    RightHandSide(
        "top_in_euler_angles",
        "θ̈, φ̈, ψ̈ of the heavy symmetric top: (3.54)-(3.56).  Singular where sin θ = 0.",
        (s.theta, s.thetadot, s.phidot, s.psidot),
        (s.lambda1, s.lambda3, s.M, s.g, s.R),
        top.symmetric_top_accelerations,
    ),
    RightHandSide(
        "heavy_body",
        "q̇₀ … q̇₃, ω̇₁, ω̇₂, ω̇₃ of a heavy body about a pivot, centre of mass anywhere in it.",
        (*top.QUATERNION, s.omega1, s.omega2, s.omega3),
        (s.lambda1, s.lambda2, s.lambda3, s.M, s.g, s.R1, s.R2, s.R3),
        top.heavy_body_rates,
    ),
    RightHandSide(
        "heavy_top",
        "q̇₀ … q̇₃, ω̇₁, ω̇₂ of the symmetric top, in the frame that does not turn about e₃.",
        (*top.QUATERNION, s.omega1, s.omega2),
        (s.lambda1, s.lambda3, s.M, s.g, s.R, s.omega3),
        top_without_spin,
    ),
    RightHandSide(
        "top_by_routh",
        "θ̈, φ̇, ψ̇ of the heavy symmetric top from its Routhian.  Singular where sin θ = 0.",
        (s.theta,),
        (s.lambda1, s.lambda3, s.M, s.g, s.R, s.p_phi, s.p_psi),
        top.reduced_rates,
        expand=False,
    ),
    RightHandSide(
        "top_by_hamilton",
        "θ̇, φ̇, ψ̇, ṗ_θ of the heavy symmetric top: Hamilton's equations, singular at sin θ = 0.",
        (s.theta, s.p_theta),
        (s.lambda1, s.lambda3, s.M, s.g, s.R, s.p_phi, s.p_psi),
        top_by_hamilton,
        expand=False,
    ),
    RightHandSide(
        "body_in_euler_angles",
        "θ̈, φ̈, ψ̈ of a heavy body about a pivot: Lagrange's equations, singular at sin θ = 0.",
        (s.theta, s.psi, s.thetadot, s.phidot, s.psidot),
        (s.lambda1, s.lambda2, s.lambda3, s.M, s.g, s.R1, s.R2, s.R3),
        top.accelerations_in_euler_angles,
    ),
    RightHandSide(
        "body_by_hamilton",
        "θ̇, φ̇, ψ̇, ṗ_θ, ṗ_ψ of a heavy body: Hamilton's equations, singular at sin θ = 0.",
        (s.theta, s.psi, s.p_theta, s.p_psi),
        (s.lambda1, s.lambda2, s.lambda3, s.M, s.g, s.R1, s.R2, s.R3, s.p_phi),
        body_by_hamilton,
        expand=False,
    ),
)


_DRAG = (sliding.drag, sliding.drag1, sliding.drag3)


def contact_kinematics() -> tuple[Expr, ...]:
    """e₃, V and a of a top on a table, a with V put in."""
    axis, velocity = sliding.kinematics()
    moving = dict(zip(sliding.VELOCITY, velocity, strict=True))
    return *axis, *velocity, *sliding.free_slip().subs(moving)


SLIDING = (
    RightHandSide(
        "contact_kinematics",
        "Of a top on a table e₃, the velocity of its centre of mass, and a (see `theory.sliding`).",
        (*top.QUATERNION, s.omega1, s.omega2, s.omega3, *sliding.SLIP),
        (s.lambda1, s.lambda3, s.M, s.g, s.R, sliding.tip, *_DRAG),
        contact_kinematics,
    ),
    RightHandSide(
        "sliding_force",
        "F_x, F_y, N of a tip that slides in the direction d, v̇, and by what N was divided.",
        (*sliding.AXIS, *sliding.SLIP, *sliding.DIRECTION, *sliding.FREE_SLIP),
        (s.lambda1, s.lambda3, s.M, s.R, sliding.tip, s.mu, sliding.viscosity),
        sliding.sliding_force,
        expand=False,
    ),
    RightHandSide(
        "rolling_force",
        "F_x, F_y, N that let the point of contact rest.",
        (*sliding.AXIS, *sliding.FREE_SLIP),
        (s.lambda1, s.lambda3, s.M, s.R, sliding.tip),
        sliding.rolling_force,
        expand=False,
    ),
    RightHandSide(
        "sliding_top",
        "Rates of q₀ … q₃, ω and what friction and air dissipate, from the contact force.",
        (
            *top.QUATERNION,
            *(s.omega1, s.omega2, s.omega3),
            *sliding.SLIP,
            *sliding.VELOCITY,
            *sliding.CONTACT_FORCE,
        ),
        (s.lambda1, s.lambda3, s.R, sliding.tip, *_DRAG),
        sliding.rates,
    ),
)
"""A top on a table, in four parts: what it does, the contact force by two laws, what that does.

λ₁ and λ₃ are moments about the centre of mass here, and ω₁, ω₂ components in the frame that follows
e₃ without turning about it.
"""


def named(name: str) -> RightHandSide:
    """The right-hand side of that name; ValueError with the names there are for another."""
    for side in (*SHIPPED, *SLIDING):
        if side.name == name:
            return side
    names = ", ".join(side.name for side in (*SHIPPED, *SLIDING))
    raise ValueError(f"no right-hand side {name!r}: {names}")


def derived(name: str) -> tuple[Expr, ...]:
    """The expressions that `rigidtop.theory` derives for a shipped function."""
    return tuple(named(name).derive())


def symbolic(name: str, text: str | None = None) -> tuple[Expr, ...]:
    """What is shipped: the source run on symbols, with SymPy's sine and cosine.

    >>> symbolic("heavy_body")[6].subs(s.g, 0)
    omega1*omega2*(lambda1 - lambda2)/lambda3
    """
    side = named(name)
    module: dict[str, Any] = {"__name__": "equations"}
    exec(PATH.read_text("utf-8") if text is None else text, module)
    trigonometry = {
        word: getattr(sympy, word)
        for word in module[name].__kwdefaults__ or ()  # the keyword-only sin and cos
    }
    return tuple(module[name](*side.parameters, **trigonometry)(side.state))


@dataclass(frozen=True)
class Split:
    """A right-hand side as it is computed: constants once for a motion, rates at every call."""

    constants: Mapping[Symbol, Expr]
    expressions: tuple[Expr, ...]
    """The rates, in terms of these."""
    rates: Function


def split(side: RightHandSide) -> Split:
    """Take everything that depends on parameters alone out of the rates."""
    names: dict[Expr, Symbol] = {}
    collect = _by_constants if side.expand else _as_they_stand
    rates = [collect(rate, side.state, names) for rate in side.derive()]
    constants = {name: constant for constant, name in names.items()}
    used = set[Symbol]().union(*(rate.free_symbols for rate in rates))
    alone = [parameter for parameter in side.parameters if parameter in used]
    arguments = (*side.state, *constants, *alone)
    return Split(constants, tuple(rates), function(rates, arguments, "rates"))


def _by_constants(rate: Expr, state: Sequence[Symbol], names: dict[Expr, Symbol]) -> Expr:
    """Σ constant × (something of the state), with each constant a symbol from `names`."""
    factors: dict[Expr, Expr] = defaultdict(lambda: sympy.S.Zero)
    for term in sympy.Add.make_args(sympy.expand(rate)):
        factor, of_state = term.as_independent(*state, as_Add=False)
        factors[of_state] += factor
    grouped: dict[Expr, Expr] = defaultdict(lambda: sympy.S.Zero)
    for of_state, factor in factors.items():
        number, constant = sympy.factor(factor).as_coeff_Mul()
        grouped[constant] += number * of_state
    total = sympy.S.Zero
    for constant, of_state in grouped.items():
        number, rest = sympy.factor_terms(of_state).as_coeff_Mul()
        if constant == 1:
            total += number * rest
            continue
        # One constant serves both signs.
        sign = -1 if (number * constant).could_extract_minus_sign() else 1
        name = names.setdefault(sign * number * constant, Symbol(f"c{len(names)}"))
        total += sign * name * rest
    return total


def _as_they_stand(rate: Expr, state: Sequence[Symbol], names: dict[Expr, Symbol]) -> Expr:
    """The same sums and products, with each part that the state does not enter a symbol."""
    if rate.is_Add or rate.is_Mul:
        constant, of_state = rate.as_independent(*state)
        sign = -1 if constant.could_extract_minus_sign() else 1
        if not constant.is_Number and (constant * sign) not in rate.free_symbols:
            name = names.setdefault(sign * constant, Symbol(f"c{len(names)}"))
            return rate.func(sign * name, _as_they_stand(of_state, state, names))
    if rate.is_Atom:
        return rate
    return rate.func(*(_as_they_stand(part, state, names) for part in rate.args))


HEADER = '''\
"""Right-hand sides of rigid-body motion, as derived.

Written by `python -m rigidtop.codegen` from `rigidtop.theory`: do not edit.

Each function takes the parameters once, in the order of its first line, and returns the rates as a
function of the state.  The numbers may be floats, NumPy arrays that broadcast, or symbols; where
angles occur, `sin` and `cos` are those of `math` unless others are given.  SI units and radians;
λ₁, λ₂, λ₃ are the moments of inertia about the pivot (for a free body, and for a top on a table,
about the centre of mass), and ω₁, ω₂, ω₃ are components in the body frame unless said otherwise.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any

Number = Any  # a float, an array or a symbol
Function = Callable[[Number], Number]
Rates = Callable[[Sequence[Number]], tuple[Number, ...]]
'''


def module_text() -> str:
    """The whole text of the generated module."""
    return "\n".join([HEADER, *("\n" + _text(side) + "\n" for side in (*SHIPPED, *SLIDING))])


def _text(side: RightHandSide) -> str:
    parts = split(side)
    called = sorted(source.names_called(parts.rates.definition))
    more = [f"{word}: Function = math.{word}" for word in called]
    lines = [
        *source.signature(side.name, ["*parameters: Number", *more], returns="Rates"),
        f'    """{side.about}',
        "",
        f"    The state is ({', '.join(x.name for x in side.state)}).",
        '    """',
        f"    {_row(side.parameters)} = parameters",
        *source.assignments([*parts.constants.items()]),
        "",
        "    def rates(state: Sequence[Number]) -> tuple[Number, ...]:",
        f"        {_row(side.state)} = state",
        *source.body(parts.rates.program, depth=2),
        "",
        "    return rates",
    ]
    return "\n".join(lines)


def _row(symbols: Sequence[Symbol]) -> str:
    names = ", ".join(x.name for x in symbols)
    return names if len(symbols) > 1 else f"({names},)"
