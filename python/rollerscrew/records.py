"""What stands inside the result documents; names and units are those of `prs --json`.

A quantity that a case does not define is absent: attribute access raises, `get` gives its default.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from rollerscrew.record import Record, Values

Array = npt.NDArray[np.float64]  #: Read-only.


class PerPart(Record):
    """One number each of screw, roller and nut."""

    __slots__ = ()
    screw: float
    roller: float
    nut: float


class PerPartRange(Record):
    """Smallest and largest value each of screw, roller and nut."""

    __slots__ = ()
    screw: Array
    roller: Array
    nut: Array


class InterfaceContact(Record):
    """Where two threads touch: Sandu, chapter 1. `body` is the screw or the nut."""

    __slots__ = ()
    radius_on_body_mm: float
    radius_on_roller_mm: float
    angle_on_body_deg: float
    angle_on_roller_deg: float
    body_curvatures_per_mm: Array
    roller_curvatures_per_mm: Array
    relative_curvatures_per_mm: Array
    curvature_sum_per_mm: float
    equivalent_radius_mm: float
    first_directions_angle_deg: float
    normal_angle_deg: float
    normal: Array
    backlash_mm: float
    hertz_constant_N_per_mm1_5: float
    ellipticity: float
    semi_major_mm_per_N1_3: float
    semi_minor_mm_per_N1_3: float
    max_shear_over_peak_pressure: float
    max_shear_depth_over_semi_minor: float
    flank_clearance_mm: float
    body_crest_clearance_mm: float
    roller_crest_clearance_mm: float


class Contacts(Record):
    """Mechanism and contacts of both interfaces."""

    __slots__ = ()
    centre_distance_mm: float
    pitch_diameter_mm: PerPart
    helix_angle_deg: PerPart
    profile_radius_limits_mm: PerPartRange
    max_rollers: int
    screw: InterfaceContact
    nut: InterfaceContact


class InterfaceLoads(Record):
    """Threads of one interface of one roller; thread 1 is next to the loaded end of the screw."""

    __slots__ = ()
    hertz_constant_N_per_mm1_5: float
    normal_angle_deg: float
    axial_load_N: Array
    normal_load_N: Array
    load_rate_percent: Array
    approach_um: Array
    semi_major_mm: Array
    semi_minor_mm: Array
    peak_pressure_MPa: Array
    max_shear_stress_MPa: Array
    max_shear_depth_mm: Array


class InterfaceSlip(Record):
    """Threads of one interface of one roller: slip, friction, film and power, Sandu chapter 3."""

    __slots__ = ()
    power_W: Array
    power_density_W_per_mm2: Array
    friction_coefficient: Array
    spin_torque_Nmm: Array
    sliding_speed_mm_per_s: Array
    max_sliding_speed_mm_per_s: Array
    film_thickness_nm: Array
    central_film_nm: Array
    film_ratio: Array
    dynamic_normal_load_N: Array


class Slip(Record):
    """Stationary slip of a load case: Sandu, chapters 2 and 3."""

    __slots__ = ()
    converged: bool
    status: str
    evaluations: int
    relative_residue: float
    speed_rpm: float
    gear_ratio: float
    slip_ratio: float
    ideal_slip_ratio: float
    optimality_percent: float
    efficiency: float
    efficiency_fit: float
    power_loss_W: float
    power_loss_input_output_W: float
    torque_screw_Nm: float
    torque_nut_Nm: float
    viscosity_mPas: float
    bearing_eccentricity_ratio: float
    slip_ratio_estimates: Values
    share_percent: Values
    roller_moments_Nmm: Values
    roller_forces_N: Values
    hottest_thread: Values
    equal_shares: Values
    screw: InterfaceSlip
    nut: InterfaceSlip


class NewtonIteration(Record):
    """One linear solve of the load distribution."""

    __slots__ = ()
    energy_J: float
    relative_residual: float
    step_length: float
    shift: float


class LoadCase(Record):
    """The answer to one load case; one that did not converge has its status and residual alone."""

    __slots__ = ()
    name: str
    axial_force_N: float
    direction: str
    position_mm: float
    converged: bool
    status: str
    iterations: int
    relative_residual: float
    axial_displacement_um: float
    axial_stiffness_N_per_um: float
    tangent_stiffness_N_per_um: float
    screw: InterfaceLoads
    nut: InterfaceLoads
    slip: Slip
    measures: Values
    warnings: list[str]
    newton_history: list[NewtonIteration]


class InputValue(Record):
    """One value of the resolved case."""

    __slots__ = ()
    path: str
    value: str
    default: bool


class PreloadPoint(Record):
    """Equilibrium under one external load."""

    __slots__ = ()
    axial_force_N: float
    converged: bool
    status: str
    iterations: int
    relative_residual: float
    axial_displacement_um: float
    tangent_stiffness_N_per_um: float
    sides: Values


class WithoutPreload(Record):
    """The same nut without preload."""

    __slots__ = ()
    stiffness_at_zero_N_per_um: Values
    lost_motion_um: float
    loads: list[PreloadPoint]


class Preload(Record):
    """The preloaded nut: forces and displacements are > 0 in tension."""

    __slots__ = ()
    arrangement: str
    position_mm: float
    held_at_mm: Values
    preload_force_N: float
    interference_um: float
    backlash_um: float
    opening_force_N: Values
    lost_motion_load_N: float
    stiffness_at_zero_N_per_um: Values
    lost_motion_um: float
    loads: list[PreloadPoint]
    without_preload: WithoutPreload


class InterfaceLife(Record):
    """Lives of the threads of one interface."""

    __slots__ = ()
    equivalent_load_N: Array
    l10_revolutions: Array
    largest_load_N: Array
    equivalent_range_N: Array
    peak_pressure_MPa: float


class DirectionLife(Record):
    """Lives under the loads of one direction."""

    __slots__ = ()
    l10_revolutions: float
    l10_revolutions_range: Array
    l10_hours: float
    l10_travel_km: float
    l10_passes: float
    share_of_revolutions: float
    mean_load_N: float
    largest_force_N: float
    static_capacity_N: float
    flank_edge_load_N: float
    static_safety: float
    static_safety_limit: str
    equilibria: int
    interpolation_error: float
    screw: InterfaceLife
    nut: InterfaceLife


class Life(Record):
    """Lives of mechanism and threads."""

    __slots__ = ()
    converged: bool
    status: str
    share: str
    capacity: Values
    loads: Values
    cycles: Values
    system: Values
    equal_shares: Values
    catalogue: Values
    static_safety: float
    static_safety_limit: str
    weakest_thread: Values
    tension: DirectionLife
    compression: DirectionLife
