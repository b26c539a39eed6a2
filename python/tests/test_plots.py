"""Pictures of results: what they show is what the results say, and nothing is cut or covered."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
import pytest
import rollerscrew as rs
from matplotlib.axes import Axes
from rollerscrew import plots

CONFIGS = Path(__file__).parents[2] / "configs"


@cache
def lesson(number: int) -> rs.Case:
    (file,) = CONFIGS.glob(f"{number:02}_*.yaml")
    return rs.Case.from_yaml(file)


@cache
def result(number: int, command: str) -> Any:
    return getattr(lesson(number), command)()


@cache
def long_sweep() -> rs.SolveResult:
    return (
        lesson(3)
        .with_(**{"load_cases[0].axial_force": "{from: 1 kN, to: 45 kN, steps: 100}"})
        .solve()
    )


@pytest.fixture(autouse=True)
def figures_closed() -> Iterator[None]:
    plt.close("all")
    yield
    plt.close("all")


def edited(of: Any, change: Callable[[dict[str, Any]], object]) -> Any:
    """The result of the document, changed."""
    document = json.loads(of.to_json())
    change(document)
    return type(of).from_json(json.dumps(document))


#: Every picture of every result.
PICTURES: dict[str, Callable[[Axes | None], Axes]] = {
    "check: contact points": lambda ax: result(1, "check").plot_contact_points(ax),
    "contact points, standard": lambda ax: result(5, "contact").plot_contact_points(ax),
    "contact points, inverted": lambda ax: result(1, "contact").plot_contact_points(ax),
    "contact: ellipses": lambda ax: result(7, "contact").plot_ellipses(ax=ax),
    "contact: load distribution": lambda ax: result(7, "contact").plot_load_distribution(ax=ax),
    "load distribution, 6 cases": lambda ax: result(1, "solve").plot_load_distribution(ax=ax),
    "load distribution, 1 case": lambda ax: result(1, "solve").plot_load_distribution([0], ax),
    "load distribution, 6 sweeps": lambda ax: result(3, "solve").plot_load_distribution(ax=ax),
    "load distribution, 100 loads": lambda ax: long_sweep().plot_load_distribution(range(100), ax),
    "load distribution, 35 threads": lambda ax: result(5, "solve").plot_load_distribution(ax=ax),
    "pressures": lambda ax: result(1, "solve").plot_pressures(ax=ax),
    "pressures, 100 loads": lambda ax: long_sweep().plot_pressures(range(100), ax),
    "ellipses, 20 threads": lambda ax: result(1, "solve").plot_ellipses(ax=ax),
    "ellipses, 35 threads": lambda ax: result(5, "solve").plot_ellipses("compression", ax),
    "stiffness, 6 sweeps": lambda ax: result(3, "solve").plot_stiffness(ax),
    "stiffness, 6 cases": lambda ax: result(1, "solve").plot_stiffness(ax),
    "displacement": lambda ax: result(3, "solve").plot_displacement(ax),
    "displacement, 100 loads": lambda ax: long_sweep().plot_displacement(ax),
    "butterfly, screw": lambda ax: result(3, "solve").plot_butterfly(ax=ax),
    "butterfly, nut": lambda ax: long_sweep().plot_butterfly("nut", ax),
    "convergence": lambda ax: result(1, "solve").plot_convergence(ax),
    "slip: power": lambda ax: result(9, "slip").plot_power(ax=ax),
    "slip: power by source": lambda ax: result(9, "slip").plot_power_by_source(ax=ax),
    "slip: friction": lambda ax: result(9, "slip").plot_friction("push", ax),
    "slip: load distribution": lambda ax: result(9, "slip").plot_load_distribution(ax=ax),
    "slip: stiffness": lambda ax: result(9, "slip").plot_stiffness(ax),
    "measures: stiffness terms": lambda ax: result(18, "measures").plot_stiffness_terms(ax),
    "measures: pressures": lambda ax: result(18, "measures").plot_pressures(ax=ax),
    "preload: displacement": lambda ax: result(12, "preload").plot_displacement(ax),
    "preload: stiffness": lambda ax: result(12, "preload").plot_stiffness(ax),
    "life: lives": lambda ax: result(14, "life").plot_lives(ax),
    "life: cycles": lambda ax: result(14, "life").plot_cycles(ax),
    "derivatives: elasticities": lambda ax: result(17, "study").plot_elasticities(ax=ax),
    "study: 12 factors": lambda ax: result(10, "study").plot(ax=ax),
    "study: 1 factor": lambda ax: result(11, "study").plot("axial_stiffness_N_per_um", ax),
    "study: samples": lambda ax: result(15, "study").plot(ax=ax),
    "study: grid of 4": lambda ax: result(16, "study").plot(ax=ax),
    "study: 7 factors": lambda ax: result(19, "study").plot(ax=ax),
    "study: grid of 2": lambda ax: result(21, "study").plot(ax=ax),
    "study: map of 4": lambda ax: result(16, "study").plot_map(ax=ax),
    "study: map of 2": lambda ax: result(21, "study").plot_map(ax=ax),
    "study: envelope": lambda ax: result(21, "study").plot_envelope(ax),
    "study: histogram": lambda ax: result(15, "study").plot_histogram(ax=ax),
    "study: contributions": lambda ax: result(15, "study").plot_contributions(ax=ax),
    "optimization: front": lambda ax: result(22, "optimize").plot_front(ax),
}

#: Axes whose ticks are words, or which have no ticks.
WITHOUT_X_LABEL = ("ellipses", "power by source")
WITHOUT_Y_LABEL = ("ellipses", "terms", "elasticities", "contributions")


#: Where the legend stands within the roller, or above the axes.
NAMED_WITHIN = ("check: contact", "contact points", "study: histogram")


def line(ax: Axes, label: str) -> Any:
    (found,) = [each for each in ax.get_lines() if each.get_label() == label]
    return found


def data(ax: Axes, label: str) -> np.ndarray[Any, Any]:
    return np.asarray(line(ax, label).get_ydata(), dtype=float)


def at(ax: Axes, label: str) -> np.ndarray[Any, Any]:
    return np.asarray(line(ax, label).get_xdata(), dtype=float)


def bars(ax: Axes) -> dict[str, float]:
    """Width of each bar by the name beside it."""
    names = {tick: text.get_text() for tick, text in zip(ax.get_yticks(), ax.get_yticklabels())}
    drawn: Any = ax.patches
    return {names[round(bar.get_y() + 0.5 * bar.get_height())]: bar.get_width() for bar in drawn}


# Every picture.


@pytest.mark.parametrize("name", PICTURES)
def test_a_new_figure_shows_all_its_text_and_no_legend_lies_on_the_axes(name: str) -> None:
    before = dict(matplotlib.rcParams)
    ax = PICTURES[name](None)
    assert dict(matplotlib.rcParams) == before
    figure: Any = ax.figure
    assert plt.get_fignums() == [figure.number]
    assert figure.get_figwidth() * 25.4 < 137.0
    figure.canvas.draw()
    box, room = figure.get_tightbbox(), 0.02
    assert box.x0 > -room and box.y0 > -room
    assert box.x1 < figure.get_figwidth() + room
    assert box.y1 < figure.get_figheight() + room
    for legend in figure.legends:
        for axes in figure.axes:
            assert legend.get_window_extent().y0 >= axes.get_window_extent().y1 - 1.0 or (
                legend.get_window_extent().x0 >= axes.get_window_extent().x1 - 1.0
            )


@pytest.mark.parametrize("name", PICTURES)
def test_axes_that_are_given_come_back_and_keep_their_style(name: str) -> None:
    with plt.style.context("default"):
        figure, ax = plt.subplots(figsize=(7.0, 5.0))
        size = ax.xaxis.label.get_fontsize()
        assert PICTURES[name](ax) is ax
        figure.canvas.draw()
    assert plt.get_fignums() == [figure.number]
    assert ax.xaxis.label.get_fontsize() == size
    assert tuple(figure.get_size_inches()) == (7.0, 5.0)
    assert not figure.legends
    legend = ax.get_legend()
    if legend is not None and not name.startswith(NAMED_WITHIN):
        box = legend.get_window_extent()
        for axes in figure.axes:
            for each in axes.get_lines():
                points = each.get_transform().transform(each.get_xydata())
                if len(points) > 2:
                    assert not box.count_contains(points)
            assert not any(box.overlaps(bar.get_window_extent()) for bar in axes.patches)


@pytest.mark.parametrize("name", PICTURES)
def test_axes_have_labels_with_units(name: str) -> None:
    ax = PICTURES[name](None)
    bare = {"Efficiency", "Designs", "Linear solve", "Relative residual", "Friction coefficient"}
    for axis, label, missing in (
        ("x", ax.get_xlabel(), WITHOUT_X_LABEL),
        ("y", ax.get_ylabel(), WITHOUT_Y_LABEL),
    ):
        if any(word in name for word in missing):
            continue
        assert label, axis
        has_unit = re.search(r"\((mm|µm|kN|%|N/µm|MPa|W|revolutions|kN/kg|mm/s)|\(% of", label)
        counts = label.startswith(("Thread, ", "Size by", "Factor over"))
        assert has_unit or counts or label in bare, label


def test_pictures_are_made_without_pyplot_until_then() -> None:
    code = "import sys, rollerscrew; sys.exit('matplotlib.pyplot' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_style_of_the_user_does_not_reach_new_figures() -> None:
    with plt.rc_context({"font.size": 20.0, "xtick.direction": "out", "xtick.major.size": 12.0}):
        ax = result(1, "solve").plot_stiffness()
        ax.figure.canvas.draw()
        assert ax.xaxis.label.get_fontsize() == 8.0
        tick = ax.xaxis.get_major_ticks()[-1]
        assert tick.label1.get_fontsize() == 7.5 and tick.tick1line.get_markersize() == 3.0


def test_a_picture_that_fails_leaves_no_figure() -> None:
    with pytest.raises(ValueError):
        result(1, "solve").plot_butterfly()
    assert plt.get_fignums() == []


def test_every_picture_of_results_is_there() -> None:
    source = "".join(Path(m.__file__).read_text() for m in (rs.results, rs.designs))
    assert sorted(plots.__all__) == sorted(set(re.findall(r"plots\.(\w+)\(", source)))


# Loads.


def test_load_distribution_shows_the_shares_and_their_mean() -> None:
    solved = result(1, "solve")
    ax = solved.plot_load_distribution()
    for case in solved.load_cases:
        for side in ("screw", "nut"):
            np.testing.assert_array_equal(
                data(ax, f"{case.name}, {side}"), case[side].load_rate_percent
            )
    np.testing.assert_array_equal(at(ax, f"{solved.load_cases[0].name}, nut"), np.arange(1, 21))
    assert set(data(ax, "equal shares")) == {5.0}
    assert list(ax.get_xticks()) == [1, 5, 10, 15, 20]


def test_interfaces_differ_without_colours() -> None:
    ax = result(1, "solve").plot_load_distribution()
    screw, nut = line(ax, "config1-tension, screw"), line(ax, "config1-tension, nut")
    assert screw.get_linestyle() != nut.get_linestyle()
    assert screw.get_markerfacecolor() != nut.get_markerfacecolor()
    markers = {each.get_marker() for each in ax.get_lines() if each.get_marker() != "None"}
    assert len(markers) == len(result(1, "solve").load_cases)


def test_of_many_sweeps_the_largest_loads_are_shown() -> None:
    solved = result(3, "solve")
    ax = solved.plot_load_distribution()
    assert len(ax.get_lines()) == 2 * 6 + 1
    np.testing.assert_array_equal(
        data(ax, "config1-tension, screw"),
        solved.load_case("config1-tension[44]").screw.load_rate_percent,
    )
    assert ax.figure.legends[0].get_title().get_text() == "axial load 45 kN"


def test_many_loads_of_a_sweep_have_a_colour_scale() -> None:
    ax = long_sweep().plot_load_distribution(range(100))
    assert len(ax.get_lines()) == 201
    (bar,) = [axes for axes in ax.figure.axes if axes is not ax]
    assert bar.get_ylabel() == "Axial load (kN)"
    assert bar.get_ylim() == (1.0, 45.0)


def test_pressures_are_those_of_the_threads() -> None:
    case = result(1, "solve").load_cases[3]
    ax = result(1, "solve").plot_pressures([case.name])
    np.testing.assert_array_equal(data(ax, f"{case.name}, nut"), case.nut.peak_pressure_MPa)


@pytest.mark.parametrize(
    "plot, quantity",
    [
        ("plot_stiffness", "axial_stiffness_N_per_um"),
        ("plot_displacement", "axial_displacement_um"),
    ],
)
def test_a_line_a_sweep_over_the_load(plot: str, quantity: str) -> None:
    solved = result(3, "solve")
    ax = getattr(solved, plot)()
    assert len(ax.get_lines()) == 6
    cases = [case for case in solved.load_cases if case.name.startswith("config2-compression[")]
    np.testing.assert_array_equal(data(ax, "config2-compression"), [c[quantity] for c in cases])
    np.testing.assert_allclose(at(ax, "config2-compression"), np.linspace(1.0, 45.0, 45))


def test_single_cases_are_points() -> None:
    ax = result(1, "solve").plot_stiffness()
    for each, case in zip(ax.get_lines(), result(1, "solve").load_cases, strict=True):
        assert each.get_linestyle() == "None"
        assert list(each.get_xdata()) == [45.0]
        assert list(each.get_ydata()) == [case.axial_stiffness_N_per_um]


@pytest.mark.parametrize("interface", ["screw", "nut"])
def test_butterfly_has_tension_to_the_right(interface: str) -> None:
    solved = result(3, "solve")
    ax = solved.plot_butterfly(interface)
    for direction, sign in (("tension", 1.0), ("compression", -1.0)):
        label = f"config3-{direction}, thread 20"
        np.testing.assert_allclose(at(ax, label), sign * np.linspace(1.0, 45.0, 45))
        rates = [
            case[interface].load_rate_percent[19]
            for case in solved.load_cases
            if case.name.startswith(f"config3-{direction}[")
        ]
        np.testing.assert_allclose(data(ax, label), 20.0 * np.array(rates))


def test_convergence_shows_the_residuals() -> None:
    ax = result(1, "solve").plot_convergence()
    assert ax.get_yscale() == "log"
    case = result(1, "solve").load_cases[0]
    np.testing.assert_array_equal(
        data(ax, case.name), [each.relative_residual for each in case.newton_history]
    )


def test_names_are_no_formulas_and_stay_in_the_legend() -> None:
    def rename(document: dict[str, Any]) -> None:
        document["load_cases"][0]["name"] = "_x$y^2$\nz"
        document["load_cases"][1]["name"] = "n" * 80

    ax = edited(result(1, "solve"), rename).plot_load_distribution()
    ax.figure.canvas.draw()
    texts = [text.get_text() for text in ax.figure.legends[0].get_texts()]
    assert texts[0] == r" _x\$y^2\$ z"
    assert texts[1].endswith("…") and len(texts[1]) < 40


# Contacts.


def test_contact_points_lie_where_the_document_says() -> None:
    contact = result(1, "contact").contact
    ax = result(1, "contact").plot_contact_points()
    for side in ("screw", "nut"):
        (label,) = [
            str(each.get_label())
            for each in ax.get_lines()
            if str(each.get_label()).startswith(f"contact with the {side}")
        ]
        angle = np.radians(contact[side].angle_on_body_deg)
        np.testing.assert_allclose(
            [at(ax, label)[0], data(ax, label)[0]],
            contact[side].radius_on_body_mm * np.array([np.cos(angle), np.sin(angle)]),
            atol=1e-12,
        )
    radius = np.hypot(at(ax, "pitch circle, nut"), data(ax, "pitch circle, nut"))
    np.testing.assert_allclose(radius, 17.5)
    roller = np.hypot(at(ax, "pitch circle, roller") - 14.0, data(ax, "pitch circle, roller"))
    np.testing.assert_allclose(roller, 3.5)
    assert ax.get_aspect() == 1.0


@pytest.mark.parametrize("number, threads", [(1, 20), (5, 35)])
def test_ellipses_are_to_scale(number: int, threads: int) -> None:
    case = result(number, "solve").load_cases[0]
    ax = result(number, "solve").plot_ellipses()
    (collection,) = ax.collections
    assert ax.get_aspect() == 1.0
    values = np.concatenate([case[side].peak_pressure_MPa for side in ("screw", "nut")])
    np.testing.assert_array_equal(collection.get_array(), values)
    paths = collection.get_paths()
    assert len(paths) == 2 * threads
    extents = [path.get_extents() for path in paths]
    np.testing.assert_allclose(
        [box.width for box in extents],
        np.concatenate([2.0 * case[side].semi_major_mm for side in ("screw", "nut")]),
        rtol=1e-6,
    )
    np.testing.assert_allclose(
        [box.height for box in extents],
        np.concatenate([2.0 * case[side].semi_minor_mm for side in ("screw", "nut")]),
        rtol=1e-6,
    )
    assert min(box.y0 for box in extents[:threads]) > max(box.y1 for box in extents[threads:])
    assert not any(a.overlaps(b) for k, a in enumerate(extents) for b in extents[:k])


# Slip, measures, preload, life.


def test_power_and_friction_are_those_of_the_threads() -> None:
    slip = result(9, "slip").load_cases[0].slip
    ax = result(9, "slip").plot_power()
    np.testing.assert_array_equal(data(ax, "screw–roller"), slip.screw.power_W)
    np.testing.assert_array_equal(data(ax, "roller–nut"), slip.nut.power_W)
    ax = result(9, "slip").plot_friction()
    np.testing.assert_array_equal(
        data(ax, "Friction coefficient, roller–nut"), slip.nut.friction_coefficient
    )
    (right,) = [axes for axes in ax.figure.axes if axes is not ax]
    np.testing.assert_array_equal(
        data(right, "Sliding speed (mm/s), roller–nut"), slip.nut.sliding_speed_mm_per_s
    )


def test_power_by_source_sums_to_the_loss() -> None:
    slipped = result(9, "slip")
    ax = slipped.plot_power_by_source()
    tops = [max(bar.get_y() + bar.get_height() for bar in group) for group in zip(*ax.containers)]
    np.testing.assert_allclose(tops, [case.slip.power_loss_W for case in slipped.load_cases])


def test_power_over_the_loads_of_a_sweep_is_an_area() -> None:
    slipped = (
        lesson(10)
        .with_(**{"load_cases[0].axial_force": "{from: 5 kN, to: 60 kN, steps: 100}"})
        .slip()
    )
    ax = slipped.plot_power_by_source()
    top = np.asarray(ax.collections[-1].get_paths()[0].vertices)
    losses = [case.slip.power_loss_W for case in slipped.load_cases]
    np.testing.assert_allclose(top[:, 1].max(), max(losses))
    assert ax.get_xlim() == (5.0, 60.0)
    ax.figure.canvas.draw()


def test_stiffness_terms_add_up_to_the_stiffness_of_the_threads() -> None:
    measured = result(18, "measures")
    terms = bars(measured.plot_stiffness_terms())
    in_series = sum(
        value for name, value in terms.items() if name.startswith(("contacts", "teeth"))
    )
    stiffness = measured.load_cases[0].measures.thread_stiffness_N_per_um
    np.testing.assert_allclose(1e3 / in_series, stiffness, rtol=1e-9)
    np.testing.assert_allclose(
        terms["shaft of the screw"], 1e3 / measured.measures.shaft_stiffness_N_per_um
    )


def test_contacts_of_several_loads_have_bars_of_their_own() -> None:
    measured = lesson(18).with_(**{"load_cases[1].axial_force": "10 kN"}).measures()
    ax = measured.plot_stiffness_terms()
    ax.figure.canvas.draw()
    assert len(ax.patches) == len(bars(ax)) + 2
    labels = [text.get_text() for text in ax.figure.legends[0].get_texts()]
    assert labels == ["pull, 30 kN", "push, 10 kN"]


def test_preload_curves() -> None:
    preloaded = result(12, "preload")
    frame = preloaded.to_frame()
    ax = preloaded.plot_displacement()
    np.testing.assert_array_equal(data(ax, "with preload"), frame["axial_displacement_um"])
    np.testing.assert_allclose(at(ax, "with preload"), frame["axial_force_N"] / 1e3)
    ax = preloaded.plot_stiffness()
    np.testing.assert_array_equal(
        data(ax, "without preload"), frame["without_preload_tangent_stiffness_N_per_um"]
    )
    opening = preloaded.preload.opening_force_N
    np.testing.assert_allclose(
        at(ax, "a side opens"), [opening.tension / 1e3, -opening.compression / 1e3]
    )


def test_lives_and_cycles() -> None:
    life = result(14, "life").life
    ax = result(14, "life").plot_lives()
    assert ax.get_yscale() == "log"
    np.testing.assert_array_equal(
        data(ax, "compression, roller–nut"), life.compression.nut.l10_revolutions
    )
    assert set(data(ax, "mechanism")) == {life.system.l10_revolutions}
    ax = result(14, "life").plot_cycles()
    (mesh,) = ax.collections
    np.testing.assert_allclose(mesh.get_array().filled(0.0), life.cycles.matrix.count)
    np.testing.assert_allclose(ax.get_ylim()[1], life.cycles.matrix.range_to_N / 1e3)


# Studies.


def test_elasticities_rank_the_factors() -> None:
    derived = result(17, "study")
    response = derived.derivatives[3]
    ax = derived.plot_elasticities(response.response)
    shown = list(bars(ax).values())
    assert sorted(shown) == sorted(by.percent_per_percent for by in response.by)
    ordered = [bars(ax)[text.get_text()] for text in ax.get_yticklabels()]
    assert [abs(value) for value in ordered] == sorted(map(abs, ordered), reverse=True)


def test_a_study_of_one_factor_has_its_units() -> None:
    studied = result(11, "study")
    ax = studied.plot("axial_stiffness_N_per_um")
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("Crowning (µm)", "Axial stiffness (N/µm)")
    designs = studied.all_designs
    np.testing.assert_array_equal(
        data(ax, "axial stiffness"), designs["axial_stiffness_N_per_um"][1:]
    )
    assert data(ax, "as in the file") == designs["axial_stiffness_N_per_um"][0]


@pytest.mark.parametrize("read", [False, True])
def test_factors_one_at_a_time_are_relative_to_the_file(read: bool) -> None:
    studied = result(10, "study")
    if read:
        studied = rs.StudyResult.from_json(studied.to_json())
    ax = studied.plot("slip.efficiency")
    values = studied.all_designs["slip.efficiency"]
    np.testing.assert_allclose(at(ax, "screw diameter"), np.array([20, 25, 30, 40, 50]) / 30.0)
    np.testing.assert_allclose(
        data(ax, "screw diameter"), 100.0 * (values[1:6] / values[0] - 1.0), atol=1e-12
    )
    assert 1.0 in at(ax, "viscosity")
    (legend,) = ax.figure.legends
    assert legend.get_texts()[-1].get_text().startswith("not shown:\nscrew profile curvature")


def test_what_a_factor_takes_along_does_not_count_as_another_factor() -> None:
    studied = result(19, "study")
    for each in (studied, rs.StudyResult.from_json(studied.to_json())):
        ax = each.plot()
        assert len(at(ax, "d_n, all in proportion")) == 22  # 21 values, the file's between them
        assert np.isnan(data(ax, "d_s, same nut")).sum() == 3  # refused


@pytest.mark.parametrize("read", [False, True])
def test_lines_of_a_grid(read: bool) -> None:
    studied = result(16, "study")
    if read:
        studied = rs.StudyResult.from_json(studied.to_json())
    ax = studied.plot("axial_stiffness_N_per_um")
    assert len(ax.get_lines()) == 12
    label = "position: 54.333 mm, loading: compression, roller: rigid_bending"
    values = studied.all_designs["axial_stiffness_N_per_um"]
    np.testing.assert_array_equal(data(ax, label), values[109:121])
    np.testing.assert_allclose(at(ax, label), np.linspace(1.0, 45.0, 12))
    assert len({tuple(map(str, _look(each))) for each in ax.get_lines()}) == 12


def _look(of: Any) -> tuple[Any, ...]:
    return of.get_color(), of.get_linestyle(), of.get_marker()


@pytest.mark.parametrize("read", [False, True])
def test_a_map_holds_other_factors_as_in_the_file(read: bool) -> None:
    studied = result(16, "study")
    if read:
        studied = rs.StudyResult.from_json(studied.to_json())
    ax = studied.plot_map("screw.peak_pressure_MPa.max", y="load_cases[0].position")
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("Axial force (kN)", "Position (mm)")
    assert ax.get_title(loc="left") == "loading: tension, roller: flexible"
    assert ax.get_xlim() == (1.0, 45.0)
    dots = line(ax, "designs")
    assert len(dots.get_xdata()) == 36
    bar = next(axes for axes in ax.figure.axes if axes is not ax)
    assert bar.get_ylabel() == "Max screw peak pressure (MPa)"
    values = studied.all_designs["screw.peak_pressure_MPa.max"][1:37]
    filled = ax.collections[0]
    assert filled.get_clim()[0] <= values.min() < values.max() <= filled.get_clim()[1]


def test_a_map_tells_designs_without_answer() -> None:
    ax = result(21, "study").plot_map("measures.weight_kg")
    assert len(at(ax, "designs")) == 63
    assert len(at(ax, "designs without answer")) == 27


def test_the_envelope_has_its_points() -> None:
    studied = result(21, "study")
    ax = studied.plot_envelope()
    for point in studied.envelope.points:
        settings = point.settings
        assert at(ax, point.name) == settings["mechanism.lead"]["number"]
        assert data(ax, point.name) == settings["mechanism.rollers"]["number"]


def test_an_envelope_that_the_document_leaves_out_follows_from_the_designs() -> None:
    from rollerscrew.plots.study_maps import _envelope_values

    studied = result(21, "study")
    without = edited(studied, lambda document: document["envelope"].pop("values"))
    np.testing.assert_allclose(
        _envelope_values(without, 9, 10), studied.envelope["values"], rtol=1e-12
    )
    without.plot_envelope()


def test_the_histogram_is_that_of_the_summary() -> None:
    studied = result(15, "study")
    name = "nut.peak_pressure_MPa.max"
    ax = studied.plot_histogram(name)
    statistics = studied.summary.statistics[name]
    values, edges, _ = ax.patches[0].get_data()
    np.testing.assert_array_equal(values, statistics.histogram.counts)
    assert (edges[0], edges[-1]) == (statistics.histogram["from"], statistics.histogram.to)
    marks = [each.get_xdata()[0] for each in ax.get_lines()]
    quantiles = [statistics.quantiles[p] for p in ("0.05", "0.5", "0.95")]
    assert marks == [*quantiles, studied.all_designs[name][0]]


def test_contributions_have_the_sign_of_the_surface() -> None:
    studied = result(15, "study")
    name = "contact.screw.curvature_sum_per_mm"
    shown = bars(studied.plot_contributions(name))
    labels = {factor["path"]: factor["label"] for factor in studied.study.factors}
    for factor in studied.summary.response_surface.responses[name].factors:
        value = np.copysign(factor.contribution_percent, factor.coefficient)
        label = labels[factor["path"]]
        assert shown[label] == value
    assert "R² = " in plt.gcf().legends[0].get_title().get_text()


def test_shares_of_the_variance_are_drawn_where_the_study_has_them() -> None:
    studied = lesson(15).with_(**{"study.plan": "sobol_indices", "study.samples": 32}).study()
    assert isinstance(studied, rs.StudyResult)
    ax = studied.plot_contributions()
    ax.figure.canvas.draw()
    first = studied.summary.sobol_indices["screw.peak_pressure_MPa.max"].factors[0]
    drawn: Any = ax.patches
    widths = [bar.get_width() for bar in drawn]
    assert 100.0 * first.total.value in widths and 100.0 * first.first.value in widths


# Optimizations.


def test_the_front_has_its_designs_and_the_compromise() -> None:
    found = result(22, "optimize")
    ax = found.plot_front()
    names = ["screw.peak_pressure_MPa.max", "nut.peak_pressure_MPa.max"]
    assert at(ax, "compromise") == found.compromise.responses[names[0]]
    assert data(ax, "compromise") == found.compromise.responses[names[1]]
    assert data(ax, "as in the file") == found.initial.responses[names[1]]
    expected = sorted(tuple(row.responses[n] for n in names) for row in found.search.front)
    drawn = zip(at(ax, "front, nsga2"), data(ax, "front, nsga2"), strict=True)
    assert list(drawn) == expected
    assert ax.get_xlabel() == "Max screw peak pressure (MPa)"


def test_one_objective_is_shown_over_the_designs() -> None:
    single = edited(
        result(22, "optimize"), lambda document: document["optimize"]["objectives"].pop()
    )
    ax = single.plot_front()
    ax.figure.canvas.draw()
    assert (ax.get_xlabel(), ax.get_ylabel()) == (
        "Design of the search",
        "Max screw peak pressure (MPa)",
    )
    (compromise,) = [
        each for each in ax.get_lines() if str(each.get_label()).startswith("compromise")
    ]
    assert list(compromise.get_xdata()) == [single.compromise.design]


# What cannot be drawn.


def failed(document: dict[str, Any]) -> None:
    kept = ("name", "axial_force_N", "direction", "relative_residual", "iterations")
    for case in document["load_cases"]:
        for name in [name for name in case if name not in kept]:
            del case[name]
        case |= {"converged": False, "status": "iteration_limit"}


def no_pressures(document: dict[str, Any]) -> None:
    for case in document["load_cases"]:
        for side in ("screw", "nut"):
            for name in ("peak_pressure_MPa", "semi_major_mm", "semi_minor_mm"):
                del case[side][name]


def slip_failed(document: dict[str, Any]) -> None:
    document["load_cases"][0]["slip"] = {"converged": False, "status": "no_bracket"}


def no_designs(document: dict[str, Any]) -> None:
    document.pop("designs")


def without_fronts(document: dict[str, Any]) -> None:
    document.pop("check")
    document.pop("compromise")
    document["search"]["front"] = []


REFUSED: dict[str, tuple[Callable[[], object], str]] = {
    "no loads": (
        lambda: edited(result(1, "solve"), failed).plot_load_distribution(),
        "no load case has thread loads",
    ),
    "a case without loads": (
        lambda: edited(result(1, "solve"), failed).plot_pressures([0]),
        "'config1-tension' has no thread loads: iteration_limit",
    ),
    "ellipses without loads": (
        lambda: edited(result(1, "solve"), failed).plot_ellipses(),
        "has no thread loads",
    ),
    "stiffness": (
        lambda: edited(result(1, "solve"), failed).plot_stiffness(),
        "no load case has an axial stiffness",
    ),
    "displacement": (
        lambda: edited(result(1, "solve"), failed).plot_displacement(),
        "no load case has an axial displacement",
    ),
    "convergence": (
        lambda: edited(result(1, "solve"), failed).plot_convergence(),
        "history of Newton's method",
    ),
    "butterfly": (lambda: result(1, "solve").plot_butterfly(), "no sweep of loads"),
    "interface": (
        lambda: result(3, "solve").plot_butterfly("roller"),
        "no interface 'roller'; there is screw, nut",
    ),
    "pressures": (
        lambda: edited(result(1, "solve"), no_pressures).plot_pressures(),
        "has no peak pressures",
    ),
    "ellipses": (
        lambda: edited(result(1, "solve"), no_pressures).plot_ellipses(),
        "has no contact ellipses",
    ),
    "slip": (
        lambda: edited(result(9, "slip"), slip_failed).plot_power(),
        "slip of load case 'pull' did not converge: no_bracket",
    ),
    "no slip": (lambda: plots.friction(result(1, "solve").load_cases[0]), "has no slip"),
    "power": (
        lambda: plots.power_by_source(result(1, "solve").load_cases),
        "no load case has a converged slip equilibrium",
    ),
    "cycles": (
        lambda: edited(result(14, "life"), lambda d: d["life"].pop("cycles")).plot_cycles(),
        "there are no load cycles",
    ),
    "lives": (
        lambda: edited(
            result(14, "life"), lambda d: d["life"].update(converged=False, status="failed there")
        ).plot_lives(),
        "there are no lives of threads: failed there",
    ),
    "preload": (
        lambda: edited(
            result(12, "preload"), lambda d: d["preload"].update(loads=[])
        ).plot_displacement(),
        "no load of the preloaded nut converged",
    ),
    "no grid": (
        lambda: result(10, "study").plot_map(),
        "needs `plan: grid` with two factors of numbers; this is one_at_a_time",
    ),
    "one axis": (
        lambda: result(16, "study").plot_map(
            x="load_cases[0].position", y="load_cases[0].position"
        ),
        "vary together",
    ),
    "companion": (
        lambda: result(21, "study").plot_map(x="mechanism.lead", y="mechanism.contacts_per_roller"),
        "vary together",
    ),
    "no envelope": (lambda: result(16, "study").plot_envelope(), "has no envelope"),
    "no surface": (
        lambda: result(16, "study").plot_contributions(),
        "has no linear surface: expected a plan that draws samples",
    ),
    "no designs": (
        lambda: edited(result(16, "study"), no_designs).plot(),
        "the document holds no designs",
    ),
    "no front": (
        lambda: edited(result(22, "optimize"), without_fronts).plot_front(),
        "no design with an answer",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_not_there_is_told(name: str) -> None:
    draw, sentence = REFUSED[name]
    with pytest.raises(ValueError, match=re.escape(sentence)):
        draw()
    assert plt.get_fignums() == []


def test_a_constant_response_has_no_histogram() -> None:
    name = "slip.share_percent.carrier_screw"
    with pytest.raises(ValueError, match="has no histogram"):
        result(10, "study").plot_histogram(name)


@pytest.mark.parametrize(
    "draw",
    [
        lambda: result(10, "study").plot("slip.power"),
        lambda: result(16, "study").plot_map("slip.power"),
        lambda: result(15, "study").plot_histogram("slip.power"),
        lambda: result(15, "study").plot_contributions("slip.power"),
        lambda: result(17, "study").plot_elasticities("slip.power"),
    ],
)
def test_an_unknown_response_is_told_with_those_that_there_are(draw: Callable[[], object]) -> None:
    with pytest.raises(KeyError, match=r"no response 'slip\.power'; there is ") as told:
        draw()
    assert "_" in str(told.value).split("there is ")[1]


def test_an_unknown_factor_is_told_with_those_that_there_are() -> None:
    with pytest.raises(
        KeyError, match=r"no factor of numbers 'model\.roller'; there is load_cases"
    ):
        result(16, "study").plot_map(x="model.roller")


def test_a_load_case_that_is_not_there_is_told() -> None:
    with pytest.raises(KeyError, match="no load case 'config9'"):
        result(1, "solve").plot_load_distribution(["config9"])


def test_designs_as_points() -> None:
    case = rs.Case.from_yaml(CONFIGS / "05_standard_screw.yaml")
    forces = np.linspace(5.0, 30.0, 7)
    answers = case.evaluate(
        {"load_cases[0].axial_force": (forces, "kN")}, ["axial_stiffness_N_per_um"]
    )
    ax = answers.plot("load_cases[0].axial_force_kN", "axial_stiffness_N_per_um")
    points = np.asarray(ax.collections[0].get_offsets())
    np.testing.assert_array_equal(points[:, 0], forces)
    np.testing.assert_array_equal(points[:, 1], answers["axial_stiffness_N_per_um"])
    assert ax.get_ylabel() == "Axial stiffness (N/µm)"
    plt.close("all")
    with pytest.raises(KeyError, match="no column 'x'"):
        answers.plot("x", "axial_stiffness_N_per_um")
