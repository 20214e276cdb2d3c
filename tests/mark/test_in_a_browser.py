"""A browser's Python marks as this one does: SymPy, mpmath and Lark alone, no NumPy."""

import json
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

import rigidtop
from rigidtop import derivations
from rigidtop.cli import main

PYODIDE = "pyodide@314.0.7"

ANSWER = r"""
\[ \frac{\partial\mathcal L}{\partial\dot\theta} = \lambda_1\dot\theta \]
\[ 0 = \lambda_1\Omega^2\cos\theta + \lambda_3\omega_3\Omega + MgR \]
"""
MARK = ["mark", "answer.tex", "--from", "3.53", "--to", "3.57", "--seconds", "3600", "--json"]

PAGE = """
import { loadPyodide } from "pyodide";
const [folders, words] = JSON.parse(process.argv[2]);
const python = await loadPyodide();
for (const [name, folder] of Object.entries(folders)) python.mountNodeFS("/" + name, folder);
python.globals.set("words", python.toPy(words));
python.runPython(`
import os, sys
sys.path.insert(0, "/packages")
os.chdir("/work")
from rigidtop.cli import main
main(words)
assert "numpy" not in sys.modules
`);
"""


@pytest.fixture(scope="module")
def node_modules(tmp_path_factory):
    """Where Pyodide is, installed by npm."""
    npm, folder = shutil.which("npm"), tmp_path_factory.mktemp("npm")
    if npm is None or shutil.which("node") is None:
        pytest.skip("no node, or no npm")
    command = [npm, "install", "--no-fund", "--no-audit", "--fetch-retries=0", PYODIDE]
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=60)
    except subprocess.TimeoutExpired:
        pytest.skip(f"npm does not get {PYODIDE} within a minute")
    if done.returncode:
        pytest.skip(f"npm does not get {PYODIDE}: {done.stderr.strip().splitlines()[-1]}")
    return folder


def test_a_browser_marks_the_same(node_modules, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("answer.tex").write_text(ANSWER, "utf-8")
    assert main(MARK) == 1
    here = json.loads(capsys.readouterr().out)
    assert [line["verdict"] for line in here["lines"]] == ["follows", "wrong"]

    own = node_modules / "rigidtop"
    shutil.copytree(Path(rigidtop.__file__).parent, own, dirs_exist_ok=True)
    shutil.copytree(Path(derivations.__file__).parent, own / "derivations", dirs_exist_ok=True)
    folders = {"work": str(tmp_path), "packages/rigidtop": str(own)}
    for name in ("sympy", "mpmath", "lark"):
        [folders[f"packages/{name}"]] = find_spec(name).submodule_search_locations
    page = node_modules / "page.mjs"
    page.write_text(PAGE, "utf-8")
    done = subprocess.run(
        ["node", str(page), json.dumps([folders, MARK])],
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == here


ROOMS = ("theory", "proof", "notation", "read")


def test_theory_proof_reader_and_marker_load_without_numpy():
    code = f"""
import pkgutil, sys
from importlib import import_module
sys.modules.update(dict.fromkeys(["numpy", "scipy", "matplotlib"]))
for room in map(import_module, {[f"rigidtop.{room}" for room in ROOMS]}):
    for module in pkgutil.walk_packages(room.__path__, f"{{room.__name__}}."):
        import_module(module.name)
import rigidtop.mark.limits
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
