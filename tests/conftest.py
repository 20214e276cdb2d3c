"""Times are measured by the benchmarks, never by a test; draws are the same in every run."""

import signal
from dataclasses import replace

import pytest
from hypothesis import settings

# What lands has passed what is run again.
settings.register_profile("same", deadline=None, derandomize=True)
# Other draws each time: `pytest --hypothesis-profile=other`.
settings.register_profile("other", deadline=None, derandomize=False)
settings.load_profile("same")

# Programs: what they need is long to load, and they have no examples in their words.
collect_ignore = ["benchmarks", "motion/reference"]

LONGEST = 240
"""Seconds; a test that has not ended by then fails."""


class Endless(BaseException):
    """No Exception, so that neither what is tested nor Hypothesis takes it for its own."""


class Alarm:
    """Ends what hangs, in the doctests too, which no fixture of this folder reaches."""

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item):
        def ring(number, frame):
            raise Endless(f"no end after {LONGEST} s")

        before = signal.signal(signal.SIGALRM, ring)
        signal.setitimer(signal.ITIMER_REAL, LONGEST)
        try:
            return (yield)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)


def pytest_configure(config):
    if hasattr(signal, "setitimer"):
        config.pluginmanager.register(Alarm())


@pytest.fixture(scope="session")
def judged():
    """The pages of the lecture, each with its judgements, for all tests of a worker."""
    from rigidtop.derivations import PAGES
    from rigidtop.derivations.letters import LETTERS
    from rigidtop.proof.verdict import judge

    return [
        (page, tuple(judge(claim, page.section, letters=LETTERS) for claim in page.claims))
        for page in PAGES
    ]


@pytest.fixture(scope="session")
def judgements(judged):
    """Judgements by the claim's name, in reading order."""
    return {each.claim.name: each for _, row in judged for each in row}


@pytest.fixture(scope="session")
def fallen():
    """Of changes of what a judgement upholds, each third: how many are refuted, and what stands.

    What stands may say the same (0 = −a), or what holds besides (0 = a²): of a check that holds
    whatever it prints nothing falls.
    """
    from rigidtop.derivations.letters import LETTERS
    from rigidtop.proof.changed import Perturbation, perturbations
    from rigidtop.proof.counterexample import is_refuted
    from rigidtop.proof.equation import Equation, NoMeaningError
    from rigidtop.proof.verdict import Finding, Verdict

    def refuted(check):
        try:
            return is_refuted(check, 40, LETTERS)
        except (NoMeaningError, TypeError, AttributeError, ValueError):
            return None  # ∫ρ² d³r is nothing that a body has, the square of a vector no vector

    def tried(judged):
        fell, stood = 0, []
        for finding in (item for item in judged.items if isinstance(item, Finding)):
            check = finding.check
            if finding.verdict is Verdict.CONVENTION and check.other_reading is not None:
                check = replace(check, meaning=check.other_reading, other_reading=None)
            elif finding.verdict not in (Verdict.PROVED, Verdict.SAMPLED, Verdict.ASSUMING):
                continue
            assert not refuted(check)
            claimed = check.claimed
            opposite = {"≠": "=", ">": "<", "<": ">"}.get(claimed.relation)
            # In an order that does not hang on how they are found.
            every = perturbations(claimed, LETTERS.families)
            changes = sorted(every, key=lambda change: change.change)[::3]
            if opposite is not None:  # it stays true under many changes but this one
                turned = Equation(*claimed.sides, relation=opposite)
                changes = (Perturbation(turned, f"{opposite} for {claimed.relation}"),)
            for change in changes:
                found = refuted(replace(check, claimed=change.equation))
                fell += found is True
                stood += [change.change] if found is False else []
        return fell, stood

    return tried
