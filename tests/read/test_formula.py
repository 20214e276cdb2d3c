"""What is printed reads back, what can't be read says where, and nothing is evaluated."""

import pytest

from rigidtop.derivations import PAGES
from rigidtop.present.latex import latex
from rigidtop.proof.page import Check, Definition, Step
from rigidtop.read.formula import read


def equations():
    for page in PAGES:
        for claim in page.claims:
            for item in claim.evidence():
                if isinstance(item, Check):
                    yield claim.name, item.claimed
                elif isinstance(item, (Definition, Step)):
                    yield claim.name, item.equation


@pytest.mark.parametrize(("name", "equation"), list(equations()), ids=lambda x: str(x)[:20])
def test_what_is_printed_reads_back(name, equation):
    printed = latex(equation)
    [line] = read(printed)
    assert line.problem == ""
    assert latex(line.equation, "typed") == printed
