"""The arrow of imports: each room reads only the rooms before it."""

import ast
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

import rigidtop

PACKAGE = Path(rigidtop.__file__).parent
DERIVATIONS = PACKAGE.parent / "derivations"

ORDER = (
    *("errors", "trace", "parameters", "terminal"),
    *("theory", "proof", "notation", "tree", "typeset", "read", "judge", "codegen"),
    *("motion", "derivations", "figures", "report", "system", "mark", "starter"),
    *("collection", "web", "notebook", "commands", "cli", "__init__", "__main__"),
)
"""A room may import of the others those before it."""

NUMBERS = {"errors", "trace", "parameters", "terminal", "motion"}
"""Rooms that never load SymPy: they import one another alone."""

HANDS_ON = {"motion": {"figures"}}
"""What else a room may import inside a function, for a method that only hands on: `Rows.plot`."""

SYMBOLIC = {"sympy", "mpmath"}
NUMERIC = {"numpy", "scipy", "matplotlib"}
FORBIDDEN = {
    "errors": SYMBOLIC | NUMERIC,
    "theory": NUMERIC,
    "proof": NUMERIC,
    "tree": SYMBOLIC | NUMERIC,
    "judge": {"scipy", "matplotlib"},
    "typeset": NUMERIC,
    "motion": SYMBOLIC | {"matplotlib"},
    "codegen": {"matplotlib"},
    "derivations": {"matplotlib"},
    "starter": {"matplotlib"},
    "__init__": SYMBOLIC | NUMERIC,
    "__main__": SYMBOLIC | NUMERIC,
}
"""What a room may not import from outside."""


def files(room):
    if room == "derivations":
        return sorted(DERIVATIONS.rglob("*.py"))
    single = PACKAGE / f"{room}.py"
    return [single] if single.exists() else sorted((PACKAGE / room).rglob("*.py"))


def imported(tree, package):
    """The modules that a tree imports, anywhere in it, as absolute dotted names."""
    names = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            parts = package.split(".")
            base = parts[: len(parts) - node.level + 1] if node.level else []
            module = ".".join([*base, *([node.module] if node.module else [])])
            # `from rigidtop import theory` names a room too.
            names |= {module, *(f"{module}.{alias.name}" for alias in node.names)}
    return names


def without_functions(tree):
    """The statements of a module that run when it is imported."""
    return ast.Module([n for n in tree.body if not isinstance(n, ast.FunctionDef | ast.ClassDef)])


def complaints(room, text, package):
    """What is wrong with the imports and calls of a module of a room."""
    tree = ast.parse(text)
    found = []
    loaded = imported(without_functions(tree), package)
    at_once = {name.split(".")[1] for name in loaded if "." in name}
    for name in sorted(imported(tree, package)):
        top, *rest = name.split(".")
        if top in FORBIDDEN.get(room, set()):
            found.append(f"{room} imports {top}")
        allowed = {*ORDER[: ORDER.index(room) + 1], *(HANDS_ON.get(room, set()) - at_once)}
        if room in NUMBERS:
            allowed &= NUMBERS | HANDS_ON.get(room, set())
        if top == "rigidtop" and rest and rest[0] in ORDER and rest[0] not in allowed:
            found.append(f"{room} imports {rest[0]}")
    if room not in WRITERS:
        found += [
            f"{room} calls {node.func.id}"
            for node in ast.walk(tree)
            if isinstance(node, ast.Call)
            and isinstance(node.func, ast.Name)
            and node.func.id in ("eval", "exec", "compile")
        ]
    return sorted(set(found))


WRITERS = {"codegen", "trace"}
"""They run what they have written themselves."""


def package_of(room):
    return "rigidtop" if (PACKAGE / f"{room}.py").exists() else f"rigidtop.{room}"


@pytest.mark.parametrize("room", ORDER)
def test_arrow_of_imports(room):
    for file in files(room):
        assert complaints(room, file.read_text("utf-8"), package_of(room)) == [], file.name


def classes(text):
    """The names of all classes of a module, those in functions and in classes, too."""
    return [node.name for node in ast.walk(ast.parse(text)) if isinstance(node, ast.ClassDef)]


def shared(texts):
    """The names that more than one class has, with the files in which they stand."""
    homes = {}
    for file, text in texts.items():
        for name in classes(text):
            homes.setdefault(name, []).append(file)
    return {name: places for name, places in homes.items() if len(places) > 1}


def test_no_class_name_stands_twice():
    paths = {path for room in ORDER for path in files(room)}
    names = {str(path.relative_to(PACKAGE.parent)): path for path in sorted(paths)}
    assert shared({name: path.read_text("utf-8") for name, path in names.items()}) == {}


