"""What the language server tells an editor, asked by a client of the protocol."""

import asyncio
import json
import sys
from contextlib import asynccontextmanager, suppress
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lsprotocol import types as lsp
from pygls.lsp.client import LanguageClient

import rigidtop.commands.editor
import rigidtop.judge.text
from rigidtop.cli import main
from rigidtop.collection import built_in
from rigidtop.commands.draft import Draft, Lines, OldTextError, well_formed
from rigidtop.commands.editor import Editor, OpenDocument

BOB = r"""A bob 𝜔 has the Lagrangian

$$L = \tfrac12 m l^2\dot\theta^2 + m g l\cos\theta$$

𝜔: and so $l\ddot\theta = g\sin\theta$ and $m l^2\ddot\theta + m g l\sin\theta = 0$

\begin{align}
p &= m l^2\dot\theta, \label{p} \\
\dot p &= m g l\sin\theta. \tag{2}
\end{align}

Then $q = = 2$.
"""


class Client:
    """An editor with one open file, and what it has been told of it."""

    def __init__(self, path):
        self.path, self.uri, self.version = path, path.as_uri(), 0
        self.told = asyncio.Queue()
        self.client = LanguageClient("test", "1")
        told = lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS
        self.client.feature(told)(lambda params: self.told.put_nowait(params))

    def send(self, text):
        """Tell the server what stands in the file."""
        self.version += 1
        if self.version == 1:
            item = lsp.TextDocumentItem(self.uri, "markdown", 1, text)
            self.client.text_document_did_open(lsp.DidOpenTextDocumentParams(item))
        else:
            document = lsp.VersionedTextDocumentIdentifier(self.version, self.uri)
            change = [lsp.TextDocumentContentChangeWholeDocument(text)]
            params = lsp.DidChangeTextDocumentParams(document, change)
            self.client.text_document_did_change(params)

    async def diagnostics(self):
        """What is told of the newest text."""
        while True:
            told = await asyncio.wait_for(self.told.get(), 30)
            if told.version == self.version:
                return told.diagnostics

    async def write(self, text):
        """What is told of a text."""
        self.send(text)
        return await self.diagnostics()

    async def hover(self, line, column):
        params = lsp.HoverParams(self.document, lsp.Position(line, column))
        found = await self.client.text_document_hover_async(params)
        return found.contents.value if found is not None else None

    async def definition(self, line, column):
        params = lsp.DefinitionParams(self.document, lsp.Position(line, column))
        found = await self.client.text_document_definition_async(params)
        return [(each.uri, each.range.start.line) for each in found]

    async def repairs(self, where):
        params = lsp.CodeActionParams(self.document, where, lsp.CodeActionContext([]))
        return await self.client.text_document_code_action_async(params)

    @property
    def document(self):
        return lsp.TextDocumentIdentifier(self.uri)


@asynccontextmanager
async def editing(path):
    editor = Client(path)
    await editor.client.start_io(sys.executable, "-m", "rigidtop", "lsp", "--stdio")
    try:
        capabilities = lsp.ClientCapabilities()
        await editor.client.initialize_async(lsp.InitializeParams(capabilities=capabilities))
        editor.client.initialized(lsp.InitializedParams())
        yield editor
        await editor.client.shutdown_async(None)
        editor.client.exit(None)
    finally:
        await editor.client.stop()


def marked(text, where):
    """What stands in a range, whose columns are counted in units of UTF-16."""
    assert where.start.line == where.end.line
    line = text.splitlines()[where.start.line].encode("utf-16-le")
    return line[2 * where.start.character : 2 * where.end.character].decode("utf-16-le")


def test_an_editor_is_told_what_the_audit_finds(tmp_path, capsys):
    path = tmp_path / "bob.md"
    path.write_text(BOB, "utf-8")
    assert main(["audit", str(path), "--json"]) == 1
    rows = json.loads(capsys.readouterr().out)

    async def ask():
        async with editing(path) as editor:
            told = await editor.write(BOB)
            wrong = [(each.range.start.line + 1, each.message.split("\n")[0]) for each in told]
            assert wrong == [(x["line"], x["note"]) for x in rows if x["passed"] is False]
            assert [marked(BOB, each.range) for each in told] == [
                r"l\ddot\theta = g\sin\theta",
                r"\dot p &= m g l\sin\theta",
            ]
            for row in rows:
                [equation] = row["equations"]
                start = lsp.Position(row["line"] - 1, equation["column"] - 1)
                said = await editor.hover(start.line, start.character + 1)
                assert f": {row['verdict']}" in said
                assert row["note"] in said
            assert await editor.hover(0, 0) is None
            first = told[0].range.start
            places = await editor.definition(first.line, first.character)
            assert places == [(path.as_uri(), 2)]
            assert await editor.definition(0, 0) == []

    asyncio.run(ask())


