"""Planetary roller screws: load distribution, stiffness, contact, slip, life and design.

>>> import rollerscrew as rs
>>> case = rs.Case.from_yaml("configs/01_config_1_to_3.yaml")
>>> case.solve().load_cases[0].axial_stiffness_N_per_um
"""

from rollerscrew import records, results
from rollerscrew._engine import InputError, schema
from rollerscrew._engine import version as __version__
from rollerscrew.cad import export_step
from rollerscrew.case import Case, explore
from rollerscrew.designs import Designs
from rollerscrew.record import Record, Values
from rollerscrew.results import *  # noqa: F403
from rollerscrew.sizing import size

__all__ = [
    "Case",
    "Designs",
    "InputError",
    "Record",
    "Values",
    "__version__",
    "explore",
    "export_step",
    "records",
    "schema",
    "size",
]
__all__ += results.__all__

InputError.__module__ = __name__
