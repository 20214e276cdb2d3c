"""The folder of a collection as a module; what is wrong in it, in one line with its place."""

from __future__ import annotations

import hashlib
import importlib.util
import sys
import traceback
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, redirect_stdout
from dataclasses import replace
from functools import wraps
from pathlib import Path
from types import ModuleType
from typing import Any, get_args

from sympy.core.relational import Relational

from rigidtop.collection.kinds import a
from rigidtop.errors import RigidtopError
from rigidtop.proof.independence import refuse_circular
from rigidtop.proof.page import Assumption, Check, Claim, Evidence, Measure, by_lines


class PageError(Exception):
    """A claim of a collection that breaks.  The message is one line with file and line number."""


def module_name(folder: Path) -> str:
    """A name that nothing else has, so that no module is shadowed, whatever the folder's name."""
    path = str(folder.resolve()).encode("utf-8", "surrogateescape")
    return f"_rigidtop_collection_{hashlib.sha256(path).hexdigest()[:16]}"


def imported(folder: Path) -> ModuleType:
    name, root = module_name(folder), folder.resolve()
    _forget(name)  # it may have been changed
    importlib.invalidate_caches()
    spec = importlib.util.spec_from_file_location(
        name, root / "__init__.py", submodule_search_locations=[str(root)]
    )
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # for imports with a dot
    try:
        with redirect_stdout(sys.stderr):  # stdout is for results
            spec.loader.exec_module(module)
    except BaseException:
        _forget(name)
        raise
    return module


def _forget(name: str) -> None:
    for module in [m for m in sys.modules if m == name or m.startswith(f"{name}.")]:
        del sys.modules[module]


@contextmanager
def in_one_line(folder: Path) -> Iterator[None]:
    try:
        yield
    except RigidtopError:
        raise
    except (Exception, SystemExit) as error:
        if isinstance(error, (OSError, SystemExit)) and _place(error, folder) is None:
            raise  # of the terminal or the disk, not of the folder
        raise RigidtopError(said(error, folder)) from None


def said(error: BaseException, folder: Path, default: str = "") -> str:
    """File, line, kind of error and its message, in one line."""
    words = " ".join(str(getattr(error, "msg", "") or error).split())
    words = words.replace(module_name(folder), folder.resolve().name)
    if isinstance(error, ModuleNotFoundError) and error.name:
        own = folder / error.name.partition(".")[0]
        if own.is_dir() or own.with_suffix(".py").is_file():
            words += f"; a file of the folder is imported with a dot: from .{own.name} import …"
    place = _place(error, folder) or default or str(folder)
    return f"{place}: {type(error).__name__}: {words}".rstrip(": ")


def _place(error: BaseException, folder: Path) -> str | None:
    """The innermost line of the folder that an error comes from, or None."""
    places = [(f.filename, f.lineno) for f in traceback.extract_tb(error.__traceback__)]
    if isinstance(error, SyntaxError):
        places.append((error.filename or "", error.lineno))
    for filename, line in reversed(places):
        path = _shown(filename, folder)
        if path:
            return f"{path}, line {line}"
    return None


def _shown(filename: str, folder: Path) -> str:
    """The path of a file of the folder, as the folder was named; "" for another file."""
    try:
        return str(folder / Path(filename).resolve().relative_to(folder.resolve()))
    except ValueError:
        return ""


# --- Claims, watched -----------------------------------------------------------------------------


def watched(claim: Claim, folder: Path) -> Claim:
    """The claim, whose errors say where they are: raises PageError while it is judged."""
    if claim.evidence is by_lines:
        return claim

    @wraps(claim.evidence)
    def evidence() -> Iterator[Evidence]:
        evidence: Any = None
        try:
            evidence = claim.evidence()
            if not isinstance(evidence, Iterable):
                raise TypeError(f"{claim.name} yields nothing")
            for item in evidence:
                sound = _sound(item)
                if isinstance(sound, Check):
                    refuse_circular(sound, evidence, claim.evidence)
                yield sound
        except Exception as error:
            raise PageError(said(error, folder, _stands(claim, evidence, folder))) from error

    return replace(claim, evidence=evidence)


def _stands(claim: Claim, evidence: Any, folder: Path) -> str:
    """Where a claim has come to, or else where it begins."""
    code = getattr(claim.evidence, "__code__", None)
    if code is None:
        return ""
    frame = getattr(evidence, "gi_frame", None)
    line = code.co_firstlineno if frame is None else frame.f_lineno
    return f"{_shown(code.co_filename, folder)}, line {line}"


def _sound(item: Any) -> Evidence:
    """What a claim yields, if it is evidence; raises TypeError."""
    if not isinstance(item, get_args(Evidence)):
        raise TypeError(f"{a(item)} is no Step, Check, Definition or Measure")
    if isinstance(item, Measure):  # a number of another kind is not printed as one
        return replace(item, error=float(item.error), tolerance=float(item.tolerance))
    if isinstance(item, Check):
        if not isinstance(item.assuming, tuple):
            raise TypeError(f"assuming is {a(item.assuming)}, not a tuple: (x,) has a comma")
        for assumption in item.assuming:
            if not isinstance(assumption, Assumption):
                raise TypeError(f"{a(assumption)} is no Assumption")
            if not isinstance(assumption.condition, Relational):
                raise TypeError(f"the assumption is {assumption.condition}: it says nothing")
    sound: Evidence = item
    return sound