def test_the_newest_text_wins_and_what_a_quick_fix_writes_is_right(tmp_path):
    async def ask():
        async with editing(tmp_path / "bob.md") as editor:
            for k in range(5):
                editor.send(BOB + f"\n$x_{k} = {k}$\n")
            assert len(await editor.diagnostics()) == 2
            text = BOB
            while told := await editor.write(text):
                [repair] = await editor.repairs(told[0].range)
                [edit] = repair.edit.changes[editor.uri]
                lines = Lines(text)
                start, end = (
                    lines.position(x.line, x.character) for x in (edit.range.start, edit.range.end)
                )
                text = text[:start] + edit.new_text + text[end:]
            assert text.count("-") == 2
            assert r"\label{p} \\" in text
            assert r"\dot{p} &= -m g l \sin \theta. \tag{2}" in text

    asyncio.run(ask())


@pytest.fixture
def judged(monkeypatch):
    """The numbers of the statements that are judged."""
    numbers, judge = [], rigidtop.judge.text.in_time

    def counted(judge_, statement, at, *rest):
        numbers.append(at.number)
        return judge(judge_, statement, at, *rest)

    monkeypatch.setattr(rigidtop.judge.text, "in_time", counted)
    return numbers


def outcomes(audit):
    return [each.record for each in audit.notes.findings]


@pytest.mark.parametrize(
    ("before", "after", "again"),
    [
        ("Then $q", "Now then $q", []),
        (r"\dot p &= m g", r"\dot p &= -m g", [4]),
        ("A bob", "The bob", [0]),
        ("A bob", "There is a top. A bob", []),
        ("A bob", "Let $a = 3$.\n\n# A bob\n\nA bob", [0, 1, 2, 3, 4, 5]),  # it stands for 3 below
        ("Then $q", r"Then $\dot x = 1$ and $q", [0, 1, 2, 3, 4, 5]),  # x has a rate from now on
    ],
)
def test_what_is_as_before_is_not_judged_again(before, after, again, judged):
    draft, collection = Draft(Path("bob.md")), built_in()
    draft.audit(BOB, collection)
    judged.clear()
    changed = BOB.replace(before, after)
    audit = draft.audit(changed, collection)
    assert judged == again
    assert outcomes(audit) == outcomes(Draft(Path("bob.md")).audit(changed, collection))


PARTS = (
    "# A bob\n",
    "## A sleeve\n",
    "1. It is heavy.\n2. It is let go at rest, with $\\theta = \\theta_0$.\n",
    "A bob of mass $m$ hangs on a rod of length $l$.",
    "A sleeve of mass $m$ is on a spring of stiffness $k$, and goes by $x$.",
    "$$L = \\tfrac12 m l^2\\dot\\theta^2 + m g l\\cos\\theta$$",
    "$$L = \\tfrac12 m\\dot x^2 - \\tfrac12 k x^2$$",
    "and so $l\\ddot\\theta = -g\\sin\\theta$",
    "and so $l\\ddot\\theta = g\\sin\\theta$.",
    "So\n\\begin{align}p &= m l^2\\dot\\theta, \\\\\n\\dot p &= m g l\\sin\\theta.\n\\end{align}",
    "It has $m\\ddot x = -k x$ and $E = \\tfrac12 m\\dot x^2 + \\tfrac12 k x^2$, conserved.",
    "At the start $x = a$ and $\\dot x = 0$, so that $E = \\tfrac12 k a^2$.",
    "At the lowest point $\\theta = 0$, and there $\\dot\\theta = \\omega$.",
    "If $k = 3 m$, then $\\ddot x = -3 x$.",
    "In general $\\ddot x = -\\omega^2 x$ with $\\omega^2 = k / m$.",
    "For small $\\theta$ it is $\\ddot\\theta = -\\tfrac{g}{l}\\theta$.",
    "Then $q = = 2$.",
    "Nothing is said here. It is prose",
)
"""Pieces of texts: headings, words, what is right and what is wrong."""

SIGNS = (".", " ", "\n\n", "not ", "At first ", " $x = 2$ ", "$", "-", "2", "where ", "\n# New\n\n")
"""What may be typed anywhere."""

CHANGES = st.one_of(
    st.tuples(st.just("put"), st.floats(0, 1), st.sampled_from([*SIGNS, *PARTS])),
    st.tuples(st.just("cut"), st.floats(0, 1), st.integers(1, 80)),
)


