"""`rt.System`: a Lagrangian and all that follows from it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from html import escape
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike
from sympy import Expr, Matrix

from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.system.forms import short
from rigidtop.system.friction import refuse
from rigidtop.system.linkage import Linkage, Tree
from rigidtop.system.names import Given, expression, several
from rigidtop.system.numeric import Computed
from rigidtop.system.parts import Body, Mass, potential_energy

if TYPE_CHECKING:
    from rigidtop.proof.equation import Equation
    from rigidtop.system.derivation import Derivation
    from rigidtop.system.fit import SystemFit
    from rigidtop.system.many import SystemMotions
    from rigidtop.system.motion import SystemMotion
    from rigidtop.system.steady import Small

SHOWN = 60
"""Operations in the right-hand side up to which a notebook shows the accelerations."""


@dataclass(frozen=True, repr=False, init=False)
class System(Computed):
    """A mechanical system: L(q, q̇, t), forces, constraints.

    `q` are the n coordinates: functions of time, such as SymPy's `dynamicsymbols`, or plain symbols
    with their velocities `qdot`.  `forces` are the generalised forces Q that L does not have, in
    the order of `q` or by coordinate, and a `DryFriction`.  `constraints` are expressions that
    vanish, or equations: of the coordinates (holonomic), or linear in the velocities; multipliers
    keep them.  `rayleigh` is a function ℱ(q, q̇) of which −∂ℱ/∂q̇ is a force too.

    Results are in the names that were given; each is derived when it is asked for.  Raises
    RigidtopError, in one line, for what is no system.

    >>> from sympy import cos, symbols
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> m, l, g = symbols("m l g", positive=True)
    >>> theta = dynamicsymbols("theta")
    >>> pendulum = System(m*l**2*theta.diff()**2/2 + m*g*l*cos(theta), [theta])
    >>> pendulum.accelerations
    Matrix([[-g*sin(theta(t))/l]])
    >>> pendulum.energy
    -g*l*m*cos(theta(t)) + l**2*m*Derivative(theta(t), t)**2/2
    """

    @classmethod
    def of_energies(cls, T: Given, V: Given, q: Given, qdot: Given = None, **more: Any) -> System:
        """L = T − V; `more` are `forces`, `constraints` and `rayleigh`."""
        V = expression("V", V)
        system = cls(expression("T", T) - V, q, qdot, **more)
        object.__setattr__(system, "potential", V)
        return system

    @classmethod
    def of_parts(
        cls,
        parts: Given,
        q: Given,
        qdot: Given = None,
        *,
        V: Given = 0,
        gravity: Given = None,
        **more: Any,
    ) -> System:
        """The system of masses and bodies, with places and attitudes as functions of q and t.

        A part may be a `Mechanism` too, in coordinates of which its own are some.
        `gravity` is g as a vector of 2 or 3 components, `V` what potential energy there is besides;
        `more` are `forces`, `constraints` and `rayleigh`.

        >>> from sympy import cos, sin, symbols
        >>> m, l, g, theta, omega = symbols("m l g theta omega", positive=True)
        >>> bob = Mass(m, [l*sin(theta), -l*cos(theta)])
        >>> System.of_parts(bob, theta, omega, gravity=[0, -g]).L
        g*l*m*cos(theta) + l**2*m*omega**2/2
        """
        g = Mass(1, (0, 0, 0) if gravity is None else gravity).place
        V, assemblies = expression("V", V), []
        for part in several(parts):
            if not isinstance(part, (Mass, Body, Linkage)):
                raise RigidtopError(f"a part is a Mass or a Body, not {in_one_line(part)}")
            assemblies.append(Tree(part, g) if isinstance(part, Linkage) else part)
        if gravity is not None:
            V += potential_energy([x for x in assemblies if isinstance(x, (Mass, Body))], g)
        system = cls.of_energies(0, V, q, qdot, parts=assemblies, **more)
        if any(isinstance(part, Tree) for part in assemblies):
            object.__setattr__(system, "potential", None)  # of which V is only what is besides
        return system

    def __repr__(self) -> str:
        names = self.names
        words = f"System in {', '.join(x.name for x in names.q)}"
        if self.constraints:
            words += f", {len(self.constraints)} constraints"
        parameters = ", ".join(x.name for x in self.parameters)
        return f"<{words}; parameters {parameters}>" if parameters else f"<{words}>"

    def _repr_latex_(self) -> str:
        return f"$${self.latex()}$$"

    def _repr_html_(self) -> str:
        """The same with MathML, for notebooks."""
        from rigidtop.typeset.mathml import display

        return f"<p>{escape(repr(self))}</p>\n{display(self._shown)}"

    def latex(self) -> str:
        """L, the equations of motion and constraints, in amsmath's ``aligned``, where not long."""
        from rigidtop.typeset.latex import latex

        lines = (" &= ".join(map(latex, row.sides)) for row in self._shown)
        return r"\begin{aligned}" + r" \\ ".join(lines) + r"\end{aligned}"

    @cached_property
    def _shown(self) -> list[Equation]:
        """L, and the accelerations where there are some and they are short."""
        from rigidtop.proof.equation import Equation
        from rigidtop.theory.symbols import Lagrangian

        rows = [Equation(Lagrangian, self.plain)]
        try:
            if self.program.operations <= SHOWN:
                right = self.names.plain(self.accelerations)
                rows += map(Equation, self.names.a, right)
        except RigidtopError:
            pass  # L alone is what there is to see
        return [*rows, *(Equation(rule, 0) for rule in self.rules)]

    def derivation(self, section: str = "") -> Derivation:
        """The way from L to the equations of motion by lines and moves, judged and typeset.

        Equations have the numbers 1, 2, …, or those of a `section`: 3.1, 3.2, ….

        >>> from sympy import symbols
        >>> m, k = symbols("m k", positive=True)
        >>> x, v = symbols("x v", real=True)
        >>> way = System(m*v**2/2 - k*x**2/2, [x], [v]).derivation()
        >>> way
        <Derivation: 11 lines, all follow>
        """
        from rigidtop.system.derivation import derivation

        return derivation(self, section)

    # --- steady motions, other ways ---------------------------------------------------------------

    @cached_property
    def balance(self) -> Matrix:
        """∂L/∂q + Q + Σ λA where all velocities vanish (n×1): zero at an equilibrium."""
        from rigidtop.system.steady import balance

        return self.names.back(balance(self).applyfunc(short))

    def equilibria(self) -> tuple[dict[Expr, Expr], ...]:
        """Where the system stays at rest, as SymPy solves it: the coordinates that are not free.

        Angles of 0 and π, which SymPy may lose, are tried besides where there are no constraints,
        and parts of a turn everywhere; angles are from 0 to 2π where they are numbers.
        Raises RigidtopError where SymPy does not, and for constraints of velocities.

        >>> from sympy import cos, symbols
        >>> m, l, g = symbols("m l g", positive=True)
        >>> theta, w = symbols("theta w", real=True)
        >>> System(m*l**2*w**2/2 + m*g*l*cos(theta), [theta], [w]).equilibria()
        ({theta: 0}, {theta: pi})
        """
        from rigidtop.system.steady import equilibria

        refuse(self.friction, "equilibria", "it rests within a band, |force| ≤ μₛN")
        return equilibria(self)

    def small(self, about: Mapping[Expr, object]) -> Small:
        """Small deviations from a steady motion: matrices, frequencies, stability.

        `about` gives the steady values of coordinates and velocities; velocities that are not given
        are zero.  With constraints of coordinates they are the deviations of as many coordinates as
        are free.  Raises RigidtopError where that is no steady motion.
        """
        from rigidtop.system.steady import small

        refuse(self.friction, "small deviations")
        return small(self, about)

    def linearise(
        self, at: Mapping[Expr, object], inputs: Expr | Sequence[Expr] = ()
    ) -> tuple[Matrix, Matrix]:
        """A and B of ẋ = A x + B u near a steady motion, x the deviations of (q, q̇).

        `at` gives the steady values of coordinates and velocities, and of inputs and parameters
        where they have any; velocities and inputs that are not given are zero.  `inputs` are
        letters of the forces or of L.  With constraints x has the coordinates and the velocities
        that are independent: of those that a constraint ties together the first follows the others.
        Raises RigidtopError where that is no steady motion.

        >>> from sympy import cos, symbols
        >>> m, l, g = symbols("m l g", positive=True)
        >>> theta, w, N = symbols("theta w N", real=True)
        >>> bob = System(m*l**2*w**2/2 + m*g*l*cos(theta), [theta], [w], forces=[N])
        >>> bob.linearise(at={theta: 0}, inputs=[N])
        (Matrix([
        [   0, 1],
        [-g/l, 0]]), Matrix([
        [         0],
        [1/(l**2*m)]]))
        """
        from rigidtop.system.linear import linearise

        refuse(self.friction, "a linearisation")
        return linearise(self, at, inputs)

    def certify(self, parameters: Mapping[Expr, Any], seed: int = 0) -> dict[str, float]:
        """How far other ways to q̈ are from the program, at most, at states that are drawn.

        "Hamilton" by H(q, p); "Newton–Euler" by d'Alembert's principle and "Lagrange" by L, where
        the system was made of parts; "balance of energy" is dE/dt less the power of the forces.
        The places of the parts, their rates and the solver are the program's own in the two ways
        from parts, whose balances alone are others: of a wrong place they say nothing.
        Differences are relative; all are rounding where all is well.  Raises RigidtopError where
        there is no other way.
        """
        from rigidtop.system.certify import certify

        return certify(self, parameters, seed)

    def source(self, language: str, name: str = "accelerations") -> str:
        """A file with one function of t, q, q̇ and the parameters, which gives q̈ and multipliers.

        The time and parameters that do not enter are left out.  `language` is "c", "fortran",
        "julia", "javascript", "octave" or "python"; the comment says what goes in and what comes
        out.  Raises RigidtopError for another.

        >>> from sympy import symbols
        >>> m, k = symbols("m k", positive=True)
        >>> x, v = symbols("x v", real=True)
        >>> print(System(m*v**2/2 - k*x**2/2, [x], [v]).source("c"))    # doctest: +ELLIPSIS
        /*
        ...
        void accelerations(double x, double v, double k, double m, double *out)
        {
            out[0] = -k*x/m;
        }
        <BLANKLINE>
        """
        from rigidtop.system.source import source

        return source(self, language, name)

    # --- motions ----------------------------------------------------------------------------------

    def motion(
        self, parameters: Mapping[Expr, object] | None = None, q: Given = None, qdot: Given = None
    ) -> SystemMotion:
        """The motion from an initial state at t = 0.

        `parameters` gives a number for each of `self.parameters`, by symbol or by name.  `q` and
        `qdot` are rows of n numbers in the order of the coordinates, one number where n = 1, or
        mappings from coordinates; velocities that are not given are zero.  Raises RigidtopError
        where a number is missing, or a constraint does not hold.
        """
        from rigidtop.system.motion import started

        return started(self, parameters, q, qdot)

    def motions(
        self, parameters: Mapping[Expr, object] | None = None, q: Given = None, qdot: Given = None
    ) -> SystemMotions:
        """Many motions: as `motion`, with arrays that broadcast in the place of numbers.

        >>> from sympy import symbols
        >>> m, k = symbols("m k", positive=True)
        >>> x, v = symbols("x v", real=True)
        >>> springs = System(m*v**2/2 - k*x**2/2, [x], [v]).motions({m: 1, k: [1, 4, 9]}, [1])
        >>> len(springs), springs.integrate([0, 1]).shape
        (3, (2, 3, 2, 1))
        """
        from rigidtop.system.many import many

        return many(self, parameters, q, qdot)

    def fit(
        self,
        t: ArrayLike,
        measured: Mapping[Expr, ArrayLike],
        parameters: Mapping[Expr, object] | None = None,
        start: Mapping[Expr, object] | None = None,
        known: Mapping[Expr, object] | None = None,
        sigma: Given = None,
        starts: int = 8,
        method: str | None = None,
        rtol: float = 1e-9,
        atol: float = 1e-11,
    ) -> SystemFit:
        """The parameters, and the start, with which the motion fits measurements best.

        `t` (s) are N times that increase; the start is that at t = 0.  `measured` has N numbers for
        each quantity that was measured: coordinates, or expressions of q, q̇, t and the parameters.

        `parameters` are those that are looked for, with a value to start from or a pair (low, high)
        between which the search begins, and `known` has the numbers of all others.  `start` has
        coordinates and velocities at t = 0 that are known, or such a pair; those that it leaves out
        are found too.  The search begins at so many places as `starts` says and goes on through
        windows of the time that double, so that it does not end in a wrong number of turns.

        Noise is independent from row to row, with the standard deviation `sigma`, a number or one
        for each quantity; without it, its size is that of the residuals of each quantity.
        `method`, `rtol` and `atol` are those of the motions; see `SystemMotion.sensitivities`.

        Raises RigidtopError for what can't be known from the measurements, and names it, and for a
        force that jumps, of which there are no derivatives.

        >>> import numpy as np
        >>> from sympy import symbols
        >>> m, k, c = symbols("m k c", positive=True)
        >>> x, v = symbols("x v", real=True)
        >>> spring = System(m*v**2/2 - k*x**2/2, [x], [v], rayleigh=c*v**2/2)
        >>> t = np.linspace(0, 10, 101)
        >>> data = spring.motion({m: 0.5, k: 8, c: 0.1}, q=1.0).integrate(t).q[:, 0]
        >>> data += 0.01*np.random.default_rng(1).normal(size=101)
        >>> fit = spring.fit(t, {x: data}, {k: (1, 30), c: (0, 1)}, start={v: 0}, known={m: 0.5})
        >>> print(f"{fit.parameters[k]:.3f} ± {fit.errors['k']:.3f}")
        8.001 ± 0.002
        """
        from rigidtop.system.fit import fitted

        refuse(self.friction, "a fit")
        how = vars(self.numeric.accuracy(method, rtol, atol))
        return fitted(self, t, measured, parameters, start, known, sigma, starts, how)
