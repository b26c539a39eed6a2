"""Data frames of which every column has one type, as Parquet and netCDF want it.

A number that is missing is NaN, a text that is missing is empty. Flags and whole numbers of which
one is missing are floats: 1, 0 and NaN.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from rollerscrew.record import Record, types_of

if TYPE_CHECKING:
    import pandas as pd

#: Names of columns with the types of their values.
Kinds = Mapping[str, type]


def frame_of(rows: Iterable[Mapping[str, Any]], kinds: Kinds | None = None) -> pd.DataFrame:
    """A row for each mapping. Without rows it has the columns of `kinds`."""
    import pandas as pd

    rows = list(rows)
    kinds = {} if kinds is None else kinds
    names = list(dict.fromkeys(name for row in rows for name in row)) if rows else list(kinds)
    columns = {}
    for name in names:
        columns[name] = _column([row.get(name) for row in rows], kinds.get(name))
    return pd.DataFrame(columns)


def _column(values: list[Any], kind: type | None) -> Any:
    import pandas as pd

    there = [value for value in values if value is not None]
    if kind is None:
        kinds = {bool if isinstance(value, np.bool_) else type(value) for value in there}
        kind = kinds.pop() if len(kinds) == 1 else str if str in kinds else float
    if issubclass(kind, str):
        return pd.Series(["" if value is None else str(value) for value in values], dtype="str")
    if issubclass(kind, bool | int) and len(there) == len(values):
        return np.array(values, dtype=bool if issubclass(kind, bool) else np.int64)
    return np.array([np.nan if value is None else float(value) for value in values])


def flat(record: Record, prefix: str = "") -> Iterator[tuple[str, Any]]:
    """The values of a record and of the records in it that are no arrays or lists."""
    for name, value in record.items():
        if isinstance(value, Record):
            yield from flat(value, f"{prefix}{name}_")
        elif not isinstance(value, np.ndarray | list):
            yield f"{prefix}{name}", value


def kinds_of(owner: type[Record], prefix: str = "") -> dict[str, type]:
    """What `flat` may give of such records, with the types."""
    kinds: dict[str, type] = {}
    types = types_of(owner)
    for name, hint in types.hints.items():
        if hint in (bool, int, float, str):
            kinds[prefix + name] = hint
        elif isinstance(hint, type) and issubclass(hint, Record):
            kinds |= kinds_of(hint, f"{prefix}{name}_")
    return kinds


def array_kinds(owner: type[Record]) -> dict[str, type]:
    """The columns of threads of such records."""
    from rollerscrew.records import Array

    arrays = [name for name, hint in types_of(owner).hints.items() if hint == Array]
    return {"thread": int, **dict.fromkeys(arrays, float)}
