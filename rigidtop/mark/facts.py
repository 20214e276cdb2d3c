"""What may be used between two equations of the lecture: a model that gives every symbol a value.

A line of a derivation is right if it holds for every motion that the facts allow, whatever its
form.  So the facts are a `Model`: what each symbol means in terms of a few that are free, the rate
of each of these, and what holds besides.  A `Passage` leads from one numbered equation to another:
its models, from the general to the special, and what it means to arrive.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import sympy
from sympy import (
    Expr,
    Integer,
    Matrix,
    MatrixBase,
    Ne,
    Symbol,
    cos,
    eye,
    sin,
)

from rigidtop.derivations import lecture
from rigidtop.derivations.letters import LETTERS
from rigidtop.notation import NOTES, Notation
from rigidtop.proof import decide
from rigidtop.proof.equation import BODY, SPACE, Equation, NoMeaningError, Rate, value
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.euler import (
    OMEGA,
    OMEGA_DOT,
    angular_momentum,
    body_accelerations,
    kinetic_energy,
)
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.rotation import (
    EULER_RATES,
    Z_AXIS,
    euler_matrix,
    euler_omega,
    primed_matrix,
    rotation_z,
    total_derivative,
)
from rigidtop.theory.symbols import Glyph, Quantity

Meaning = Mapping[Any, Any]


def _lettered(name: str, glyph: Glyph, meaning: str = "") -> Symbol:
    return Lettered(name, Quantity(glyph, meaning, ""), real=True)


def _dotted(symbol: Symbol) -> Symbol:
    glyph = s.VOCABULARY[symbol].glyph
    return _lettered(f"{symbol.name}dot", replace(glyph, accent="dot"), f"rate of {symbol.name}")


SLOPES: Mapping[Symbol, Symbol] = {
    q: _lettered(f"dL_d{q.name}", Glyph("Ł", s.VOCABULARY[q].glyph.base)) for q in top.ANGLES
}
"""∂ℒ/∂q, as one symbol each: the reader has no partial derivatives."""

SLOPES_IN_RATES: Mapping[Symbol, Symbol] = {
    p: _lettered(f"dL_d{q.name}dot", Glyph("Đ", s.VOCABULARY[q].glyph.base))
    for p, q in zip(top.CONJUGATE, top.ANGLES, strict=True)
}
"""∂ℒ/∂q̇ likewise, by the momentum that it is."""

EXPLICIT = _lettered("dL_dt", Glyph("Ł", "t"))
"""∂ℒ/∂t: ℒ knows of time only by the angles and their rates, so this is zero."""

MOMENTUM_RATES: Mapping[Symbol, Symbol] = {p: _dotted(p) for p in top.CONJUGATE}
OTHER_RATES: Mapping[Symbol, Symbol] = {x: _dotted(x) for x in (s.L_z, s.L3, s.Omega, s.E)}
PHASE = Symbol("chi", real=True)
"""Ω_b t."""


# --- Models --------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Model:
    """Values of symbols: `meaning` in terms of the state, `rates` of what changes in time.

    `limits` are put in afterwards, one mapping after the other: what holds for the special motion.
    `words` name it.  Where the facts allow other motions besides, `branch` has those.
    """

    words: str
    meaning: Meaning
    rates: Mapping[Symbol, Expr]
    limits: tuple[Mapping[Symbol, Expr], ...] = ()
    branch: tuple[Model, ...] = ()
    lost: Expr | None = None
    """What vanishes on the branch."""
    frame: Matrix | None = None
    """Rotational velocity of the axes along which vectors are given; None where it is not said."""
    timeless: bool = False
    """Nothing is said of time: no derivative has a meaning."""
    frozen: frozenset[Symbol] = frozenset()
    """Symbols whose rate is left out: for a derivative that forgets them."""
    along: bool = False
    """Whether its accelerations are those of the motion: an identity holds for any."""

    def before_limits(self, node: Any) -> Any:
        """The value of a typed tree for the general motion; NoMeaningError if it has none."""
        return value(node, {**self.meaning, **self._of_rates(node)})

    def value(self, node: Any) -> Any:
        """The value of a typed tree: a scalar, a column or a matrix in the state's symbols."""
        return self.limited(self.before_limits(node))

    def rate(self, node: Any) -> Any:
        """The value of d/dt of a typed tree."""
        return self.limited(self._derivative(self.before_limits(node)))

    def limited(self, found: Any) -> Any:
        """A value with what holds for the special motion put in."""
        found = sympy.sympify(found)
        for limit in self.limits:
            found = found.xreplace(dict(limit))
        return found

    def _of_rates(self, node: Any) -> dict[Any, Any]:
        """The meaning of every rate in a tree, inner ones first."""
        found: dict[Any, Any] = {}
        sides = list(node) if isinstance(node, MatrixBase) else [node]
        rates = set().union(*(side.atoms(Rate) for side in sides))
        for rate in sorted(rates, key=lambda r: sympy.count_ops(r, visual=False)):
            if rate in self.meaning:
                continue
            inside = value(rate.args[0], {**self.meaning, **found})
            found[rate] = self._derivative(inside)
            if BODY in rate.args and isinstance(inside, MatrixBase):
                found[rate] -= self.meaning[s.omega_vec].cross(inside)
        return found

    def _derivative(self, expression: Any) -> Any:
        """d/dt, of vectors as seen from space."""
        if self.timeless:
            raise NoMeaningError("a rate where nothing is said of time")
        kept = {x: rate for x, rate in self.rates.items() if x not in self.frozen}
        rate = total_derivative(sympy.sympify(expression), kept)
        if not isinstance(expression, MatrixBase):
            return rate
        if self.frame is None or expression.shape != (3, 1):
            raise NoMeaningError("a rate of a vector, but not as seen from where")
        return rate + self.frame.cross(expression)

    def symbols(self) -> set[Symbol]:
        """The symbols that have a value here, those of the state among them."""
        named = {x for x in self.meaning if isinstance(x, Symbol)}
        values = [sympy.sympify(v) for v in self.meaning.values()]
        return named | set().union(*(v.free_symbols for v in values)) | {*self.rates, s.const}


