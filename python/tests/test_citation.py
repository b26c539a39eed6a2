"""How the program is cited is the same in every place, and names its version."""

import json
import re
from pathlib import Path

import yaml
from conftest import Run

ROOT = Path(__file__).resolve().parents[2]


def version() -> str:
    found = re.search(r'kVersion = "([^"]+)"', (ROOT / "prs/version.h").read_text())
    assert found
    return found[1]


def test_citation_and_metadata_name_this_version() -> None:
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    metadata = json.loads((ROOT / "codemeta.json").read_text())
    assert citation["version"] == metadata["version"] == version()
    assert citation["license"] == "BSD-3-Clause"
    assert metadata["license"].endswith(citation["license"])
    assert citation["authors"][0]["name"] == metadata["author"][0]["name"]
    assert citation["authors"][0]["name"] in (ROOT / "LICENSE").read_text()


def test_the_program_prints_how_to_cite_it(program: Run) -> None:
    printed = program("--version", "--cite").stdout
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    fields = dict(re.findall(r"(\w+) +=[ {]+([^}]+)}", printed))
    assert fields == {
        "author": citation["authors"][0]["name"],
        "title": citation["title"],
        "version": citation["version"],
        "year": str(citation["date-released"].year),
    }


def test_every_source_that_the_paper_cites_is_in_its_bibliography() -> None:
    cited = set(re.findall(r"@([a-z]+\d*)", (ROOT / "paper/paper.md").read_text()))
    listed = set(re.findall(r"@\w+\{(\w+),", (ROOT / "paper/paper.bib").read_text()))
    assert cited == listed
