"""Every claim falls when what it prints is changed: else it would say nothing."""

import pytest

from rigidtop.derivations import PAGES

CLAIMS = [claim.name for page in PAGES for claim in page.claims]
TOTAL = 1300


@pytest.fixture(scope="session")
def counts(judgements, fallen):
    return {name: fallen(judged) for name, judged in judgements.items()}


@pytest.mark.parametrize("name", CLAIMS)
def test_changes_make_the_claim_fall(counts, name):
    fell, stood = counts[name]
    assert fell >= 3
    assert fell > len(stood)


def test_total(counts, record_property):
    total, stood = (sum(x) for x in zip(*((a, len(b)) for a, b in counts.values()), strict=True))
    record_property("changes", total)
    assert total >= TOTAL, f"{total} changes of {len(counts)} claims"
    assert stood < total / 8
