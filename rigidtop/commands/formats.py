"""What an audit finds, as code hosts, editors and test runners read it."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any
from urllib.parse import quote
from xml.etree import ElementTree

from rigidtop.commands.findings import AuditFinding
from rigidtop.commands.notes import Notes
from rigidtop.terminal.visible import visible

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"


def github(audits: Sequence[Notes]) -> str:
    """A workflow command for each line that is wrong: GitHub shows it beside the line.

    The characters that such a command uses are escaped as its documentation says.
    """
    return "\n".join(
        f"::error file={_property(_file(each, notes))},line={_line(each)},"
        f"title={_property(f'{each.title} is wrong')}::{_data(message(each))}"
        for notes, each in _wrong(audits)
    )


def _data(text: str) -> str:
    for sign, code in (("%", "%25"), ("\r", "%0D"), ("\n", "%0A")):
        text = text.replace(sign, code)
    return text


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")


def sarif(audits: Sequence[Notes]) -> str:
    """One run in the Static Analysis Results Interchange Format, version 2.1.0."""
    from rigidtop import __version__

    rule = {"id": "false", "shortDescription": {"text": "A formula contradicts what stands above"}}
    driver = {"name": "rigidtop", "version": __version__, "rules": [rule]}
    results = [
        {
            "ruleId": "false",
            "level": "error",
            "message": {"text": message(each)},
            "locations": [_location(_file(each, notes), _line(each))],
            "relatedLocations": [
                {**_location(place.file or _file(each, notes), place.line), "message": {"text": x}}
                for place, x in each.against
            ],
        }
        for notes, each in _wrong(audits)
    ]
    runs = [{"tool": {"driver": driver}, "results": results}]
    log = {"$schema": SCHEMA, "version": "2.1.0", "runs": runs}
    return json.dumps(log, ensure_ascii=False, indent=1)


def _location(file: str, line: int) -> dict[str, Any]:
    region = {"startLine": max(line, 1)}
    return {"physicalLocation": {"artifactLocation": {"uri": quote(file)}, "region": region}}


def junit(audits: Sequence[Notes]) -> str:
    """A test case for each formula: a wrong one fails, one of which nothing is known is skipped."""
    suites = ElementTree.Element("testsuites")
    for notes in audits:
        _suite(suites, notes)
    ElementTree.indent(suites)
    return ElementTree.tostring(suites, "unicode", xml_declaration=True)


def _suite(suites: ElementTree.Element, notes: Notes) -> None:
    """Add the test cases of a file."""
    file = notes.source.path.as_posix()
    findings = [each for each in notes.findings if each.place is not None]
    counts = {
        "tests": len(findings),
        "failures": sum(each.is_wrong for each in findings),
        "skipped": sum(each.passed is None for each in findings),
    }
    named = {"name": visible(file), **{key: str(count) for key, count in counts.items()}}
    suite = ElementTree.SubElement(suites, "testsuite", named)
    for each in findings:
        named = {"classname": visible(file), "name": visible(each.title)}
        case = ElementTree.SubElement(suite, "testcase", named)
        if each.is_wrong:
            failure = ElementTree.SubElement(case, "failure", {"message": visible(each.note)})
            failure.text = visible(message(each))
        elif each.passed is None:
            reason = visible(f"{each.verdict}: {each.note}")
            ElementTree.SubElement(case, "skipped", {"message": reason})


FORMATS: Mapping[str, Callable[[Sequence[Notes]], str]] = {
    "github": github,
    "sarif": sarif,
    "junit": junit,
}


def message(each: AuditFinding) -> str:
    """What is wrong in lines: why, as it is written, as it has to be, what it contradicts."""
    against = [f"against {place}: {formula}" for place, formula in each.against]
    parts = [("written", each.written), ("right", each.right)]
    return "\n".join([each.note, *(f"{head}: {x}" for head, x in parts if x), *against])


def _wrong(audits: Sequence[Notes]) -> Iterator[tuple[Notes, AuditFinding]]:
    return ((notes, each) for notes in audits for each in notes.findings if each.is_wrong)


def _file(each: AuditFinding, notes: Notes) -> str:
    """The file of a finding, from where the command was started."""
    top = notes.source.path
    named = each.place.file if each.place is not None else ""
    return (top.parent / named if named else top).as_posix()


def _line(each: AuditFinding) -> int:
    return each.place.line if each.place is not None else 1
