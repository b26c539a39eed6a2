"""Docstrings of what users call have the sections of numpydoc, with each argument and no other."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from typing import Any

import pytest
import rollerscrew as rs

#: Classes whose own methods are called by users; exports say their arguments in a sentence.
OWN = (rs.Case, rs.Designs, rs.Function)
CALLED: dict[str, Callable[..., Any]] = {
    "fit": rs.fit,
    "size": rs.size,
    "new": rs.new,
    "lesson": rs.lesson,
    "configurations": rs.configurations,
    "draw": rs.plots.draw,
    "compare": rs.plots.compare,
} | {
    f"{owner.__name__}.{name}": getattr(owner, name)
    for owner in OWN
    for name, each in vars(owner).items()
    if not name.startswith(("_", "export_"))
    and isinstance(each, (type(inspect.cleandoc), classmethod))
}


def section(doc: str, title: str) -> str:
    found = re.search(rf"^{title}\n-+\n((?:.+\n?)+)", doc, re.M)
    return found[1] if found else ""


@pytest.mark.parametrize("name", CALLED)
def test_arguments_and_what_is_returned_are_said(name: str) -> None:
    doc = inspect.getdoc(CALLED[name]) or ""
    signature = inspect.signature(CALLED[name])
    said = [
        one.strip(" *")
        for names in re.findall(r"^(\S.*?) :", section(doc, "Parameters"), re.M)
        for one in names.split(",")
    ]
    assert sorted(said) == sorted(set(signature.parameters) - {"self"})
    assert section(doc, "Returns")
    assert all(len(line) <= 100 for line in doc.splitlines())
