"""Principal moments and axes of a body whose inertia tensor is known in other axes."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import linear_sum_assignment
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.motion.attitude import Floats
from rigidtop.motion.rigid import Triple

WRITTEN = 1e-9
"""So much, of the largest entry, may entries differ that a table gives twice."""


def principal(tensor: ArrayLike) -> tuple[Triple, Rotation]:
    """Principal moments, and the right-handed axes that belong to them, of a tensor (3, 3).

    The rotation takes components along the principal axes to those of the tensor.  Each axis is
    numbered and directed as the one of the tensor's that it is nearest to.  Raises RigidtopError
    for a tensor that is not symmetric, or has a moment that is not positive.
    """
    entries = checks.numbers("I", tensor)
    if entries.shape != (3, 3):
        raise RigidtopError(f"I must be a tensor of shape (3, 3), not {entries.shape}")
    skew = np.abs(entries - entries.T)
    if skew.max() > WRITTEN * np.abs(entries).max():
        row, column = sorted(divmod(int(skew.argmax()), 3))
        raise RigidtopError(
            f"I must be symmetric: I[{row}][{column}] = {entries[row, column]:g}, but "
            f"I[{column}][{row}] = {entries[column, row]:g}"
        )
    moments, axes = np.linalg.eigh((entries + entries.T) / 2)
    if moments[0] <= checks.TOLERANCE * np.abs(moments).max():
        listed = ", ".join(f"{moment:.4g}" for moment in moments)
        raise RigidtopError(
            f"the principal moments of I are {listed}, and each must be positive; products of "
            "inertia stand in I with a minus sign, -∫xy dm"
        )
    first, second, third = moments[_nearest(axes)].tolist()
    return (first, second, third), Rotation.from_matrix(_right_handed(axes[:, _nearest(axes)]))


def _nearest(axes: Floats) -> list[int]:
    """Which of the columns is nearest to the first, the second and the third axis."""
    order: list[int] = linear_sum_assignment(-np.abs(axes))[1].tolist()
    return order


def _right_handed(axes: Floats) -> Floats:
    """The columns, each directed as the axis of its number, as far as the hand allows."""
    along = np.diag(axes)
    directed: Floats = axes * np.where(along < 0, -1.0, 1.0)
    if np.linalg.det(directed) < 0:
        directed[:, np.abs(along).argmin()] *= -1
    return directed