def test_a_class_name_that_stands_twice_is_seen():
    texts = {"a.py": "class Line:\n    class Row: ...", "b.py": "def f():\n    class Line: ..."}
    assert shared(texts) == {"Line": ["a.py", "b.py"]}
    assert shared({"a.py": "class Row: ...\nclass Row: ..."}) == {"Row": ["a.py", "a.py"]}


def test_every_room_is_known_and_has_modules():
    rooms = {p.stem for p in PACKAGE.iterdir() if p.suffix == ".py" or (p / "__init__.py").exists()}
    assert rooms | {"derivations"} == set(ORDER)
    assert all(files(room) for room in ORDER)


@pytest.mark.parametrize(
    ("room", "text", "complaint"),
    [
        ("theory", "import numpy as np", "theory imports numpy"),
        ("theory", "from rigidtop.proof import decide", "theory imports proof"),
        ("theory", "from rigidtop import proof", "theory imports proof"),
        ("theory", "from ..motion import top", "theory imports motion"),
        ("proof", "def f():\n    from scipy import linalg", "proof imports scipy"),
        ("proof", "from rigidtop.derivations import PAGES", "proof imports derivations"),
        ("motion", "import sympy", "motion imports sympy"),
        ("motion", "from rigidtop.codegen import shipped", "motion imports codegen"),
        ("motion", "from rigidtop.web import page", "motion imports web"),
        ("motion", "from rigidtop.theory import top", "motion imports theory"),
        ("codegen", "from rigidtop.motion import top", "codegen imports motion"),
        ("derivations", "from rigidtop.report import html", "derivations imports report"),
        ("typeset", "from rigidtop.report import html", "typeset imports report"),
        ("figures", "from rigidtop.report import report", "figures imports report"),
        ("report", "from rigidtop import cli", "report imports cli"),
        ("commands", "from rigidtop.cli import main", "commands imports cli"),
        ("report", "eval('1')", "report calls eval"),
        ("derivations", "exec('x = 1')", "derivations calls exec"),
    ],
)
def test_a_breach_is_seen(room, text, complaint):
    assert complaints(room, text, f"rigidtop.{room}") == [complaint]


ROUND = {("motion.rows", "figures.trajectories")}
"""A method that only hands on: `Rows.plot`."""


def imports():
    """Of each file of the package which others of it it imports, also for types alone."""
    known = {
        ".".join(p.relative_to(PACKAGE).with_suffix("").parts): p for p in PACKAGE.rglob("*.py")
    }
    made = {}
    for name, path in known.items():
        package = ".".join(["rigidtop", *name.split(".")[:-1]])
        found = {
            x.removeprefix("rigidtop.")
            for x in imported(ast.parse(path.read_text("utf-8")), package)
        }
        made[name] = {x for x in found & {*known} - {name} if (name, x) not in ROUND}
    return made


def test_no_files_import_one_another_in_a_circle():
    """Methods of a system import what computes: that may not import the system, not for types."""
    TopologicalSorter(imports()).prepare()  # raises CycleError, with the files


def test_neighbours_in_a_room_are_allowed():
    assert complaints("derivations", "from . import evidence", "rigidtop.derivations") == []
    assert complaints("codegen", "exec('x = 1')", "rigidtop.codegen") == []


def test_a_method_may_hand_on():
    text = "class Rows:\n    def plot(self):\n        from rigidtop.figures import trajectories"
    assert complaints("motion", text, "rigidtop.motion") == []
    assert complaints("theory", text, "rigidtop.theory") == ["theory imports figures"]


OF_EVERY_SUBJECT = {"const", "t", "unit"}
"""What stands for itself in the mechanics of anything."""


def symbols_taken(text):
    """What a module takes from the vocabulary; the whole of it is "*"."""
    found = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ImportFrom) and node.module == "rigidtop.theory.symbols":
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module == "rigidtop.theory":
            found |= {"*" for alias in node.names if alias.name == "symbols"}
        elif isinstance(node, ast.Import):
            found |= {"*" for alias in node.names if alias.name == "rigidtop.theory.symbols"}
    return found


def test_proof_knows_no_top():
    for file in files("proof"):
        text = file.read_text("utf-8")
        assert symbols_taken(text) <= OF_EVERY_SUBJECT, file.name
        others = imported(ast.parse(text), "rigidtop.proof")
        rooms = {name for name in others if name.startswith("rigidtop.theory.")}
        kept = tuple(
            f"rigidtop.theory.{room}" for room in ("symbols", "trig", "rates", "polynomial")
        )
        assert {name for name in rooms if not name.startswith(kept)} == set(), file.name


@pytest.mark.parametrize(
    "text",
    [
        "from rigidtop.theory.symbols import lambda1",
        "from rigidtop.theory import symbols as s",
        "import rigidtop.theory.symbols",
    ],
)
def test_a_top_in_proof_is_seen(text):
    assert not symbols_taken(text) <= OF_EVERY_SUBJECT
