"""Which screw, and which motor, for a requirement."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from rollerscrew import _engine
from rollerscrew.case import _file_name, _folder, _overrides, _source
from rollerscrew.results import SizeResult
from rollerscrew.values import case_text

_FILE = "requirement.yaml"


def size(
    requirement: str | os.PathLike[str] | Mapping[str, Any],
    *,
    set: Mapping[str, Any] | None = None,
) -> SizeResult:
    """Candidates against a requirement: a file, or its blocks as a dictionary.

    `set` replaces values as `--set` does it. `to_frame()` of the answer has one row per candidate,
    in the order of their ranks.

    Parameters
    ----------
    requirement : path or dict
        A file, or its blocks.
    set : dict, optional
        Values by their paths.

    Returns
    -------
    SizeResult

    Raises
    ------
    InputError
        Where the requirement is wrong.
    """
    overrides = _overrides({} if set is None else set)
    source = (
        _source(_FILE, case_text(requirement), overrides, _folder(_FILE))
        if isinstance(requirement, Mapping)
        else _engine.Source.load(_file_name(requirement, "requirement"), overrides)
    )
    return SizeResult(_engine.size(source))