@dataclass(frozen=True)
class Sample:
    """A motion in numbers: the free symbols' short values, and the value of every symbol."""

    point: Mapping[Symbol, Expr]
    meaning: Meaning


DIGITS = 30


@cache
def samples(model: Model, count: int = 30) -> tuple[Sample, ...]:
    """Motions in numbers that the facts allow, short numbers first."""
    meaning = {
        key: model.limited(found) for key, found in model.meaning.items() if not callable(found)
    }
    for symbol in sorted(model.symbols() - set(meaning) - {s.const}, key=str):
        meaning[symbol] = model.limited(symbol)
    flat = [e for v in meaning.values() for e in (list(v) if isinstance(v, MatrixBase) else [v])]
    free = sorted(set().union(*(sympy.sympify(e).free_symbols for e in flat)), key=str)
    angles = decide.angle_symbols([sympy.sympify(e) for e in flat])
    # In digits, a sine that is zero would be divided by all the same.
    points = [
        point
        for point in decide.points(free, angles, 30 * count, LETTERS.exists)
        if all(sin(2 * point[x]) != 0 for x in angles & set(point))
    ]
    found: list[Sample] = []
    # The choice of numbers widens slowly: some of the first, some of the later ones.
    for point in points[:: max(1, len(points) // (3 * count))]:
        numbers = {x: number(v) for x, v in point.items()}
        made = {k: number(sympy.sympify(v).xreplace(numbers)) for k, v in meaning.items()}
        # Where something is divided by zero, the symbols do not describe the motion.
        if all(_is_finite(v) for v in made.values()):
            found.append(Sample(dict(point), made))
        if len(found) == count:
            break
    return tuple(found)


def number(found: Any) -> Any:
    """A value in digits; an angle stays exact, so that its sine may be exactly zero."""
    if isinstance(found, MatrixBase):
        return found.applyfunc(number)
    found = sympy.sympify(found)
    return found if (found / sympy.pi).is_Rational else sympy.N(found, DIGITS)


def _is_finite(found: Any) -> bool:
    return all(e.is_finite for e in (found if isinstance(found, MatrixBase) else [found]))


# --- The top -------------------------------------------------------------------------------------

_SYMMETRIC = {s.lambda2: s.lambda1}


def _axes() -> dict[Any, Any]:
    """Unit vectors, e₁′, e₂′ and e₃ being the basis."""
    space = primed_matrix().T
    last = rotation_z(s.psi)
    return {
        s.e1p: Matrix([1, 0, 0]),
        s.e2p: Matrix([0, 1, 0]),
        s.e3: Matrix([0, 0, 1]),
        s.e1: last[:, 0],
        s.e2: last[:, 1],
        s.xhat: space[:, 0],
        s.yhat: space[:, 1],
        s.zhat: space[:, 2],
    }


@cache
def _top(on_shell: bool) -> Model:
    """The symmetric top in Euler angles; vectors along e₁′, e₂′, e₃, symbols free off shell."""
    found = dict(zip(top.ACCELERATIONS, top.symmetric_top_accelerations(), strict=True))
    accelerations = found if on_shell else {a: a for a in top.ACCELERATIONS}
    rates = {q: accelerations.get(rate, rate) for q, rate in EULER_RATES.items()}
    omega = Matrix(euler_omega("primed"))
    body = euler_omega("body")
    moments = Matrix([s.lambda1, s.lambda1, s.lambda3])
    momentum = moments.multiply_elementwise(omega)
    lagrangian, p = top.symmetric_lagrangian(), top.symmetric_momenta()
    potential = s.M * s.g * s.R * cos(s.theta)
    axes = _axes()
    torque = s.M * s.g * s.R * axes[s.zhat].cross(axes[s.e3])
    # The frame of e₁′, e₂′, e₃ turns: without ψ̇.
    frame = Matrix([omega[0], omega[1], s.phidot * cos(s.theta)])

    def seen_from_space(vector: Matrix) -> Matrix:
        return total_derivative(vector, rates) + frame.cross(vector)

    meaning: dict[Any, Any] = {
        **axes,
        s.lambda2: s.lambda1,
        s.omega1p: omega[0],
        s.omega2p: omega[1],
        s.omega1: body[0],
        s.omega2: body[1],
        s.omega3: omega[2],
        s.omega3dot: total_derivative(omega[2], rates),
        s.omega_vec: omega,
        s.L_vec: momentum,
        s.L1: s.lambda1 * body[0],
        s.L2: s.lambda1 * body[1],
        s.L_vecdot: seen_from_space(momentum),
        s.e3dot: seen_from_space(axes[s.e3]),
        s.L3: momentum[2],
        s.L_z: (axes[s.zhat].T * momentum)[0],
        s.T: lagrangian + potential,
        s.V: potential,
        s.E: lagrangian + 2 * potential,
        s.Lagrangian: lagrangian,
        **dict(zip(top.CONJUGATE, p, strict=True)),
        **{slope: lagrangian.diff(q) for q, slope in SLOPES.items()},
        EXPLICIT: Integer(0),
        **{
            pdot: total_derivative(px, rates)
            for px, pdot in zip(p, MOMENTUM_RATES.values(), strict=True)
        },
        Rate(s.L_vec): seen_from_space(momentum),
        Rate(s.L_vec, SPACE): seen_from_space(momentum),
        s.N_vec: torque,
        s.N_ext: torque,
        s.R_CM: s.R * axes[s.e3],
        s.g_vec: -s.g * axes[s.zhat],
    }
    for quantity in (s.L_z, s.L3, s.E):
        meaning[OTHER_RATES[quantity]] = total_derivative(meaning[quantity], rates)
    if on_shell:
        meaning |= accelerations
    return Model("", meaning, rates, frame=frame, along=on_shell)


def off_shell() -> Model:
    """The symmetric top whatever its accelerations are."""
    return _top(on_shell=False)


@cache
def _steady() -> Model:
    """θ is constant: φ̇ = Ω and ω₃ are too, and the torque is balanced (3.57), or sin θ = 0."""
    general = _top(on_shell=True)
    meaning = {**general.meaning, s.Omega: s.phidot, OTHER_RATES[s.Omega]: Integer(0)}
    spin = s.omega3 - s.Omega * cos(s.theta)
    at_rest: Mapping[Symbol, Expr] = {s.thetadot: Integer(0)}
    turning: Mapping[Symbol, Expr] = {s.phidot: s.Omega, s.psidot: spin}
    # Ω = 0 balances nothing, so this is every steady motion with sin θ ≠ 0.
    weight = s.M * s.g * s.R
    balanced = {s.omega3: (s.lambda1 * cos(s.theta) * s.Omega**2 + weight) / (s.lambda3 * s.Omega)}
    upright = tuple(
        replace(general, meaning=meaning, limits=(at_rest, turning, {s.theta: angle}))
        for angle in (Integer(0), sympy.pi)
    )
    return replace(
        general,
        words="θ constant",
        meaning=meaning,
        limits=(at_rest, turning, balanced),
        branch=upright,
        lost=sin(s.theta),
    )


@cache
def _roots() -> Model:
    """What ω₃ and θ say of the two rates of steady precession."""
    discriminant = (s.lambda3 * s.omega3) ** 2 - 4 * s.lambda1 * s.M * s.g * s.R * cos(s.theta)
    below = 2 * s.lambda1 * cos(s.theta)
    return Model(
        "",
        {
            s.D: discriminant,
            s.Omega_minus: (s.lambda3 * s.omega3 - sympy.sqrt(discriminant)) / below,
            s.Omega_plus: (s.lambda3 * s.omega3 + sympy.sqrt(discriminant)) / below,
        },
        {},
        timeless=True,
    )


# --- Free bodies, the simple picture, components -------------------------------------------------


@cache
def _free(symmetric: bool) -> Model:
    """Euler's equations without torque, in body components."""
    rates = dict(zip(OMEGA, body_accelerations(), strict=True))
    momentum = angular_momentum()

    def along(expression: Any) -> Any:
        return total_derivative(expression, rates)

    meaning: dict[Any, Any] = {
        s.e1: Matrix([1, 0, 0]),
        s.e2: Matrix([0, 1, 0]),
        s.e3: Matrix([0, 0, 1]),
        **dict(zip(OMEGA_DOT, body_accelerations(), strict=True)),
        s.omega1ddot: along(along(s.omega1)),
        s.omega2ddot: along(along(s.omega2)),
        s.omega_vec: Matrix(OMEGA),
        s.L_vec: momentum,
        **dict(zip((s.L1, s.L2, s.L3), momentum, strict=True)),
        s.T: kinetic_energy(),
        Rate(s.L_vec, BODY): along(momentum),
        Rate(s.L_vec, SPACE): sympy.zeros(3, 1),
        s.N_ext: sympy.zeros(3, 1),
        s.t: s.t,
    }
    model = Model("", meaning, {**rates, s.t: Integer(1)})
    if not symmetric:
        return model
    meaning[s.Omega_b] = (s.lambda1 - s.lambda3) * s.omega3 / s.lambda1
    return replace(model, words="λ₂ = λ₁", meaning=meaning, limits=(_SYMMETRIC,))


@cache
def turning() -> Model:
    """Euler's equations with any torque, in body components."""
    torque = Matrix([s.N1, s.N2, s.N3])
    free, rates = _free(symmetric=False), dict(zip(OMEGA, body_accelerations(torque), strict=True))
    omega, momentum, energy = Matrix(OMEGA), angular_momentum(), kinetic_energy()
    along = total_derivative(momentum, rates)
    kept = {x: m for x, m in free.meaning.items() if x in (s.e1, s.e2, s.e3, s.omega_vec, s.L_vec)}
    meaning: dict[Any, Any] = {
        **kept,
        **dict(zip((s.L1, s.L2, s.L3), momentum, strict=True)),
        **dict(zip(OMEGA_DOT, rates.values(), strict=True)),
        s.L: sympy.sqrt(momentum.dot(momentum)),
        s.T: energy,
        s.Tdot: total_derivative(energy, rates),
        s.L_vecdot: along + omega.cross(momentum),
        s.N_vec: torque,
        s.N_ext: torque,
    }
    return Model("", meaning, rates, frame=omega)


@cache
def _body_cone() -> Model:
    """The solution of a symmetric body that starts with ω₂ = 0, ω₁ = ω₀."""
    model = _free(symmetric=True)
    frequency = model.meaning[s.Omega_b]
    turning = {
        s.omega1: s.omega_0 * cos(PHASE),
        s.omega2: -s.omega_0 * sin(PHASE),
        s.t: PHASE / frequency,
    }
    return replace(
        model,
        words="ω₂ = 0 and ω₁ = ω₀ at t = 0",
        meaning={**model.meaning, s.omega_0: s.omega_0},
        limits=(_SYMMETRIC, turning),
    )


@cache
def _picture() -> Model:
    """3.5.2: L = λ₃ω₃e₃ turned by the torque of gravity; space components."""
    axis = Matrix([sin(s.theta) * cos(s.phi), sin(s.theta) * sin(s.phi), cos(s.theta)])
    vertical = Matrix(Z_AXIS)
    precession = s.M * s.g * s.R / (s.lambda3 * s.omega3)
    torque = s.M * s.g * s.R * vertical.cross(axis)
    turning = precession * vertical
    attitude = euler_matrix()
    meaning: dict[Any, Any] = {
        s.e1: attitude[:, 0],
        s.e2: attitude[:, 1],
        s.e3: axis,
        s.omega1: Integer(0),
        s.omega2: Integer(0),
        s.e3dot: turning.cross(axis),
        s.xhat: Matrix([1, 0, 0]),
        s.yhat: Matrix([0, 1, 0]),
        s.zhat: vertical,
        s.L_vec: s.lambda3 * s.omega3 * axis,
        s.L_vecdot: torque,
        s.omega_vec: s.omega3 * axis,
        s.N_vec: torque,
        s.N_ext: torque,
        s.R_CM: s.R * axis,
        s.g_vec: -s.g * vertical,
        s.Omega_vec: turning,
        s.Omega: precession,
        s.phidot: precession,
        s.thetadot: Integer(0),
    }
    return Model("", meaning, {s.phi: precession}, frame=sympy.zeros(3, 1))


@cache
def _components() -> Model:
    """O with e₁, e₂, e₃ as columns, and a vector that is the same in both frames."""
    attitude = euler_matrix()
    body = Matrix(sympy.symbols("r1 r2 r3", real=True))
    short = ((s.c_theta, s.s_theta), (s.c_phi, s.s_phi), (s.c_psi, s.s_psi))
    return Model(
        "",
        {
            **{cosine: cos(a) for (cosine, _), a in zip(short, top.ANGLES, strict=True)},
            **{sine: sin(a) for (_, sine), a in zip(short, top.ANGLES, strict=True)},
            s.O_matrix: attitude,
            s.unit: eye(3),
            s.r_vecp: body,
            s.r_vec: attitude * body,
            **{e: attitude[:, k] for k, e in enumerate((s.e1, s.e2, s.e3))},
            s.xhat: Matrix([1, 0, 0]),
            s.yhat: Matrix([0, 1, 0]),
            s.zhat: Matrix([0, 0, 1]),
        },
        {},
        timeless=True,
    )


# --- Passages ------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Passage:
    """To an equation, from another one.

    `models` are the facts, from the general to the special.  The goal is reached by lines that
    give its `equations` in the symbols `allowed`, `loose` being a model in which these equations
    are no identities.  `conserved` is what must be shown to be constant, `given` what is known not
    to vanish.
    """

    goal: str
    models: tuple[Model, ...]
    loose: Model
    equations: tuple[Equation, ...]
    allowed: frozenset[Symbol]
    conserved: Symbol | None = None
    given: tuple[Any, ...] = ()
    start: str = ""

    @property
    def notation(self) -> Notation:
        """The notes' letters, but only those that mean something here."""
        known = set().union(*(model.symbols() for model in self.models))
        glyphs = {x: glyph for x, glyph in NOTES.glyphs.items() if x in known}
        spellings = {g: x for g, x in NOTES.spellings.items() if x in known}
        if s.p_phi in known:
            known |= set(SLOPES_IN_RATES.values())
        made = (SLOPES, SLOPES_IN_RATES, MOMENTUM_RATES, OTHER_RATES)
        for x in (EXPLICIT, *(x for symbols in made for x in symbols.values())):
            if x in known:
                glyphs[x] = x.quantity.glyph
        return replace(NOTES, glyphs=glyphs, spellings=spellings)


def _printed(number: str) -> tuple[Equation, ...]:
    """The equations that the lecture has under a number."""
    lines = lecture().lines.values()
    [found] = [line.equations for line in lines if any(e.tag == number for e in line.equations)]
    return tuple(found)


def freed(model: Model, free: Meaning) -> Model:
    """The model without a value for what the goal is to tell."""
    return replace(model, meaning={**model.meaning, **free}, limits=model.limits, branch=())


def column(name: str) -> Matrix:
    """A vector of which nothing is known."""
    return entries(name, 3, 1)


def entries(name: str, rows: int, columns: int) -> Matrix:
    """A matrix of which nothing is known."""
    return Matrix(rows, columns, sympy.symbols(f"{name}_1:{rows * columns + 1}", real=True))


_ANGULAR = frozenset(
    {s.theta, s.phidot, s.psidot, s.thetadot, s.lambda1, s.lambda3, s.omega3, s.L3, s.p_psi}
)


def _kinematic(goal: str, free: Meaning, extra: set[Symbol]) -> Passage:
    model = _top(on_shell=False)
    return Passage(
        goal,
        (model,),
        freed(model, free),
        _printed(goal),
        _ANGULAR | frozenset(extra),
    )


def _omega_along_primed() -> Passage:
    free = {s.omega_vec: column("w")}
    axes = {s.omega_vec, s.e1p, s.e2p, s.e3, s.omega1p, s.omega2p}
    return _kinematic("3.42", free, axes)


def _momentum_along_primed() -> Passage:
    return _kinematic("3.43", {s.L_vec: column("l")}, {s.L_vec, s.e1p, s.e2p, s.e3})


def _kinetic_energy() -> Passage:
    return _kinematic("3.44", {s.T: s.T}, {s.T})


def _azimuthal_rate() -> Passage:
    model = _top(on_shell=False)
    free = {s.L_z: s.L_z, s.L3: s.L3}
    allowed = frozenset({s.phidot, s.theta, s.lambda1, s.L_z, s.L3})
    return Passage("3.45", (model,), freed(model, free), _printed("3.45"), allowed)


def _theta_equation() -> Passage:
    allowed = (_ANGULAR - {s.thetadot}) | {s.thetaddot, s.M, s.g, s.R}
    return Passage("3.54", (_top(True),), _top(on_shell=False), _printed("3.54"), allowed)


def _conserved(momentum: Symbol, goal: str) -> Callable[[], Passage]:
    def passage() -> Passage:
        loose = freed(_top(on_shell=False), {momentum: momentum})
        # L₃ is p_ψ: only another letter.
        letters = {s.L3, s.p_psi} if momentum == s.p_psi else {s.p_psi}
        allowed = (_ANGULAR - {s.thetadot} - letters) | {momentum}
        return Passage(goal, (_top(True),), loose, _printed(goal), allowed, conserved=momentum)

    return passage


def _quadratic() -> Passage:
    steady = _steady()
    # Everything but the balance of torques.
    loose = replace(steady, limits=steady.limits[:2], branch=())
    allowed = {s.lambda1, s.lambda3, s.theta, s.Omega, s.omega3, s.M, s.g, s.R}
    return Passage(
        "3.57",
        (_top(True), steady),
        loose,
        _printed("3.57"),
        frozenset(allowed | {s.phidot, s.psidot, s.L3, s.p_psi}),
        given=(Ne(s.Omega, 0),),
    )


def _two_roots() -> Passage:
    roots = {s.Omega_minus: s.Omega_minus, s.Omega_plus: s.Omega_plus}
    lines = lecture().lines.values()
    [equations] = [
        line.equations
        for line in lines
        if [e.sides[0] for e in line.equations] == [*roots] and line.equations[0].relation == "="
    ]
    model = _roots()
    allowed = {*roots, s.D, s.lambda1, s.lambda3, s.omega3, s.theta, s.M, s.g, s.R}
    models = (_top(True), _steady(), model)
    return Passage("two-roots", models, freed(model, roots), equations, frozenset(allowed))


def _euler_equations() -> Passage:
    model = _free(symmetric=True)
    loose = freed(model, {w: w for w in OMEGA_DOT})
    allowed = frozenset({s.lambda1, s.lambda3, s.Omega_b, *OMEGA, s.omega1dot, s.omega2dot})
    models = (_free(symmetric=False), model)
    return Passage("3.37", models, loose, _printed("3.37"), allowed)


def _omega_on_cone() -> Passage:
    model = _body_cone()
    w1, w2, _ = column("w")
    free = {s.omega1: w1, s.omega2: w2, s.omega_vec: Matrix([w1, w2, s.omega3])}
    allowed = frozenset({s.omega_vec, *OMEGA, s.omega_0, s.Omega_b, s.t, s.e1, s.e2, s.e3})
    models = (_free(symmetric=True), model)
    return Passage("3.38", models, freed(model, free), _printed("3.38"), allowed)


def _momentum_on_cone() -> Passage:
    model = _body_cone()
    along = column("l")
    free = {s.L_vec: along, **dict(zip((s.L1, s.L2, s.L3), along, strict=True))}
    allowed = {s.L_vec, s.L1, s.L2, s.L3, s.omega_0, s.Omega_b, s.t, s.omega3}
    return Passage(
        "3.39",
        (_free(symmetric=True), model),
        freed(model, free),
        _printed("3.39"),
        frozenset(allowed | {s.lambda1, s.lambda3, s.e1, s.e2, s.e3}),
    )


def _precession_vector() -> Passage:
    picture = _picture()
    # λ₁ is in no line of the picture: one that has it is false, not unread.
    model = replace(picture, meaning={**picture.meaning, s.lambda1: s.lambda1})
    return Passage(
        "3.52",
        (model,),
        freed(model, {s.Omega_vec: column("W")}),
        _printed("3.52"),
        frozenset({s.Omega_vec, s.zhat, s.M, s.g, s.R, s.lambda3, s.omega3}),
        given=(Ne(s.omega3, 0),),
    )


def _rotation_matrix() -> Passage:
    model = _components()
    return Passage(
        "3.46",
        (model,),
        freed(model, {s.r_vecp: column("p"), s.r_vec: column("r")}),
        _printed("3.46"),
        frozenset({s.r_vecp, s.r_vec, s.O_matrix}),
    )


GOALS: Mapping[str, Callable[[], Passage]] = {
    "3.37": _euler_equations,
    "3.38": _omega_on_cone,
    "3.39": _momentum_on_cone,
    "3.42": _omega_along_primed,
    "3.43": _momentum_along_primed,
    "3.44": _kinetic_energy,
    "3.45": _azimuthal_rate,
    "3.46": _rotation_matrix,
    "3.52": _precession_vector,
    "3.54": _theta_equation,
    "3.55": _conserved(s.p_phi, "3.55"),
    "3.56": _conserved(s.p_psi, "3.56"),
    "3.57": _quadratic,
    "two-roots": _two_roots,
}
"""Goals that may be said in other letters than those of the page, or that are no identities alone.

What else the lecture says is judged by the first of `families` in which it holds.
"""


def families() -> tuple[tuple[Model, ...], ...]:
    """The models that there are: of each kind of motion from the general to the special."""
    return (
        (_components(),),
        (_free(symmetric=False), _free(symmetric=True), _body_cone()),
        (_top(on_shell=False),),
        (_top(on_shell=True), _steady(), _roots()),
        (_picture(),),
    )
