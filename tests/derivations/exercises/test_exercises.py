"""Every exercise: claims hold and can fall, measures pass, numbers depend on what is set."""

import math
import re
from importlib.resources import files
from itertools import zip_longest

import pytest

from rigidtop.derivations import PAGES, lecture, lecture_with
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.notation import NOTES
from rigidtop.parameters import settings
from rigidtop.proof.exercise import Answer, Table, texts
from rigidtop.proof.page import Measure, by_lines
from rigidtop.proof.verdict import Verdict, judge
from rigidtop.read.page import read_exercises
from rigidtop.report import claims as printed_claims
from rigidtop.report.records import record as claim_record

NAMES = [exercise.name for exercise in EXERCISES]
OF_THE_NOTES = {claim.name for page in PAGES for claim in page.claims}
NEW_CLAIMS = {
    claim.name: claim
    for exercise in EXERCISES
    for claim in exercise.claims
    if claim.name not in OF_THE_NOTES
}


@pytest.fixture(scope="module")
def solved():
    """What each exercise yields as it is set."""
    return {each.name: tuple(each.solve(**settings(each.parameters))) for each in EXERCISES}


def numbers(outcomes):
    """Every number of a solution."""
    for outcome in outcomes:
        if isinstance(outcome, Answer):
            yield outcome.value
        elif isinstance(outcome, Table):
            yield from (cell for row in outcome.rows for cell in row)


def test_names_are_told_apart_and_claims_have_one_home():
    assert len(set(NAMES)) == len(NAMES)
    assert not set(NAMES) & (OF_THE_NOTES | set(NEW_CLAIMS))
    of_pages = {id(claim) for page in PAGES for claim in page.claims}
    for exercise in EXERCISES:
        for claim in exercise.claims:
            assert id(claim) in of_pages or claim is NEW_CLAIMS[claim.name]


def test_a_claim_that_its_lines_show_holds_under_their_conditions():
    lines = lecture_with(["exercises/fast_spin_roots", "exercises/gyroscope"])
    claims = NEW_CLAIMS["roots-in-powers"], NEW_CLAIMS["disc-on-an-arm"]
    with_conditions, inherited = (judge(claim, lecture=lines) for claim in claims)
    assert with_conditions.verdict is Verdict.ASSUMING
    kept = [str(item.assumption.condition) for item in printed_claims.tested(with_conditions)]
    assert "Ne(cos(theta), 0)" in kept
    assert "omega3 > 0" in kept
    assert claim_record(with_conditions)["note"].startswith("holds if ")
    # (3.52), on which it rests, divides by ω₃, and its own line by r.
    kept = [str(item.assumption.condition) for item in printed_claims.tested(inherited)]
    assert (inherited.verdict, kept) == (Verdict.ASSUMING, ["Ne(omega3, 0)", "Ne(radius, 0)"])


@pytest.mark.parametrize("exercise", EXERCISES, ids=NAMES)
def test_texts_show_its_claims(exercise):
    """Its own, or that of another exercise that has the claim too."""
    folder = files("rigidtop.derivations")
    read = [folder.joinpath(f"{x}.md").read_text("utf-8") for x in texts([exercise], EXERCISES)]
    shown = {name for text in read for name in re.findall(r'<a id="([^"]+)">', text)}
    assert {claim.name for claim in exercise.claims} & {*NEW_CLAIMS} <= shown


def test_the_lines_of_its_solution_show_a_claim():
    assert all(claim.evidence is by_lines for claim in NEW_CLAIMS.values())
    claim, name = NEW_CLAIMS["disc-on-a-stem"], "exercises/toy_box"
    judged = judge(claim, lecture=lecture_with([name]))
    assert (judged.verdict, judged.problem) == (Verdict.PROVED, "")
    assert judge(claim).verdict is Verdict.UNDECIDED
    text = files("rigidtop.derivations").joinpath(f"{name}.md").read_text("utf-8")
    wrong = [(name, text.replace(r"\tfrac13M_sl_s^2", r"\tfrac14M_sl_s^2"))]
    fallen = judge(claim, lecture=read_exercises(wrong, lecture(), NOTES))
    assert fallen.verdict is Verdict.UNDECIDED
    assert "does not follow" in fallen.problem


@pytest.mark.parametrize("exercise", EXERCISES, ids=NAMES)
def test_numbers_are_finite_and_agree(exercise, solved):
    outcomes = solved[exercise.name]
    named = [o.name for o in outcomes if not isinstance(o, Measure)]
    assert len(set(named)) == len(named)
    assert any(isinstance(outcome, Measure) for outcome in outcomes)
    for outcome in outcomes:
        if isinstance(outcome, Measure):
            assert outcome.passed, outcome
            assert outcome.tolerance > 0
    assert all(math.isfinite(x) for x in numbers(outcomes) if not isinstance(x, str))


@pytest.mark.parametrize(
    ("exercise", "parameter"),
    [pytest.param(e, p, id=f"{e.name}-{p.name}") for e in EXERCISES for p in e.parameters],
)
def test_every_parameter_matters(exercise, parameter, solved):
    changed = parameter.default * 1.03 or 0.03
    after = exercise.solve(**settings(exercise.parameters, {parameter.name: changed}))
    # A generator: nothing is computed behind the first number that differs.
    before = numbers(solved[exercise.name])
    assert any(new != old for new, old in zip_longest(numbers(after), before))
