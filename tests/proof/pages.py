"""Pages in short, for tests of what becomes of their lines."""

import re

from rigidtop.derivations.letters import LETTERS
from rigidtop.notation import NOTES
from rigidtop.proof.lecture import Lecture
from rigidtop.read.page import read_lecture


def markdown(page: str) -> str:
    """A page from lines "sentence => equation"; what is indented goes on with the line above.

    A line without an arrow, such as a heading, stands as it is.
    """
    lines = (line.partition("=>") for line in re.sub(r"\n +", " ", page.strip()).splitlines())
    return "\n\n".join(
        f"{words.strip()}:\n\n$${equation.strip()}$$" if arrow else words
        for words, arrow, equation in lines
    )


def lecture(laws: str, page: str, letters=LETTERS) -> Lecture:
    """A page below laws, in the letters of the lecture."""
    return read_lecture([("laws", markdown(laws)), ("page", markdown(page))], letters, NOTES)
