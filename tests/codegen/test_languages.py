"""What is written in other languages compiles, and evaluates to what Python evaluates to."""

from __future__ import annotations

import json
import math
import re
import shutil
import subprocess
from functools import cache

import numpy as np
import pytest
from sympy import (
    Abs,
    Add,
    Matrix,
    Rational,
    Symbol,
    cos,
    expand,
    lambdify,
    pi,
    simplify,
    sin,
    sqrt,
    symbols,
    zeros,
)

from rigidtop.codegen import shipped
from rigidtop.codegen.languages import LANGUAGES, Source, function_name, source
from rigidtop.codegen.values import ClaimLine, ClaimOutputs, NothingToEvaluateError, Output, values
from rigidtop.commands.derive import SOURCES
from rigidtop.derivations import PAGES
from rigidtop.proof.equation import Equation
from rigidtop.proof.page import Check, Correction, claim
from rigidtop.proof.verdict import judge
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.euler import body_accelerations
from rigidtop.theory.rotation import euler_matrix
from rigidtop.typeset.text import text

NOTHING = {"principal-axes", "3.35", "same-frequency", "free-fall", "z-hat"}
"""The claims between vectors, and those that something vanishes or differs."""

STATES = 6
ULPS = 8


@cache
def everything() -> dict[str, ClaimOutputs]:
    """Every claim that has something to evaluate, by name."""
    found = {}
    for page in PAGES:
        for each in page.claims:
            try:
                found[each.name] = values(judge(each, page.section))
            except NothingToEvaluateError:
                assert each.name in NOTHING
    return found


def by_hand(expressions, name="by-hand"):
    """Expressions that no claim has."""
    made = [Output(f"y{i}", e, Equation(s.E, e)) for i, e in enumerate(expressions, 1)]
    free = sorted(set().union(*(e.free_symbols for e in expressions)), key=str)
    lines = tuple(ClaimLine(v.equation) for v in made)
    return ClaimOutputs(name, "Made for a test.", tuple(made), tuple(free), lines)


a, b, M, m, out, lambda_, x0 = symbols("a b M m out lambda X0")
AWKWARD = by_hand(
    [
        a**2 / 2 - b / 3 + Rational(1, 3),
        sqrt(a) / b**3 + a**5 + b ** Rational(3, 2) + 1 / sqrt(2 * a + 1),
        -Rational(3, 4) * Abs(a - b) * (M - m) ** 2 / (out * lambda_ + M),
        pi * sin(a + b) ** 2 / (x0 * (1 + cos(a) ** 2)) + sqrt(2) * sin(a + b),
        x0 - 2 * (a - b) ** -2,
        sum(k * sin(k * a) * cos((k + 1) * b) * M for k in range(1, 30)),
    ],
    "awkward",
)
"""Fractions, roots, names that are words of a language or differ by case only, a long sum."""


@cache
def programs() -> tuple[ClaimOutputs, ...]:
    return (*everything().values(), AWKWARD)


@cache
def written(language: str) -> tuple[Source, ...]:
    return tuple(source(made, language, text) for made in programs())


@cache
def states() -> tuple[np.ndarray, ...]:
    """Numbers for the arguments of each program, a row a state."""
    rng = np.random.default_rng(20)
    light = {"M", "g", "R"}  # the top spins fast enough for its roots to be real

    def column(symbol):
        low, high = (
            (0.1, 0.4)
            if symbol.name in light
            else (3, 5)
            if symbol.name == "omega3"
            else (0.3, 1.2)
        )
        return rng.uniform(low, high, STATES)

    return tuple(np.array([column(x) for x in made.arguments]).T for made in programs())


@cache
def expected() -> tuple[np.ndarray, ...]:
    """What the Python files give."""
    found = []
    for file, rows in zip(written("python"), states(), strict=True):
        names: dict = {}
        exec(file.text, names)
        function = names[name_in(file)]
        found.append(np.array([function(*row.tolist()) for row in rows]))
    return tuple(found)


def name_in(file: Source) -> str:
    return function_name(file.name)


@cache
def rounding() -> tuple[np.ndarray, ...]:
    """One unit in the last place of each value, or of the largest of the terms that it sums."""
    found = []
    for made, rows in zip(programs(), states(), strict=True):
        sizes = [sum(map(Abs, Add.make_args(expand(v.expression)))) for v in made.outputs]
        size = lambdify(made.arguments, sizes, "math", cse=True)
        found.append(np.array([np.spacing(np.array(size(*row), dtype=float)) for row in rows]))
    return tuple(found)


