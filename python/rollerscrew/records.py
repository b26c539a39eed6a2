"""What stands inside the result documents; names and units are those of `prs --json`.

A quantity that a case does not define is absent: attribute access raises, `get` gives its default.
What each is: docs/reference. Written by scripts/reference.py from the program's table.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
import numpy.typing as npt

from rollerscrew.record import Record

Array = npt.NDArray[np.float64]  #: Read-only.

#: What each design of a study runs through.
Command = Literal["contact", "solve", "slip", "life", "measures"]


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
    """Where two threads touch: Sandu 2018, chapter 1. `body` is the screw or the nut."""

    __slots__ = ()
    radius_on_body_mm: float
    radius_on_roller_mm: float
    angle_on_body_deg: float
    angle_on_roller_deg: float
    flank_clearance_mm: float
    body_crest_clearance_mm: float
    roller_crest_clearance_mm: float
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


class ThreadWidths(Record):
    """Axial widths of a truncated thread."""

    __slots__ = ()
    crest_width_mm: float
    root_width_mm: float


class Threads(Record):
    """Threads of the parts by themselves; needs their heights."""

    __slots__ = ()
    screw: ThreadWidths
    roller: ThreadWidths
    nut: ThreadWidths


class Criterion(Record):
    """A value, the limit that it is held against, and how it stands to it."""

    __slots__ = ()
    name: str
    title: str
    unit: str
    sense: str
    value: float
    best: float
    limit: float
    limit_source: str
    state: str
    load_case: str
    reason: str


class Verdict(Record):
    """Whether the case meets its limits."""

    __slots__ = ()
    state: str
    criteria: list[Criterion]


class Model(Record):
    """How the loads were solved."""

    __slots__ = ()
    bodies: str
    roller_contacts: str
    effects_off: list[str]
    accuracy: str
    tooth_compliance_width_mm: float
    note: str


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
    roller_share_percent: Array
    largest_normal_load_N: float
    largest_roller: int
    largest_thread: int
    overload_factor: float
    unloaded_threads: int


class ScrewEnd(Record):
    """The loaded section of the screw of a full mechanism."""

    __slots__ = ()
    displacement_um: Array
    rotation_mrad: Array
    freedoms: list[str]
    stiffness_SI: Array
    compliance_SI: Array


class NutSupport(Record):
    """What holds the nut."""

    __slots__ = ()
    force_N: Array
    moment_Nm: Array
    at_mm: float


class RingForce(Record):
    """What a guide ring does to the rollers."""

    __slots__ = ()
    force_N: Array
    moment_Nm: Array
    at_mm: float
    roller_N: Array


class BearingForce(Record):
    """What a bearing does to the screw."""

    __slots__ = ()
    at_mm: float
    force_N: Array
    moment_Nm: Array


class Reactions(Record):
    """Forces of the supports of a full mechanism on its parts."""

    __slots__ = ()
    nut: NutSupport
    rings: list[RingForce]
    bearings: list[BearingForce]


class SymmetricLoads(Record):
    """The screw under its axial force alone."""

    __slots__ = ()
    axial_displacement_um: float
    axial_stiffness_N_per_um: float
    tangent_stiffness_N_per_um: float
    largest_normal_load_N: Array


class OrbitLoads(Record):
    """What a turn of the carrier does at an interface."""

    __slots__ = ()
    first_roller_largest_normal_load_N: Array
    equivalent_normal_load_N: Array
    largest_normal_load_N: float
    at_carrier_angle_deg: float
    largest_roller: int
    largest_thread: int
    largest_equivalent_normal_load_N: float
    least_normal_load_N: float


class Orbit(Record):
    """A turn of the carrier of a full mechanism."""

    __slots__ = ()
    steps: int
    positions: int
    exponent: float
    carrier_angles_deg: Array
    screw: OrbitLoads
    nut: OrbitLoads
    axial_displacement_um: Array
    axial_error_um: float


class NewtonIteration(Record):
    """One linear solve of the load distribution."""

    __slots__ = ()
    energy_J: float
    relative_residual: float
    step_length: float
    shift: float


class PartNumbers(Record):
    """A number of each part."""

    __slots__ = ()
    screw: float
    rollers: float
    nut: float


class InterfaceNumbers(Record):
    """A number of each interface."""

    __slots__ = ()
    screw: float
    nut: float


class Heat(Record):
    """Steady temperatures: what friction puts into the parts flows off through the conductances."""

    __slots__ = ()
    converged: bool
    status: str
    reason: str
    evaluations: int
    other_steady_states: bool
    temperature_degC: PartNumbers
    oil_degC: InterfaceNumbers
    heat_W: PartNumbers


class SlipRatioEstimates(Record):
    """Slip ratios by formulas of geometry alone."""

    __slots__ = ()
    simple: float
    jones: float


class PowerShares(Record):
    """Where power is lost."""

    __slots__ = ()
    screw: float
    nut: float
    carrier_roller: float
    carrier_screw: float
    carrier_nut: float


class RollerMoments(Record):
    """Moments on one roller about its axis; they add up to zero in equilibrium. Sandu 2018, (3.39) to (3.42)."""

    __slots__ = ()
    contacts: float
    spin: float
    carrier: float
    gears: float


class RollerForces(Record):
    """Forces on one roller across its axis, x away from the screw's axis, y along the orbit."""

    __slots__ = ()
    contacts_x: float
    contacts_y: float
    gears_x: float
    gears_y: float
    carrier_x: float
    carrier_y: float
    centrifugal: float


