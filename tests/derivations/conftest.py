"""Every claim of the lecture, judged once for all tests."""

import pytest

from rigidtop.derivations import PAGES
from rigidtop.derivations.letters import LETTERS
from rigidtop.proof.verdict import Judgement, judge_page


@pytest.fixture(scope="session")
def judgements() -> dict[str, Judgement]:
    """Judgements by the claim's name, in reading order."""
    return {judged.claim.name: judged for page in PAGES for judged in judge_page(page, LETTERS)}