def worst(numbers) -> float:
    """The largest difference from Python, in units of rounding."""
    wanted, unit = (np.concatenate([x.ravel() for x in xs]) for xs in (expected(), rounding()))
    return float(np.max(np.abs(np.array(list(numbers)) - wanted) / unit))


def run(*command: object) -> str:
    done = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, check=False, timeout=120
    )
    assert done.returncode == 0, done.stderr[:3000]
    return done.stdout


def needs(program: str) -> str:
    if shutil.which(program) is None:
        pytest.skip(f"there is no {program}")
    return program


def calls(language: str):
    """Each function with each of its states."""
    for file, rows in zip(written(language), states(), strict=True):
        for row in rows:
            yield file, [repr(x) for x in row.tolist()]


# --- Compiled and run ----------------------------------------------------------------------------


def run_c(folder, text_of=lambda file: file.text) -> str:
    main = [
        f"    {name_in(file)}({', '.join(row)}, out);\n"
        f'    for (i = 0; i < {len(file.returns)}; i++) printf("%.17g\\n", out[i]);'
        for file, row in calls("c")
    ]
    lines = [
        *map(text_of, written("c")),
        "#include <stdio.h>",
        "int main(void)\n{\n    double out[32];\n    int i;",
        *main,
        "    return 0;\n}",
    ]
    (folder / "all.c").write_text("\n".join(lines) + "\n", "utf-8")
    strict = ("-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror")
    run(needs("gcc"), *strict, folder / "all.c", "-o", folder / "all", "-lm")
    return run(folder / "all")


def test_c(tmp_path):
    assert worst(map(float, run_c(tmp_path).split())) < ULPS


def test_a_wrong_sign_in_c_is_seen(tmp_path):
    def turned(file: Source) -> str:
        if file.name != "3.56":
            return file.text
        assert "cos(theta) + psidot" in file.text
        return file.text.replace("cos(theta) + psidot", "cos(theta) - psidot")

    assert worst(map(float, run_c(tmp_path, turned).split())) > 1e6


def test_fortran(tmp_path):
    uses = [f"  use {name_in(file)}_module" for file in written("fortran")]
    main = []
    for file, row in calls("fortran"):
        numbers = ", &\n      ".join(f"{x}_real64" for x in row)
        main.append(f"  call {name_in(file)}( &\n      {numbers}, out)")
        main.append(f"  write (*, '(es25.17e3)') out(1:{len(file.returns)})")
    lines = [
        *(file.text for file in written("fortran")),
        "program all",
        *uses,
        "  use, intrinsic :: iso_fortran_env, only: real64",
        "  implicit none",
        "  real(real64) :: out(32)",
        *main,
        "end program all",
    ]
    (tmp_path / "all.f90").write_text("\n".join(lines) + "\n", "utf-8")
    strict = ("-std=f2018", "-Wall", "-Werror")
    run(needs("gfortran"), *strict, "-J", tmp_path, tmp_path / "all.f90", "-o", tmp_path / "all")
    assert worst(map(float, run(tmp_path / "all").split())) < ULPS


def test_javascript(tmp_path):
    for file in written("javascript"):
        (tmp_path / "one.js").write_text(file.text, "utf-8")
        if file.name in ("3.54", "awkward"):
            run(needs("node"), "--check", tmp_path / "one.js")
    main = [f"all.push(...{name_in(f)}({', '.join(row)}));" for f, row in calls("javascript")]
    files = [file.text for file in written("javascript")]
    lines = ['"use strict";', *files, "const all = [];", *main, "console.log(JSON.stringify(all));"]
    (tmp_path / "all.js").write_text("\n".join(lines) + "\n", "utf-8")
    assert worst(json.loads(run(needs("node"), tmp_path / "all.js"))) < ULPS


def test_octave_over_arrays(tmp_path):
    needs("octave-cli")
    lines = ["1;", *(file.text for file in written("octave"))]
    for file, rows in zip(written("octave"), states(), strict=True):
        columns = ", ".join(f"[{' '.join(map(repr, x))}]" for x in rows.T.tolist())
        names = [f"r{i}" for i in range(len(file.returns))]
        lines.append(f"[{', '.join(names)}] = {name_in(file)}({columns});")
        lines += [f"{name} = {name} + zeros(1, {STATES});" for name in names]
        lines.append(f'printf("%.17g\\n", [{"; ".join(names)}]);')
    (tmp_path / "all.m").write_text("\n".join(lines) + "\n", "utf-8")
    done = run("octave-cli", "--norc", "--no-gui", tmp_path / "all.m")
    assert worst(map(float, done.split())) < ULPS


