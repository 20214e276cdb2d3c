"""Random, broken and hostile messages: none ends the language server or the assistant's tools."""

import json
import os
import random
import subprocess
import sys
import threading

import pytest

COUNT = int(os.environ.get("RIGIDTOP_MESSAGES", "500"))
"""So many messages are sent to each; twenty times as many were, by hand."""

URIS = ["file:///tmp/a.md", "file:///tmp/b.tex", "untitled:1", "", "::", "file:///\0", "a" * 5000]
TEXTS = [
    *("", "$", "$$x = y$$", "$$x = $$", "\ud800$x$", "\0", "$$" + "{" * 3000 + "$$"),
    *("\\input{/etc/passwd}", "\\begin{align}" * 200, "$x=1$\r$y\u2028=2$\r\n", "$\\frac" * 500),
]
STRANGE = [
    *(None, True, -1, 0, 1 << 70, 1e308, "", "x", [], {}, [[]], {"uri": 3}, {"": None}),
    *({"textDocument": {"uri": 1}}, {"position": {"line": -9, "character": 1 << 40}}),
]


def anything(dice):
    """Some value, mostly of a kind that is not expected."""
    return dice.choice([*STRANGE, dice.choice(TEXTS), dice.choice(URIS)])


def document(dice):
    text, uri = dice.choice(TEXTS), dice.choice(URIS)
    item = {"uri": uri, "languageId": "x", "version": dice.randint(-9, 9), "text": text}
    position = {"line": dice.choice([0, 5, -1, 1 << 30]), "character": dice.choice([0, 7, -3])}
    change = {"text": dice.choice(TEXTS)}
    if dice.random() < 0.5:
        change["range"] = {"start": position, "end": position}
    return {
        "textDocument": item,
        "position": position,
        "range": {"start": position, "end": position},
        "context": {"diagnostics": []},
        "contentChanges": [change],
    }


def call(dice):
    tool = dice.choice(["audit", "derive", "mark", "simulate", "certify", "run", ""])
    start = {"theta": dice.choice([0.3, -1, "x", 1e400]), "omega3": dice.choice([4, 1e300, None])}
    given = [
        {"text": dice.choice(TEXTS)},
        {"name": dice.choice(["/etc", "../x", "3.999", "\0", "3" * 9999])},
        {"text": dice.choice(TEXTS), "given": dice.choice(TEXTS), "goal": dice.choice(TEXTS)},
        {"top": start, "time": dice.choice([1, 1e9, -1]), "samples": dice.choice([2, 0, 1 << 60])},
    ]
    return {"name": tool, "arguments": dice.choice([*given, anything(dice)])}


def message(dice, methods, params):
    """A message of the protocol, or something like it, as text."""
    kind = dice.random()
    if kind < 0.1:
        return dice.choice(
            ["", "{", "[" * 20_000, "null", "[]", "NaN", '"x"', "{}" * 9, "\x00\x01"]
        )
    said = {"jsonrpc": dice.choice(["2.0"] * 9 + ["1.0", 2]), "method": dice.choice(methods)}
    said["params"] = params(dice) if kind < 0.8 else anything(dice)
    if dice.random() < 0.5:
        said["id"] = dice.choice([1, 1, "a", None, -5, 1.5, {}, 1 << 80, dice.randint(0, 10**6)])
    if dice.random() < 0.1:
        said.pop(dice.choice([*said]))
    return json.dumps(said)


def in_frame(dice, text):
    """With a header, which is at times a wrong one."""
    body = text.encode("utf-8", "surrogatepass")
    length = len(body) if dice.random() < 0.95 else max(0, len(body) + dice.choice([-7, -1, 3]))
    header = dice.choice([b"Content-Length: %d\r\n\r\n"] * 30 + [b"Content-Length: -%d\r\n\r\n"])
    return header % length + body


def in_line(dice, text):
    return text.encode("utf-8", "surrogatepass") + b"\n"


LSP = [
    *("initialize", "initialized", "textDocument/didOpen", "textDocument/didChange"),
    *("textDocument/didClose", "textDocument/hover", "textDocument/definition", "nothing"),
    *("textDocument/codeAction", "$/cancelRequest", "$/setTrace", "workspace/executeCommand"),
    *("textDocument/didSave", "", "window/workDoneProgress/cancel", "textDocument/didOpen"),
]
MCP = [
    *("tools/call", "tools/call", "tools/list", "initialize", "ping", "nothing", "prompts/get"),
    *("resources/read", "notifications/cancelled", "notifications/initialized", "logging/setLevel"),
]
PLACE = {"textDocument": {"uri": URIS[0]}, "position": {"line": 0, "character": 0}}
STARTED = {"protocolVersion": "2025-06-18", "capabilities": {}}
STARTED |= {"clientInfo": {"name": "test", "version": "1"}}


@pytest.mark.parametrize(
    ("command", "frame", "methods", "params", "asked"),
    [
        ("lsp", in_frame, LSP, document, {"method": "textDocument/hover", "params": PLACE}),
        ("mcp", in_line, MCP, call, {"method": "ping", "params": {}}),
    ],
)
def test_nothing_ends_a_server(command, frame, methods, params, asked, tmp_path):
    dice = random.Random(7)
    asked = {"jsonrpc": "2.0", "id": "the last", **asked}
    start = [sys.executable, "-m", "rigidtop", command]
    pipe = subprocess.PIPE
    with (tmp_path / "errors").open("w+") as errors:
        server = subprocess.Popen(
            start, stdin=pipe, stdout=pipe, stderr=errors, cwd=tmp_path, bufsize=0
        )
        heard, answered = bytearray(), threading.Event()

        def listen():
            while piece := server.stdout.read(1 << 16):
                heard.extend(piece)
                if b'"the last"' in heard[-(1 << 17) :]:
                    answered.set()

        listening = threading.Thread(target=listen)
        listening.start()
        plain = random.Random(0)
        plain.random = lambda: 0.0  # with a right header
        started = {"jsonrpc": "2.0", "id": 0, "method": "initialize", "params": STARTED}
        server.stdin.write(frame(plain, json.dumps(started)))
        for _ in range(COUNT):
            # One with a wrong header may take the one behind it with it, no more.
            server.stdin.write(b"\n\n" + frame(dice, message(dice, methods, params)))
        for _ in range(5):
            server.stdin.write(b"\n\n" + frame(plain, json.dumps(asked)))
        was_answered = answered.wait(120)
        server.stdin.close()
        try:
            code = server.wait(30)
        finally:
            server.kill()
        listening.join()
        server.stdout.close()
        assert was_answered
        assert code in (0, 1)
        errors.seek(0)
        assert "Traceback" not in errors.read()
