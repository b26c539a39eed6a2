"""Grooved bodies as solids, by build123d: `pip install 'rollerscrew[cad]'`."""

from __future__ import annotations

import json
import math
import os
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from rollerscrew.case import Case

#: Arcs of crests and roots that are shorter than this are the points where flanks meet [mm].
_SHORTEST = 1e-6


class Thread:
    """A thread on its drawing: half the width of its groove at each radius [mm].

    A nut is described by the air in it, as a thread on the outside.
    """

    def __init__(self, profile: dict[str, Any], starts: int) -> None:
        self.starts = starts
        self.lead = 1e3 * profile["lead"]
        self.radius: NDArray[np.float64] = 1e3 * np.array(profile["radius"])
        self.height: NDArray[np.float64] = 1e3 * np.array(profile["height"])

    @property
    def half_angle(self) -> NDArray[np.float64]:
        """Of the groove in a section across the axis [rad]."""
        angle: NDArray[np.float64] = 2.0 * math.pi * self.height / abs(self.lead)
        return angle

    @property
    def area(self) -> float:
        """Of the section across the axis, by the integral of r^2/2 over the angle [mm^2].

        Times the length it is the volume, as every section is the same one turned (Pappus).
        """
        angle, square = self.half_angle, 0.5 * self.radius**2
        flanks = 2.0 * float(np.trapezoid(square, angle))
        crest = square[-1] * (2.0 * math.pi / self.starts - 2.0 * angle[-1])
        return self.starts * float(2.0 * angle[0] * square[0] + flanks + crest)


def _modeller() -> Any:
    try:
        import build123d
    except ImportError as error:
        raise ImportError(
            "this needs build123d, which is not installed; `pip install 'rollerscrew[cad]'`"
        ) from error
    return build123d


def _section(b: Any, thread: Thread, turn: float) -> Any:
    """Face across the axis at z = 0, the middle of a groove at the angle `turn` [rad]."""

    def at(radius: float, angle: float) -> Any:
        return b.Vector(radius * math.cos(angle), radius * math.sin(angle), 0.0)

    angles, radii = thread.half_angle, thread.radius
    edges = []

    def arc(radius: float, first: float, last: float) -> None:
        if radius * (last - first) > _SHORTEST:
            points = (at(radius, angle) for angle in (first, 0.5 * (first + last), last))
            edges.append(b.Edge.make_three_point_arc(*points))

    step = 2.0 * math.pi / thread.starts
    for groove in (turn + step * k for k in range(thread.starts)):
        arc(radii[0], groove - angles[0], groove + angles[0])
        rising = [at(r, groove + a) for r, a in zip(radii, angles)]
        edges.append(b.Edge.make_spline(rising))
        arc(radii[-1], groove + angles[-1], groove + step - angles[-1])
        falling = [at(r, groove + step - a) for r, a in zip(radii[::-1], angles[::-1])]
        edges.append(b.Edge.make_spline(falling))
    return b.Face(b.Wire(edges))


def _solid(b: Any, thread: Thread, length: float, turn: float = 0.0) -> Any:
    """Threads along z, from -length/2 to length/2; `turn` is that of the section at z = 0."""
    whole = 2.0 * math.pi * length / thread.lead
    section = _section(b, thread, turn - 0.5 * whole)
    solid = b.Solid.extrude_linear_with_rotation(
        section, (0, 0, 0), (0, 0, length), math.degrees(whole)
    )
    return solid.moved(b.Location((0, 0, -0.5 * length)))


def _cylinder(b: Any, diameter: float, low: float, high: float) -> Any:
    return b.Solid.make_cylinder(0.5 * diameter, high - low, b.Plane((0, 0, low)))


def _number(text: str) -> float:
    """Of a length in a resolved input, which is in mm [mm]."""
    number, unit = text.split()
    assert unit == "mm"
    return float(number)