def test_julia_reads_as_python():
    """The part of Julia that is written here is Python with ^ for ** and // for a fraction."""
    found = []
    for file, rows in zip(written("julia"), states(), strict=True):
        lines = [line for line in file.text.splitlines() if not line.startswith("#")]
        assert lines[0].startswith(f"function {name_in(file)}(")
        assert lines[-1] == "end"
        assert not any(word in line for line in lines for word in (".*", "./", ".^", "**"))
        signature, inside = "\n".join(lines[:-1]).removeprefix("function").split(")\n", 1)
        python = f"def{signature}):\n{inside}\n"
        names: dict = {"sin": math.sin, "cos": math.cos, "sqrt": math.sqrt, "pi": math.pi}
        python = python.replace("^", "**").replace(" // ", "/")
        exec(re.sub(r"\blambda\b", "lambda_", python), names)
        found += [x for row in rows for x in names[name_in(file)](*row.tolist())]
    assert worst(found) < ULPS


def test_julia(tmp_path):
    needs("julia")
    main = [f"foreach(println, {name_in(f)}({', '.join(row)}))" for f, row in calls("julia")]
    lines = [*(file.text for file in written("julia")), *main]
    (tmp_path / "all.jl").write_text("\n".join(lines) + "\n", "utf-8")
    assert worst(map(float, run("julia", tmp_path / "all.jl").split())) < ULPS


# --- What is evaluated ---------------------------------------------------------------------------


def expressions(name: str) -> dict:
    return {value.name: value.expression for value in everything()[name].outputs}


def test_the_numbered_equations_have_something_to_evaluate():
    numbered = {name for name in everything() if name[0] == "3"}
    assert numbered == {f"3.{k}" for k in range(33, 58)} - {"3.35"}
    count = sum(len(page.claims) for page in PAGES)
    assert len(everything()) == count - len(NOTHING)


def test_3_54_is_a_whole_system():
    made = everything()["3.54"]
    assert [value.name for value in made.outputs] == ["thetaddot", "phiddot", "psiddot"]
    assert tuple(value.expression for value in made.outputs) == shipped.derived(
        "top_in_euler_angles"
    )
    assert " ".join(x.name for x in made.arguments) == (
        "theta thetadot phidot psidot lambda1 lambda3 M g R"
    )


def test_what_is_printed_is_solved_for_what_it_names():
    for ours, theirs in zip(expressions("3.36").values(), body_accelerations(), strict=True):
        assert simplify(ours - theirs) == 0
    # Lagrange's equations for φ and ψ combined, against the system solved at once
    assert simplify(expressions("constant-rate")["phiddot"] - expressions("3.54")["phiddot"]) == 0


def test_momenta_are_constant_along_the_accelerations():
    rates = dict(zip(top.RATES, expressions("3.54").values(), strict=True))
    for name, momentum in (("3.55", "p_phi"), ("3.56", "p_psi")):
        conserved = expressions(name)[momentum]
        flow = conserved.diff(s.theta) * s.thetadot
        flow += sum(conserved.diff(x) * rate for x, rate in rates.items())
        assert simplify(flow) == 0


def test_both_roots_make_the_residual_vanish():
    residual = expressions("3.57")["residual"]
    for root in expressions("two-roots").values():
        assert simplify(residual.subs(s.Omega, root)) == 0
    lines = source(everything()["two-roots"], "julia", text).text.splitlines()
    [slow] = [i for i, line in enumerate(lines) if line.startswith("# Ω₋ = ")]
    assert lines[slow + 1] == "#   For ω₃ > 0; regular at cos θ = 0."


def test_a_condition_stands_with_the_line_that_needs_it():
    made = source(everything()["3.40"], "julia", text).text
    assert "# τ_b = 2π/Ω_b\n#   if Ω_b > 0 ((λ₁ − λ₃)ω₃ > 0: a long body" in made
    assert "Holds if" not in made


def test_a_limit_is_said_to_be_one():
    made = source(everything()["fast-is-free"], "c", text).text
    assert "ε → 0 (ω₃ very large: to leading order in ε" in " ".join(made.split())
    assert "epsilon → 0 (ω₃ very large" in source(everything()["fast-is-free"], "c").text


@claim("corrected", "E = 2T, which is false.")
def corrected():
    meaning = {s.E: (s.T**2 / 2).diff(s.T)}
    yield Check(Equation(s.E, 2 * s.T), meaning)
    yield Correction(Equation(s.E, s.T + s.V - s.V), meaning)