def changed(text, how, where, what):
    """A text with something put in or cut out; a part is put between two lines."""
    place = int(where * len(text))
    if how == "cut":
        return text[:place] + text[place + what :]
    if what in PARTS:
        place = text.find("\n\n", place) % (len(text) + 1)
        what = f"\n\n{what}\n\n"
    return text[:place] + what + text[place:]


def everything(draft, audit):
    """All that is told of a text, and all that is known of each of its statements."""
    remarks = [(x.start, x.end, x.repair, x.finding.record) for x in audit.remarks]
    return remarks, [step.row for step in draft.history.steps], audit.notes and outcomes(audit)


@settings(max_examples=12, deadline=None)
@given(
    st.lists(st.sampled_from(PARTS), min_size=3, max_size=9),
    st.lists(CHANGES, min_size=1, max_size=6),
    st.integers(0, 9),
)
def test_a_changed_text_has_the_outcomes_of_one_read_for_the_first_time(parts, changes, end):
    draft, text = Draft(Path("text.md")), "\n\n".join(parts)
    draft.audit(text, built_in())
    for change in changes:
        text = changed(text, *change)
        left = iter(range(end))
        with suppress(OldTextError):  # now and then somebody types on in the meantime
            draft.audit(text + end * " ", built_in(), lambda left=left: next(left, None) is None)
        fresh = Draft(Path("text.md"))
        expected = everything(fresh, fresh.audit(text, built_in()))
        assert everything(draft, draft.audit(text, built_in())) == expected


def test_an_old_text_is_given_up_and_taken_up_again(judged):
    draft, collection = Draft(Path("bob.md")), built_in()
    with pytest.raises(OldTextError):
        draft.audit(BOB, collection, lambda: len(judged) == 3)
    assert judged == [0, 1, 2]
    audit = draft.audit(BOB, collection)
    assert judged == [0, 1, 2, 3, 4]
    assert outcomes(audit) == outcomes(Draft(Path("bob.md")).audit(BOB, collection))


def test_a_dollar_too_much_is_told_where_no_formula_stands():
    audit = Draft(Path("text.md")).audit("m$ hangs on a rod.", built_in())
    [remark] = audit.remarks
    assert (remark.start, remark.end, remark.finding.verdict) == (0, 18, "unread")


LONG = "\n\n".join(f"# Bob {k}\n\n{BOB}" for k in range(3))


def test_what_is_far_below_a_change_is_told_as_it_was_at_first(judged):
    draft, collection = Draft(Path("bob.md")), built_in()
    before = draft.audit(LONG, collection)
    edited = LONG.replace("g\\sin\\theta$ and", "-g\\sin\\theta$ and", 1).replace("Bob 0", "A bob")
    judged.clear()
    first = draft.audit(edited, collection, is_enough=lambda: len(judged) == 1)
    assert judged == [1]
    assert not first.is_whole
    whole = draft.audit(edited, collection)
    assert whole.is_whole
    assert outcomes(whole) == outcomes(Draft(Path("bob.md")).audit(edited, collection))
    assert len(first.remarks) == len(whole.remarks)
    assert outcomes(first)[:2] == outcomes(whole)[:2] != outcomes(before)[:2]
    verdicts = [[x["verdict"] for x in outcomes(each)[2:]] for each in (first, before)]
    assert verdicts[0] == verdicts[1]


def test_what_is_near_to_a_change_is_told_before_the_rest(tmp_path, monkeypatch):
    monkeypatch.setattr(rigidtop.commands.editor, "SOON", 0.0)
    editor, told = Editor(built_in()), []
    monkeypatch.setattr(editor, "_publish", lambda _, found, version: told.append((found, version)))
    document = OpenDocument("file:///bob.md", Draft(tmp_path / "bob.md"), "", None)
    editor.documents[document.uri] = document
    for version, text in enumerate((LONG, LONG.replace("= g\\sin", "= -g\\sin", 1))):
        document.text = text
        editor._judge(document, text, version)
    assert [(len(found), version) for found, version in told] == [(6, 0), (5, None), (5, 1)]


def test_columns_are_counted_as_the_protocol_says():
    lines = Lines("a𝜔b\n\nc")
    assert [lines.place(k) for k in range(7)] == [
        *((0, 0), (0, 1), (0, 3), (0, 4)),
        *((1, 0), (2, 0), (2, 1)),
    ]
    assert [lines.position(*lines.place(k)) for k in range(7)] == [*range(7)]
    assert lines.position(0, 99) == 3
    assert lines.position(9, 0) == lines.position(-1, 2) == 6


def test_text_from_elsewhere_is_well_formed():
    assert well_formed("a\r\nb\rc\0\ud800") == "a\nb\nc\ufffd\ufffd"
