"""Where a text comes to another case."""

import pytest

from rigidtop.read.cases import cases


@pytest.mark.parametrize(
    ("text", "paths"),
    [
        ("x\n# A\n x \n## B\n x", [(0,), (1,), (2,)]),
        ("\\section{A} x \\section*{B} x", [(1,), (2,)]),
        (
            "# A\nx\n\n- x\n- x\n  1. x\n  2. x\n- x\n\nWords x",
            [(1,), (1, 2), (1, 3), (1, 3, 4), (1, 3, 5), (1, 6), (1,)],
        ),
        (
            "x\\begin{enumerate}x\\item x\\item x\\begin{itemize}\\item x\\end{itemize}x"
            "\\end{enumerate}x",
            [(0,), (0,), (0, 2), (0, 3), (0, 3, 5), (0, 3), (0,)],
        ),
        (
            "# A\nx\n(a) x\n**(b)** x\n\\paragraph{C} x\n**Problem 2.** x\n# B\nx",
            [(1,), (1, 2), (1, 3), (1, 4), (1, 5), (2,)],
        ),
        ("# A\n\n| x | x |\n| x |\n\nNow x <tr><td>x", [(1, 2), (1, 2), (1, 3), (1,), (1, 5)]),
        ("$$a\n + x$$ x\n", [(0,), (0,)]),
        ("\\begin{document}\n- x\n- x", [(0,), (0,)]),
    ],
)
def test_a_place_lies_in_a_path_of_cases(text, paths):
    where = cases(text)
    assert [where(i) for i, sign in enumerate(text) if sign == "x"] == paths
