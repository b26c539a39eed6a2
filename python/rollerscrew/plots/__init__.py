"""Pictures of results, one function each; `plot_` methods of the results call them.

Every function draws into `ax`, which keeps its style, or into a new figure in the style of a paper,
and returns the axes. Matplotlib is imported with the first picture.
"""

from rollerscrew.plots.contact import contact_points, ellipses
from rollerscrew.plots.designs_cloud import designs
from rollerscrew.plots.life import cycles, thread_lives
from rollerscrew.plots.loads import (
    butterfly,
    convergence,
    displacement,
    load_distribution,
    pressures,
    stiffness,
)
from rollerscrew.plots.measures import stiffness_terms
from rollerscrew.plots.optimization import front
from rollerscrew.plots.preload import preload_displacement, preload_stiffness
from rollerscrew.plots.sensitivity import elasticities, study_contributions, study_histogram
from rollerscrew.plots.slip import friction, power, power_by_source
from rollerscrew.plots.study_lines import study_lines
from rollerscrew.plots.study_maps import study_envelope, study_map

__all__ = [
    "butterfly",
    "contact_points",
    "convergence",
    "cycles",
    "designs",
    "displacement",
    "elasticities",
    "ellipses",
    "friction",
    "front",
    "load_distribution",
    "power",
    "power_by_source",
    "preload_displacement",
    "preload_stiffness",
    "pressures",
    "stiffness",
    "stiffness_terms",
    "study_contributions",
    "study_envelope",
    "study_histogram",
    "study_lines",
    "study_map",
    "thread_lives",
]
