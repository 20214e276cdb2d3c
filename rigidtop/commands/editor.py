"""The language server: what an editor asks of the notes that stand in it."""

from __future__ import annotations

import asyncio
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from itertools import count
from pathlib import Path
from typing import BinaryIO

from lsprotocol import types as lsp
from pygls.io_ import StdoutWriter, run_async
from pygls.lsp.server import LanguageServer
from pygls.uris import from_fs_path, to_fs_path

from rigidtop import __version__
from rigidtop.collection import Collection
from rigidtop.commands.draft import Audit, Draft, OldTextError, TextRemark, well_formed
from rigidtop.commands.findings import AuditFinding, FilePlace
from rigidtop.commands.formats import message
from rigidtop.commands.worker import Worker, own_output
from rigidtop.errors import RigidtopError
from rigidtop.terminal.files import LONGEST
from rigidtop.terminal.visible import visible

SOURCE = "rigidtop"

SOON = 0.1
"""So long a change is judged before an editor is told what is near to it (s)."""


@dataclass
class OpenDocument:
    """An open file: its newest text with its version, and the last audit, perhaps of an older."""

    uri: str
    draft: Draft
    text: str
    version: int | None
    audit: Audit | None = None

    @property
    def current(self) -> Audit | None:
        """The audit of the newest text, once there is one."""
        return self.audit if self.audit is not None and self.audit.text == self.text else None


class Editor:
    """An editor's open files, judged one at a time as they change."""

    def __init__(self, collection: Collection) -> None:
        self.collection = collection
        self.worker = Worker()
        self.documents: dict[str, OpenDocument] = {}
        self.server = LanguageServer(
            SOURCE, __version__, text_document_sync_kind=lsp.TextDocumentSyncKind.Full
        )
        answers: dict[str, Callable[..., object]] = {
            lsp.TEXT_DOCUMENT_DID_OPEN: self.open,
            lsp.TEXT_DOCUMENT_DID_CHANGE: self.change,
            lsp.TEXT_DOCUMENT_DID_CLOSE: self.close,
            lsp.TEXT_DOCUMENT_HOVER: self.hover,
            lsp.TEXT_DOCUMENT_DEFINITION: self.definition,
            lsp.TEXT_DOCUMENT_CODE_ACTION: self.repairs,
        }
        for name, answer in answers.items():  # each is marked, which a method refuses
            self.server.feature(name)(partial(answer))

    def serve(self) -> None:
        """Answer on standard output what comes by standard input, until it ends."""
        with own_output() as output:
            self.server.protocol.set_writer(StdoutWriter(output))
            self.worker.serve(self._listen)

    def _listen(self) -> None:
        messages = Messages(sys.stdin.buffer)
        with suppress(SystemExit):  # how the protocol ends
            asyncio.run(run_async(threading.Event(), messages, self.server.protocol))

    # --- What changes ----------------------------------------------------------------------------

    def open(self, params: lsp.DidOpenTextDocumentParams) -> None:
        item = params.text_document
        draft = Draft(Path(to_fs_path(item.uri) or item.uri))
        self.documents[item.uri] = OpenDocument(item.uri, draft, "", None)
        self._write(self.documents[item.uri], item.text, item.version)

    def change(self, params: lsp.DidChangeTextDocumentParams) -> None:
        document = self.documents.get(params.text_document.uri)
        if document is not None:
            text = self.server.workspace.get_text_document(document.uri).source
            self._write(document, text, params.text_document.version)

    def close(self, params: lsp.DidCloseTextDocumentParams) -> None:
        document = self.documents.pop(params.text_document.uri, None)
        if document is not None:
            self._publish(document, [])

    def _write(self, document: OpenDocument, text: str, version: int | None) -> None:
        document.text, document.version = well_formed(text), version
        self.worker.result(partial(self._judge, document, document.text, version))

    def _judge(self, document: OpenDocument, text: str, version: int | None) -> None:
        """Audit a text and tell the editor, unless there is a newer one."""

        def is_old() -> bool:
            newest = self.documents.get(document.uri)
            return document is not newest or document.text is not text

        if is_old():
            return
        looks = [_soon()] if document.audit is not None else []
        for is_enough in (*looks, lambda: False):
            try:
                diagnostics, is_whole = self._told(document, text, is_old, is_enough)
            except OldTextError:
                return
            if is_old():
                return
            # Without a version it holds until there is more to tell.
            self._publish(document, diagnostics, version if is_whole else None)
            if is_whole:
                return

    def _told(
        self,
        document: OpenDocument,
        text: str,
        is_old: Callable[[], bool],
        is_enough: Callable[[], bool],
    ) -> tuple[list[lsp.Diagnostic], bool]:
        """What is wrong in a text, and whether that is all; raises OldTextError."""
        try:
            audit = document.draft.audit(text, self.collection, is_old, is_enough)
        except RigidtopError as error:
            whole = lsp.Range(lsp.Position(0, 0), lsp.Position(0, 0))
            kind = lsp.DiagnosticSeverity.Information
            document.audit = None
            return [lsp.Diagnostic(whole, visible(str(error)), severity=kind, source=SOURCE)], True
        if audit.is_whole:
            document.audit = audit
        return [*self._wrong(document, audit)], audit.is_whole

    def _publish(
        self, document: OpenDocument, diagnostics: list[lsp.Diagnostic], version: int | None = None
    ) -> None:
        params = lsp.PublishDiagnosticsParams(document.uri, diagnostics, version)
        self.server.text_document_publish_diagnostics(params)

    def _wrong(self, document: OpenDocument, audit: Audit) -> Iterator[lsp.Diagnostic]:
        for each in audit.remarks:
            if each.finding.is_wrong:
                yield lsp.Diagnostic(
                    _range(audit, each),
                    visible(message(each.finding)),
                    severity=lsp.DiagnosticSeverity.Error,
                    code=each.finding.verdict,
                    source=SOURCE,
                    related_information=[
                        lsp.DiagnosticRelatedInformation(at, visible(formula))
                        for at, formula in _rests_on(document, audit, each.finding)
                    ],
                )

    # --- What is asked ---------------------------------------------------------------------------

    def hover(self, params: lsp.HoverParams) -> lsp.Hover | None:
        """What the line is, why, from what it follows, and the right one."""
        _, audit, remarks = self._asked(params)
        if audit is None or not remarks:
            return None
        words = "\n\n".join(dict.fromkeys(_words(each.finding) for each in remarks))
        content = lsp.MarkupContent(lsp.MarkupKind.PlainText, visible(words))
        return lsp.Hover(content, _range(audit, remarks[0]))

    def definition(self, params: lsp.DefinitionParams) -> list[lsp.Location]:
        """The lines on which a line rests."""
        document, audit, remarks = self._asked(params)
        if document is None or audit is None:
            return []
        places = [at for each in remarks for at, _ in _rests_on(document, audit, each.finding)]
        return [place for k, place in enumerate(places) if place not in places[:k]]

    def repairs(self, params: lsp.CodeActionParams) -> list[lsp.CodeAction]:
        """The right line in place of a wrong one."""
        document = self.documents.get(params.text_document.uri)
        audit = document.current if document is not None else None
        if document is None or audit is None:
            return []
        first, last = (
            audit.lines.position(x.line, x.character)
            for x in (params.range.start, params.range.end)
        )
        return [
            lsp.CodeAction(
                f"Write {visible(each.finding.right)}",
                lsp.CodeActionKind.QuickFix,
                is_preferred=True,
                edit=lsp.WorkspaceEdit(
                    {document.uri: [lsp.TextEdit(_range(audit, each), each.repair)]}
                ),
            )
            for each in audit.remarks
            if each.repair and each.start <= last and first <= each.end
        ]

    def _asked(
        self, params: lsp.HoverParams | lsp.DefinitionParams
    ) -> tuple[OpenDocument | None, Audit | None, tuple[TextRemark, ...]]:
        """The file that is asked about, and what is remarked on the place."""
        document = self.documents.get(params.text_document.uri)
        audit = document.current if document is not None else None
        if audit is None:
            return document, None, ()
        at = params.position
        return document, audit, audit.at(audit.lines.position(at.line, at.character))


