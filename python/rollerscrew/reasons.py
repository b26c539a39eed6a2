"""Responses in documents, and why one is not there: what to write instead."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from rollerscrew import _engine
from rollerscrew.errors import InputError
from rollerscrew.record import Record, some_of

if TYPE_CHECKING:
    from rollerscrew.case import Case

#: The commands that have responses, and those of a study among them.
STUDIED = ("contact", "solve", "slip", "life", "measures", "response")
COMMANDS = (*STUDIED, "preload")

_OF_LOAD_CASE = re.compile(r"^load_cases\[([^\]]*)\]\.")

#: What responses of a command need, by how their paths begin.
_OF_SLIP = (
    r"slip\.|heat\.|heat_cycle\.|flanks\.|static\.|running\.|\w+\.(friction_force|running_over)"
)

_FULL = (
    r"symmetric|orbit|dofs|rollers|carrier_angle|idle_rollers|screw_end|reactions|modes|travel|guide_"
    r"|(screw|nut)\.(largest_(normal|roller|thread)|overload|roller_share|unloaded)"
    r"|life\..*(\.rollers\.|roller_failure_share)|(life\.weakest|slip\.hottest)_thread\.roller"
)

_DENSITY = tuple(f"materials.{part}.density" for part in ("screw", "roller", "nut"))

#: Inputs without which responses are absent, by how their paths begin; `path: value` needs that
#: value, `{load_case}` stands for the load case of the response.
_NEEDED: tuple[tuple[str, tuple[str, ...]], ...] = (
    (r"heat\.|life\.temperature", ("heat",)),
    (r"heat\.oil|slip\..*(film_|viscosity|boundary_share)", ("lubricant",)),
    (r"slip\..*(film_ratio|boundary_share)", ("roughness",)),
    (r"heat_cycle\.", ("heat.duty",)),
    (r"flanks\.", ("model.loads: running", "preload.arrangement: single_nut")),
    (r"slip\.(second_nut\.|hottest_thread\.of_nut)", ("preload.arrangement: double_nut",)),
    (_FULL, ("model.mechanism: full",)),
    (r"orbit\.", ("{load_case}.orbit",)),
    (r"travel\.", ("{load_case}.travel",)),
    (r"modes\.|measures\.(lowest_freq|speeds_to_av)", ("{load_case}.modes", "structure.masses")),
    (r"slip\.holding\.", ("operation.speed: 0 rpm",)),
    (r"life\.static\.system", ("model.loads: running",)),
    (r"response\.frequency", ("response.frequency_response",)),
    (r"response\.following_error", ("response.motor.controller",)),
    (r"response\.settling", ("response.settling",)),
    (r"response\..*end_stop", ("response.end_stops",)),
    (r"modes\.along_travel", ("{load_case}.modes.positions",)),
    (r"guide_", ("structure.roller.guidance.clearance",)),
    (r"(static|running)\.|\w+\.(friction_force|running_over)", ("model.loads: running",)),
    (r"contact\..*clearance|threads\.", ("mechanism.thread",)),
    (r"slip\..*heads\.|slip\.bearing_", ("carrier.bearing",)),
    (r"slip\..*flash_temp", ("materials.conductivity", "materials.specific_heat", *_DENSITY)),
    (r"slip\..*wear_", ("wear",)),
    (r"slip\..*\.centrifugal", ("materials.roller.density",)),
    (r"life\.cycles|life\..*_passes|life\..*equivalent_range", ("life.history",)),
    (r"life\.modified", ("life.contamination",)),
    (r"life\..*static_capacity_given", ("life.static_capacity",)),
    (r"life\..*_hours", ("operation.speed",)),
    (r"measures\.(buckling|critical|speed_s|shaft_s)", ("measures.shaft",)),
    (r"measures\.(screw|equivalent|travel)_inertia", ("measures.shaft.length",)),
    (r"measures\.(critical|speed_s|screw_(weight|inertia))", ("materials.screw.density",)),
    (r"measures\.(weight|force_den|material_w)", ("materials.roller.density", _DENSITY[2])),
    (r"measures\.roller_(weight|inertia)", ("materials.roller.density", _DENSITY[2])),
    (r"measures\.nut_(weight|inertia)", ("materials.nut.density",)),
    (r"measures\.equivalent_inertia", _DENSITY),
    (
        r"measures\.(efficiency|drive_t|back_driving_efficiency$)",
        ("measures.friction_coefficient",),
    ),
    (r"measures\.(root|tooth)_", ("measures.loaded_width",)),
    (r"measures\.system_stiffness", ("measures.system",)),
    (r"measures\.l10_hours", ("operation.speed",)),
    (r"measures\.back_driving_efficiency_by_slip", ("friction", "operation.speed")),
    (
        r"measures\.(envelope|material|screw_|shaft_s|buckling|critical|section|nut_|roller_[wi]|yang|force_d|weight)",
        ("structure",),
    ),
    (
        r"measures\.(yang|largest_load_rate|flank_edge_margin|solved)"
        r"|(axial_[ds]|position|iterations|relative_r|tangent|static|running|screw|nut)"
        r"|slip\.equal_shares",
        ("structure", "{load_case}.share: solved"),
    ),
)

#: Why others are absent though all that they need is there.
_ABSENT: tuple[tuple[str, str], ...] = (
    (
        r"life\.loads\.",
        "of a spectrum by shares; amounts are `revolutions`, `distance`, `duration`",
    ),
    (r"life\.(tension|compression)\.", "no load has this direction"),
    (r"slip\.holding_torque", "the load does not drive"),
    (r"slip\.equal_shares", "running loads of a preloaded nut have no equal shares"),
    (r"slip\..*jones", "the estimate is of standard screws"),
    (r"slip\..*efficiency_fit|slip\..*(film|viscosity)", "the flanks have Coulomb friction"),
    (r"measures\.back_driving", "the screw locks itself, or the load does not drive"),
    (r"measures\.buckling", "the load does not compress the screw"),
    (r"measures\.(solved_static|flank_edge_margin)", "not of a full mechanism"),
    (r"(modes\.)?idle_rollers", "every roller carries"),
    (r"travel\.at_angle", "every position has an equilibrium"),
    (r"travel\.variation_300", "the travel is shorter than 300 mm"),
    (r"response\.stopped_at", "the run came to its end"),
    (r"response\.", "of no part or event of this run"),
)


def response_in(result: Any, path: str) -> Any:
    """The value at the path of a response; None where there is none."""
    steps = re.split(r"\.|\[|\]", path)
    found = _value_at(result, steps) if path else None
    if found is None and path and result.get("load_cases"):
        found = _value_at(result["load_cases"][0], steps)
    return found


def _value_at(value: Any, steps: list[str]) -> Any:
    for step in filter(None, steps):
        if isinstance(value, list):
            names = [each.get("name") for each in value]
            place = int(step) if step.isdigit() else names.index(step) if step in names else -1
            value = value[place] if 0 <= place < len(value) else None
        elif isinstance(value, np.ndarray):
            if step in ("max", "min", "mean"):
                value = float(getattr(np, step)(value)) if value.size else None
            elif step.isdigit() and int(step) < len(value) and value.ndim == 1:
                value = float(value[int(step)])
            else:
                return None
        elif isinstance(value, Record) and step in value:
            value = value[step]
        else:
            return None
    return value


@lru_cache(maxsize=1)
def numbers_known() -> frozenset[str]:
    """The paths of all numbers that a study may record."""
    return frozenset(_engine.known_responses())


def commands_of(path: str) -> tuple[str, ...]:
    """The commands whose documents may have a response."""
    path = _OF_LOAD_CASE.sub("", path)
    block = path.partition(".")[0]
    if block in ("life", "measures", "response", "preload"):
        return (block,)
    if block in ("contact", "threads"):
        return ("contact", "solve", "slip", "life", "measures")
    return ("slip",) if re.match(_OF_SLIP, path) else ("solve", "slip", "measures", "contact")


class Reasons:
    """Why responses are not in what a command answers for a case."""

    def __init__(self, case: Case, command: str) -> None:
        self._case = case
        self._command = command
        checked = case.check()
        self._ready = checked.commands
        self._input = checked.resolved_input
        self._answers: dict[str, Any] = {}

    def answer(self, command: str) -> Any:
        """What a command answers for the case; None where it cannot."""
        if command not in self._answers:
            try:
                can = self._ready[command]["ready"]
                self._answers[command] = getattr(self._case, command)() if can else None
            except InputError:
                self._answers[command] = None
        return self._answers[command]

    def of(self, path: str) -> str:
        """`write command="life"`, `needs ..`; empty for a path that no command knows."""
        if found := _OF_LOAD_CASE.match(path):
            cases = self._input.get("load_cases", [])
            names = [str(each.get("name", k)) for k, each in enumerate(cases)]
            if names and found[1] not in (*names, *map(str, range(len(names)))):
                return f"expected one of the {len(names)} load cases, from 0: {some_of(names)}"
        homes = commands_of(path)
        for command in (*homes, *COMMANDS):
            answer = self.answer(command) if command != self._command else None
            if isinstance(answer and response_in(answer, path), int | float | np.ndarray):
                return f'write command="{command}"'
        if not self._is_known(path):
            return ""
        is_here = self._command in homes
        lacking = list(self._lacking(path))
        home = self._command if is_here else homes[0]
        missing = self._ready[home]
        for block in (
            () if missing["ready"] else (*missing.get("missing", ()), *missing.get("wrong", ()))
        ):
            if not any(each.startswith(block) for each in lacking):
                lacking.append(block)
        needs = f"needs {_listed(lacking)}" if lacking else self._said(path)
        return needs if is_here else f'{needs}; write command="{home}"'

    def lacking(self, path: str) -> str:
        """`of` for a quantity of the command's own document, without the answers of others."""
        if self._command not in (homes := commands_of(path)):
            return f"needs the command `{homes[0]}`"
        lacking = list(self._lacking(path))
        return f"needs {_listed(lacking)}" if lacking else ""

    def _is_known(self, path: str) -> bool:
        plain = _OF_LOAD_CASE.sub("", path)
        series = re.sub(r"\[\d+\]$|\.(max|min|mean)$", "", plain)
        return bool({plain, series, f"{series}.max"} & numbers_known())

    def _lacking(self, path: str) -> Iterator[str]:
        """The inputs that the response needs and the case has not."""
        found = _OF_LOAD_CASE.match(path)
        load_case = f"load_cases[{found[1] if found else 0}]"
        path = _OF_LOAD_CASE.sub("", path)
        told = set()
        for begin, inputs in _NEEDED:
            for needed in inputs if re.match(begin, path) else ():
                needed = needed.replace("{load_case}", load_case)
                if needed.startswith("materials.") and not self._has(needed.rpartition(".")[0]):
                    needed = f"materials.{needed.rpartition('.')[2]}"  # One value of all parts.
                if needed not in told and not self._has(needed):
                    told.add(needed)
                    yield needed

    def _has(self, needed: str) -> bool:
        path, _, value = needed.partition(": ")
        steps = re.split(r"\.|\[|\]", path)
        found = _value_at(self._input, steps)
        if found is None and steps[0] == "materials" and len(steps) == 3:
            found = _value_at(self._input, ["materials", steps[-1]])
        return found is not None and value in ("", found)

    def _said(self, path: str) -> str:
        """Why it is absent where nothing is missing."""
        path = _OF_LOAD_CASE.sub("", path)
        if re.match(r"measures\.(critical_|speed_s)", path):
            is_inverted = self._input["mechanism"]["type"] == "inverted"
            return f"absent, {'the nut turns, not the screw' if is_inverted else 'the screw rests'}"
        return next((f"absent, {why}" for begin, why in _ABSENT if re.match(begin, path)), "absent")


def _listed(inputs: list[str]) -> str:
    quoted = [f"`{each}`" for each in inputs]
    return " and ".join(filter(None, (", ".join(quoted[:-1]), quoted[-1])))
