"""The bridge, the only one, from derived expressions to functions of numbers.

`numpy` makes a function of floats and of arrays; `languages` writes a claim's right-hand sides as
source, in C, Fortran, JavaScript, Julia, Octave and Python.

>>> from sympy import cos, symbols
>>> from rigidtop.codegen.numpy import function
>>> m, g, l, theta = symbols("m g l theta")
>>> potential = function([-m*g*l*cos(theta)], [m, g, l, theta], "potential")
>>> potential(1.0, 9.81, 2.0, 0.0)
(-19.62,)
>>> potential(1.0, 9.81, [1.0, 2.0], 0.0)
array([[ -9.81, -19.62]])
"""

__all__ = ["languages", "numpy"]
