"""Planetary roller screws: load distribution, stiffness, contact, slip, life and design.

>>> import rollerscrew as rs
>>> case = rs.new("standard", screw_diameter="25 mm", lead="5 mm")  # or rs.lesson(1)
>>> case = rs.Case.from_yaml("mine.yaml")  # which case.to_yaml("mine.yaml") writes
>>> case.inputs()  # what may be changed, with paths
>>> case.responses()  # what may be asked for
>>> result = case.solve()  # slip, life, measures, preload, contact, check, ..
>>> result.load_cases[0].axial_stiffness_N_per_um
>>> result.plot_load_distribution()
>>> nine = case.with_({"mechanism.rollers": 9})
>>> rs.plots.compare({"as it was": result, "9 rollers": nine.solve()}, "load_distribution")
>>> case.evaluate({"mechanism.rollers": [8, 9, 10]}, ["axial_stiffness_N_per_um"])  # many designs
>>> f = case.function(["mechanism.flank_angle"], ["screw.peak_pressure_MPa.max"])  # for optimizers
"""

from rollerscrew import plots, records, results, theory
from rollerscrew._engine import schema
from rollerscrew._engine import version as __version__
from rollerscrew.cad import export_step
from rollerscrew.case import Case, explore
from rollerscrew.designs import Designs
from rollerscrew.errors import InputError, InputProblem, MissingFileError
from rollerscrew.fitting import fit
from rollerscrew.function import Function
from rollerscrew.library import configurations, lesson, lessons, lubricants, new, units
from rollerscrew.record import Record, Values
from rollerscrew.results import *  # noqa: F403
from rollerscrew.sizing import size

__all__ = [
    "Case",
    "Designs",
    "Function",
    "InputError",
    "InputProblem",
    "MissingFileError",
    "Record",
    "Values",
    "__version__",
    "configurations",
    "explore",
    "export_step",
    "fit",
    "lesson",
    "lessons",
    "lubricants",
    "new",
    "plots",
    "records",
    "schema",
    "size",
    "theory",
    "units",
]
__all__ += results.__all__


def __dir__() -> list[str]:
    """Without the modules that it consists of."""
    return sorted([*__all__, "results"])
