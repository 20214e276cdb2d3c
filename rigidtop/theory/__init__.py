"""Mechanics of any Lagrangian and any body, and the top, as SymPy expressions of declared symbols.

`symbols` has each letter with its meaning and its unit.  `lagrangian` makes equations of any
L(q, q̇), `euler` those of any three moments; `rotation` and `inertia` are what both stand on, and
`top` puts them together.  Nothing here is simplified unasked, and NumPy is never loaded.

>>> from sympy import cos, symbols
>>> from rigidtop.theory.lagrangian import accelerations
>>> m, l, g, phi, phidot = symbols("m l g phi phidot", positive=True)
>>> accelerations(m*l**2*phidot**2/2 + m*g*l*cos(phi), [phi], [phidot])
Matrix([[-g*sin(phi)/l]])
"""

__all__ = ["euler", "inertia", "lagrangian", "rotation", "symbols", "top"]