def _soon() -> Callable[[], bool]:
    """What says that something has been judged, and that it has taken long enough."""
    begun, asked = time.monotonic(), count()
    return lambda: next(asked) > 0 and time.monotonic() > begun + SOON


def _words(finding: AuditFinding) -> str:
    """The verdict of a line and what it is drawn from."""
    head = f"{finding.title}: {finding.verdict}"
    if finding.is_wrong:
        return f"{head}: {message(finding)}"
    return f"{head}: {finding.words}" if finding.words else head


def _range(audit: Audit, remark: TextRemark) -> lsp.Range:
    start, end = (audit.lines.place(x) for x in (remark.start, remark.end))
    return lsp.Range(lsp.Position(*start), lsp.Position(*end))


def _rests_on(
    document: OpenDocument, audit: Audit, finding: AuditFinding
) -> Iterator[tuple[lsp.Location, str]]:
    """Where the lines stand on which one rests, or which it contradicts, with their formulas."""
    for place, formula in finding.against:
        source = _source(audit, place)
        if source is None:
            continue
        start = lsp.Position(place.line - 1, 0)
        uri = document.uri
        if audit.notes is not None and source != audit.notes.source.path:
            uri = from_fs_path(str(source.resolve())) or uri
        yield lsp.Location(uri, lsp.Range(start, start)), formula


def _source(audit: Audit, place: FilePlace) -> Path | None:
    """The file of a place among those that belong together."""
    files = audit.notes.files if audit.notes is not None else ()
    paths = [each.path for each in files]
    return next((path for path in paths if place.file in ("", path.name)), None)


class Messages:
    """The messages of a stream; what is longer than a file may be is skipped."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream

    async def readline(self) -> bytes:
        return self._stream.readline(LONGEST)

    async def readexactly(self, count: int) -> bytes:
        if count <= 8 * LONGEST:
            return self._stream.read(count)
        while count > 0 and (skipped := self._stream.read(min(count, LONGEST))):
            count -= len(skipped)
        return b"null"
