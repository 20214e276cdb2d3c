"""Theory, proof and reader load without NumPy, as in a browser's Python that has not fetched it."""

import subprocess
import sys

ROOMS = ("theory", "proof", "notation", "tree", "read")


def test_theory_proof_and_reader_load_without_numpy():
    code = f"""
import pkgutil, sys
from importlib import import_module
sys.modules.update(dict.fromkeys(["numpy", "scipy", "matplotlib"]))
for room in map(import_module, {[f"rigidtop.{room}" for room in ROOMS]}):
    for module in pkgutil.walk_packages(room.__path__, f"{{room.__name__}}."):
        import_module(module.name)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
