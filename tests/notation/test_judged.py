"""Every equation of every page, in every notation: judged anew and taken back."""

from dataclasses import replace
from itertools import cycle

import pytest
import sympy

from rigidtop.derivations import PAGES
from rigidtop.notation import BUILT_IN, named
from rigidtop.notation.judged import judgement_in
from rigidtop.proof.equation import Equation, Group, Underbrace
from rigidtop.proof.page import Definition, Step
from rigidtop.proof.verdict import Finding, judge_check
from rigidtop.theory import symbols as s

NOTATIONS = [named(name) for name in BUILT_IN if name != "notes"]
TURNED = [notation for notation in NOTATIONS if notation.sequence == "zxz"]
CLAIMS = [claim for page in PAGES for claim in page.claims]


def equation_of(item):
    if isinstance(item, Finding):
        return item.check.claimed
    return item.equation if isinstance(item, (Step, Definition)) else None


def plain(side):
    """Without brackets and braces, which are only for the page, expanded."""
    if isinstance(side, sympy.MatrixBase):
        return [plain(entry) for entry in side]
    return sympy.expand(_bare(side))


def _bare(tree):
    if isinstance(tree, (Group, Underbrace)):
        return _bare(tree.args[0])
    return tree.func(*map(_bare, tree.args)) if tree.args else tree


@pytest.mark.parametrize("notation", NOTATIONS, ids=lambda notation: notation.name)
def test_every_equation_comes_back(judgements, notation):
    seen = 0
    for judged in judgements.values():
        for item in judged.items:
            equation = equation_of(item)
            if equation is None:
                continue
            seen += 1
            back = notation.in_notes(notation.written(equation))
            assert (back.relation, back.tag) == (equation.relation, equation.tag)
            assert [plain(side) for side in back.sides] == [plain(side) for side in equation.sides]
    assert seen > 130


@pytest.mark.parametrize(("claim", "notation"), [*zip(CLAIMS, cycle(TURNED))], ids=lambda x: x.name)
def test_every_line_gets_the_same_verdict_in_its_own_symbols(judgements, claim, notation):
    """In one notation, that of the claim before in another."""
    name = claim.name
    made = judgement_in(notation, judgements[name])
    for old, new in zip(judgements[name].items, made.items, strict=True):
        if isinstance(old, Finding):
            assert judge_check(new.check).verdict == old.verdict


def test_a_sign_lost_on_the_way_would_be_seen(judgements):
    goldstein = named("goldstein")
    [line] = [i.check for i in judgement_in(goldstein, judgements["3.42"]).items]
    nodes = goldstein.letters[s.e2p]
    left, right = line.claimed.sides
    broken = Equation(left, right.xreplace({nodes: -nodes}))
    assert judge_check(line).verdict == "proved"
    assert judge_check(replace(line, claimed=broken)).verdict == "false"


def test_numbers_of_a_counterexample_are_at_the_same_attitude(judgements):
    [old] = [f.counterexample for f in judgements["3.47"].findings() if f.counterexample]
    made = judgement_in(named("goldstein"), judgements["3.47"])
    [new] = [f.counterexample for f in made.findings() if f.counterexample]
    letters = named("goldstein").letters
    assert new.values[letters[s.phi]] == old.values[s.phi] + sympy.pi / 2
    assert new.values[letters[s.psi]] == old.values[s.psi] - sympy.pi / 2
    assert new.values[s.theta] == old.values[s.theta]
