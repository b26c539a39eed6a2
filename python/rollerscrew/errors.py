"""What is wrong with an input, in its parts."""

from __future__ import annotations

import re
import sys
import warnings
from dataclasses import dataclass

_LINE = re.compile(r"(?P<file>.*?):(?P<line>\d+):(?P<column>\d+): error: (?P<message>.*)")
_KEY = re.compile(r"(?P<path>(?!got |malformed YAML)[^:]+): (?P<message>.*)")

#: Errors of arguments, which stand in no file.
_ARGUMENT = re.compile(
    r"(?:inputs\['(?P<input>.*?)'\](?:\[\d+\])?|(?P<name>[^:\s]+)): (?P<message>.*)"
)

#: How messages say that there is no file.
_NO_FILE = re.compile(r": error: (got no such file;|.* does not exist; give its path)")


@dataclass(frozen=True)
class InputProblem:
    """One error of an input: `FILE:LINE:COLUMN: error: PATH: got GOT; expected ..; HINT`."""

    text: str
    file: str = ""
    line: int | None = None
    column: int | None = None
    path: str = ""  #: The key as it was given: `mechanism.leed`; empty of a whole file.
    got: str = ""
    hint: str = ""  #: How to fix it.

    @classmethod
    def of(cls, text: str) -> InputProblem:
        place = _LINE.fullmatch(text)
        if place is None:
            argument = _ARGUMENT.fullmatch(text)
            if argument is None:
                return cls(text)
            path = argument["input"] or argument["name"]
            got, hint = _got_and_hint(argument["message"])
            return cls(text, path=path, got=got, hint=hint)
        keyed = _KEY.fullmatch(place["message"])
        path, message = (keyed["path"], keyed["message"]) if keyed else ("", place["message"])
        line, column = int(place["line"]), int(place["column"])
        return cls(text, place["file"], line, column, path, *_got_and_hint(message))


def _got_and_hint(message: str) -> tuple[str, str]:
    parts = message.partition(" (from --set ")[0].split("; ")
    got = next((part[4:] for part in parts if part.startswith("got ")), "")
    has_hint = len(parts) > 1 and not parts[-1].startswith("expected ")
    return got, parts[-1] if has_hint else ""


class InputError(ValueError):
    """The input is wrong; the text is that of `prs check`, one line for each error.

    `errors` has all of them in their parts; `path`, `line`, `column`, `got` and `hint` are those of
    the first that is about what was given: a misspelt key rather than the one that is missing.
    """

    @property
    def errors(self) -> list[InputProblem]:
        return [InputProblem.of(line) for line in str(self).splitlines()]

    @property
    def _first(self) -> InputProblem:
        errors = self.errors or [InputProblem(str(self))]
        return next((each for each in errors if ": missing; " not in each.text), errors[0])

    @property
    def path(self) -> str:
        return self._first.path

    @property
    def line(self) -> int | None:
        return self._first.line

    @property
    def column(self) -> int | None:
        return self._first.column

    @property
    def got(self) -> str:
        return self._first.got

    @property
    def hint(self) -> str:
        return self._first.hint


class MissingFileError(InputError, FileNotFoundError):
    """The case, or a file that it names, is not there."""

    @property
    def filename(self) -> str:
        """The file, as it was named."""
        return self._first.got if self._first.path else self._first.file


def input_error(text: str) -> InputError:
    """The error of that text; called by the engine."""
    return MissingFileError(text) if _NO_FILE.search(text) else InputError(text)


def warn_caller(text: str) -> None:
    """Warns at the line that called the package, however deep in it this is."""
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").partition(".")[0] == "rollerscrew":
        level, frame = level + 1, frame.f_back
    warnings.warn(text, stacklevel=level)


InputError.__module__ = MissingFileError.__module__ = "rollerscrew"
