"""Hamilton's and Routh's functions of a system, and what follows from them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import sympy
from sympy import Expr, Integer, Matrix, Rational

from rigidtop.codegen.points import points
from rigidtop.errors import RigidtopError
from rigidtop.proof import decide
from rigidtop.system.derived import Derived
from rigidtop.system.forms import over, parts_of, readable, short
from rigidtop.system.names import expression, own_functions
from rigidtop.theory import lagrangian as mechanics


@dataclass(frozen=True, repr=False, init=False)
class Canonical(Derived):
    """Besides, what is derived in coordinates and momenta."""

    @cached_property
    def _velocities(self) -> dict[Expr, Expr]:
        """Each velocity q̇ as a function of q and p, in plain symbols."""
        names = self.names
        still = dict.fromkeys(names.v, Integer(0))
        try:
            self.program  # noqa: B018 - raises where the mass matrix is singular
            if not self._balance[0].has(*names.v):
                moved = [p - x.subs(still) for p, x in zip(names.p, self.conjugate, strict=True)]
                velocities = over(self._balance[0], moved)
                if velocities:
                    return dict(zip(names.v, velocities, strict=True))
            return mechanics.inverse_momenta(self.plain, names.v, names.p)
        except ValueError as error:
            raise RigidtopError(str(error)) from None

    @cached_property
    def hamiltonian(self) -> Expr:
        """H(q, p, t) = Σ p q̇ − L, with the letters `p`; without the constraints.

        >>> from sympy import symbols
        >>> from rigidtop import System
        >>> m, k = symbols("m k", positive=True)
        >>> x, v = symbols("x v", real=True)
        >>> System(m*v**2/2 - k*x**2/2, [x], [v]).hamiltonian
        k*x**2/2 + p_x**2/(2*m)
        """
        return self.names.back(self.reduced_hamiltonian)

    @cached_property
    def reduced_hamiltonian(self) -> Expr:
        """The Hamiltonian H(q, p, t), in plain symbols."""
        names = self.names
        if self._balance[0].has(*names.v):
            turned = sympy.Add(*(p * v for p, v in zip(names.p, names.v, strict=True)))
            return readable((turned - self.plain).xreplace(self._velocities))
        # ½ (p − a)·q̇ − L₀, where L = ½ q̇·Mq̇ + a·q̇ + L₀
        still = dict.fromkeys(names.v, Integer(0))
        kinetic = [
            (p - x.subs(still)) * self._velocities[v] / 2
            for p, x, v in zip(names.p, self.conjugate, names.v, strict=True)
        ]
        parts = parts_of(self._balance[0].applyfunc(short))
        together = [readable(sympy.Add(*(kinetic[k] for k in part))) for part in parts]
        return sympy.Add(*together, -sympy.expand(self.plain.subs(still)))

    @cached_property
    def hamilton_equations(self) -> Matrix:
        """q̇ = ∂H/∂p and ṗ = −∂H/∂q + Q + Σ λA (2n×1), the coordinates first."""
        names = self.names
        equations = mechanics.hamilton_equations(self.reduced_hamiltonian, names.q, names.p)
        acting = Matrix(self.generalised_forces) + self.reactions
        pushed = Matrix([*(0 * acting), *acting]).xreplace(self._velocities)
        return names.back((equations + pushed).applyfunc(sympy.factor_terms))

    def poisson(self, first: Expr, second: Expr) -> Expr:
        """The bracket {f, g} = Σ ∂f/∂q ∂g/∂p − ∂f/∂p ∂g/∂q of quantities of q, q̇ and p.

        What comes out has q and p.

        >>> from sympy import symbols
        >>> from rigidtop import System
        >>> m = symbols("m", positive=True)
        >>> x, y, u, v = symbols("x y u v", real=True)
        >>> free = System(m*(u**2 + v**2)/2, [x, y], [u, v])
        >>> p_x, p_y = free.p
        >>> free.poisson(x, p_x), free.poisson(x*p_y - y*p_x, p_x)
        (1, p_y)
        """
        names = self.names
        f, g = (self._own(expression("the quantity", each)) for each in (first, second))
        f, g = (x.xreplace(self._velocities) if x.has(*names.v) else x for x in (f, g))
        pairs = zip(names.q, names.p, strict=True)
        bracket = [f.diff(x) * g.diff(p) - f.diff(p) * g.diff(x) for x, p in pairs]
        return names.back(readable(sympy.Add(*bracket)))

    @cached_property
    def routhian(self) -> Expr:
        """L − Σ p q̇ over the cyclic coordinates, their velocities given by the constant `p`."""
        return self.names.back(self._routhian)

    @cached_property
    def _routhian(self) -> Expr:
        names = self.names
        chosen = [k for k, x in enumerate(self.q) if x in self.cyclic]
        if not chosen:
            return self.plain
        velocities, momenta = ([group[k] for k in chosen] for group in (names.v, names.p))
        try:
            return readable(mechanics.routhian(self.plain, velocities, momenta))
        except ValueError as error:
            raise RigidtopError(str(error)) from None

    @cached_property
    def effective_potential(self) -> Expr:
        """Minus the Routhian where the velocities of the other coordinates vanish."""
        return self.names.back(-self._routhian.subs(dict.fromkeys(self.names.v, 0)))

    def rate(self, quantity: Expr) -> Expr:
        """d/dt of a quantity (of q, q̇, p and t) along the motion."""
        names = self.names
        plain = self.quantity(expression("the quantity", quantity))
        motion = dict(zip(names.a, self.program.written_out(), strict=False))
        rates = {x: rate.xreplace(motion) for x, rate in names.rates.items()}
        return names.back(readable(names.rate(plain, rates)))

    def is_conserved(self, quantity: Expr) -> bool:
        """Whether a quantity is constant along every motion, shown symbolically.

        Raises RigidtopError where it is neither shown nor refuted.

        >>> from sympy import symbols
        >>> from rigidtop import System
        >>> m, k = symbols("m k", positive=True)
        >>> x, y, u, v = symbols("x y u v", real=True)
        >>> well = System(m*(u**2 + v**2)/2 - k*(x**2 + y**2)/2, [x, y], [u, v])
        >>> well.is_conserved(x*v - y*u), well.is_conserved(x*v + y*u)
        (True, False)
        """
        rate = self.names.plain(self.rate(quantity))
        if decide.vanishes(rate):
            return True
        if self.constraints:
            raise RigidtopError(
                "that it changes where the constraints do not hold tells nothing: see drift()"
            )
        unknown = any(own_functions([rate]))
        for point in () if unknown else points(sorted(rate.free_symbols, key=str)):
            value = sympy.N(rate.xreplace(point), 50)
            if value.is_comparable and abs(value) > Rational(1, 10**30):
                return False
        raise RigidtopError(
            "its rate is zero, or not real, wherever it was tried: neither shown nor refuted"
        )
