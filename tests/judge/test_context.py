"""What is known at a line: nothing stands for itself, and a moment is over with its scope."""

from rigidtop.judge.context import Context, Habits, LetterDefinition
from rigidtop.tree.nodes import Letter, Product

A, B, C, T = map(Letter, "ABCt")


def test_what_would_make_a_letter_stand_for_itself_is_over():
    context = Context(Habits()).defining(A, LetterDefinition(Product((B, T)), 0))
    context = context.defining(B, LetterDefinition(C, 1)).defining(
        C, LetterDefinition(Product((A, T)), 2)
    )
    assert {*context.definitions} == {A, C}


def test_a_moment_is_over_with_its_scope():
    context = Context(Habits()).defining(T, LetterDefinition(A, 0, (1, 2)))
    assert T in context.within((1, 2, 3)).definitions
    assert T not in context.within((1, 3)).definitions
