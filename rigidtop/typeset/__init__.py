"""An equation, a sentence or a table becomes layout, then LaTeX, MathML or text on a line.

>>> from rigidtop.theory.symbols import R, M, g, theta
>>> from sympy import cos
>>> from rigidtop.typeset.latex import latex
>>> from rigidtop.typeset.text import text
>>> latex(M*g*R*cos(theta)), text(M*g*R*cos(theta))
('MgR\\\\cos\\\\theta', 'MgR cos θ')
"""

__all__ = ["latex", "mathml", "text"]