def threads(case: Case) -> dict[str, Thread]:
    """The threads of screw, roller and nut."""
    profiles = json.loads(case._case.thread_profiles())
    starts = case.check().resolved_input["mechanism"]["starts"]
    of = {"screw": starts["screw"], "roller": starts["roller"], "nut": starts["screw"]}
    return {part: Thread(profiles[part], int(of[part])) for part in of}


def bodies(case: Case) -> dict[str, Any]:
    """Solids of build123d [mm] along z, each about its own axis: screw, roller and nut.

    True helices: the section across the axis is turned along it. Screw and nut have the length of
    the nut, the roller its threads with both ends. Where the case has no `structure` the threads
    are as long as the roller's, and the nut's wall is as thick as the roller.
    """
    b = _modeller()
    of = threads(case)
    resolved = case.check().resolved_input
    mechanism = resolved["mechanism"]
    pitch = abs(of["screw"].lead) / of["screw"].starts
    threaded = int(mechanism["contacts_per_roller"]) * pitch
    nut = resolved.get("structure", {}).get("nut", {})
    length = _number(nut["length"]) if nut else threaded

    screw = _solid(b, of["screw"], length)
    bore = _number(resolved["structure"]["screw"]["bore"]) if nut else 0.0
    if bore > 0.0:
        screw = screw - _cylinder(b, bore, -length, length)

    # Its crest stands in the screw's groove, at the side of the screw's axis.
    roller = _solid(b, of["roller"], threaded, math.pi - math.pi / of["roller"].starts)
    ends = resolved["structure"]["roller"] if nut else {}
    if ends and _number(ends["end_length"]) > 0.0:
        for low, high in (
            (-0.5 * threaded - _number(ends["end_length"]), -0.5 * threaded),
            (0.5 * threaded, 0.5 * threaded + _number(ends["end_length"])),
        ):
            roller = roller + _cylinder(b, _number(ends["end_diameter"]), low, high)

    # With an even number of starts the roller has crests on both sides, at the nut too.
    turn = math.pi / of["nut"].starts if of["roller"].starts % 2 == 0 else 0.0
    outer = (
        _number(nut["outer_diameter"])
        if nut
        else 2.0 * (of["nut"].radius[-1] + of["roller"].radius[-1])
    )
    air = _solid(b, of["nut"], length, turn)
    shell = _cylinder(b, outer, -0.5 * length, 0.5 * length) - air
    for flange in nut.get("flanges", []):
        low, high = (_number(flange[end]) - 0.5 * length for end in ("from", "to"))
        ring = _cylinder(b, _number(flange["outer_diameter"]), low, high)
        shell = shell + (ring - _cylinder(b, outer, low, high))
    return {"screw": screw, "roller": roller, "nut": shell}


def export_step(case: Case, file: str | os.PathLike[str]) -> None:
    """Writes screw, nut and all rollers with their grooves as a STEP file, in millimetres.

    They stand in phase, in the middle of their play: each roller's crests in the screw's grooves.
    Raises ImportError where build123d is missing.
    """
    b = _modeller()
    of, solids = threads(case), bodies(case)
    count = int(case.check().resolved_input["mechanism"]["rollers"])
    centre_distance = 1e3 * json.loads(case._case.thread_profiles())["centre_distance"]
    parts = []
    for part, solid in solids.items():
        solid.label = part
        if part != "roller":
            parts.append(solid)
    for k in range(count):
        orbit = 2.0 * math.pi * k / count
        # So that at the side of the screw its crest is where the screw's groove is.
        spin = orbit - orbit * of["screw"].lead / of["roller"].lead
        place = b.Location(
            (centre_distance * math.cos(orbit), centre_distance * math.sin(orbit), 0.0),
            (0.0, 0.0, math.degrees(spin)),
        )
        parts.append(solids["roller"].moved(place))
    assembly = b.Compound(label="planetary roller screw", children=parts)
    if not b.export_step(assembly, os.fspath(file)):
        raise OSError(f"cannot write {os.fspath(file)}")
