"""``qovr verify``: the paper's claims, decided."""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qovr_core.commands.common import DONE, SOURCE_HELP, add_window, finite, path, print_json, progress_bar
from qovr_core.document import Document
from qovr_core.files import read_source, write_document
from qovr_core.files.atomic import made_folder
from qovr_core.files.qovr_document import document_to_json
from qovr_core.formulations import FORMULATIONS

if TYPE_CHECKING:
    from qovr_core.laboratory.jumps import JointPlace
    from qovr_core.laboratory.verify import Finding


def add_command(commands: Any) -> None:
    command = commands.add_parser("verify", help="decide the paper's claims for a document", epilog=SOURCE_HELP)
    command.add_argument("source", metavar="SOURCE")
    forms = command.add_mutually_exclusive_group()
    forms.add_argument("--json", action="store_true", help="everything, counterexamples included")
    forms.add_argument("--markdown", action="store_true", help="one table: what the paper says, what is so")
    command.add_argument(
        "--counterexamples", metavar="DIR", type=path, help="write counterexamples and examples as .qovr files"
    )
    add_window(command, "the window of a net for claims that do not speak of joints (default: 0,0)", (0, 0))
    command.set_defaults(command=_verify)


def _verify(arguments: argparse.Namespace) -> int:
    from qovr_core.laboratory.claims import CLAIMS
    from qovr_core.laboratory.claims_report import findings_markdown, findings_text
    from qovr_core.laboratory.verify import verify

    document, decided, known = read_source(arguments.source), len(CLAIMS) * len(FORMULATIONS), count(1)
    with progress_bar("verify") as progress:
        findings = verify(document, arguments.window, lambda _finding: progress(next(known) / decided))
    is_net = not document.is_one_window
    if arguments.counterexamples is not None:
        _write_documents(findings, arguments.counterexamples)
    if arguments.json:
        about = {"window": arguments.window} if is_net else {}
        print_json({"source": arguments.source, **about, "claims": _claims_json(findings)})
    elif arguments.markdown:
        print(findings_markdown(findings))
    else:
        if is_net:
            print(
                "Claims about neighbours are measured at every joint of the net, others on window ({}, {}).\n".format(
                    *arguments.window
                )
            )
        print(findings_text(findings))
    return DONE


def _write_documents(findings: Sequence[Finding], folder: Path) -> None:
    """Write every counterexample and example; the names tell claim and formulation."""
    made_folder(folder)
    for finding in findings:
        for kind, document in (("counterexample", finding.counterexample), ("example", finding.example)):
            if document is not None:
                name = f"{finding.claim.file_name}-{finding.formulation}-{kind}.qovr"
                write_document(document, folder / name)


def _claims_json(findings: Sequence[Finding]) -> list[dict[str, Any]]:
    """Return everything found, ready for JSON: numbers that are not finite are null, documents are whole."""
    from qovr_core.laboratory.claims_report import by_claim

    return [
        {
            "id": claim.name,
            "claim": claim.text,
            "where": claim.where,
            "formulations": {str(finding.formulation): _finding_json(finding) for finding in of_claim},
        }
        for claim, of_claim in by_claim(findings)
    ]


def _finding_json(finding: Finding) -> dict[str, Any]:
    return {
        "verdict": str(finding.verdict),
        "known": str(finding.ground),
        "proof": finding.proof or None,
        "trials": finding.trials,
        "condition": finding.condition or None,
        "holds_here": finding.here.holds,
        "value": finite(finding.here.value),
        "largest": finite(finding.largest),
        "what": finding.here.what,
        "note": finding.here.note or None,
        **_place_json(finding.here.place),
        "counterexample": _document_json(finding.counterexample),
        "example": _document_json(finding.example),
    }


def _place_json(place: JointPlace | None) -> dict[str, Any]:
    """Return the joint of a net at which the difference is largest."""
    if place is None:
        return {}
    return {"place": {"text": str(place), "window": place.window, "parameters": place.parameters}}


def _document_json(document: Document | None) -> object:
    return None if document is None else json.loads(document_to_json(document))
