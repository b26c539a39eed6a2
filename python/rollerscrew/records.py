"""What stands inside the result documents; names and units are those of `prs --json`.

Of what a case may not define the attribute is None; `record["name"]` raises and says why.
Written by scripts/reference.py from the program's table.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
import numpy.typing as npt

from rollerscrew.record import Record

Array = npt.NDArray[np.float64]  #: Read-only.

#: What each design of a study runs through.
Command = Literal["contact", "solve", "slip", "life", "measures", "response"]


class PerPart(Record):
    """One number each of screw, roller and nut.

    screw: screw
    roller: roller
    nut: nut
    """

    __slots__ = ()
    screw: float
    roller: float
    nut: float


class PerPartRange(Record):
    """Smallest and largest value each of screw, roller and nut.

    screw: screw
    roller: roller
    nut: nut
    """

    __slots__ = ()
    screw: Array
    roller: Array
    nut: Array


class InterfaceContact(Record):
    """Where two threads touch: Sandu 2018, chapter 1. `body` is the screw or the nut.

    radius_on_body_mm [mm]: of the contact point from the body's axis; Sandu 2018, chapter 1
    radius_on_roller_mm [mm]: of the contact point from the roller's axis; Sandu 2018, chapter 1
    angle_on_body_deg [deg]: of the contact point about the body's axis, from the line of centres; Sandu 2018, chapter 1
    angle_on_roller_deg [deg]: of the contact point about the roller's axis, from the line of centres; Sandu 2018, chapter 1
    flank_clearance_mm [mm]: along the axis, each thread in the middle of the other's groove; half the backlash; Yao 2023, (55) to (58)
    body_crest_clearance_mm [mm]: along the axis, from the edge of the body's crest to the roller's flank; Yao 2023, (55) to (58)
    roller_crest_clearance_mm [mm]: along the axis, from the edge of the roller's crest to the body's flank; Yao 2023, (55) to (58)
    body_curvatures_per_mm [1/mm]: principal curvatures, convex > 0, ascending in absolute value; Sandu 2018, chapter 1
    roller_curvatures_per_mm [1/mm]: principal curvatures, convex > 0, ascending in absolute value; Sandu 2018, chapter 1
    relative_curvatures_per_mm [1/mm]: eigenvalues of the sum of both curvature tensors, without a factor 1/2; Sandu 2018, chapter 1
    curvature_sum_per_mm [1/mm]: kappa_1 + kappa_2; Sandu 2018, (1.77)
    equivalent_radius_mm [mm]: 1 over the sum of the relative curvatures
    first_directions_angle_deg [deg]: between the first principal directions of body and roller; Sandu 2018, (1.61)
    normal_angle_deg [deg]: psi = arccos|n_z|; Sandu 2018, chapter 1
    normal: unit vector, outward from the roller: radial, across, axial; Sandu 2018, chapter 1
    position_mm [mm]: contact point in tension: radial and across from the axis of screw and nut, axial from the origin of the roller's surface; in compression across and axial change sign; Sandu 2018, (1.22)
    origin_height_tension_mm [mm]: of the body's surface origin above the roller's, along the axis, in tension; needs equal pitches; Sandu 2018, (1.41) to (1.44)
    origin_height_compression_mm [mm]: the same in compression; Sandu 2018, (1.41) to (1.44)
    major_axis: t_1, unit vector along the major axis of the ellipse: radial, across, axial; Sandu 2018, (1.67)
    major_axis_from_body_deg [deg]: phi_1, acute angle of the major axis from the body's first principal direction; Sandu 2018, (1.65); Yao 2023, (36)
    major_axis_from_roller_deg [deg]: phi_2, acute angle of the major axis from the roller's first principal direction; Sandu 2018, (1.62); Yao 2023, (36)
    backlash_mm [mm]: axial play of both faces; < 0: the threads are too thick; needs equal pitches; Sandu 2018, (1.40)
    hertz_constant_N_per_mm1_5 [N/mm^1.5]: k_0 of N = k_0 delta^1.5; Hertz with exact ellipticity
    ellipticity: b/a of the contact ellipse; Hertz with exact ellipticity
    semi_major_mm_per_N1_3 [mm/N^(1/3)]: semi-axis a over the cube root of the normal load; Hertz with exact ellipticity
    semi_minor_mm_per_N1_3 [mm/N^(1/3)]: semi-axis b over the cube root of the normal load; Hertz with exact ellipticity
    max_shear_over_peak_pressure: largest shear stress below the surface over p_0; Hertz with exact ellipticity
    max_shear_depth_over_semi_minor: its depth over b; Hertz with exact ellipticity
    max_von_mises_over_peak_pressure: largest von Mises stress below the centre of the ellipse over p_0; Hertz with exact ellipticity
    max_von_mises_depth_over_semi_minor: its depth over b; Hertz with exact ellipticity
    """

    __slots__ = ()
    radius_on_body_mm: float
    radius_on_roller_mm: float
    angle_on_body_deg: float
    angle_on_roller_deg: float
    flank_clearance_mm: float | None
    body_crest_clearance_mm: float | None
    roller_crest_clearance_mm: float | None
    body_curvatures_per_mm: Array
    roller_curvatures_per_mm: Array
    relative_curvatures_per_mm: Array
    curvature_sum_per_mm: float
    equivalent_radius_mm: float
    first_directions_angle_deg: float
    normal_angle_deg: float
    normal: Array
    position_mm: Array
    origin_height_tension_mm: float | None
    origin_height_compression_mm: float | None
    major_axis: Array
    major_axis_from_body_deg: float
    major_axis_from_roller_deg: float
    backlash_mm: float | None
    hertz_constant_N_per_mm1_5: float | None
    ellipticity: float | None
    semi_major_mm_per_N1_3: float | None
    semi_minor_mm_per_N1_3: float | None
    max_shear_over_peak_pressure: float | None
    max_shear_depth_over_semi_minor: float | None
    max_von_mises_over_peak_pressure: float | None
    max_von_mises_depth_over_semi_minor: float | None


class Contacts(Record):
    """Mechanism and contacts of both interfaces.

    centre_distance_mm [mm]: from the axis of the screw to that of a roller
    pitch_diameter_mm [mm]: where thread and groove are equally wide, or as the file has it
    helix_angle_deg [deg]: at the pitch diameter
    profile_radius_limits_mm [mm]: radii between which there is a flank
    max_rollers: that fit side by side
    screw: of roller and screw
    nut: of roller and nut
    """

    __slots__ = ()
    centre_distance_mm: float
    pitch_diameter_mm: PerPart
    helix_angle_deg: PerPart
    profile_radius_limits_mm: PerPartRange
    max_rollers: int
    screw: InterfaceContact | None
    nut: InterfaceContact | None


class ThreadWidths(Record):
    """Axial widths of a truncated thread.

    crest_width_mm [mm]: along the axis; < 0: the profile ends before; Yao 2023, (52) to (54)
    root_width_mm [mm]: along the axis; Yao 2023, (52) to (54)
    """

    __slots__ = ()
    crest_width_mm: float | None
    root_width_mm: float | None


class Threads(Record):
    """Threads of the parts by themselves; needs their heights.

    screw: screw
    roller: roller
    nut: nut
    """

    __slots__ = ()
    screw: ThreadWidths | None
    roller: ThreadWidths | None
    nut: ThreadWidths | None


class Criterion(Record):
    """A value, the limit that it is held against, and how it stands to it.

    name: key in `limits`, where it has one
    title: in words
    unit: of value and limit; empty for ratios and fractions
    sense: least | greatest: which the limit is
    value: the worst of all load cases, with the real thread loads
    best: the best value of all load cases and places
    limit: that it is held against
    limit_source: case | physics | recommended: `limits` of the case, what physics allows, or what is usual
    state: green | amber | red | no_limit | not_computed | not_applicable
    load_case: where the worst value stands
    reason: what limits it, or why there is no value
    """

    __slots__ = ()
    name: str
    title: str
    unit: str
    sense: str
    value: float | None
    best: float | None
    limit: float | None
    limit_source: str | None
    state: str
    load_case: str | None
    reason: str | None


class Verdict(Record):
    """Whether the case meets its limits.

    state: the worst: green | amber | red | no_limit
    criteria: each with its worst value
    not_built: commands that the case is ready for and this program leaves out; scripts/install.sh builds all
    skipped: commands that the case is ready for and that were not run, as they take long; `prs report` runs them
    failed: commands that the case is ready for and that found something wrong with it
    """

    __slots__ = ()
    state: str
    criteria: list[Criterion]
    not_built: list[str] | None
    skipped: list[str] | None
    failed: list[str] | None


class Model(Record):
    """How the loads were solved.

    bodies: bars | refined | influence
    roller_contacts: opposite | half_pitch_apart
    effects_off: effects of `refined` that are switched off
    accuracy: working | reference, of `influence`
    tooth_compliance_width_mm [mm]: of the teeth that deflect as Yamamoto has it
    note: how far it is known to be off
    """

    __slots__ = ()
    bodies: str
    roller_contacts: str | None
    effects_off: list[str] | None
    accuracy: str | None
    tooth_compliance_width_mm: float | None
    note: str | None


class Running(Record):
    """How loads of a running screw and their friction were found.

    status: how the search for loads and friction ended
    rounds: evaluations of slip
    change: of a thread's load in the last round, over the largest load
    """

    __slots__ = ()
    status: str
    rounds: int
    change: float


class LargestAtRest(Record):
    """Threads of an interface of a screw at rest.

    largest_normal_load_N [N]: of all threads
    """

    __slots__ = ()
    largest_normal_load_N: float


class AtRest(Record):
    """What a running load case is at rest.

    screw: threads at the screw
    nut: threads at the nut
    axial_displacement_um [µm]: of the loaded section; > 0 along the load
    """

    __slots__ = ()
    screw: LargestAtRest
    nut: LargestAtRest
    axial_displacement_um: float


class FrictionForces(Record):
    """Friction of each thread on the roller.

    axial: along x, from the loaded end of the screw
    radial: outwards
    tangential: along the orbit
    """

    __slots__ = ()
    axial: Array
    radial: Array
    tangential: Array


class InterfaceLoads(Record):
    """Threads of one interface of one roller; thread 1 is next to the loaded end of the screw.

    hertz_constant_N_per_mm1_5 [N/mm^1.5]: k_0 of N = k_0 delta^1.5, as used in the solve; Hertz with exact ellipticity
    normal_angle_deg [deg]: psi between the normal and the axis, as used in the solve
    axial_load_N [N]: axial part of the normal load, of a running screw with that of friction
    normal_load_N [N]: at rest axial load over cos(psi)
    load_rate_percent [%]: share: axial load over force per roller; Abevi 2015, (3)
    approach_um [µm]: by which the bodies come closer along the normal; Hertz with exact ellipticity
    semi_major_mm [mm]: longer semi-axis a of the contact ellipse; Hertz with exact ellipticity
    semi_minor_mm [mm]: shorter semi-axis b of the contact ellipse; Hertz with exact ellipticity
    peak_pressure_MPa [MPa]: p_0 = 3 N/(2 pi a b); Hertz with exact ellipticity
    max_shear_stress_MPa [MPa]: largest shear stress below the surface; Hertz with exact ellipticity
    max_shear_depth_mm [mm]: where the largest shear stress acts, for the depth of hardening; Hertz with exact ellipticity
    max_von_mises_stress_MPa [MPa]: largest von Mises stress below the centre of the ellipse; Hertz with exact ellipticity
    max_von_mises_depth_mm [mm]: where the largest von Mises stress acts; Hertz with exact ellipticity
    friction_force_N [N]: of each thread on the roller; running loads
    running_over_static: largest normal load over the largest of the same case at rest; running loads
    roller_share_percent [%]: of the axial load, one for each roller
    largest_normal_load_N [N]: of all rollers
    largest_roller: where the largest load acts, from 1
    largest_thread: where the largest load acts, from 1
    overload_factor: largest load over that of the same screw with the axial force only
    unloaded_threads: of the rollers present
    """

    __slots__ = ()
    hertz_constant_N_per_mm1_5: float | None
    normal_angle_deg: float
    axial_load_N: Array
    normal_load_N: Array
    load_rate_percent: Array | None
    approach_um: Array
    semi_major_mm: Array
    semi_minor_mm: Array
    peak_pressure_MPa: Array
    max_shear_stress_MPa: Array
    max_shear_depth_mm: Array
    max_von_mises_stress_MPa: Array
    max_von_mises_depth_mm: Array
    friction_force_N: FrictionForces | None
    running_over_static: float | None
    roller_share_percent: Array | None
    largest_normal_load_N: float | None
    largest_roller: int | None
    largest_thread: int | None
    overload_factor: float | None
    unloaded_threads: int | None


class FlankThreads(Record):
    """Threads of a flank of one roller at an interface.

    normal_load_N [N]: of each thread of a roller
    power_W [W]: that friction takes at each of them; with slip
    axial_N [N]: axial load of all rollers; that of the tension flank less that of the compression flank is the load
    """

    __slots__ = ()
    normal_load_N: Array
    power_W: Array | None
    axial_N: float


class Flank(Record):
    """A flank of a nut under preload.

    screw: threads at the screw
    nut: threads at the nut
    """

    __slots__ = ()
    screw: FlankThreads
    nut: FlankThreads


class Flanks(Record):
    """Both flanks of a nut under preload.

    tension: that carries tension
    compression: that carries compression
    """

    __slots__ = ()
    tension: Flank
    compression: Flank


class ScrewEnd(Record):
    """The loaded section of the screw of a full mechanism.

    displacement_um [µm]: x, y, z; misalignment included
    rotation_mrad [mrad]: about y and z
    freedoms: those that no bearing holds there: the order of both matrices
    stiffness_SI: tangent, N/m, N and N m/rad; the inverse of the compliance
    compliance_SI: displacements per load at the load
    """

    __slots__ = ()
    displacement_um: Array
    rotation_mrad: Array
    freedoms: list[str]
    stiffness_SI: Array | None
    compliance_SI: Array | None


class NutSupport(Record):
    """What holds the nut.

    force_N [N]: x, y, z, of the housing on the nut
    moment_Nm [N m]: about y and z
    at_mm [mm]: the thrust section
    """

    __slots__ = ()
    force_N: Array
    moment_Nm: Array
    at_mm: float


class RingForce(Record):
    """What a guide ring does to the rollers.

    force_N [N]: y, z, of the ring on the rollers
    moment_Nm [N m]: of the ring on the rollers about y and z, at `at_mm`
    at_mm [mm]: x
    roller_N [N]: on each roller, outwards
    """

    __slots__ = ()
    force_N: Array
    moment_Nm: Array
    at_mm: float
    roller_N: Array


class BearingForce(Record):
    """What a bearing does to the screw.

    at_mm [mm]: x
    force_N [N]: y, z, of the bearing on the screw
    moment_Nm [N m]: about y and z
    """

    __slots__ = ()
    at_mm: float
    force_N: Array
    moment_Nm: Array


class Reactions(Record):
    """Forces of the supports of a full mechanism on its parts.

    nut: of the nut's seat
    rings: near and far
    bearings: as the file has them
    """

    __slots__ = ()
    nut: NutSupport
    rings: list[RingForce]
    bearings: list[BearingForce]


class SymmetricLoads(Record):
    """The screw under its axial force alone.

    axial_displacement_um [µm]: of the loaded section
    axial_stiffness_N_per_um [N/µm]: secant: force over displacement
    tangent_stiffness_N_per_um [N/µm]: derivative of the force by the displacement
    largest_normal_load_N [N]: at the screw and at the nut
    """

    __slots__ = ()
    axial_displacement_um: float
    axial_stiffness_N_per_um: float
    tangent_stiffness_N_per_um: float | None
    largest_normal_load_N: Array


class OrbitLoads(Record):
    """What a turn of the carrier does at an interface.

    first_roller_largest_normal_load_N [N]: of the first roller that is there, at each position
    equivalent_normal_load_N [N]: (mean N^exponent)^(1/exponent) over the turn, by roller and thread
    largest_normal_load_N [N]: of the whole turn
    at_carrier_angle_deg [deg]: where the largest load acts
    largest_roller: where the largest load acts, from 1
    largest_thread: where the largest load acts, from 1
    largest_equivalent_normal_load_N [N]: of all threads
    least_normal_load_N [N]: of the whole turn
    """

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
    """A turn of the carrier of a full mechanism.

    steps: positions for each spacing of the rollers
    positions: of the whole turn
    exponent: of the equivalent loads
    carrier_angles_deg [deg]: of each position
    screw: contacts at the screw
    nut: contacts at the nut
    axial_displacement_um [µm]: at the positions that differ
    axial_error_um [µm]: peak to peak
    """

    __slots__ = ()
    steps: int
    positions: int
    exponent: float
    carrier_angles_deg: Array
    screw: OrbitLoads
    nut: OrbitLoads
    axial_displacement_um: Array
    axial_error_um: float


class TravelSpectrum(Record):
    """Amplitudes of the travel deviation by orders.

    order: periods in a turn
    amplitude_um [µm]: of the deviation, less its drift
    """

    __slots__ = ()
    order: Array
    amplitude_um: Array


class TravelOrder(Record):
    """Amplitude of the travel deviation at an order of a part.

    name: turn | carrier | carrier_on_screw | roller_spin | rollers_past_nut | rollers_past_screw
    order: periods in a turn
    amplitude_um [µm]: by one least-squares fit of all orders
    """

    __slots__ = ()
    name: str
    order: float
    amplitude_um: float


class TravelEnd(Record):
    """The loaded section of the screw over a travel.

    displacement_um [µm]: x: the deviation; y, z as at rest, at each position
    rotation_mrad [mrad]: about y and z, at each position
    """

    __slots__ = ()
    displacement_um: Array
    rotation_mrad: Array


class TravelNut(Record):
    """The nut's seat over a travel.

    force_N [N]: x, y, z, of the housing on the nut, at each position
    moment_Nm [N m]: about y and z, at each position
    """

    __slots__ = ()
    force_N: Array
    moment_Nm: Array


class TravelBearing(Record):
    """A bearing over a travel.

    at_mm [mm]: x
    force_N [N]: y, z, of the bearing on the screw, at each position
    moment_Nm [N m]: about y and z, at each position
    """

    __slots__ = ()
    at_mm: float
    force_N: Array
    moment_Nm: Array


class TravelLoads(Record):
    """Normal loads over a travel at an interface.

    largest_normal_load_N [N]: of all rollers, threads and positions
    at_angle_deg [deg]: turn at which it acts
    largest_roller: where it acts, from 1
    largest_thread: where it acts, from 1
    least_normal_load_N [N]: of all rollers, threads and positions
    mean_normal_load_N [N]: over the positions, by roller and thread
    ripple_normal_load_N [N]: largest less least over the positions, by roller and thread
    """

    __slots__ = ()
    largest_normal_load_N: float
    at_angle_deg: float
    largest_roller: int
    largest_thread: int
    least_normal_load_N: float
    mean_normal_load_N: Array
    ripple_normal_load_N: Array


class Travel(Record):
    """Positions of the turning mechanism, whose parts carry their errors along.

    converged: whether every position has an equilibrium
    status: how the first position without equilibrium ended
    at_angle_deg [deg]: turn of the first position without equilibrium
    turns: of the screw against the nut
    steps: in a turn
    positions: both ends included
    slip_ratio: turn of the carrier against the nut over that of the screw
    angle_deg [deg]: turn of the screw against the nut
    deviation_um [µm]: of the loaded section along x, less its mean
    peak_to_peak_um [µm]: of the deviation
    mean_travel_deviation_um [µm]: e_0a: rise of the least-squares line over the travel; > 0 goes too far; ISO 3408-3, names of its actual values
    variation_um [µm]: v_ua: width of the band along that line; ISO 3408-3, names of its actual values
    variation_300_mm_um [µm]: v_300a: largest over 300 mm; absent of a shorter travel; ISO 3408-3, names of its actual values
    variation_one_turn_um [µm]: v_2pia: largest over a turn; ISO 3408-3, names of its actual values
    spectrum: of the deviation
    orders: amplitudes of the orders of the parts
    tangent_stiffness_N_per_um [N/µm]: derivative of the force by the displacement, at each position
    stiffness_ripple_percent [%]: largest less least stiffness over the mean
    screw_end: the loaded section of the screw
    nut_reaction: of the nut's seat
    bearings: as the file has them
    side_force_ripple_N [N]: largest distance of the nut's force across the axis from its mean
    tilt_ripple_mrad [mrad]: largest distance of the rotation of the screw's end from its mean
    screw: contacts at the screw
    nut: contacts at the nut
    """

    __slots__ = ()
    converged: bool
    status: str
    at_angle_deg: float | None
    turns: int | None
    steps: int | None
    positions: int | None
    slip_ratio: float | None
    angle_deg: Array | None
    deviation_um: Array | None
    peak_to_peak_um: float | None
    mean_travel_deviation_um: float | None
    variation_um: float | None
    variation_300_mm_um: float | None
    variation_one_turn_um: float | None
    spectrum: TravelSpectrum | None
    orders: list[TravelOrder] | None
    tangent_stiffness_N_per_um: Array | None
    stiffness_ripple_percent: float | None
    screw_end: TravelEnd | None
    nut_reaction: TravelNut | None
    bearings: list[TravelBearing] | None
    side_force_ripple_N: float | None
    tilt_ripple_mrad: float | None
    screw: TravelLoads | None
    nut: TravelLoads | None


class AlongAxes(Record):
    """A number for each axis.

    x: along the axis
    y: across it
    z: across it
    """

    __slots__ = ()
    x: float
    y: float
    z: float


class MotionOrder(Record):
    """How often a motion comes back in a turn.

    name: as those of `travel`
    order: periods in a turn of screw against nut
    """

    __slots__ = ()
    name: str
    order: float


class KineticEnergy(Record):
    """Where the kinetic energy of a mode is.

    screw: of the screw
    nut: of the nut
    rollers: of the rollers, also as they orbit and spin
    masses: of masses and drive
    """

    __slots__ = ()
    screw: float
    nut: float
    rollers: float
    masses: float


class StrainEnergy(Record):
    """Where the strain energy of a mode is.

    screw: of the screw
    nut: of the nut
    rollers: of the rollers
    screw_contacts: of the contacts at the screw
    nut_contacts: of the contacts at the nut
    supports: of springs of supports, rings and drive
    prestress: of axial forces in bending; < 0 in compression
    """

    __slots__ = ()
    screw: float
    nut: float
    rollers: float
    screw_contacts: float
    nut_contacts: float
    supports: float
    prestress: float | None


class BodyShape(Record):
    """Displacements of screw or nut in a mode.

    x_mm [mm]: of the nodes
    displacement: x, y, z
    """

    __slots__ = ()
    x_mm: Array
    displacement: Array


class RollerShape(Record):
    """Displacements of the rollers in a mode.

    axial: of the middle of each roller
    radial: of the middle of each roller
    """

    __slots__ = ()
    axial: Array
    radial: Array


class ModeShape(Record):
    """Shape of a mode.

    screw: of the screw
    nut: of the nut
    rollers: of the rollers
    """

    __slots__ = ()
    screw: BodyShape
    nut: BodyShape
    rollers: RollerShape


class Mode(Record):
    """A natural mode.

    frequency_Hz [Hz]: natural frequency
    effective_mass_kg [kg]: what takes part along each axis
    kinetic_energy_percent [%]: shares of the parts
    strain_energy_percent [%]: shares of parts, contacts and supports
    shape: scaled so that its largest number is 1
    critical_speed_rpm [rpm]: of screw against nut, at which each of `orders` meets the frequency
    """

    __slots__ = ()
    frequency_Hz: float
    effective_mass_kg: AlongAxes
    kinetic_energy_percent: KineticEnergy
    strain_energy_percent: StrainEnergy
    shape: ModeShape
    critical_speed_rpm: Array


class ModesAlongTravel(Record):
    """Natural frequencies at positions of the travel.

    angle_deg [deg]: turn of the screw against the nut
    frequency_Hz [Hz]: natural frequencies at each, from the lowest
    """

    __slots__ = ()
    angle_deg: Array
    frequency_Hz: Array


class Modes(Record):
    """Natural vibration of the loaded mechanism, without damping.

    mass_kg [kg]: that moves along each axis
    dofs: freedoms of the model
    idle_rollers: that have no part in it, from 1
    orders: of the parts
    mode: from the lowest frequency
    along_travel: frequencies at positions of the travel
    """

    __slots__ = ()
    mass_kg: AlongAxes
    dofs: int
    idle_rollers: Array
    orders: list[MotionOrder]
    mode: list[Mode]
    along_travel: ModesAlongTravel | None


class NewtonIteration(Record):
    """One linear solve of the load distribution.

    energy_J [J]: potential energy after the step
    relative_residual: largest force out of balance over the load
    step_length: share of the Newton step that was taken
    shift: added to the diagonal so that it can be solved
    """

    __slots__ = ()
    energy_J: float
    relative_residual: float
    step_length: float
    shift: float


class PartNumbers(Record):
    """A number of each part.

    screw: of the screw
    rollers: of all rollers
    nut: of the nut
    """

    __slots__ = ()
    screw: float
    rollers: float
    nut: float


class InterfaceNumbers(Record):
    """A number of each interface.

    screw: of the contacts at the screw
    nut: of the contacts at the nut
    """

    __slots__ = ()
    screw: float
    nut: float


class Heat(Record):
    """Steady temperatures: what friction puts into the parts flows off through the conductances.

    converged: whether there is a steady state
    status: converged | no_steady_state | iteration_limit
    reason: where not converged
    evaluations: of the losses at temperatures
    other_steady_states: whether hotter ones exist; this one is reached from ambient temperature
    temperature_degC [°C]: of each part
    oil_degC [°C]: at the contacts of each interface: the mean of its two bodies; needs a lubricant
    heat_W [W]: that friction puts into each part
    """

    __slots__ = ()
    converged: bool
    status: str
    reason: str | None
    evaluations: int
    other_steady_states: bool | None
    temperature_degC: PartNumbers | None
    oil_degC: InterfaceNumbers | None
    heat_W: PartNumbers | None


class SlipRatioEstimates(Record):
    """Slip ratios by formulas of geometry alone.

    simple: contacts at the pitch points; Sandu 2018, (2.21)
    jones: standard mechanisms only; Jones et al., in Sandu 2018, (2.20)
    """

    __slots__ = ()
    simple: float
    jones: float | None


class PowerShares(Record):
    """Where power is lost.

    screw: share of the power that is lost there; Sandu 2018, (3.51)
    nut: share of the power that is lost there; Sandu 2018, (3.51)
    carrier_roller: share of the power that is lost there; Sandu 2018, (3.51)
    carrier_screw: share of the power that is lost there; Sandu 2018, (3.51)
    carrier_nut: share of the power that is lost there; Sandu 2018, (3.51)
    """

    __slots__ = ()
    screw: float
    nut: float
    carrier_roller: float
    carrier_screw: float
    carrier_nut: float


class RollerMoments(Record):
    """Moments on one roller about its axis; they add up to zero in equilibrium. Sandu 2018, (3.39) to (3.42).

    contacts: friction at the contacts, R_c
    spin: spin torques, R_s
    carrier: friction in the carrier, R_p
    gears: gears at the ends, R_e
    """

    __slots__ = ()
    contacts: float
    spin: float
    carrier: float
    gears: float


class RollerForces(Record):
    """Forces on one roller across its axis, x away from the screw's axis, y along the orbit.

    contacts_x: of all threads; Sandu 2018, (3.27)
    contacts_y: of all threads; Sandu 2018, (3.27)
    gears_x: of the gears; Sandu 2018, (3.28), (3.29)
    gears_y: of the gears; Sandu 2018, (3.28), (3.29)
    carrier_x: by the roller on the carrier; Sandu 2018, (3.26), (3.32)
    carrier_y: by the roller on the carrier; Sandu 2018, (3.26), (3.32)
    centrifugal: needs the rollers' density; Sandu 2018, (3.33)
    """

    __slots__ = ()
    contacts_x: float
    contacts_y: float
    gears_x: float
    gears_y: float
    carrier_x: float
    carrier_y: float
    centrifugal: float | None


class RollerHeads(Record):
    """The heads of a roller in the carrier, or of each roller.

    guide_force_N [N]: of the guides on the roller, near and far end; > 0 outwards
    bearing_force_N [N]: of the bearing, that of the gears and the carrier's drive included
    torque_Nmm [N mm]: that resists; needs carrier.bearing
    eccentricity_ratio: e/c; needs a carrier.bearing with a film
    """

    __slots__ = ()
    guide_force_N: Array
    bearing_force_N: Array
    torque_Nmm: Array | None
    eccentricity_ratio: Array | None


class HottestThread(Record):
    """The thread of the largest power density.

    interface: screw | nut
    thread: from 1, next to the loaded end of the screw
    power_W [W]: power that friction takes there
    power_density_W_per_mm2 [W/mm²]: power over its ellipse
    roller: from 1; of a full mechanism
    of_nut: 1 | 2, of a double nut
    """

    __slots__ = ()
    interface: str
    thread: int
    power_W: float | None
    power_density_W_per_mm2: float
    roller: int | None
    of_nut: int | None


class EqualShareSlip(Record):
    """Slip if all threads carried the same load.

    slip_ratio: carrier over screw, against the nut
    power_loss_W [W]: of the whole mechanism
    efficiency: power out over power in
    max_thread_power_W [W]: larger of both interfaces
    max_power_density_W_per_mm2 [W/mm²]: power of a thread over its ellipse
    """

    __slots__ = ()
    slip_ratio: float
    power_loss_W: float
    efficiency: float | None
    max_thread_power_W: float
    max_power_density_W_per_mm2: float


class InterfaceSlip(Record):
    """Threads of one interface of one roller: slip, friction, film and power; Sandu 2018, chapter 3.

    power_W [W]: power that friction takes at the thread; Sandu 2018, (3.51)
    power_density_W_per_mm2 [W/mm²]: power over the contact ellipse pi a b
    friction_coefficient: mean over the points of the ellipse; Sandu 2018, (2.40)
    spin_torque_Nmm [N mm]: about the roller's outward normal; Sandu 2018, (3.10)
    sliding_speed_mm_per_s [mm/s]: at the centre of the ellipse
    max_sliding_speed_mm_per_s [mm/s]: largest over the points of the ellipse
    film_thickness_nm [nm]: central film; needs a lubricant; Sandu 2018, (2.39)
    central_film_nm [nm]: central film; needs a lubricant; Nijenbanning, Venner, Moes 1994; with lubricant.film.direction: rolling Chittenden et al. 1985
    film_factor: phi, the film over that of a full and cold inlet: starvation times shear heating, 1 without lubricant.film; needs a lubricant; Gupta, Cheng, Zhu, Forster, Krauter 1992
    film_ratio: Lambda: phi times central film over the composite roughness; needs lubricant and roughness
    boundary_share: share (1 + Lambda)^-exponent of the load on flanks that touch, exponent 2 where the case has none; that of friction only if mixed; Olver and Spikes 1998
    dynamic_normal_load_N [N]: normal load that keeps the axial load in balance with friction; Sandu 2018, (3.11), (3.12)
    wear_mm3_per_km [mm³/km]: volume that both bodies lose at the thread for each km of travel of screw or nut; needs wear; Archard 1953
    flash_temperature_K [K]: largest rise of the surfaces above their parts while they pass the contact; needs conductivity, density and specific_heat of the materials; Greenwood 1991; Muzychka, Yovanovich 2001; Blok 1937
    """

    __slots__ = ()
    power_W: Array
    power_density_W_per_mm2: Array
    friction_coefficient: Array
    spin_torque_Nmm: Array
    sliding_speed_mm_per_s: Array
    max_sliding_speed_mm_per_s: Array
    film_thickness_nm: Array | None
    central_film_nm: Array | None
    film_factor: Array | None
    film_ratio: Array | None
    boundary_share: Array | None
    dynamic_normal_load_N: Array
    wear_mm3_per_km: Array | None
    flash_temperature_K: Array | None


class SecondNut(Record):
    """Slip of the rollers of a second nut.

    converged: whether there is an answer: a slip ratio, or at rest `holding`
    status: how the search for the slip ratio ended
    evaluations: of the roller's moment balance
    relative_residue: moment on a roller over radius and normal load; Sandu 2018, (3.38)
    speed_rpm [rpm]: screw against nut
    gear_ratio: Gamma of the gears: n_R/n_S; Sandu 2018, (2.1)
    slip_ratio: epsilon, carrier against nut over screw against nut; Sandu 2018, (2.2)
    ideal_slip_ratio: epsilon* of least sliding; Sandu 2018, (2.16), (2.17)
    optimality_percent [%]: 100 % at the ideal slip ratio; Sandu 2018, (2.19)
    travel_per_turn_mm [mm]: of the nut on the screw per turn of the screw against the nut; the lead where screw and nut have the same; Sandu 2018, (2.5)
    migration_per_turn_um [µm]: of the rollers along the part that they are geared to, per turn of the screw against the nut, > 0 ahead of its travel; 0 for equal pitches; Sandu 2018, (2.12)
    pitch_sliding_per_turn_um [µm]: circumferential, of the pitch cylinders of rollers and geared part, per turn of the screw against the nut; 0 for diameters in the ratio of the gears; Sandu 2018, (2.14)
    driven_by: screw | load: force x speed x lead > 0 or < 0
    efficiency: power out over power in: of the load over the shaft, or of the shaft over the load that drives; absent where self-locking; Sandu 2018, (3.52)
    self_locking: whether no power comes out; where the load drives
    holding_torque_Nm [N m]: by the drive on the screw in the sense of the motion, where the load drives: > 0 turns a self-locking screw, < 0 holds back the load
    efficiency_fit: fit near a reference example; absent with Coulomb friction; Sandu 2018, (3.55)
    power_loss_W [W]: lost to all sources of friction; Sandu 2018, (3.51)
    power_loss_input_output_W [W]: the same as power in less power out; Sandu 2018, (3.53)
    torque_screw_Nm [N m]: by the drive on the screw; Sandu 2018, (3.30)
    torque_nut_Nm [N m]: on the nut; Sandu 2018, (3.31)
    viscosity_mPas [mPa s]: dynamic, in operation; needs a lubricant
    bearing_eccentricity_ratio: e/c of the roller heads in the carrier, the larger one
    slip_ratio_estimates: by geometry alone
    share_percent [%]: of each source in the power that is lost
    roller_moments_Nmm [N mm]: on one roller about its axis, by source; the mean of all in a full mechanism
    roller_forces_N [N]: on one roller across its axis, by source; the mean of all in a full mechanism
    heads: of the rollers in the carrier, near and far end
    hottest_thread: of the largest power density
    equal_shares: what slip would be if all threads carried the same load
    screw: threads at the screw, of one roller or of all
    nut: threads at the nut, of one roller or of all
    """

    __slots__ = ()
    converged: bool
    status: str
    evaluations: int
    relative_residue: float | None
    speed_rpm: float | None
    gear_ratio: float | None
    slip_ratio: float | None
    ideal_slip_ratio: float | None
    optimality_percent: float | None
    travel_per_turn_mm: float | None
    migration_per_turn_um: float | None
    pitch_sliding_per_turn_um: float | None
    driven_by: str | None
    efficiency: float | None
    self_locking: bool | None
    holding_torque_Nm: float | None
    efficiency_fit: float | None
    power_loss_W: float | None
    power_loss_input_output_W: float | None
    torque_screw_Nm: float | None
    torque_nut_Nm: float | None
    viscosity_mPas: float | None
    bearing_eccentricity_ratio: float | None
    slip_ratio_estimates: SlipRatioEstimates | None
    share_percent: PowerShares | None
    roller_moments_Nmm: RollerMoments | None
    roller_forces_N: RollerForces | None
    heads: RollerHeads | None
    hottest_thread: HottestThread | None
    equal_shares: EqualShareSlip | None
    screw: InterfaceSlip | None
    nut: InterfaceSlip | None


class HoldingBound(Record):
    """Torques and forces at which a screw at rest begins to move.

    holding_torque_Nm [N m]: by the drive on the screw, > 0 against the load; inverted: the nut, which turns, has its reaction
    torque_screw_Nm [N m]: by the drive on the screw; Sandu 2018, (3.30)
    torque_nut_Nm [N m]: on the nut; Sandu 2018, (3.31)
    slip_ratio: with which motion begins
    roller_forces_N [N]: on one roller across its axis, that on the carrier among them
    """

    __slots__ = ()
    holding_torque_Nm: float
    torque_screw_Nm: float
    torque_nut_Nm: float
    slip_ratio: float
    roller_forces_N: RollerForces


class Holding(Record):
    """A screw at rest under load: between its bounds static friction holds it.

    self_locking: whether the screw holds its load without a torque
    against_load: beyond it the drive moves the load
    with_load: below it the load moves the screw
    """

    __slots__ = ()
    self_locking: bool
    against_load: HoldingBound
    with_load: HoldingBound


class Slip(Record):
    """Stationary slip of a load case: Sandu 2018, chapters 2 and 3.

    converged: whether there is an answer: a slip ratio, or at rest `holding`
    status: how the search for the slip ratio ended
    evaluations: of the roller's moment balance
    relative_residue: moment on a roller over radius and normal load; Sandu 2018, (3.38)
    speed_rpm [rpm]: screw against nut
    gear_ratio: Gamma of the gears: n_R/n_S; Sandu 2018, (2.1)
    slip_ratio: epsilon, carrier against nut over screw against nut; Sandu 2018, (2.2)
    ideal_slip_ratio: epsilon* of least sliding; Sandu 2018, (2.16), (2.17)
    optimality_percent [%]: 100 % at the ideal slip ratio; Sandu 2018, (2.19)
    travel_per_turn_mm [mm]: of the nut on the screw per turn of the screw against the nut; the lead where screw and nut have the same; Sandu 2018, (2.5)
    migration_per_turn_um [µm]: of the rollers along the part that they are geared to, per turn of the screw against the nut, > 0 ahead of its travel; 0 for equal pitches; Sandu 2018, (2.12)
    pitch_sliding_per_turn_um [µm]: circumferential, of the pitch cylinders of rollers and geared part, per turn of the screw against the nut; 0 for diameters in the ratio of the gears; Sandu 2018, (2.14)
    driven_by: screw | load: force x speed x lead > 0 or < 0
    efficiency: power out over power in: of the load over the shaft, or of the shaft over the load that drives; absent where self-locking; Sandu 2018, (3.52)
    self_locking: whether no power comes out; where the load drives
    holding_torque_Nm [N m]: by the drive on the screw in the sense of the motion, where the load drives: > 0 turns a self-locking screw, < 0 holds back the load
    efficiency_fit: fit near a reference example; absent with Coulomb friction; Sandu 2018, (3.55)
    power_loss_W [W]: lost to all sources of friction; Sandu 2018, (3.51)
    power_loss_input_output_W [W]: the same as power in less power out; Sandu 2018, (3.53)
    torque_screw_Nm [N m]: by the drive on the screw; Sandu 2018, (3.30)
    torque_nut_Nm [N m]: on the nut; Sandu 2018, (3.31)
    viscosity_mPas [mPa s]: dynamic, in operation; needs a lubricant
    bearing_eccentricity_ratio: e/c of the roller heads in the carrier, the larger one
    slip_ratio_estimates: by geometry alone
    share_percent [%]: of each source in the power that is lost
    roller_moments_Nmm [N mm]: on one roller about its axis, by source; the mean of all in a full mechanism
    roller_forces_N [N]: on one roller across its axis, by source; the mean of all in a full mechanism
    heads: of the rollers in the carrier, near and far end
    hottest_thread: of the largest power density
    equal_shares: what slip would be if all threads carried the same load
    screw: threads at the screw, of one roller or of all
    nut: threads at the nut, of one roller or of all
    second_nut: rollers of the second nut of a double nut; powers, torques and efficiency here are of both nuts, all else of the first
    holding: bounds of static friction of a screw that is held at rest, speed 0
    """

    __slots__ = ()
    converged: bool
    status: str
    evaluations: int
    relative_residue: float | None
    speed_rpm: float | None
    gear_ratio: float | None
    slip_ratio: float | None
    ideal_slip_ratio: float | None
    optimality_percent: float | None
    travel_per_turn_mm: float | None
    migration_per_turn_um: float | None
    pitch_sliding_per_turn_um: float | None
    driven_by: str | None
    efficiency: float | None
    self_locking: bool | None
    holding_torque_Nm: float | None
    efficiency_fit: float | None
    power_loss_W: float | None
    power_loss_input_output_W: float | None
    torque_screw_Nm: float | None
    torque_nut_Nm: float | None
    viscosity_mPas: float | None
    bearing_eccentricity_ratio: float | None
    slip_ratio_estimates: SlipRatioEstimates | None
    share_percent: PowerShares | None
    roller_moments_Nmm: RollerMoments | None
    roller_forces_N: RollerForces | None
    heads: RollerHeads | None
    hottest_thread: HottestThread | None
    equal_shares: EqualShareSlip | None
    screw: InterfaceSlip | None
    nut: InterfaceSlip | None
    second_nut: SecondNut | None
    holding: Holding | None


class StiffnessContribution(Record):
    """A part of an axis and its share of what gives way.

    stiffness_N_per_um [N/µm]: of this part alone
    percent [%]: of the total compliance; all sum to 100
    """

    __slots__ = ()
    stiffness_N_per_um: float
    percent: float


class StiffnessContributions(Record):
    """Parts of an axis in series.

    mechanism: threads and bodies, the secant stiffness of the load case at rest
    shaft: stretch of the screw's shaft
    wind_up: travel by which the shaft twists, without friction
    support_bearing: all bearings of the shaft together
    housing: what holds the nut
    """

    __slots__ = ()
    mechanism: StiffnessContribution | None
    shaft: StiffnessContribution | None
    wind_up: StiffnessContribution | None
    support_bearing: StiffnessContribution | None
    housing: StiffnessContribution | None


class SystemStiffness(Record):
    """Axial stiffness of an axis.

    total_N_per_um [N/µm]: of all in series
    contributions: by what gives way
    """

    __slots__ = ()
    total_N_per_um: float
    contributions: StiffnessContributions


class LoadMeasures(Record):
    """Design measures under one load.

    lowest_frequency_Hz [Hz]: omega/(2 pi) of the first mode about the equilibrium, K phi = omega^2 M phi; needs `modes` and `structure.masses`; modes of all rollers, docs/motion.md
    speeds_to_avoid_rpm [rpm]: 60 f/order, at which turn, carrier, rollers or their number meet the lowest frequency, screw against nut; needs `modes` and `structure.masses`; modes of all rollers, docs/motion.md
    hertz_stiffness_screw_N_per_um [N/µm]: k = N_r N/(h f^(-1/3)), h = 1/(k_0^(2/3) cos(psi)^(5/3)), f = F/(N_r N); secant, equal thread loads; roller moves axially only; Hertz with exact ellipticity
    hertz_stiffness_nut_N_per_um [N/µm]: k = N_r N/(h f^(-1/3)), h = 1/(k_0^(2/3) cos(psi)^(5/3)), f = F/(N_r N); secant, equal thread loads; roller moves axially only; Hertz with exact ellipticity
    thread_stiffness_N_per_um [N/µm]: N_r N/((h_S + h_N) f^(-1/3) + sum 1/k_tooth), teeth of screw, nut and twice the roller where measures.loaded_width is given; secant, equal thread loads; roller moves axially only; with teeth a lower bound, which may be below `solve`'s whole screw: the models of the bodies have Hertz contacts without Yamamoto's teeth, whose deflection Hertz has in part and whose nut ring each contact widens alone; Jung 2017, (3.45), (3.46), without the roller's teeth there
    system_stiffness: 1/k = sum 1/k_i: mechanism, secant; shaft L/(E A) or x (L - x)/(L E A); wind-up (l/(2 pi))^2 L_t/(G J); bearings; housing; needs measures.system; what it leaves out is rigid; without friction, the mechanism as solved at rest; geometry
    yang_largest_load_rate_percent [%]: largest axial thread load over F/N_r; each roller tooth a ball that passes on what it takes; needs structure, position and thrust section; Yang, in Jung 2017, (4.1), (8.20), corrected
    largest_load_rate_screw_percent [%]: largest axial thread load over F/N_r, of the solved distribution; that of the model; load distribution of `prs solve`
    largest_load_rate_nut_percent [%]: largest axial thread load over F/N_r, of the solved distribution; that of the model; load distribution of `prs solve`
    largest_load_rate_percent [%]: largest axial thread load over F/N_r, of the solved distribution; that of the model; load distribution of `prs solve`
    mean_peak_pressure_screw_MPa [MPa]: p_0 = 3 N/(2 pi a b) at N = f/cos(psi); equal thread loads; Hertz with exact ellipticity
    mean_peak_pressure_nut_MPa [MPa]: p_0 = 3 N/(2 pi a b) at N = f/cos(psi); equal thread loads; Hertz with exact ellipticity
    largest_peak_pressure_screw_MPa [MPa]: p_0 = 3 N/(2 pi a b) of the most loaded thread; that of the load distribution; Hertz with exact ellipticity
    largest_peak_pressure_nut_MPa [MPa]: p_0 = 3 N/(2 pi a b) of the most loaded thread; that of the load distribution; Hertz with exact ellipticity
    root_shear_stress_screw_MPa [MPa]: tau = F/(a w), mean over the root a of a tooth; needs measures.loaded_width w; nominal: no notch, no radial force; teeth wider than high are hardly beams; Shigley, Mechanical Engineering Design, power screws (shear there: largest, 3/2 of the mean)
    root_shear_stress_roller_MPa [MPa]: tau = F/(a w), mean over the root a of a tooth; needs measures.loaded_width w; nominal: no notch, no radial force; teeth wider than high are hardly beams; Shigley, Mechanical Engineering Design, power screws (shear there: largest, 3/2 of the mean)
    root_shear_stress_nut_MPa [MPa]: tau = F/(a w), mean over the root a of a tooth; needs measures.loaded_width w; nominal: no notch, no radial force; teeth wider than high are hardly beams; Shigley, Mechanical Engineering Design, power screws (shear there: largest, 3/2 of the mean)
    root_bending_stress_screw_MPa [MPa]: sigma = 6 F c/(a^2 w), load at the pitch line; needs measures.loaded_width w; nominal: no notch, no radial force; teeth wider than high are hardly beams; Shigley, Mechanical Engineering Design, power screws (shear there: largest, 3/2 of the mean)
    root_bending_stress_roller_MPa [MPa]: sigma = 6 F c/(a^2 w), load at the pitch line; needs measures.loaded_width w; nominal: no notch, no radial force; teeth wider than high are hardly beams; Shigley, Mechanical Engineering Design, power screws (shear there: largest, 3/2 of the mean)
    root_bending_stress_nut_MPa [MPa]: sigma = 6 F c/(a^2 w), load at the pitch line; needs measures.loaded_width w; nominal: no notch, no radial force; teeth wider than high are hardly beams; Shigley, Mechanical Engineering Design, power screws (shear there: largest, 3/2 of the mean)
    solved_static_safety: the case's static capacity, else the force at which the first thread has the pressure of 4.0 GPa, of steel, or of materials.static_pressure_limit, with the thread loads there, over F; as that of `prs life`; not of a full mechanism; ISO 76:2006; Hertz
    flank_edge_margin: force at which the first ellipse reaches a crest or root, with the thread loads there, over F; below 1 flanks have edge stresses, which are no yield; not of a full mechanism; Hertz; geometry
    static_safety: the case's static capacity, else the smaller of both pressure capacities, over F; estimate of `prs life`'s static safety by threads; the same there with `share: equal`; ISO 76:2006; Hertz
    thread_static_safety: the smaller of both interfaces' static limits over N_r N times the largest axial thread load; estimate of `prs life`'s static safety, with the shares that the threads have under this load in place of those at the limit; ISO 76:2006; Hertz
    buckling_safety: buckling load over F; in compression; that of the buckling load; Euler; J. B. Johnson
    l10_revolutions [revolutions]: 10^6 (C_a/F)^3; equal thread loads, 90 % reliability, F up to about C_a/2; spectra: `prs life`; Jung 2017, (8.25); ISO 281
    l10_hours [h]: L10 over the speed; needs a speed; that of L10; Jung 2017, (8.25); ISO 281
    l10_travel_km [km]: L10 |l|; that of L10; Jung 2017, (8.25); ISO 281
    drive_torque_Nm [N m]: F |l|/(2 pi eta); needs measures.friction_coefficient; mu is that of the whole mechanism as catalogues state it; no preload; Jung 2017, (8.31), corrected, with (8.29)
    back_driving_efficiency_by_slip: shaft's power over that of the load that drives; needs what `prs slip` needs; at the speed of the case; absent where the screw locks itself; Sandu 2018, chapters 2 and 3, as `prs slip`
    speed_safety: critical speed over |speed|; standard mechanisms, whose screw turns; that of the critical speed; Euler-Bernoulli beam
    solved_static_safety_limit: pressure | given; that of solved_static_safety; ISO 76:2006; Hertz
    static_safety_limit: pressure | given; that of static_safety; ISO 76:2006; Hertz
    thread_static_safety_limit: pressure | given; that of thread_static_safety; ISO 76:2006; Hertz
    yang_load_rate_percent [%]: h (F_k^(2/3) - F_(k+1)^(2/3)) = what screw and nut stretch between threads k and k + 1; sum F/N_r; each roller tooth a ball that passes on what it takes: no bending, nothing along the roller; screw and nut as bars; no deviations; Yang, in Jung 2017, (4.1), (8.20), corrected
    """

    __slots__ = ()
    lowest_frequency_Hz: float | None
    speeds_to_avoid_rpm: Array | None
    hertz_stiffness_screw_N_per_um: float | None
    hertz_stiffness_nut_N_per_um: float | None
    thread_stiffness_N_per_um: float | None
    system_stiffness: SystemStiffness | None
    yang_largest_load_rate_percent: float | None
    largest_load_rate_screw_percent: float | None
    largest_load_rate_nut_percent: float | None
    largest_load_rate_percent: float | None
    mean_peak_pressure_screw_MPa: float | None
    mean_peak_pressure_nut_MPa: float | None
    largest_peak_pressure_screw_MPa: float | None
    largest_peak_pressure_nut_MPa: float | None
    root_shear_stress_screw_MPa: float | None
    root_shear_stress_roller_MPa: float | None
    root_shear_stress_nut_MPa: float | None
    root_bending_stress_screw_MPa: float | None
    root_bending_stress_roller_MPa: float | None
    root_bending_stress_nut_MPa: float | None
    solved_static_safety: float | None
    flank_edge_margin: float | None
    static_safety: float | None
    thread_static_safety: float | None
    buckling_safety: float | None
    l10_revolutions: float | None
    l10_hours: float | None
    l10_travel_km: float | None
    drive_torque_Nm: float | None
    back_driving_efficiency_by_slip: float | None
    speed_safety: float | None
    solved_static_safety_limit: str | None
    static_safety_limit: str | None
    thread_static_safety_limit: str | None
    yang_load_rate_percent: Array | None


class LoadCase(Record):
    """The answer to one load case; one that did not converge has its status and residual alone.

    name: as the file has it
    axial_force_N [N]: on the whole screw; > 0 with a direction
    direction: tension | compression
    position_mm [mm]: of the first roller contact on the nut
    loads: static | running: of a screw that turns, with friction
    converged: whether there is an equilibrium
    status: how the solve ended; equal thread loads need none
    iterations: linear solves
    relative_residual: largest force out of balance over the load
    factorization: library, version and kind of what solved the sparse equations
    axial_displacement_um [µm]: of the loaded section; > 0 along the load
    axial_stiffness_N_per_um [N/µm]: secant: force over displacement
    tangent_stiffness_N_per_um [N/µm]: derivative of the force by the displacement
    running: how loads and friction were found together
    static: the same case at rest, at the same temperatures; running loads
    screw: threads of one roller at the screw
    nut: threads of one roller at the nut
    guide_displacement_um [µm]: of guides with a clearance, of the roller's end nodes outwards: outer and inner of the first end, inner and outer of the last; roller after roller
    guide_force_N [N]: of these guides on the roller, outwards
    flanks: under preload: both flanks of the threads, or both nuts; the lists above are those of the flank that the direction names
    dofs: freedoms of the model
    rollers: missing ones included
    carrier_angle_deg [deg]: azimuth of the first roller
    idle_rollers: that carry nothing, from 1
    screw_end: displacement and stiffness of the loaded section
    reactions: forces of the supports on the parts
    symmetric: the same screw with the axial force only: aligned, all rollers, nominal parts
    orbit: what a turn of the carrier does
    travel: positions of the turning mechanism
    modes: natural vibration about the equilibrium
    warnings: what is unusual about this load
    assumptions: choices of the model that matter for it
    newton_history: one per linear solve; documents of many load cases leave it out
    heat: with `heat`: loads and slip are those at its temperatures
    slip: of `prs slip`
    measures: of `prs measures`
    """

    __slots__ = ()
    name: str
    axial_force_N: float
    direction: str | None
    position_mm: float | None
    loads: str
    converged: bool
    status: str
    iterations: int | None
    relative_residual: float | None
    factorization: str | None
    axial_displacement_um: float | None
    axial_stiffness_N_per_um: float | None
    tangent_stiffness_N_per_um: float | None
    running: Running | None
    static: AtRest | None
    screw: InterfaceLoads | None
    nut: InterfaceLoads | None
    guide_displacement_um: Array | None
    guide_force_N: Array | None
    flanks: Flanks | None
    dofs: int | None
    rollers: int | None
    carrier_angle_deg: float | None
    idle_rollers: Array | None
    screw_end: ScrewEnd | None
    reactions: Reactions | None
    symmetric: SymmetricLoads | None
    orbit: Orbit | None
    travel: Travel | None
    modes: Modes | None
    warnings: list[str]
    assumptions: list[str] | None
    newton_history: list[NewtonIteration] | None
    heat: Heat | None
    slip: Slip | None
    measures: LoadMeasures | None


class MostLoadedThread(Record):
    """What an interface's threads carry, by one model.

    most_loaded_thread: 1 is next to the loaded end of the screw
    most_loaded_roller: from 1; of a full mechanism
    largest_load_rate_percent [%]: its share: axial load over force per roller
    largest_peak_pressure_MPa [MPa]: largest of a thread
    load_rate_percent [%]: share of each thread; of a full mechanism [roller][thread]
    """

    __slots__ = ()
    most_loaded_thread: int
    most_loaded_roller: int | None
    largest_load_rate_percent: float | None
    largest_peak_pressure_MPa: float | None
    load_rate_percent: Array


class ComparedModel(Record):
    """The answer of one model of the bodies to a load case.

    bodies: bars | refined | influence of one sector, or full: all rollers
    converged: whether there is an equilibrium
    axial_stiffness_N_per_um [N/µm]: secant: force over displacement
    stiffness_over_best: over that of the best model
    axial_displacement_um [µm]: of the loaded section; > 0 along the load
    largest_peak_pressure_MPa [MPa]: largest of a thread at either interface
    pressure_over_best: largest over that of the best model
    screw: threads of one roller at the screw
    nut: threads of one roller at the nut
    """

    __slots__ = ()
    bodies: str
    converged: bool
    axial_stiffness_N_per_um: float | None
    stiffness_over_best: float | None
    axial_displacement_um: float | None
    largest_peak_pressure_MPa: float | None
    pressure_over_best: float | None
    screw: MostLoadedThread | None
    nut: MostLoadedThread | None


class ComparedLoadCase(Record):
    """A load case by each model of the bodies.

    name: as the file has it
    axial_force_N [N]: on the whole screw
    direction: tension | compression
    position_mm [mm]: of the first roller contact on the nut
    models: the best last
    warnings: what is unusual about this load, by the best model
    """

    __slots__ = ()
    name: str
    axial_force_N: float
    direction: str | None
    position_mm: float | None
    models: list[ComparedModel]
    warnings: list[str]


class Comparison(Record):
    """The models of the bodies side by side.

    models: that were compared: bars | refined | influence, or one of them | full; the best last
    load_cases: those that are solved, not of equal thread loads
    """

    __slots__ = ()
    models: list[str]
    load_cases: list[ComparedLoadCase]


class LargestDeviation(Record):
    """The deviation of largest magnitude from a reference.

    value: with its sign
    percent_of_mean: of the mean magnitude of the reference
    at: where it is, in `along_unit`
    """

    __slots__ = ()
    value: float | None
    percent_of_mean: float | None
    at: float | None


class ReferenceModel(Record):
    """How far a model lies from a reference.

    bodies: bars | refined | influence of one sector, or full: all rollers
    mean_deviation: mean of computed less reference
    rms_deviation: root mean square
    largest_deviation: of largest magnitude
    mean_deviation_percent_of_mean: of the mean magnitude of the reference
    rms_deviation_percent_of_mean: of the same
    slope: over the force, by least squares, in `slope_unit`
    stiffness_N_per_um [N/µm]: force over displacement, by the same line
    met: whether no deviation is beyond the tolerance
    """

    __slots__ = ()
    bodies: str
    mean_deviation: float | None
    rms_deviation: float | None
    largest_deviation: LargestDeviation | None
    mean_deviation_percent_of_mean: float | None
    rms_deviation_percent_of_mean: float | None
    slope: float | None
    stiffness_N_per_um: float | None
    met: bool | None


class ComputedThere(Record):
    """Results of the models at a reading of a reference.

    bars: one-dimensional elements, as the paper
    refined: one-dimensional elements with what bars miss
    influence: grooved bodies of revolution by finite elements
    """

    __slots__ = ()
    bars: float | None
    refined: float | None
    influence: float | None


class ReferencePoint(Record):
    """A reading of a reference, and what is computed there.

    along: where it stands, in `along_unit`; threads from 1
    reference: the reference's number
    reference_deviation: its own deviation, where it is stated
    computed: by the models
    """

    __slots__ = ()
    along: float | None
    reference: float
    reference_deviation: float | None
    computed: ComputedThere


class ComparedReference(Record):
    """A curve of another program or a test against the case.

    name: of the reference; by default that of its file
    file: as the case names it
    load_case: that it belongs to; absent of the whole case
    response: path in the load case or the whole case
    unit: of the response and of all deviations; empty of ratios
    along: `thread`, or the input that readings set; absent of a single number
    along_unit: of the places
    count: of readings
    mean: mean magnitude of the reference
    sum: over a complete set of threads, of shares and of axial loads
    expected_sum: what the load of a roller makes of it
    reference_sum_percent [%]: that sum in % of the expected one
    mean_deviation: mean of computed less reference, by the model of the bodies that the case states, as the next two
    rms_deviation: root mean square
    largest_deviation: of largest magnitude
    slope: of the reference over the force, by least squares
    slope_unit: of slopes
    stiffness_N_per_um [N/µm]: force over displacement, by the same line
    tolerance: as the case has it
    met: by the model of the bodies that the case states
    models: as in `comparison`
    points: readings, ascending
    """

    __slots__ = ()
    name: str
    file: str
    load_case: str | None
    response: str
    unit: str
    along: str | None
    along_unit: str | None
    count: int
    mean: float
    sum: float | None
    expected_sum: float | None
    reference_sum_percent: float | None
    mean_deviation: float | None
    rms_deviation: float | None
    largest_deviation: LargestDeviation | None
    slope: float | None
    slope_unit: str | None
    stiffness_N_per_um: float | None
    tolerance: str | None
    met: bool | None
    models: list[ReferenceModel]
    points: list[ReferencePoint]


class PartSeries(Record):
    """Numbers of each part over time.

    screw: of the screw
    rollers: of all rollers
    nut: of the nut
    """

    __slots__ = ()
    screw: Array
    rollers: Array
    nut: Array


class PartTimes(Record):
    """A time of each part to which something happens.

    screw: of the screw
    rollers: of all rollers
    nut: of the nut
    """

    __slots__ = ()
    screw: float | None
    rollers: float | None
    nut: float | None


class HeatCycle(Record):
    """The state of a duty that repeats itself from cycle to cycle, or a mission.

    converged: whether there is a state that repeats itself
    status: converged | no_steady_state | iteration_limit
    reason: where not converged
    period_s [s]: of the duty
    cycles: of the mission; with heat.cycles
    time_s [s]: from the start of the cycle, or of the mission, to its end
    temperature_degC [°C]: of each part at these times
    start_degC [°C]: of each part at the start of the mission; with heat.cycles
    end_degC [°C]: of each part at its end
    time_to_limit_s [s]: until parts first reach limits.temperature in the mission
    peak_degC [°C]: largest of each part
    mean_degC [°C]: of each part over the cycle or the mission
    energy_in_J [J]: that shaft and load bring in while they drive, per cycle or mission
    energy_lost_J [J]: to friction, per cycle or mission
    efficiency: energy out over energy in
    """

    __slots__ = ()
    converged: bool
    status: str
    reason: str | None
    period_s: float
    cycles: int | None
    time_s: Array | None
    temperature_degC: PartSeries | None
    start_degC: PartNumbers | None
    end_degC: PartNumbers | None
    time_to_limit_s: PartTimes | None
    peak_degC: PartNumbers | None
    mean_degC: PartNumbers | None
    energy_in_J: float | None
    energy_lost_J: float | None
    efficiency: float | None


class PerDirection(Record):
    """One number for each sense of the load.

    tension: tension
    compression: compression
    """

    __slots__ = ()
    tension: float | None
    compression: float | None


class PreloadSide(Record):
    """Contacts that carry one sense of the load.

    axial_load_N [N]: of all threads of this side
    max_normal_load_N [N]: of a thread of one roller
    peak_pressure_MPa [MPa]: largest of a thread; Hertz with exact ellipticity
    """

    __slots__ = ()
    axial_load_N: float
    max_normal_load_N: float
    peak_pressure_MPa: float | None


class PreloadSides(Record):
    """Contacts by the sense of the load that they carry.

    tension: contacts that carry tension
    compression: contacts that carry compression
    """

    __slots__ = ()
    tension: PreloadSide
    compression: PreloadSide


class PreloadPoint(Record):
    """Equilibrium under one external load.

    axial_force_N [N]: external load, > 0 in tension
    converged: whether there is an equilibrium
    status: how the solve ended
    iterations: linear solves
    relative_residual: largest force out of balance over the load
    axial_displacement_um [µm]: of the loaded section, 0 without external load, > 0 in tension
    tangent_stiffness_N_per_um [N/µm]: derivative of the force by the displacement; absent where the screw is loose
    sides: contacts by the sense of the load that they carry
    """

    __slots__ = ()
    axial_force_N: float
    converged: bool
    status: str
    iterations: int
    relative_residual: float
    axial_displacement_um: float | None
    tangent_stiffness_N_per_um: float | None
    sides: PreloadSides | None


class WarmPreload(Record):
    """A fit at the temperatures of the parts.

    load_case: whose steady temperatures these are, by `heat`
    temperature_status: how the search for them ended
    temperature_degC [°C]: of the parts
    preload_force_N [N]: axial load of each side without external load
    stiffness_at_zero_N_per_um [N/µm]: tangent without external load, reached from either sense
    opening_force_N [N]: external load at which the side that opposes it opens
    lost_motion_um [µm]: displacement between the lost-motion load in tension and in compression
    """

    __slots__ = ()
    load_case: str | None
    temperature_status: str | None
    temperature_degC: PartNumbers | None
    preload_force_N: float | None
    stiffness_at_zero_N_per_um: PerDirection | None
    opening_force_N: PerDirection | None
    lost_motion_um: float | None


class WithoutPreload(Record):
    """The same nut without preload.

    stiffness_at_zero_N_per_um [N/µm]: tangent without external load, reached from either sense
    lost_motion_um [µm]: displacement between the lost-motion load in tension and in compression
    loads: one equilibrium per external load
    """

    __slots__ = ()
    stiffness_at_zero_N_per_um: PerDirection
    lost_motion_um: float | None
    loads: list[PreloadPoint]


class Preload(Record):
    """The preloaded nut: forces and displacements are > 0 in tension.

    thread_loads: static: of a screw at rest, without friction
    arrangement: single_nut | double_nut
    position_mm [mm]: of the first roller contact on the nut
    held_at_mm [mm]: section at which the first nut is held, by the sense of the load
    reference_temperature_degC [°C]: of all parts where the fit is made
    preload_force_N [N]: axial load of each side without external load, of the fit at the reference temperature
    interference_um [µm]: oversize of the rollers' pitch diameter, or of the spacer, at the reference temperature; absent with play
    backlash_um [µm]: axial play
    opening_force_N [N]: external load at which the side that opposes it opens
    lost_motion_load_N [N]: to both senses
    stiffness_at_zero_N_per_um [N/µm]: tangent without external load, reached from either sense
    lost_motion_um [µm]: displacement between the lost-motion load in tension and in compression
    loads: one equilibrium per external load
    at_temperature: the same fit at the temperatures of the parts, of `deviations` or of `heat`
    without_preload: neither preload nor play
    """

    __slots__ = ()
    thread_loads: str
    arrangement: str
    position_mm: float
    held_at_mm: PerDirection
    reference_temperature_degC: float
    preload_force_N: float | None
    interference_um: float | None
    backlash_um: float | None
    opening_force_N: PerDirection
    lost_motion_load_N: float
    stiffness_at_zero_N_per_um: PerDirection
    lost_motion_um: float | None
    loads: list[PreloadPoint]
    at_temperature: WarmPreload | None
    without_preload: WithoutPreload | None


class PerInterface(Record):
    """One number each of the roller's contacts with screw and nut.

    screw: screw
    nut: nut
    """

    __slots__ = ()
    screw: float
    nut: float


class Capacity(Record):
    """What the mechanism can carry.

    dynamic_capacity_N [N]: C_a; life.dynamic_capacity where stated; Lemor, in Jung 2017, (6.1) to (6.3)
    dynamic_capacity_range_N [N]: f_c at d_r cos/d_n, d_r cos/(2 c) and D_c cos/(2 c): Lemor's ratio of diameters and ISO 281's; docs/life.md
    source: lemor | given
    geometry_factor: f_c; Lemor, in Jung 2017, (6.1) to (6.3)
    geometry_factor_range: f_c at d_r cos/d_n, d_r cos/(2 c) and D_c cos/(2 c): Lemor's ratio of diameters and ISO 281's; docs/life.md
    diameter_ratio: d_r cos(alpha)/d_n; Lemor, in Jung 2017, (6.1) to (6.3)
    element_diameter_mm [mm]: diameter of the equivalent ball; Lemor, in Jung 2017, (6.1) to (6.3)
    failure_share: share of each interface in the failures under equal loads
    roller_failure_share: part of the rollers in the failures of each interface; of a full mechanism; Lundberg and Palmgren
    static_capacity_equal_shares_N [N]: force at which equal thread loads have the peak pressure of 4.0 GPa, of steel, or of materials.static_pressure_limit; ISO 76:2006
    flank_edge_load_equal_shares_N [N]: force at which ellipses of equal loads reach a crest or root; Hertz with exact ellipticity
    static_capacity_given_N [N]: life.static_capacity
    """

    __slots__ = ()
    dynamic_capacity_N: float
    dynamic_capacity_range_N: Array
    source: str
    geometry_factor: float | None
    geometry_factor_range: Array | None
    diameter_ratio: float | None
    element_diameter_mm: float | None
    failure_share: PerInterface
    roller_failure_share: PerInterface | None
    static_capacity_equal_shares_N: float | None
    flank_edge_load_equal_shares_N: float | None
    static_capacity_given_N: float | None


class LifeLoads(Record):
    """The history or the spectrum.

    samples: of the history or the spectrum
    revolutions: of one pass
    travel_m [m]: of one pass
    duration_h [h]: of one pass
    mean_load_N [N]: cubic mean over the revolutions under load; ISO 281; cubic mean
    largest_force_N [N]: of either direction
    """

    __slots__ = ()
    samples: int
    revolutions: float | None
    travel_m: float | None
    duration_h: float | None
    mean_load_N: float
    largest_force_N: float


class CycleMatrix(Record):
    """Load cycles by range and mean.

    range_to_N [N]: end of the last class of ranges, from 0
    mean_from_N [N]: start of the first class of means
    mean_to_N [N]: end of the last class of means
    count: of cycles, by range and mean
    """

    __slots__ = ()
    range_to_N: float
    mean_from_N: float
    mean_to_N: float
    count: Array


class Cycles(Record):
    """Load cycles of a history: rainflow, ASTM E1049-85.

    count: half cycles as halves; ASTM E1049-85
    fatigue_slope: of the S-N curve; FKM
    equivalent_range_N [N]: constant range that does the same damage in as many cycles; FKM; Miner elementary
    largest_range_N [N]: of a cycle
    matrix: cycles by range and mean
    """

    __slots__ = ()
    count: float
    fatigue_slope: float
    equivalent_range_N: float
    largest_range_N: float
    matrix: CycleMatrix


class LifeInUse(Record):
    """A life L10 at the value of the dynamic capacity.

    l10_revolutions [revolutions]: turns under load, which 90 % reach; travel without load does not count; Jung 2017, (8.25); ISO 281
    l10_revolutions_range: by the range of the dynamic capacity; Jung 2017, (8.25); ISO 281
    l10_hours [h]: clock hours where the file states time, duration or period, else hours in motion at operation.speed; Jung 2017, (8.25); ISO 281
    l10_moving_hours [h]: in motion under load at operation.speed; Jung 2017, (8.25); ISO 281
    l10_travel_km [km]: under load; with life.travel all travel; Jung 2017, (8.25); ISO 281
    l10_passes: of the history or the spectrum; Jung 2017, (8.25); ISO 281
    rated_revolutions [revolutions]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_revolutions_range: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_hours [h]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_moving_hours [h]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_travel_km [km]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_passes: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    """

    __slots__ = ()
    l10_revolutions: float | None
    l10_revolutions_range: Array | None
    l10_hours: float | None
    l10_moving_hours: float | None
    l10_travel_km: float | None
    l10_passes: float | None
    rated_revolutions: float | None
    rated_revolutions_range: Array | None
    rated_hours: float | None
    rated_moving_hours: float | None
    rated_travel_km: float | None
    rated_passes: float | None


class LifeAtRest(Record):
    """Lives on the loads of a screw at rest.

    system: of the mechanism
    """

    __slots__ = ()
    system: LifeInUse


class FixedBearing(Record):
    """The bearing that holds the part that turns.

    equivalent_load_N [N]: of the loads with preload over all revolutions, travel without load included; ISO 281; preload by the rule of makers
    l10_revolutions [revolutions]: of the part that turns in it, all of them; that 90 % reach; ISO 281; preload by the rule of makers
    l10_hours [h]: as those of the screw; ISO 281; preload by the rule of makers
    static_safety: static capacity over the largest force; ISO 76
    """

    __slots__ = ()
    equivalent_load_N: float
    l10_revolutions: float | None
    l10_hours: float | None
    static_safety: float | None


class BearingLives(Record):
    """Bearings at the ends of the shaft.

    fixed: that holds the part that turns along its axis
    """

    __slots__ = ()
    fixed: FixedBearing


class LifeWithBearings(Record):
    """Life of screw and bearings.

    l10_revolutions [revolutions]: of screw and bearings together, e = 10/9; Jung 2017, (8.25); ISO 281
    l10_hours [h]: as those of the screw; Jung 2017, (8.25); ISO 281
    l10_travel_km [km]: as that of the screw; Jung 2017, (8.25); ISO 281
    """

    __slots__ = ()
    l10_revolutions: float
    l10_hours: float | None
    l10_travel_km: float


class ModifiedLife(Record):
    """What film and dirt do to the life, by ISO 281.

    film_ratio: Lambda under the mean load at the operation's speed, the smallest of all threads
    viscosity_ratio: kappa = Lambda^1.3; ISO 281:2007, 9.3.3
    load_ratio: C_u/P, (1.5 GPa over the largest peak pressure)^3 under the mean load; ISO 281:2007, 9.3.3
    factor: a_ISO, next to the modification_factor that the case states; ISO 281:2007, 9.3.3
    system: of the mechanism, real thread loads
    """

    __slots__ = ()
    film_ratio: float
    viscosity_ratio: float
    load_ratio: float
    factor: float
    system: LifeInUse


class WeakestThread(Record):
    """The thread that fails first, of those that turn under load.

    l10_revolutions [revolutions]: turns under load, which 90 % reach; travel without load does not count; Jung 2017, (8.25); ISO 281
    l10_revolutions_range: by the range of the dynamic capacity; Jung 2017, (8.25); ISO 281
    l10_hours [h]: clock hours where the file states time, duration or period, else hours in motion at operation.speed; Jung 2017, (8.25); ISO 281
    l10_moving_hours [h]: in motion under load at operation.speed; Jung 2017, (8.25); ISO 281
    l10_travel_km [km]: under load; with life.travel all travel; Jung 2017, (8.25); ISO 281
    l10_passes: of the history or the spectrum; Jung 2017, (8.25); ISO 281
    rated_revolutions [revolutions]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_revolutions_range: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_hours [h]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_moving_hours [h]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_travel_km [km]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_passes: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    direction: tension | compression
    interface: screw | nut
    thread: from 1, next to the loaded end of the screw
    part: screw | roller | nut: whose thread; of a full mechanism
    roller: from 1; of a roller of a full mechanism
    equivalent_load_N [N]: axial, cubic mean over all revolutions; ISO 281; cubic mean
    """

    __slots__ = ()
    l10_revolutions: float | None
    l10_revolutions_range: Array | None
    l10_hours: float | None
    l10_moving_hours: float | None
    l10_travel_km: float | None
    l10_passes: float | None
    rated_revolutions: float | None
    rated_revolutions_range: Array | None
    rated_hours: float | None
    rated_moving_hours: float | None
    rated_travel_km: float | None
    rated_passes: float | None
    direction: str
    interface: str
    thread: int
    part: str | None
    roller: int | None
    equivalent_load_N: float


class RollerLives(Record):
    """Lives of the threads of the rollers at one interface.

    equivalent_load_N [N]: [roller][thread], axial, cubic mean over all revolutions; ISO 281; cubic mean
    l10_revolutions [revolutions]: [roller][thread]; null where the thread is never loaded; Jung 2017, (8.25); ISO 281
    rated_revolutions [revolutions]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    """

    __slots__ = ()
    equivalent_load_N: Array
    l10_revolutions: Array
    rated_revolutions: Array


class InterfaceLife(Record):
    """Lives of the threads of one interface.

    equivalent_load_N [N]: axial, cubic mean over all revolutions; ISO 281; cubic mean
    l10_revolutions [revolutions]: of the thread on all rollers; null where it is never loaded; Jung 2017, (8.25); ISO 281
    rated_revolutions [revolutions]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    largest_load_N [N]: axial, the largest of all forces: at rest, and of a running screw where life is of its loads
    equivalent_range_N [N]: of the axial load over the cycles of the history; FKM; Miner elementary
    rollers: threads of the rollers of a full mechanism
    peak_pressure_MPa [MPa]: under the largest loads of its threads; Hertz with exact ellipticity
    """

    __slots__ = ()
    equivalent_load_N: Array | None
    l10_revolutions: Array | None
    rated_revolutions: Array | None
    largest_load_N: Array | None
    equivalent_range_N: Array | None
    rollers: RollerLives | None
    peak_pressure_MPa: float | None


class DirectionLife(Record):
    """Lives under the loads of one direction.

    l10_revolutions [revolutions]: turns under load, which 90 % reach; travel without load does not count; Jung 2017, (8.25); ISO 281
    l10_revolutions_range: by the range of the dynamic capacity; Jung 2017, (8.25); ISO 281
    l10_hours [h]: clock hours where the file states time, duration or period, else hours in motion at operation.speed; Jung 2017, (8.25); ISO 281
    l10_moving_hours [h]: in motion under load at operation.speed; Jung 2017, (8.25); ISO 281
    l10_travel_km [km]: under load; with life.travel all travel; Jung 2017, (8.25); ISO 281
    l10_passes: of the history or the spectrum; Jung 2017, (8.25); ISO 281
    rated_revolutions [revolutions]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_revolutions_range: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_hours [h]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_moving_hours [h]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_travel_km [km]: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    rated_passes: the L10 value times reliability_factor and modification_factor; ISO 281:2007, a1
    share_of_revolutions: under loads of this direction
    mean_load_N [N]: cubic mean over the revolutions of both directions; ISO 281; cubic mean
    largest_force_N [N]: of this direction
    static_capacity_N [N]: force at which the first thread has the peak pressure of 4.0 GPa, of steel, or of materials.static_pressure_limit; ISO 76:2006
    flank_edge_load_N [N]: force at which the first ellipse reaches a crest or root; Hertz with exact ellipticity
    flank_edge_margin: that force over the largest force; Hertz with exact ellipticity
    static_safety: stated static capacity, else force at which the first thread has 4.0 GPa, over the largest force; ISO 76
    static_safety_limit: pressure | given
    equilibria: that were solved
    interpolation_error: of thread loads between the equilibria, relative
    screw: threads of one roller at the screw
    nut: threads of one roller at the nut
    """

    __slots__ = ()
    l10_revolutions: float | None
    l10_revolutions_range: Array | None
    l10_hours: float | None
    l10_moving_hours: float | None
    l10_travel_km: float | None
    l10_passes: float | None
    rated_revolutions: float | None
    rated_revolutions_range: Array | None
    rated_hours: float | None
    rated_moving_hours: float | None
    rated_travel_km: float | None
    rated_passes: float | None
    share_of_revolutions: float
    mean_load_N: float
    largest_force_N: float
    static_capacity_N: float | None
    flank_edge_load_N: float | None
    flank_edge_margin: float | None
    static_safety: float | None
    static_safety_limit: str | None
    equilibria: int
    interpolation_error: float
    screw: InterfaceLife
    nut: InterfaceLife


class Life(Record):
    """Lives of mechanism and threads.

    converged: whether every load has an equilibrium
    status: why there are no lives
    share: solved | equal: thread loads
    thread_loads: static | running: of a screw that turns, with friction; static safety is always static
    temperature_degC [°C]: of the parts under all loads: that at which the mean heat of the spectrum flows off, or the mean of the duty cycle; with heat
    temperature_status: converged | no_steady_state | iteration_limit; with heat
    reliability_factor: a1 of the required reliability; ISO 281:2007, a1
    modification_factor: a_ISO as the case states it; ISO 281:2007
    capacity: of the mechanism
    loads: of the history or the spectrum
    cycles: counted from a history (rainflow)
    system: of the mechanism, real thread loads
    static: the same on the loads of a screw at rest; where thread_loads is running
    equal_shares: of the mechanism, equal thread loads
    catalogue: (C_a/F_m)^3
    bearings: at the ends of the shaft; with bearings
    system_with_bearings: of screw, by the catalogue where its capacity is stated, and bearings
    static_safety: the smaller of both directions; ISO 76
    static_safety_limit: pressure | given
    modified: with film and contamination; where life.contamination is stated
    weakest_thread: that fails first
    tension: flanks that carry tension
    compression: flanks that carry compression
    """

    __slots__ = ()
    converged: bool
    status: str | None
    share: str
    thread_loads: str
    temperature_degC: PartNumbers | None
    temperature_status: str | None
    reliability_factor: float
    modification_factor: float
    capacity: Capacity
    loads: LifeLoads
    cycles: Cycles | None
    system: LifeInUse | None
    static: LifeAtRest | None
    equal_shares: LifeInUse | None
    catalogue: LifeInUse | None
    bearings: BearingLives | None
    system_with_bearings: LifeWithBearings | None
    static_safety: float | None
    static_safety_limit: str | None
    modified: ModifiedLife | None
    weakest_thread: WeakestThread | None
    tension: DirectionLife | None
    compression: DirectionLife | None


class Measures(Record):
    """Design measures of the mechanism that no load changes.

    velocity_ratio_mm_per_rad [mm/rad]: |l|/(2 pi); always; Jung 2017, (8.30), corrected
    roller_ratio: omega_R/omega_S = -d_S/(2 d_R); rolling without slip by the leads, Gamma = |l_R/l_S|, formula of matched diameters; inverted: 1 - x is the ratio to the nut that turns, screw at rest; with friction see `prs slip`; Sandu 2018, (2.4), (2.21); Jung 2017, (2.13), corrected
    carrier_ratio: omega_C/omega_S = d_S/(2 (d_S + d_R)); rolling without slip by the leads, Gamma = |l_R/l_S|, formula of matched diameters; inverted: 1 - x is the ratio to the nut that turns, screw at rest; with friction see `prs slip`; Sandu 2018, (2.21); Jung 2017, (2.27), inverted there
    efficiency: eta = 1/(1 + pi d_S mu/l); estimate: Coulomb friction of one screw and nut; `prs slip` computes the efficiency from the losses of the contacts; needs measures.friction_coefficient, that of the whole mechanism as catalogues state it; no preload; Jung 2017, (8.29)
    back_driving_efficiency: eta' = 1 - pi d_S mu/l = 2 - 1/eta; absent where self-locking; as efficiency; misses a maker's 24 screws by -0.07 to +0.01 and `slip` by -0.06 to -0.03 (lesson 10: 0.73 for 0.78), for contacts lose about the same share of the power both ways: prefer that of a load case, which is by slip; friction angle of one thread, as (8.29)
    section_stiffness_screw_N_per_um [N/µm]: E A_S/p, A_S = pi/4 (d_S^2 - d_bore^2); sections of the sector model between two threads; nut between its flanges; Jung 2017, (3.2)
    section_stiffness_roller_N_per_um [N/µm]: N_r E A_R/(2 p), A_R = pi/4 d_R^2; two pitches as printed, without a reason; the sector model has E A_R/p; Jung 2017, (3.3)
    section_stiffness_nut_N_per_um [N/µm]: E A_N/p, A_N = pi/4 (D_N^2 - d_N^2); sections of the sector model between two threads; nut between its flanges; Jung 2017, (3.1)
    tooth_stiffness_screw_N_per_um [N/µm]: w over the sum of five deflections under 1 N/m; needs measures.loaded_width w, which no theory gives; with Hertz on top part of the deflection counts twice; Yamamoto 1980 in its right form (Jung 2017, (3.4) to (3.19), misprinted)
    tooth_stiffness_roller_N_per_um [N/µm]: w over the sum of five deflections under 1 N/m; needs measures.loaded_width w, which no theory gives; with Hertz on top part of the deflection counts twice; Yamamoto 1980 in its right form (Jung 2017, (3.4) to (3.19), misprinted)
    tooth_stiffness_nut_N_per_um [N/µm]: w over the sum of five deflections under 1 N/m; needs measures.loaded_width w, which no theory gives; with Hertz on top part of the deflection counts twice; Yamamoto 1980 in its right form (Jung 2017, (3.4) to (3.19), misprinted)
    geometry_factor: polynomial in d_r cos(alpha)/d_n; ratio from 0.01 to 0.30; [N, mm]; Jung 2017, (6.3); ISO 281, thrust ball bearings of 45 deg
    element_diameter_mm [mm]: sqrt(2.5 p sqrt(2) d_r); crowned threads of 45 deg; Lemor, in Jung 2017, (6.2), (8.27)
    dynamic_capacity_N [N]: C_a = f_c cos(alpha)^0.86 N_c^(2/3) D_c^1.8 tan(alpha) cos(beta)^(1/3) [N, mm], 3.647 D_c^1.4 beyond 25.4 mm; or life.dynamic_capacity where stated; d_r cos(alpha)/d_n from 0.01 to 0.30; crowned flanks of 45 deg, hardened steel; Lemor, in Jung 2017, (5.5), (6.1), (8.26)
    dynamic_capacity_low_N [N]: C_a with f_c at d_r cos/(2 c) or D_c cos/(2 c), the ratio of ISO 281, and the fit's 0.35 %; which ratio f_c takes, not an error bar: C_a is 0.69 to 1.26 times a maker's for screws from 8 to 120 mm (validation/standard_screws); a maker's own value goes first; docs/life.md
    dynamic_capacity_high_N [N]: C_a with f_c at d_r cos/(2 c) or D_c cos/(2 c), the ratio of ISO 281, and the fit's 0.35 %; which ratio f_c takes, not an error bar: C_a is 0.69 to 1.26 times a maker's for screws from 8 to 120 mm (validation/standard_screws); a maker's own value goes first; docs/life.md
    static_capacity_N [N]: the least of deformation_capacity and pressure_capacity at screw and nut; or life.static_capacity where stated; equal thread loads; hardened bearing steel; flanks of any height, see flank_edge_load_N; as uncertain as the profile radius: a maker's hardly depends on the lead, as if r = 5 p, which gives 0.7 to 1.4 times his, an arc about the axis 0.4 to 4.7 (validation/standard_screws); ISO 76, Palmgren, Hertz
    deformation_capacity_screw_N [N]: C_0 = N_r N cos(psi) D sqrt(1e-4/(1.3e-7 kappa_1 kappa_2)) [N, mm], D twice the radius of the roller's profile: permanent deformation 1e-4 D; equal thread loads; bearing steel of 63.5 to 65.5 HRC; convex roller flank; made for grooves, allows flat flanks 5 GPa and more: compare the load at the pressure limit; Palmgren's formula (Harris, Rolling Bearing Analysis); criterion of ISO 76
    deformation_capacity_nut_N [N]: C_0 = N_r N cos(psi) D sqrt(1e-4/(1.3e-7 kappa_1 kappa_2)) [N, mm], D twice the radius of the roller's profile: permanent deformation 1e-4 D; equal thread loads; bearing steel of 63.5 to 65.5 HRC; convex roller flank; made for grooves, allows flat flanks 5 GPa and more: compare the load at the pressure limit; Palmgren's formula (Harris, Rolling Bearing Analysis); criterion of ISO 76
    pressure_capacity_screw_N [N]: axial load at which every contact has p_0 = 4.0 GPa: N_r N cos(psi) (2 pi a' b' p_0/3)^3; equal thread loads; hardened bearing steel; elastic up to there; Hertz; limit of ISO 76:2006 for roller bearings (4.2 GPa for ball bearings)
    pressure_capacity_nut_N [N]: axial load at which every contact has p_0 = 4.0 GPa: N_r N cos(psi) (2 pi a' b' p_0/3)^3; equal thread loads; hardened bearing steel; elastic up to there; Hertz; limit of ISO 76:2006 for roller bearings (4.2 GPa for ball bearings)
    flank_edge_load_N [N]: the smaller of both below; equal thread loads; ellipse of the unbounded flank; crests and roots of mechanism.thread, else where flanks meet: crests as makers cut them, 0.15 p high, bring it down to a third to a fifth; Hertz; geometry
    flank_edge_load_screw_N [N]: N_r N cos(psi) min(h/rho')^3, h the radial height from the contact point to a crest or root of body or roller, rho' = sqrt((a' t_1r)^2 + (b' t_2r)^2) the ellipse's radial reach under 1 N; equal thread loads; ellipse of the unbounded flank; crests and roots of mechanism.thread, else where flanks meet: crests as makers cut them, 0.15 p high, bring it down to a third to a fifth; Hertz; geometry
    flank_edge_load_nut_N [N]: N_r N cos(psi) min(h/rho')^3, h the radial height from the contact point to a crest or root of body or roller, rho' = sqrt((a' t_1r)^2 + (b' t_2r)^2) the ellipse's radial reach under 1 N; equal thread loads; ellipse of the unbounded flank; crests and roots of mechanism.thread, else where flanks meet: crests as makers cut them, 0.15 p high, bring it down to a third to a fifth; Hertz; geometry
    roller_weight_kg [kg]: N_r rho pi/4 (d_R^2 N p + 2 d_end^2 L_end); needs materials.density of these parts; bodies bounded by the pitch diameters; rollers with run-out and ends, nut with flanges; without carrier, gears and seals; geometry; Jung 2017, (5.1) to (5.4), corrected
    nut_weight_kg [kg]: rho pi/4 integral of (D(x)^2 - d_N^2) dx; needs materials.density of these parts; bodies bounded by the pitch diameters; rollers with run-out and ends, nut with flanges; without carrier, gears and seals; geometry; Jung 2017, (5.1) to (5.4), corrected
    weight_kg [kg]: sum of both; needs materials.density of these parts; bodies bounded by the pitch diameters; rollers with run-out and ends, nut with flanges; without carrier, gears and seals; geometry; Jung 2017, (5.1) to (5.4), corrected
    screw_weight_kg_per_m [kg/m]: rho pi/4 (d_S^2 - d_bore^2); needs materials.density of these parts; bodies bounded by the pitch diameters; rollers with run-out and ends, nut with flanges; without carrier, gears and seals; geometry
    material_volume_cm3 [cm³]: pi/4 (integral of (D(x)^2 - d_N^2) dx + N_r (d_R^2 N p + 2 d_end^2 L_end)); bodies bounded by the pitch diameters; rollers with run-out and ends, nut with flanges; without carrier, gears and seals; Jung 2017, (7.2), which lacks pi/4
    envelope_volume_cm3 [cm³]: pi/4 D_max^2 L_N; the nut's length, largest flange included; geometry
    force_density_kN_per_kg [kN/kg]: C_a over the weight of rollers and nut; that of C_a and of the weight; the screw, whose length is the actuator's, is not counted; Jung 2017, chapter 6
    roller_inertia_kg_mm2 [kg mm²]: N_r (I_R (omega_R/omega)^2 + M_R c^2 (omega_C/omega)^2); standard: the screw turns, the nut travels; inverted: the nut turns, the screw travels; without carrier and couplings; Jung 2017, (8.32) to (8.34), corrected
    travel_inertia_kg_mm2 [kg mm²]: (N_r M_R + M) (l/(2 pi))^2, M the nut or, inverted, the screw over measures.shaft.length; standard: the screw turns, the nut travels; inverted: the nut turns, the screw travels; without carrier and couplings; Jung 2017, (8.32) to (8.34), corrected
    screw_inertia_kg_mm2 [kg mm²]: rho pi/32 (d_S^4 - d_bore^4) L; needs measures.shaft.length; threaded over all of it; geometry
    nut_inertia_kg_mm2 [kg mm²]: rho pi/32 integral of (D(x)^4 - d_N^4) dx; bodies bounded by the pitch diameters; rollers with run-out and ends, nut with flanges; without carrier, gears and seals; geometry
    equivalent_inertia_kg_mm2 [kg mm²]: rollers + what travels + the part that turns (screw; inverted: nut); needs all densities and measures.shaft.length; Jung 2017, (8.34), corrected
    shaft_stiffness_N_per_um [N/µm]: E A_S/L, A_S = pi/4 (d_S^2 - d_bore^2); needs measures.shaft; held axially at one end, the nut at the other; geometry
    buckling_load_N [N]: pi^2 E I/(K L)^2; below lambda = sqrt(2 pi^2 E/s_y): A s_y (1 - s_y lambda^2/(4 pi^2 E)); needs measures.shaft; core diameter, d_S less twice the dedendum of mechanism.thread, by default d_S - 0.5 p; straight, no safety factor; without measures.yield_strength Euler alone, too high for stocky shafts; Euler; J. B. Johnson; K = 2, 1, 0.699, 0.5
    critical_speed_rpm [rpm]: (beta L)^2 sqrt(E I/(rho A L^4)), beta L = 1.8751, pi, 3.9266, 4.7300; standard mechanisms, whose screw turns; needs measures.shaft and the screw's density; slender uniform beam of the core diameter; no axial load, no margin (catalogues: 80 %); Euler-Bernoulli beam
    """

    __slots__ = ()
    velocity_ratio_mm_per_rad: float | None
    roller_ratio: float | None
    carrier_ratio: float | None
    efficiency: float | None
    back_driving_efficiency: float | None
    section_stiffness_screw_N_per_um: float | None
    section_stiffness_roller_N_per_um: float | None
    section_stiffness_nut_N_per_um: float | None
    tooth_stiffness_screw_N_per_um: float | None
    tooth_stiffness_roller_N_per_um: float | None
    tooth_stiffness_nut_N_per_um: float | None
    geometry_factor: float | None
    element_diameter_mm: float | None
    dynamic_capacity_N: float | None
    dynamic_capacity_low_N: float | None
    dynamic_capacity_high_N: float | None
    static_capacity_N: float | None
    deformation_capacity_screw_N: float | None
    deformation_capacity_nut_N: float | None
    pressure_capacity_screw_N: float | None
    pressure_capacity_nut_N: float | None
    flank_edge_load_N: float | None
    flank_edge_load_screw_N: float | None
    flank_edge_load_nut_N: float | None
    roller_weight_kg: float | None
    nut_weight_kg: float | None
    weight_kg: float | None
    screw_weight_kg_per_m: float | None
    material_volume_cm3: float | None
    envelope_volume_cm3: float | None
    force_density_kN_per_kg: float | None
    roller_inertia_kg_mm2: float | None
    travel_inertia_kg_mm2: float | None
    screw_inertia_kg_mm2: float | None
    nut_inertia_kg_mm2: float | None
    equivalent_inertia_kg_mm2: float | None
    shaft_stiffness_N_per_um: float | None
    buckling_load_N: float | None
    critical_speed_rpm: float | None


class ResponseLosses(Record):
    """What friction and damping took over a run, in joules.

    screw_friction: threads and drag
    motor_friction: dry friction of the motor, brake
    load_friction: dry friction of the guides
    coupling: damping of the coupling
    contact: material damping of the screw
    end_stop: damping of the end stops
    viscous: viscous damping of motor and load
    """

    __slots__ = ()
    screw_friction: float
    motor_friction: float
    load_friction: float
    coupling: float
    contact: float
    end_stop: float
    viscous: float


class ResponseEnergy(Record):
    """Energies of a run, in joules.

    motor: what the motor put in
    load: what the external force put in
    stored_start: kinetic and elastic energy at the start
    stored_end: the same at the end
    lost: what friction and damping took
    residual: motor + load - change of stored energy - all lost
    turnover: integral of the magnitudes of both powers, plus the stored energy at the start
    residual_relative: residual over turnover
    """

    __slots__ = ()
    motor: float
    load: float
    stored_start: float
    stored_end: float
    lost: ResponseLosses
    residual: float
    turnover: float
    residual_relative: float


class ResponseThread(Record):
    """The most loaded thread of an interface.

    normal_load_N [N]: of one roller's thread
    thread: 1 is the first
    peak_pressure_MPa [MPa]: of this thread
    """

    __slots__ = ()
    normal_load_N: float
    thread: int
    peak_pressure_MPa: float | None


class ResponseForce(Record):
    """A largest force of a run, and the threads under it.

    force_N [N]: magnitude
    time_s [s]: when
    screw: the most loaded thread of the screw by `prs solve` at this force
    nut: the same of the nut
    max_normal_load_N [N]: of a thread under this external load, by `prs preload`
    peak_pressure_MPa [MPa]: larger one of both sides, by `prs preload`
    """

    __slots__ = ()
    force_N: float
    time_s: float
    screw: ResponseThread | None
    nut: ResponseThread | None
    max_normal_load_N: float | None
    peak_pressure_MPa: float | None


class ResponseLargest(Record):
    """Extremes of a run.

    tension: largest force in tension
    compression: largest force in compression
    motor_torque_Nm [N m]: magnitude
    end_stop_force_N [N]: magnitude
    """

    __slots__ = ()
    tension: ResponseForce | None
    compression: ResponseForce | None
    motor_torque_Nm: float
    end_stop_force_N: float | None


class FollowingError(Record):
    """How far a controlled drive is off its reference.

    largest_um [µm]: of the position of the load against its reference
    largest_rpm [rpm]: of the speed of the motor against its reference
    time_s [s]: of the largest
    rms_um [µm]: root of the mean square
    rms_rpm [rpm]: root of the mean square
    """

    __slots__ = ()
    largest_um: float | None
    largest_rpm: float | None
    time_s: float
    rms_um: float | None
    rms_rpm: float | None


class ResponseImpact(Record):
    """A flank that closes.

    time_s [s]: when the flank closes
    flank: tension | compression
    speed_mm_per_s [mm/s]: of closing
    energy_J [J]: of the reduced mass at that speed
    largest_force_N [N]: of this flank up to the next impact or the end
    """

    __slots__ = ()
    time_s: float
    flank: str
    speed_mm_per_s: float
    energy_J: float
    largest_force_N: float


class Settling(Record):
    """When the load comes to rest.

    final_position_mm [mm]: of the last sample
    reference_mm [mm]: of a position loop at the end
    settled: whether the last sample lies within the band of it
    time_s [s]: from `after` to the first sample from which on all lie within the band
    """

    __slots__ = ()
    final_position_mm: float
    reference_mm: float | None
    settled: bool | None
    time_s: float | None


class Resonance(Record):
    """A natural vibration of the drive.

    frequency_Hz [Hz]: |lambda|/(2 pi)
    damping_percent [%]: -Re lambda/|lambda|
    """

    __slots__ = ()
    frequency_Hz: float
    damping_percent: float


class FrequencyResponse(Record):
    """Small vibration about a working point.

    frequency_Hz [Hz]: of the force or the torque
    compliance_um_per_N [µm/N]: position of the load over a force on it
    phase_deg [deg]: of that, < 0 behind the force
    stiffness_N_per_um [N/µm]: 1/compliance
    motor_speed_rad_per_s_per_Nm [rad/s/(N m)]: motor speed over motor torque
    motor_speed_phase_deg [deg]: of that
    position_um_per_Nm [µm/(N m)]: position of the load over motor torque
    position_phase_deg [deg]: of that
    tangent_stiffness_N_per_um [N/µm]: with the shaft, at the working point
    resonances: natural vibrations, by frequency
    """

    __slots__ = ()
    frequency_Hz: Array
    compliance_um_per_N: Array | None
    phase_deg: Array | None
    stiffness_N_per_um: Array | None
    motor_speed_rad_per_s_per_Nm: Array | None
    motor_speed_phase_deg: Array | None
    position_um_per_Nm: Array | None
    position_phase_deg: Array | None
    tangent_stiffness_N_per_um: float
    resonances: list[Resonance]


class Response(Record):
    """The screw in its drive over time and over frequency, docs/response.md.

    converged: whether the run came to its end
    status: converged | step_limit | integration_failed
    stopped_at_s [s]: where a run that did not converge ended
    duration_s [s]: of the run
    time_s [s]: of the samples
    position_mm [mm]: of the load
    speed_mm_per_s [mm/s]: of the load
    screw_angle_deg [deg]: not reduced by turns
    screw_speed_rpm [rpm]: of the screw
    motor_angle_deg [deg]: not reduced by turns
    motor_speed_rpm [rpm]: of the motor
    deflection_um [µm]: of screw and shaft, > 0 in tension
    force_N [N]: of the screw, > 0 in tension
    motor_torque_Nm [N m]: behind the current loop
    coupling_torque_Nm [N m]: between motor and screw
    external_force_N [N]: on the load
    end_stop_force_N [N]: magnitude
    lever_angle_deg [deg]: between base and arm
    lever_speed_rpm [rpm]: of the lever
    lever_torque_Nm [N m]: external, against growing angles
    energy_J [J]: over the whole run
    largest: over the whole run
    rms_motor_torque_Nm [N m]: root of the mean square
    lost_motion_um [µm]: largest less least travel of the motor beyond that of the load
    following_error: of the controller, up to its cut
    impacts: each instant at which a flank closes
    settling: with the block `settling`
    frequency_response: with the block `frequency_response`
    """

    __slots__ = ()
    converged: bool
    status: str
    stopped_at_s: float | None
    duration_s: float
    time_s: Array
    position_mm: Array
    speed_mm_per_s: Array
    screw_angle_deg: Array
    screw_speed_rpm: Array
    motor_angle_deg: Array
    motor_speed_rpm: Array
    deflection_um: Array
    force_N: Array
    motor_torque_Nm: Array
    coupling_torque_Nm: Array
    external_force_N: Array
    end_stop_force_N: Array | None
    lever_angle_deg: Array | None
    lever_speed_rpm: Array | None
    lever_torque_Nm: Array | None
    energy_J: ResponseEnergy
    largest: ResponseLargest
    rms_motor_torque_Nm: float
    lost_motion_um: float
    following_error: FollowingError | None
    impacts: list[ResponseImpact] | None
    settling: Settling | None
    frequency_response: FrequencyResponse | None


class FitPrior(Record):
    """What was known before.

    mean: what is believed before the curves
    deviation: standard deviation of that belief
    """

    __slots__ = ()
    mean: float
    deviation: float


class FitProfile(Record):
    """Interval of the profile likelihood.

    low: absent beyond a bound
    high: absent beyond a bound
    """

    __slots__ = ()
    low: float | None
    high: float | None


class FittedParameter(Record):
    """An input that was fitted, or the offset of a curve.

    name: path, or `offset of CURVE`
    label: name for people
    unit: that of `from`; of an offset that of the response
    scale: linear | log
    start: where the search began
    from: lower bound
    to: upper bound
    prior: as the file has it
    identified: whether the data determine it
    value: at the least objective
    standard_deviation: with `log` times the value
    low: end of the interval
    high: end of the interval
    degrees_of_freedom: of Student's quantile; absent: the normal one; Satterthwaite 1946
    at_bound: from | to
    profile: interval of the profile likelihood
    set: what `--set` takes for it
    """

    __slots__ = ()
    name: str
    label: str | None
    unit: str
    scale: str
    start: float
    to: float
    prior: FitPrior | None
    identified: bool
    value: float | None
    standard_deviation: float | None
    low: float | None
    high: float | None
    degrees_of_freedom: float | None
    at_bound: str | None
    profile: FitProfile | None
    set: str | None


class FitMatrix(Record):
    """Of the values with a deviation.

    names: parameters with a deviation
    matrix: rows and columns as `names`
    """

    __slots__ = ()
    names: list[str]
    matrix: Array


class FitCombination(Record):
    """Combination that the data determine of two parameters that they cannot separate.

    kind: sum | product
    names: of both parameters, a and b
    factor: a + factor b, or a b^factor
    value: of the combination, which the data determine
    standard_deviation: of a product times its value
    low: end of the interval
    high: end of the interval
    text: with its numbers, for people
    """

    __slots__ = ()
    kind: str
    names: list[str]
    factor: float
    value: float
    standard_deviation: float | None
    low: float | None
    high: float | None
    text: str


class FitDirection(Record):
    """Parameters that the data cannot separate.

    names: parameters that the data cannot separate
    direction: of the scaled parameters
    ratio: singular value over the largest
    combination: what counts of two
    """

    __slots__ = ()
    names: list[str]
    direction: Array
    ratio: float
    combination: FitCombination | None


class FitRuns(Record):
    """Runs of sign of the residuals.

    count: of equal signs in a row
    expected: of signs without a pattern
    p_value: of so few; Wald and Wolfowitz 1940
    """

    __slots__ = ()
    count: int
    expected: float
    p_value: float


class FittedCurve(Record):
    """A curve with its fit.

    name: as the file has it
    file: CSV of the readings
    response: path in the document of `command`
    unit: of the response, in which all of these are
    command: that computes the response
    rows: readings
    use: fit | compare
    loss: squares | huber | cauchy
    estimated: whether the deviation of its readings was
    redundancy: rows less what they determine
    rms: root of the mean square of the residuals
    r_squared: 1 - residual over total sum of squares
    chi_square: sum of the squares over the deviations
    runs: of sign of the residuals
    line: of the file
    measured: readings
    fitted: with the offset
    residual: measured less fitted
    standard_deviation: of a reading
    weight: of a reading under the loss
    low: band of the response
    high: band of the response
    """

    __slots__ = ()
    name: str
    file: str
    response: str
    unit: str
    command: str
    rows: int
    use: str
    loss: str
    estimated: bool
    redundancy: float | None
    rms: float | None
    r_squared: float | None
    chi_square: float | None
    runs: FitRuns | None
    line: Array
    measured: Array
    fitted: Array
    residual: Array
    standard_deviation: Array
    weight: Array
    low: Array
    high: Array


class FitCondition(Record):
    """What a band sets.

    path: input that is set
    values: one for each row, or one for all
    """

    __slots__ = ()
    path: str
    values: list[str]


class FitBand(Record):
    """A response with its uncertainty.

    name: as the file has it
    response: path in the document of `command`
    unit: of the response
    command: that computes the response
    conditions: what is set
    value: response at the fitted values, one for each row
    standard_deviation: by the covariance of the values
    low: end of the band
    high: end of the band
    """

    __slots__ = ()
    name: str
    response: str
    unit: str
    command: str
    conditions: list[FitCondition]
    value: Array
    standard_deviation: Array
    low: Array
    high: Array


class FitStart(Record):
    """A search.

    objective: S + 2 sum of rows x ln(estimated deviation)
    values: of the parameters, where it ended
    status: how the search ended
    best: whether the fit is this one
    """

    __slots__ = ()
    objective: float | None
    values: Array | None
    status: str
    best: bool


class Fit(Record):
    """Unknown inputs from measured curves.

    converged: whether the status is `converged`
    status: converged | not_identifiable | no_redundancy | iteration_limit | no_equilibrium
    objective: S
    level_percent [%]: of all intervals
    degrees_of_freedom: sum of the redundancies
    chi_square: of the curves with stated deviations and squares
    reduced_chi_square: over the sum of their redundancies
    p_value: probability of more
    evaluations: rows that were computed
    iterations: of all searches
    parameters: inputs, then offsets of curves
    correlation: of the values
    covariance: in the units of the values
    singular_value_ratios: falling
    unidentified: groups of parameters that the data cannot separate
    curves: readings and fit, curve by curve
    bands: requested responses, with their uncertainty
    starts: searches, the file's first
    """

    __slots__ = ()
    converged: bool
    status: str
    objective: float | None
    level_percent: float
    degrees_of_freedom: float
    chi_square: float | None
    reduced_chi_square: float | None
    p_value: float | None
    evaluations: int
    iterations: int
    parameters: list[FittedParameter]
    correlation: FitMatrix
    covariance: FitMatrix
    singular_value_ratios: Array
    unidentified: list[FitDirection]
    curves: list[FittedCurve]
    bands: list[FitBand]
    starts: list[FitStart]


class MotionSegment(Record):
    """Constant acceleration under one force.

    name: as given, else segment-K, sample-K or class-K
    duration_s [s]: of it, or of all in its class
    start_speed_mm_per_s [mm/s]: signed
    end_speed_mm_per_s [mm/s]: signed
    acceleration_m_per_s2 [m/s²]: signed
    travel_mm [mm]: signed
    axial_force_N [N]: on the screw, > 0 where it pushes the mass in the positive sense; THK general catalogue, axial loads
    """

    __slots__ = ()
    name: str
    duration_s: float
    start_speed_mm_per_s: float
    end_speed_mm_per_s: float
    acceleration_m_per_s2: float
    travel_mm: float
    axial_force_N: float


class LeverMotion(Record):
    """A lever over its motion, as its screw sees it.

    smallest_angle_deg [deg]: between base and arm
    largest_angle_deg [deg]: between base and arm
    middle_angle_deg [deg]: between these two
    middle_length_mm [mm]: between the screw's ends, there
    middle_ratio_mm_per_rad [mm/rad]: travel over angle, there
    middle_reflected_mass_kg [kg]: at the nut, there
    middle_gear_ratio: turns of the screw per turn of the lever, there
    middle_reflected_inertia_kg_mm2 [kg mm²]: at the screw, there
    """

    __slots__ = ()
    smallest_angle_deg: float
    largest_angle_deg: float
    middle_angle_deg: float
    middle_length_mm: float
    middle_ratio_mm_per_rad: float
    middle_reflected_mass_kg: float
    middle_gear_ratio: float | None
    middle_reflected_inertia_kg_mm2: float | None


class SizeRequirement(Record):
    """One cycle of the axis.

    cycle_s [s]: rests included
    moving_s [s]: time in motion, per cycle
    travel_mm [mm]: per cycle, of both senses
    stroke_mm [mm]: as given, else the way between the extreme positions
    mean_load_N [N]: cubic mean over travel
    largest_force_N [N]: at rest too
    largest_speed_mm_per_s [mm/s]: of either sense
    rms_speed_mm_per_s [mm/s]: over the cycle with its rests
    mean_speed_mm_per_s [mm/s]: travel over the time in motion
    segments: of constant acceleration, or classes of many samples
    lever: whose angle and torque are given
    """

    __slots__ = ()
    cycle_s: float
    moving_s: float
    travel_mm: float
    stroke_mm: float | None
    mean_load_N: float | None
    largest_force_N: float
    largest_speed_mm_per_s: float
    rms_speed_mm_per_s: float
    mean_speed_mm_per_s: float | None
    segments: list[MotionSegment]
    lever: LeverMotion | None


class SizeCounts(Record):
    """How many candidates there are.

    candidates: all rows and combinations
    passing: all criteria
    failing: some criterion
    invalid: refused by the rules of `prs new`
    """

    __slots__ = ()
    candidates: int
    passing: int
    failing: int
    invalid: int


class NearestMiss(Record):
    """The first candidate where nothing passes.

    rank: 1
    criteria: that it misses
    """

    __slots__ = ()
    rank: int
    criteria: list[str]


class Relaxation(Record):
    """What a limit would have to be.

    criterion: that is missed
    rank: of the candidate
    limit: as it is, in the unit of the criterion; of the brake its torque, N m
    needed: with which this candidate passes
    margin: as it is
    """

    __slots__ = ()
    criterion: str
    rank: int
    limit: float
    needed: float
    margin: float


class RequiredForce(Record):
    """A force that the motion requires at its speed.

    name: of the motion
    speed_mm_per_s [mm/s]: largest of the segment
    force_N [N]: axial, without sense
    driven_by: screw | load; absent at rest
    """

    __slots__ = ()
    name: str
    speed_mm_per_s: float
    force_N: float
    driven_by: str | None


class SizeCurve(Record):
    """Force over speed.

    rank: of the candidate
    speed_mm_per_s [mm/s]: constant, in one sense
    efficiency: under the mean load
    force_N [N]: that the candidate carries on and on; envelope: the least of all but motor_peak. NAME_in_cycle: mean load with the rests and changes of the cycle, that meets the limit at the mean speed if the candidate does
    required: segments of the motion under force
    """

    __slots__ = ()
    rank: int
    speed_mm_per_s: Array
    efficiency: Array
    force_N: Array
    required: list[RequiredForce]


class InvalidCandidate(Record):
    """What cannot be made.

    name: as of a candidate
    source: catalogue | design
    source_name: as of a candidate
    row: of the catalogue, from 1
    design: from 1
    reason: what is wrong
    """

    __slots__ = ()
    name: str
    source: str
    source_name: str
    row: int | None
    design: int | None
    reason: str


class SizedByThreads(Record):
    """Life and safety by the loads of the threads.

    life_revolutions [revolutions]: rated, of all travel; Jung 2017, (8.25); ISO 281
    life_hours [h]: clock time, rests included
    life_km [km]: of all travel
    static_safety: as `prs life`: pressure, deformation or edge loading
    dynamic_capacity_N [N]: Lemor's C_a
    """

    __slots__ = ()
    life_revolutions: float | None
    life_hours: float | None
    life_km: float | None
    static_safety: float | None
    dynamic_capacity_N: float | None


class ThermalConductances(Record):
    """Of the network of the parts.

    screw_ambient: screw to surroundings
    nut_ambient: nut to surroundings
    rollers_ambient: all rollers to surroundings
    screw_rollers: screw to all rollers
    rollers_nut: all rollers to nut
    """

    __slots__ = ()
    screw_ambient: float
    nut_ambient: float
    rollers_ambient: float
    screw_rollers: float
    rollers_nut: float


class SizedSegment(Record):
    """A segment of the motion on a candidate.

    name: of the motion
    efficiency: of what drives
    driven_by: screw | load
    power_loss_W [W]: at the mean speed of the segment
    torque_Nm [N m]: at the part that turns, in the sense of the motion
    motor_torque_Nm [N m]: with drag, inertia and gear
    """

    __slots__ = ()
    name: str
    efficiency: float | None
    driven_by: str | None
    power_loss_W: float | None
    torque_Nm: float | None
    motor_torque_Nm: float | None


class SizeCriterion(Record):
    """A value against its limit.

    name: what is held against a limit
    unit: of value and limit
    value: of the candidate
    limit: of the requirement
    margin: value over limit or limit over value: 1 just passes
    status: pass | fail | not_computed | not_applicable
    reason: what the value rests on, or why there is none
    """

    __slots__ = ()
    name: str
    unit: str
    value: float | None
    limit: float | None
    margin: float | None
    status: str
    reason: str | None


class SizedCandidate(Record):
    """A screw against the requirement.

    rank: from 1, over all
    name: of the row, else diameter x lead in mm; no two have one
    source: catalogue | design
    source_name: maker or series, and file, of the row; the rules of a design
    row: of the catalogue, from 1
    design: from 1
    type: standard | inverted | recirculating
    screw_diameter_mm [mm]: nominal
    lead_mm [mm]: < 0 left-handed
    starts: of screw and nut
    nut_diameter_mm [mm]: outer
    nut_length_mm [mm]: of the whole nut
    passes: all criteria
    pareto: no other that passes is as good in weight, nut diameter, life, torque and power lost, and better in one
    limited_by: the criterion of the least margin
    weight_kg [kg]: nut, rollers, screw over the shaft's length
    shaft_length_mm [mm]: between the supports
    life_basis: maker | threads
    basis: maker | computed | threads: life by the catalogues' formula with a printed or a computed C_a, or by the loads of the threads
    rated_dynamic_capacity_N [N]: C_a in the catalogues' formula
    rated_static_capacity_N [N]: C_0 in the catalogues' formula
    assumed: dimensions by the rules of `prs new`: the source states none
    life_revolutions [revolutions]: rated, of all travel; Jung 2017, (8.25); ISO 281
    life_hours [h]: clock time, rests included
    life_km [km]: of all travel
    static_safety: by C_0, or by threads
    computed: the same by the loads of the threads
    dynamic_capacity_N [N]: of the row
    static_capacity_N [N]: of the row
    drag_torque_Nm [N m]: of the row
    axial_play_mm [mm]: of the row
    grease_volume_cm3 [cm³]: of the row
    preload_N [N]: of each flank without load
    no_load_torque_Nm [N m]: of the preload at the part that turns, at the mean speed
    bearing_equivalent_load_N [N]: of the bearing, with its preload
    bearing_life_hours [h]: of the bearing at the required reliability, rests included
    bearing_life_km [km]: the same, of all travel
    life_with_bearings_hours [h]: L10 of screw and bearing together, rests included
    bearing_static_safety: static capacity over the largest force
    buckling_load_N [N]: of the shaft, as `prs measures`
    buckling_safety: against the largest compression
    critical_speed_rpm [rpm]: of a screw that turns
    largest_speed_rpm [rpm]: of screw against nut
    speed_times_diameter_mm_per_min [mm/min]: d the nominal diameter
    stiffness_N_per_um [N/µm]: of the load case with the largest force, in series with shaft and bearing
    efficiency: of the cycle, where the screw drives
    back_driving_efficiency: absent where the screw locks itself
    self_locking: by slip
    temperature_degC [°C]: mean of the cycle or the mission; absent without `heat`
    hottest_part_degC [°C]: largest of these; in a mission its peak
    heat_cycle: the mission; its course for the candidate with a curve
    conductance_W_per_K [W/K]: between parts and surroundings
    power_lost_W [W]: mean of the cycle
    inertia_kg_mm2 [kg mm²]: at the part that turns
    motor_rms_torque_Nm [N m]: over the cycle
    motor_peak_torque_Nm [N m]: largest of the cycle
    motor_largest_speed_rpm [rpm]: with the gear
    motor_peak_power_W [W]: largest of the cycle
    inertia_ratio: screw and mass over the motor's, at its shaft
    regenerated_mean_W [W]: over the cycle
    regenerated_peak_W [W]: largest of the cycle
    motor_rms_current_A [A]: over the cycle, of the direct-current motor
    motor_peak_current_A [A]: largest of the cycle
    motor_peak_voltage_V [V]: largest of the cycle
    motor_voltage_speed_rpm [rpm]: of the motor, up to which the supply's voltage drives the largest torque of the motion
    copper_loss_W [W]: mean of R I^2
    electrical_energy_J [J]: per cycle, net
    regenerated_electrical_J [J]: per cycle, back to the supply
    reflected_mass_kg [kg]: of motor, gear and screw, at the nut
    back_driving_force_N [N]: axial, with which a load begins to turn a motor without current; absent where the screw locks itself
    holding_torque_Nm [N m]: at the motor, without friction
    brake_needed: a force at rest turns the screw
    relubrication_h [h]: interval by the makers' rule; Rockwell MPAI-IN001F pp. 45 to 47; Tolomatic IMA-S guide pp. 34 to 35
    segments: of the motion
    criteria: values against limits
    warnings: on this candidate
    """

    __slots__ = ()
    rank: int
    name: str
    source: str
    source_name: str
    row: int | None
    design: int | None
    type: str
    screw_diameter_mm: float
    lead_mm: float
    starts: int
    nut_diameter_mm: float
    nut_length_mm: float
    passes: bool
    pareto: bool
    limited_by: str | None
    weight_kg: float | None
    shaft_length_mm: float | None
    life_basis: str
    basis: str
    rated_dynamic_capacity_N: float | None
    rated_static_capacity_N: float | None
    assumed: list[str]
    life_revolutions: float | None
    life_hours: float | None
    life_km: float | None
    static_safety: float | None
    computed: SizedByThreads
    dynamic_capacity_N: float | None
    static_capacity_N: float | None
    drag_torque_Nm: float | None
    axial_play_mm: float | None
    grease_volume_cm3: float | None
    preload_N: float | None
    no_load_torque_Nm: float | None
    bearing_equivalent_load_N: float | None
    bearing_life_hours: float | None
    bearing_life_km: float | None
    life_with_bearings_hours: float | None
    bearing_static_safety: float | None
    buckling_load_N: float | None
    buckling_safety: float | None
    critical_speed_rpm: float | None
    largest_speed_rpm: float | None
    speed_times_diameter_mm_per_min: float | None
    stiffness_N_per_um: float | None
    efficiency: float | None
    back_driving_efficiency: float | None
    self_locking: bool | None
    temperature_degC: PartNumbers | None
    hottest_part_degC: float | None
    heat_cycle: HeatCycle | None
    conductance_W_per_K: ThermalConductances
    power_lost_W: float | None
    inertia_kg_mm2: float | None
    motor_rms_torque_Nm: float | None
    motor_peak_torque_Nm: float | None
    motor_largest_speed_rpm: float | None
    motor_peak_power_W: float | None
    inertia_ratio: float | None
    regenerated_mean_W: float | None
    regenerated_peak_W: float | None
    motor_rms_current_A: float | None
    motor_peak_current_A: float | None
    motor_peak_voltage_V: float | None
    motor_voltage_speed_rpm: float | None
    copper_loss_W: float | None
    electrical_energy_J: float | None
    regenerated_electrical_J: float | None
    reflected_mass_kg: float | None
    back_driving_force_N: float | None
    holding_torque_Nm: float | None
    brake_needed: bool
    relubrication_h: float | None
    segments: list[SizedSegment]
    criteria: list[SizeCriterion]
    warnings: list[str]


class Size(Record):
    """Candidates against a requirement.

    requirement: what no candidate changes
    counts: of the candidates
    objective: weight | nut_diameter | life | motor_torque | power_lost
    nearest: where nothing passes
    relax: of the candidates that miss one criterion alone, the one that misses it least
    curve: of one candidate
    invalid: refused by the rules of `prs new`
    candidates: by rank
    """

    __slots__ = ()
    requirement: SizeRequirement
    counts: SizeCounts
    objective: str
    nearest: NearestMiss | None
    relax: Relaxation | None
    curve: SizeCurve | None
    invalid: list[InvalidCandidate]
    candidates: list[SizedCandidate]