class HottestThread(Record):
    """The thread of the largest power density."""

    __slots__ = ()
    interface: str
    thread: int
    power_W: float
    power_density_W_per_mm2: float
    roller: int


class EqualShareSlip(Record):
    """Slip if all threads carried the same load."""

    __slots__ = ()
    slip_ratio: float
    power_loss_W: float
    efficiency: float
    max_thread_power_W: float
    max_power_density_W_per_mm2: float


class InterfaceSlip(Record):
    """Threads of one interface of one roller: slip, friction, film and power; Sandu 2018, chapter 3."""

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
    boundary_share: Array
    dynamic_normal_load_N: Array
    wear_mm3_per_km: Array


class Slip(Record):
    """Stationary slip of a load case: Sandu 2018, chapters 2 and 3."""

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
    driven_by: str
    efficiency: float
    self_locking: bool
    holding_torque_Nm: float
    efficiency_fit: float
    power_loss_W: float
    power_loss_input_output_W: float
    torque_screw_Nm: float
    torque_nut_Nm: float
    viscosity_mPas: float
    bearing_eccentricity_ratio: float
    slip_ratio_estimates: SlipRatioEstimates
    share_percent: PowerShares
    roller_moments_Nmm: RollerMoments
    roller_forces_N: RollerForces
    hottest_thread: HottestThread
    equal_shares: EqualShareSlip
    screw: InterfaceSlip
    nut: InterfaceSlip


class LoadMeasures(Record):
    """Design measures under one load."""

    __slots__ = ()
    hertz_stiffness_screw_N_per_um: float
    hertz_stiffness_nut_N_per_um: float
    thread_stiffness_N_per_um: float
    yang_largest_load_rate_percent: float
    largest_load_rate_screw_percent: float
    largest_load_rate_nut_percent: float
    largest_load_rate_percent: float
    mean_peak_pressure_screw_MPa: float
    mean_peak_pressure_nut_MPa: float
    largest_peak_pressure_screw_MPa: float
    largest_peak_pressure_nut_MPa: float
    root_shear_stress_screw_MPa: float
    root_shear_stress_roller_MPa: float
    root_shear_stress_nut_MPa: float
    root_bending_stress_screw_MPa: float
    root_bending_stress_roller_MPa: float
    root_bending_stress_nut_MPa: float
    solved_static_safety: float
    static_safety: float
    thread_static_safety: float
    buckling_safety: float
    l10_revolutions: float
    l10_hours: float
    l10_travel_km: float
    drive_torque_Nm: float
    back_driving_efficiency_by_slip: float
    speed_safety: float
    solved_static_safety_limit: str
    static_safety_limit: str
    thread_static_safety_limit: str
    yang_load_rate_percent: Array


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
    factorization: str
    axial_displacement_um: float
    axial_stiffness_N_per_um: float
    tangent_stiffness_N_per_um: float
    screw: InterfaceLoads
    nut: InterfaceLoads
    dofs: int
    rollers: int
    carrier_angle_deg: float
    idle_rollers: Array
    screw_end: ScrewEnd
    reactions: Reactions
    symmetric: SymmetricLoads
    orbit: Orbit
    warnings: list[str]
    newton_history: list[NewtonIteration]
    heat: Heat
    slip: Slip
    measures: LoadMeasures