def test_what_is_refuted_is_not_written():
    [energy] = values(judge(corrected)).outputs
    assert energy.expression == s.T


def test_a_refuted_matrix_gives_way_to_the_corrected_one():
    matrix = Matrix(3, 3, list(expressions("3.47").values()))
    assert simplify(matrix - euler_matrix()) == zeros(3, 3)
    assert list(expressions("3.47"))[:4] == [
        "O_matrix11",
        "O_matrix12",
        "O_matrix13",
        "O_matrix21",
    ]
    for name in everything():
        corrected = name in ("3.47", "inertia-full")
        assert ("Corrected: the notes" in source(everything()[name], "c").text) == corrected


def test_body_to_space_and_back():
    to_body = Matrix(list(expressions("3.46").values()))
    there = dict(zip(everything()["3.46"].arguments[3:], expressions("3.34").values(), strict=True))
    assert simplify(to_body.subs(there, simultaneous=True)) == Matrix(symbols("r1:4", real=True))


def test_scalars_that_a_page_defines_by_each_other_stay_arguments():
    assert [x.name for x in everything()["3.45"].arguments] == ["theta", "L_z", "L3", "lambda1"]


@pytest.mark.parametrize("name", sorted(NOTHING))
def test_nothing_to_evaluate_is_said_in_one_line(name):
    [wanted] = [each for page in PAGES for each in page.claims if each.name == name]
    with pytest.raises(
        NothingToEvaluateError, match=rf"^{name} has no expression to evaluate; .*$"
    ):
        values(judge(wanted))


# --- How it is written ---------------------------------------------------------------------------


def test_the_command_line_knows_the_languages():
    assert tuple(LANGUAGES) == SOURCES
    with pytest.raises(ValueError, match="no language 'cobol': python, c, fortran, julia"):
        source(AWKWARD, "cobol")


def test_names_that_a_language_cannot_tell_apart_or_reserves():
    plain = ("M", "X0", "a", "b", "lambda", "m", "out")
    assert source(AWKWARD, "javascript").arguments == plain
    assert source(AWKWARD, "fortran").arguments == ("M", "X0", "a", "b", "lambda", "m_", "out_")
    assert source(AWKWARD, "python").arguments == ("M", "X0", "a", "b", "lambda_", "m", "out")
    assert source(AWKWARD, "c").arguments == ("M", "X0", "a", "b", "lambda", "m", "out_")
    made = by_hand([Symbol("end") + Symbol("in") + Symbol("double") + Symbol("\u03b8")])
    for language, words in (
        ("julia", ("double", "end_", "in_", "x_")),  # nothing may be read from _
        ("octave", ("double", "end_", "in", "x_")),
        ("c", ("double_", "end", "in", "x_")),
    ):
        assert source(made, language).arguments == words


@pytest.mark.parametrize("language", LANGUAGES)
def test_lines_are_short_and_the_text_is_always_the_same(language):
    for file, made in zip(written(language), programs(), strict=True):
        assert max(map(len, file.text.splitlines())) <= 100
        assert not any(line != line.rstrip() for line in file.text.splitlines())
        assert source(made, language, text) == file


def test_the_comment_says_what_goes_in_and_what_comes_out():
    comment = """\
// equation_3_43: L along the axes after two turns.
//
// L = (−λ₁φ̇ sin θ)e₁′ + λ₁θ̇e₂′ + (λ₃(ψ̇ + φ̇ cos θ))e₃, with λ₃(ψ̇ + φ̇ cos θ) ≡ L₃
// Components with e₁′ = (1, 0, 0), e₂′ = (0, 1, 0), e₃ = (0, 0, 1).
// Holds if λ₂ = λ₁ (a symmetric top).
//
// Takes numbers, in this order:
//   theta     θ, second Euler angle: polar angle of e₃ (rad)
//   thetadot  θ̇, rate of θ: nutation (rad/s)
//   phidot    φ̇, rate of φ: precession (rad/s)
//   psidot    ψ̇, rate of ψ (rad/s)
//   lambda1   λ₁, principal moment of inertia about e₁ (kg m²)
//   lambda3   λ₃, principal moment of inertia about e₃ (kg m²)
// Returns an array of 3 numbers:
//   L_vec1  component 1 of L, angular momentum (J s)
//   L_vec2  component 2 of L, angular momentum (J s)
//   L_vec3  component 3 of L, angular momentum (J s)
function"""
    assert source(everything()["3.43"], "javascript", text).text.startswith(comment)
