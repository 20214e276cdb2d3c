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