class MostLoadedThread(Record):
    """What an interface's threads carry, by one model."""

    __slots__ = ()
    most_loaded_thread: int
    most_loaded_roller: int
    largest_load_rate_percent: float
    largest_peak_pressure_MPa: float
    load_rate_percent: Array


class ComparedModel(Record):
    """The answer of one model of the bodies to a load case."""

    __slots__ = ()
    bodies: str
    converged: bool
    axial_stiffness_N_per_um: float
    stiffness_over_best: float
    axial_displacement_um: float
    largest_peak_pressure_MPa: float
    pressure_over_best: float
    screw: MostLoadedThread
    nut: MostLoadedThread


class ComparedLoadCase(Record):
    """A load case by each model of the bodies."""

    __slots__ = ()
    name: str
    axial_force_N: float
    direction: str
    position_mm: float
    models: list[ComparedModel]
    warnings: list[str]


class Comparison(Record):
    """The models of the bodies side by side."""

    __slots__ = ()
    models: list[str]
    load_cases: list[ComparedLoadCase]


class PartSeries(Record):
    """Numbers of each part over time."""

    __slots__ = ()
    screw: Array
    rollers: Array
    nut: Array


class HeatCycle(Record):
    """The state of a duty that repeats itself from cycle to cycle."""

    __slots__ = ()
    converged: bool
    status: str
    reason: str
    period_s: float
    time_s: Array
    temperature_degC: PartSeries
    peak_degC: PartNumbers
    mean_degC: PartNumbers
    energy_in_J: float
    energy_lost_J: float
    efficiency: float


class PerDirection(Record):
    """One number for each sense of the load."""

    __slots__ = ()
    tension: float
    compression: float


class PreloadSide(Record):
    """Contacts that carry one sense of the load."""

    __slots__ = ()
    axial_load_N: float
    max_normal_load_N: float
    peak_pressure_MPa: float


class PreloadSides(Record):
    """Contacts by the sense of the load that they carry."""

    __slots__ = ()
    tension: PreloadSide
    compression: PreloadSide


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
    sides: PreloadSides


class WithoutPreload(Record):
    """The same nut without preload."""

    __slots__ = ()
    stiffness_at_zero_N_per_um: PerDirection
    lost_motion_um: float
    loads: list[PreloadPoint]


class Preload(Record):
    """The preloaded nut: forces and displacements are > 0 in tension."""

    __slots__ = ()
    arrangement: str
    position_mm: float
    held_at_mm: PerDirection
    preload_force_N: float
    interference_um: float
    backlash_um: float
    opening_force_N: PerDirection
    lost_motion_load_N: float
    stiffness_at_zero_N_per_um: PerDirection
    lost_motion_um: float
    loads: list[PreloadPoint]
    without_preload: WithoutPreload


class PerInterface(Record):
    """One number each of the roller's contacts with screw and nut."""

    __slots__ = ()
    screw: float
    nut: float


class Capacity(Record):
    """What the mechanism can carry."""

    __slots__ = ()
    dynamic_capacity_N: float
    dynamic_capacity_range_N: Array
    source: str
    geometry_factor: float
    geometry_factor_range: Array
    diameter_ratio: float
    element_diameter_mm: float
    failure_share: PerInterface
    roller_failure_share: PerInterface
    static_capacity_equal_shares_N: float
    flank_edge_load_equal_shares_N: float
    static_capacity_given_N: float


class LifeLoads(Record):
    """The history or the spectrum."""

    __slots__ = ()
    samples: int
    revolutions: float
    travel_m: float
    duration_h: float
    mean_load_N: float
    largest_force_N: float


