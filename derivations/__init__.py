"""The lecture, a page a section of the notes, in reading order."""

from __future__ import annotations

from rigidtop.derivations import (
    euler_angles,
    eulers_equations,
    free_precession,
    lagrange_formalism,
    net_torque,
    nutation,
    opening,
    precession_of_rotation_axis,
    rotation_matrices,
    simplified_picture,
    space_and_body_frames,
)

PAGES = (
    opening.page,
    free_precession.page,
    space_and_body_frames.page,
    eulers_equations.page,
    precession_of_rotation_axis.page,
    euler_angles.page,
    rotation_matrices.page,
    net_torque.page,
    simplified_picture.page,
    lagrange_formalism.page,
    nutation.page,
)
"""Every page of the lecture."""
