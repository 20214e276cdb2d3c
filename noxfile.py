#!/usr/bin/env -S uv run --script

# /// script
# dependencies = ["nox>=2025.2.9"]
# ///

"""`nox` runs lint and types; `nox -s tests-3.13`, `lowest`, `docs` and `release` are asked for."""

from pathlib import Path

import nox

nox.needs_version = ">=2025.2.9"
nox.options.default_venv_backend = "uv|virtualenv"


@nox.session(python=["3.11", "3.12", "3.13"], default=False)
def tests(session: nox.Session) -> None:
    """The tests, or those that are named behind --."""
    session.install("-e", ".[test]")
    session.run("pytest", "-q", "-n", "auto", "--dist", "loadfile", *session.posargs)


@nox.session(python="3.11", default=False)
def lowest(session: nox.Session) -> None:
    """The tests with the oldest dependencies that are said to do."""
    session.install("-e", ".", "pytest", "hypothesis", "pytest-xdist", "-c", "tests/lowest.txt")
    # What those do warn of is mended in newer ones.
    chosen = session.posargs or ["tests/theory", "tests/proof", "tests/read", "tests/motion"]
    session.run("pytest", "-q", "-n", "auto", "-o", "filterwarnings=default", *chosen)


@nox.session
def lint(session: nox.Session) -> None:
    """Style, and that generated code is what the theory gives."""
    session.install("-e", ".[web]", "ruff")
    session.run("ruff", "check", ".")
    session.run("ruff", "format", "--check", ".")
    session.run("python", "-m", "rigidtop.codegen", "--check")
    session.run("python", "-m", "rigidtop.web", "--check")


@nox.session
def types(session: nox.Session) -> None:
    """Types, strictly."""
    session.install("-e", ".[dev]")
    session.run("mypy")


@nox.session(default=False)
def docs(session: nox.Session) -> None:
    """The documentation, in out/site."""
    session.install("-e", ".[docs]")
    session.run("sphinx-build", "-W", "-b", "html", "notebooks/site", "out/site")


@nox.session(default=False)
def release(session: nox.Session) -> None:
    """The sdist and the wheel of the tag that is checked out, in dist/."""
    session.install("build", "twine")
    tag = session.run("git", "describe", "--tags", "--exact-match", external=True, silent=True)
    version = tag.strip().removeprefix("v")
    if f'\nversion = "{version}"\n' not in Path("pyproject.toml").read_text("utf-8"):
        session.error(f"pyproject.toml has another version than the tag {tag.strip()}")
    if f"\n## {version}" not in Path("CHANGELOG.md").read_text("utf-8"):
        session.error(f"CHANGELOG.md says nothing of {version}")
    session.run("python", "-m", "build")
    session.run("twine", "check", "--strict", *map(str, Path("dist").glob(f"rigidtop-{version}*")))


if __name__ == "__main__":
    nox.main()
