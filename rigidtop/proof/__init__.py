"""Lines that follow from lines, and claims that are judged; it knows mechanics, and no top.

A `derivation.Line` says what it comes from and by which move, and the move is performed on what it
cites alone; `lecture` has the lines of pages, and what rests on what.  Besides, a `page` makes
claims, each with its evidence, and `verdict` judges them by what the evidence leaves over:

>>> from sympy import cos, sin, symbols
>>> from rigidtop.proof.equation import Equation
>>> from rigidtop.proof.page import Check
>>> from rigidtop.proof.verdict import judge_check
>>> theta, E, m = symbols("theta E m", real=True)
>>> judge_check(Check(Equation(E, m), {E: m*sin(theta)**2 + m*cos(theta)**2})).verdict.value
'proved'
>>> found = judge_check(Check(Equation(E, m), {E: m*sin(theta)**2}))
>>> found.verdict.value, found.counterexample is not None
('false', True)
"""

__all__ = ["derivation", "lecture", "page", "verdict"]
