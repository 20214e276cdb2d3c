"""All that the notebooks of the lecture use, at one line: ``from rigidtop.notebook import *``.

The letters of the notes, SymPy's functions, NumPy as np, rigidtop as rt, pictures and sliders.  In
Jupyter symbols then print as in the notes, and ``%%answer`` marks a cell.
"""
# ruff: noqa: F401, F403 - names are here to be taken along; letters win over names of SymPy

from datetime import datetime

import numpy as np
from IPython.core.getipython import get_ipython as _shell
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation
from sympy import (
    Function,
    Matrix,
    Poly,
    Rational,
    cos,
    diag,
    diff,
    dsolve,
    eye,
    factor,
    factor_terms,
    lambdify,
    pi,
    series,
    simplify,
    sin,
    solve,
    sqrt,
    symbols,
)

import rigidtop as rt
from rigidtop.derivations import toutatis
from rigidtop.figures.cones import draw_cones
from rigidtop.figures.nutation import draw_path, draw_regimes, nutation_times
from rigidtop.figures.potential import draw_effective_potential
from rigidtop.figures.precession import draw_precession_rates
from rigidtop.figures.style import FIRST, GREY, SECOND, THIRD
from rigidtop.mark.cell import load_ipython_extension as _load
from rigidtop.proof.equation import Equation
from rigidtop.report.notebook import enable, figure, plot, sliders, solution, steps, verdict
from rigidtop.theory.euler import (
    OMEGA,
    along_flow,
    angular_momentum,
    body_accelerations,
    kinetic_energy,
)
from rigidtop.theory.inertia import cone
from rigidtop.theory.lagrangian import accelerations, cyclic
from rigidtop.theory.rotation import rotation_x
from rigidtop.theory.symbols import *
from rigidtop.theory.top import steady_expansions, steady_quadratic, top_effective_potential
from rigidtop.theory.trig import reduce_ratio, reduce_trig

if _shell() is not None:
    enable()
    _load(_shell())
