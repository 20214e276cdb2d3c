"""Types of the page's modules, by a tool that builds nothing, and their lines."""

from __future__ import annotations

import shutil
import subprocess

import pytest

from rigidtop.web.page import FOLDER

TSC = shutil.which("tsc")


@pytest.mark.skipif(TSC is None, reason="tsc, the compiler of TypeScript, is not installed")
def test_types():
    done = subprocess.run(
        [TSC, "-p", FOLDER / "jsconfig.json"],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.stdout == ""
    assert done.returncode == 0


@pytest.mark.skipif(TSC is None, reason="tsc, the compiler of TypeScript, is not installed")
def test_a_wrong_type_is_found(tmp_path):
    for path in FOLDER.iterdir():
        shutil.copy(path, tmp_path)
    module = tmp_path / "motion.js"
    options = tmp_path / "jsconfig.json"
    options.write_text(options.read_text("utf-8").replace('"*.js"', '"motion.js"'), "utf-8")
    text = module.read_text("utf-8")
    module.write_text(text.replace("energy: energy(all),", 'energy: "much",', 1), "utf-8")
    done = subprocess.run(
        [TSC, "-p", tmp_path / "jsconfig.json"],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert "'string' is not assignable to type 'number'" in done.stdout


def test_lines_are_no_longer_than_anywhere_else():
    for path in (*FOLDER.glob("*.js"), *FOLDER.glob("*.d.ts"), *FOLDER.glob("*.css")):
        for number, line in enumerate(path.read_text("utf-8").splitlines(), 1):
            assert len(line) <= 100, f"{path.name}:{number}"
            assert line == line.rstrip(), f"{path.name}:{number}"
