"""Unknown inputs of a case from measured curves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from rollerscrew.case import Case
from rollerscrew.results import FitResult
from rollerscrew.values import checked


def fit(
    case: Case,
    parameters: Sequence[Mapping[str, Any]],
    curves: Sequence[Mapping[str, Any]],
    *,
    data: Mapping[str, Any] | None = None,
    **options: Any,
) -> FitResult:
    """Fits `parameters` of a case to `curves`: the keys of the block `fit`.

    `data` has the readings by the names of the curves, as frames or arrays by the names of columns;
    such curves need no `file`. A curve that is neither in `data` nor has a `file` is read from the
    file of its name, `torque.csv`, in the folder of the case. `options` are `level`, `starts`,
    `profile` and `bands`.

    >>> rs.fit(case, [{"path": "friction.coulomb", "from": 0.02, "to": 0.4}],
    ...     [{"name": "torque", "response": "slip.torque_screw_Nm", "measured":
    ...     {"column": "M", "unit": "N m"}}], data={"torque": frame})

    Parameters
    ----------
    case : Case
        What is measured, with first values.
    parameters : list of dict
        `path`, `from`, `to` of each unknown input.
    curves : list of dict
        `name`, `response`, `measured`, .. of each curve.
    data : dict, optional
        Readings by the names of the curves.
    **options : Any
        Other keys of the block `fit`.

    Returns
    -------
    FitResult

    Raises
    ------
    InputError
        Where a key, a path or a file is wrong.
    """
    checked("case", case, Case, "a Case")
    for name, entries in (("parameters", parameters), ("curves", curves)):
        for k, entry in enumerate(checked(name, entries, Sequence, "a list of dictionaries")):
            checked(f"{name}[{k}]", entry, Mapping, "a dictionary")
    named = [
        {"file": f"{curve.get('name', f'curve-{k + 1}')}.csv", **curve}
        for k, curve in enumerate(curves)
    ]
    block = {"parameters": list(parameters), "curves": named, **options}
    return case.with_(fit=block).fit(data)
