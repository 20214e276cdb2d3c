"""Every claim falls when what it prints is changed."""

import pytest

from rigidtop.derivations import PAGES
from rigidtop.derivations.letters import LETTERS
from rigidtop.proof.changed import Perturbation
from rigidtop.proof.equation import Equation
from rigidtop.proof.perturb import falls, telling, upheld
from rigidtop.proof.verdict import Finding

CLAIMS = [claim.name for page in PAGES for claim in page.claims]
LEAST = 10
TOTAL = 5000


def upheld_checks(judged):
    checks = [upheld(item) for item in judged.items if isinstance(item, Finding)]
    return [check for check in checks if check is not None]


@pytest.fixture(scope="session")
def counts(judgements):
    """Changes of each claim, and those that it survives."""
    found = {}
    for name, judged in judgements.items():
        changes = [(c, change) for c in upheld_checks(judged) for change in telling(c, LETTERS)]
        survived = [
            f"{change.change} in {check.claimed.sides}"
            for check, change in changes
            if not falls(check, change, LETTERS)
        ]
        found[name] = (len(changes), survived)
    return found


@pytest.mark.parametrize("name", CLAIMS)
def test_every_change_makes_the_claim_fall(counts, name):
    changes, survived = counts[name]
    assert survived == []
    assert changes >= LEAST


def test_total(counts, record_property):
    total = sum(changes for changes, _ in counts.values())
    record_property("perturbations", total)
    assert total >= TOTAL, f"{total} perturbations of {len(counts)} claims"


def test_what_is_not_changed_does_not_fall(judgements):
    # Else the test above would pass whatever a page says.
    for judged in judgements.values():
        for check in upheld_checks(judged):
            assert not falls(check, Perturbation(check.claimed, "nothing"), LETTERS)


def test_a_rearranged_equation_does_not_fall(judgements):
    for name in ("3.54", "3.57", "3.45", "3.47"):
        for check in upheld_checks(judgements[name]):
            claimed = check.claimed
            turned = Equation(*claimed.sides[::-1], relation=claimed.relation, tag=claimed.tag)
            assert not falls(check, Perturbation(turned, "read backwards"), LETTERS)
