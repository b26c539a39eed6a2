"""Planetary roller screws: load distribution, stiffness, contact, slip, life and design.

>>> import rollerscrew as rs
>>> rs.lesson(1).solve().load_cases[0].axial_stiffness_N_per_um
>>> rs.new("standard", screw_diameter="25 mm", lead="5 mm").check()
"""

from rollerscrew import plots, records, results, theory
from rollerscrew._engine import schema
from rollerscrew._engine import version as __version__
from rollerscrew.cad import export_step
from rollerscrew.case import Case, explore
from rollerscrew.designs import Designs
from rollerscrew.errors import InputError, InputProblem, MissingFileError
from rollerscrew.function import Function
from rollerscrew.library import configurations, lesson, lessons, lubricants, new, units
from rollerscrew.record import Record, Values
from rollerscrew.results import *  # noqa: F403

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
    "lesson",
    "lessons",
    "lubricants",
    "new",
    "plots",
    "records",
    "schema",
    "theory",
    "units",
]
__all__ += results.__all__
