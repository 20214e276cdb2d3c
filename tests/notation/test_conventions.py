"""The change of Euler angles is proved, and it is the one that notations make."""

import pytest
import sympy

from rigidtop.collection import built_in
from rigidtop.commands import claims
from rigidtop.derivations.conventions import ANGLES, CONVENTIONS, e1x, e2x, phi_x, psi_x
from rigidtop.derivations.letters import LETTERS
from rigidtop.notation import GOLDSTEIN
from rigidtop.proof.verdict import judge
from rigidtop.theory import symbols as s

CLAIMS = [claim for page in CONVENTIONS for claim in page.claims]


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.name)
def test_proved(claim):
    judged = judge(claim, "3.3", letters=LETTERS)
    assert (judged.verdict, judged.problem) == ("proved", "")


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.name)
def test_changes_of_a_line_are_noticed(claim, fallen):
    fell, stood = fallen(judge(claim, letters=LETTERS))
    # The cosine of an angle does not know its sign; the potential is left as it is.
    assert fell > max(15, 5 * len(stood))


def test_the_angles_proved_are_those_that_notations_write():
    letters = GOLDSTEIN.letters
    assert GOLDSTEIN.written(ANGLES[phi_x]) == letters[s.phi]
    assert GOLDSTEIN.written(ANGLES[psi_x]) == letters[s.psi]
    assert GOLDSTEIN.written(s.e2p) == letters[s.e1p]  # e1x
    assert GOLDSTEIN.written(-s.e1p) == letters[s.e2p]  # e2x
    assert (e1x.quantity.glyph.bold, e2x.quantity.glyph.sub) == (True, "2x")


def test_the_other_direction_is_refuted():
    wrong = {phi_x: s.phi - sympy.pi / 2, psi_x: s.psi + sympy.pi / 2}
    from rigidtop.theory.rotation import euler_matrix, rotation_x, rotation_z

    turned = rotation_z(wrong[phi_x]) * rotation_x(s.theta) * rotation_z(wrong[psi_x])
    assert turned - euler_matrix() != sympy.zeros(3)


def test_commands_find_them_but_the_lecture_does_not_count_them():
    names = [claim.name for claim in CLAIMS]
    collection = built_in()
    assert [claim.name for _, claim in claims.named(collection, names)] == names
    assert not set(names) & {claim.name for _, claim in claims.every(collection)}
