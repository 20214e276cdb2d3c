"""Moments that no body has, as published benchmarks use them."""

import numpy as np
import pytest

import rigidtop as rt

SIMO_WONG = {"lambda1": 5.0, "lambda3": 1.0, "M": 20.0, "R": 1.0}
"""The top of Simo and Wong, Int. J. Numer. Meth. Engng 31 (1991) 19: λ₁ = 5 about the pivot."""


def test_the_message_says_how():
    for made in (
        lambda: rt.HeavyTop(**SIMO_WONG),
        lambda: rt.FreeBody(1.0, 1.0, 3.0),
        lambda: rt.HeavyBody(5.0, 5.0, 1.0, M=20.0, centre_of_mass=(0.0, 0.1, 1.0)),
    ):
        with pytest.raises(rt.RigidtopError, match=r"\(physical=False lets them through\)$"):
            made()


def test_their_motions_are_exact_too():
    top = rt.HeavyTop(**SIMO_WONG, physical=False)
    free = rt.FreeBody(1.0, 1.5, 4.0, physical=False)
    slanting = rt.HeavyBody(5.0, 5.0, 1.0, 20.0, (0.0, 0.0, 1.0), physical=False)
    for motion in (
        top.motion(theta=0.3, omega3=50.0),
        free.motion(omega=(0.3, 0.1, 1.0)),
        slanting.motion(omega=(0.3, 0.1, 50.0)),
    ):
        exact, solved = motion.exact([0.5, 2.0]), motion.integrate([0.5, 2.0], rtol=1e-12)
        assert np.max(np.abs(exact.rotation.as_matrix() - solved.rotation.as_matrix())) < 1e-8


def test_what_is_physical_does_not_depend_on_the_switch():
    same = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5, physical=False)
    assert same == rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
    assert "physical" not in repr(same)
