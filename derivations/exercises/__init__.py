"""The exercises that the notes leave to their reader, solved, in reading order."""

from __future__ import annotations

from rigidtop.derivations.exercises import (
    euler_angles,
    eulers_equations,
    friction,
    gyroscope,
    lagrange_formalism,
    net_torque,
    nutation,
    opening,
    parallel,
    precession_of_rotation_axis,
    rotation_matrices,
    sleeping_top,
    toppling,
    toutatis,
    toy_top,
)

EXERCISES = (
    *opening.EXERCISES,
    *eulers_equations.EXERCISES,
    *precession_of_rotation_axis.EXERCISES,
    *toutatis.EXERCISES,
    *euler_angles.EXERCISES,
    *rotation_matrices.EXERCISES,
    *net_torque.EXERCISES,
    *parallel.EXERCISES,
    *toppling.EXERCISES,
    *gyroscope.EXERCISES,
    *lagrange_formalism.EXERCISES,
    *nutation.EXERCISES,
    *sleeping_top.EXERCISES,
    *friction.EXERCISES,
    *toy_top.EXERCISES,
)
"""Every exercise."""