class CycleMatrix(Record):
    """Load cycles by range and mean."""

    __slots__ = ()
    range_to_N: float
    mean_from_N: float
    mean_to_N: float
    count: Array


class Cycles(Record):
    """Load cycles of a history: rainflow, ASTM E1049-85."""

    __slots__ = ()
    count: float
    fatigue_slope: float
    equivalent_range_N: float
    largest_range_N: float
    matrix: CycleMatrix


class LifeInUse(Record):
    """A life L10 at the value of the dynamic capacity."""

    __slots__ = ()
    l10_revolutions: float
    l10_revolutions_range: Array
    l10_hours: float
    l10_travel_km: float
    l10_passes: float
    rated_revolutions: float
    rated_revolutions_range: Array
    rated_hours: float
    rated_travel_km: float
    rated_passes: float


class WeakestThread(Record):
    """The thread that fails first, of those that turn under load."""

    __slots__ = ()
    l10_revolutions: float
    l10_revolutions_range: Array
    l10_hours: float
    l10_travel_km: float
    l10_passes: float
    rated_revolutions: float
    rated_revolutions_range: Array
    rated_hours: float
    rated_travel_km: float
    rated_passes: float
    direction: str
    interface: str
    thread: int
    part: str
    roller: int
    equivalent_load_N: float


class RollerLives(Record):
    """Lives of the threads of the rollers at one interface."""

    __slots__ = ()
    equivalent_load_N: Array
    l10_revolutions: Array
    rated_revolutions: Array


class InterfaceLife(Record):
    """Lives of the threads of one interface."""

    __slots__ = ()
    equivalent_load_N: Array
    l10_revolutions: Array
    rated_revolutions: Array
    largest_load_N: Array
    equivalent_range_N: Array
    rollers: RollerLives
    peak_pressure_MPa: float


class DirectionLife(Record):
    """Lives under the loads of one direction."""

    __slots__ = ()
    l10_revolutions: float
    l10_revolutions_range: Array
    l10_hours: float
    l10_travel_km: float
    l10_passes: float
    rated_revolutions: float
    rated_revolutions_range: Array
    rated_hours: float
    rated_travel_km: float
    rated_passes: float
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
    reliability_factor: float
    modification_factor: float
    capacity: Capacity
    loads: LifeLoads
    cycles: Cycles
    system: LifeInUse
    equal_shares: LifeInUse
    catalogue: LifeInUse
    static_safety: float
    static_safety_limit: str
    weakest_thread: WeakestThread
    tension: DirectionLife
    compression: DirectionLife


class Measures(Record):
    """Design measures of the mechanism that no load changes."""

    __slots__ = ()
    velocity_ratio_mm_per_rad: float
    roller_ratio: float
    carrier_ratio: float
    efficiency: float
    back_driving_efficiency: float
    section_stiffness_screw_N_per_um: float
    section_stiffness_roller_N_per_um: float
    section_stiffness_nut_N_per_um: float
    tooth_stiffness_screw_N_per_um: float
    tooth_stiffness_roller_N_per_um: float
    tooth_stiffness_nut_N_per_um: float
    geometry_factor: float
    element_diameter_mm: float
    dynamic_capacity_N: float
    dynamic_capacity_low_N: float
    dynamic_capacity_high_N: float
    static_capacity_N: float
    deformation_capacity_screw_N: float
    deformation_capacity_nut_N: float
    pressure_capacity_screw_N: float
    pressure_capacity_nut_N: float
    flank_edge_load_N: float
    flank_edge_load_screw_N: float
    flank_edge_load_nut_N: float
    roller_weight_kg: float
    nut_weight_kg: float
    weight_kg: float
    screw_weight_kg_per_m: float
    material_volume_cm3: float
    envelope_volume_cm3: float
    force_density_kN_per_kg: float
    roller_inertia_kg_mm2: float
    travel_inertia_kg_mm2: float
    screw_inertia_kg_mm2: float
    nut_inertia_kg_mm2: float
    equivalent_inertia_kg_mm2: float
    shaft_stiffness_N_per_um: float
    buckling_load_N: float
    critical_speed_rpm: float
