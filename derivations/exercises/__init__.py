"""The exercises that the notes leave to their reader, solved, in reading order."""

from __future__ import annotations

from rigidtop.derivations.exercises import (
    euler_angles,
    lagrange_formalism,
    net_torque,
    rotation_matrices,
    simplified_picture,
)

EXERCISES = (
    *euler_angles.EXERCISES,
    *rotation_matrices.EXERCISES,
    *net_torque.EXERCISES,
    *simplified_picture.EXERCISES,
    *lagrange_formalism.EXERCISES,
)
"""Every exercise."""
