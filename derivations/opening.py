"""Opening of chapter 3.2: two point masses on a stick."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Integer, Matrix, Ne, cos, pi, sin

from rigidtop.proof.page import Assumption, Evidence, Formal, Page, claim
from rigidtop.theory import symbols as s
from rigidtop.theory.rotation import Z_AXIS, rotation_z
from rigidtop.theory.trig import reduce_trig

from .printed import printed

STICK = Matrix([0, sin(s.alpha), cos(s.alpha)])

TILTED = Assumption(
    Ne(sin(s.alpha), 0), r"the stick is tilted against $\boldsymbol\omega$", stated=True
)
TURNING = Assumption(Ne(s.omega, 0), "the masses move", stated=True)
OBLIQUE = Assumption(
    Ne(cos(s.alpha), 0), r"the stick is not at right angles to $\boldsymbol\omega$"
)


def angular_momentum(turn: Matrix) -> Matrix:
    """Σ m r × (ω × r) of both masses, after the stick has been turned (3×1)."""
    spin = s.omega * Matrix(Z_AXIS)
    positions = ((s.M_1, s.a * turn * STICK), (s.M_2, -s.b * turn * STICK))
    total = sum((m * r.cross(spin.cross(r)) for m, r in positions), Matrix([0, 0, 0]))
    return reduce_trig(total, keep="sin")


@claim(
    "two-mass-points",
    r"For two point masses on a stick tilted to $\boldsymbol\omega$, $\mathbf L$ is not parallel "
    r"to $\boldsymbol\omega$ and lies in the plane of the masses and $\boldsymbol\omega$; with "
    r"$\boldsymbol\omega$ constant $\mathbf L$ would turn, so $\boldsymbol\omega$ must change when "
    "the body is free.",
)
def two_mass_points() -> Iterator[Evidence]:
    r"""$\mathbf L = \sum m \mathbf r \times (\boldsymbol\omega \times \mathbf r)$ has a part
    across $\boldsymbol\omega$, which half a turn with constant $\boldsymbol\omega$ would reverse.

    For points exactly on a line that does not make $\boldsymbol\omega$ change: the part of
    $\boldsymbol\omega$ along the stick moves nothing, and the rest can stay constant along
    $\mathbf L$.
    """
    before = angular_momentum(rotation_z(Integer(0)))
    meaning = {
        s.L_vec: before,
        s.L_later: angular_momentum(rotation_z(pi)),
        s.omega_vec: s.omega * Matrix(Z_AXIS),
        s.r_1: s.a * STICK,
        s.xhat: Matrix([1, 0, 0]),
        s.yhat: Matrix([0, 1, 0]),
        s.zhat: Matrix(Z_AXIS),
    }
    moment = s.M_1 * s.a**2 + s.M_2 * s.b**2
    momentum = printed(
        r"\mathbf L = (M_1a^2 + M_2b^2)\omega\sin\alpha(\sin\alpha\hat{\mathbf z}"
        r" - \cos\alpha\hat{\mathbf y})"
    )
    yield Formal(momentum, meaning)
    tilted = (TILTED, TURNING, OBLIQUE)
    yield Formal(printed(r"\mathbf L\times\boldsymbol\omega \neq 0"), meaning, tilted)
    yield Formal(printed(r"\mathbf L_{\text{later}} \neq \mathbf L"), meaning, tilted)
    yield Formal(
        printed(
            r"\boldsymbol\omega\times\mathbf r_1 \neq \boldsymbol\omega_{\perp}\times\mathbf r_1"
        ),
        {
            **meaning,
            s.omega_perp: before / moment,
            s.r_1: s.a * STICK + s.radius * Matrix([1, 0, 0]),
        },
        (
            TURNING,
            OBLIQUE,
            Assumption(
                Ne(s.radius, 0),
                "the stick is thick enough to show a turn about itself",
            ),
        ),
    )


page = Page(
    "3.2 (opening)",
    "Two masses on a stick",
    r"Why a rotation axis that is not parallel to $\mathbf L$ can't stay where it is.",
    (two_mass_points,),
    text="opening",
)
