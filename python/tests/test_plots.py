"""The renderer draws what a description says, and nothing is cut or covered."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
import pytest
import rollerscrew as rs
from conftest import CONFIGS, answer, commands, lesson
from matplotlib.axes import Axes
from rollerscrew import plots
from rollerscrew.plots import draw

Description = dict[str, Any]


@pytest.fixture(autouse=True)
def figures_closed() -> Iterator[None]:
    plt.close("all")
    yield
    plt.close("all")


def line(ax: Axes, label: str) -> Any:
    (found,) = [each for each in ax.get_lines() if each.get_label() == label]
    return found


def data(ax: Axes, label: str) -> np.ndarray[Any, Any]:
    return np.asarray(line(ax, label).get_xydata(), dtype=float)


def texts(ax: Axes) -> list[str]:
    return [text.get_text() for text in ax.texts]


def legend_texts(ax: Axes) -> list[str]:
    figure: Any = ax.figure
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


def other_axes(ax: Axes) -> list[Axes]:
    return [axes for axes in ax.figure.axes if axes is not ax]


def rectangle(x: tuple[float, float], y: tuple[float, float]) -> list[list[float]]:
    return [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]]


def one_panel(panel: Description, **figure: Any) -> Description:
    """A description as JSON has it."""
    described: Description = json.loads(json.dumps({"name": "one", **figure, "panels": [panel]}))
    return described


def shares(**figure: Any) -> Description:
    """Lines of two configurations with their mean."""
    return one_panel(
        {
            "series": [
                {"style": 0, "parts": [[[1, 40], [2, 33], [3, 27]]]},
                {"style": 1, "parts": [[[1, 30], [2, 31]], [[4, 29], [5, 28]]]},
            ],
            "references": [{"style": 2, "at": 33.0}, {"style": 2, "at": 2.5, "vertical": True}],
        },
        **{
            "x": {"label": "Thread", "whole": True},
            "y": {"label": "Share of the load", "unit": "%", "from": 0, "to": 42},
            "styles": [
                {"colour": "blue", "mark": "circle"},
                {"colour": "vermillion", "dash": "dashed", "mark": "square", "open": True},
                {"colour": "reference", "weight": "thin"},
            ],
            "legend": [
                {"title": "config1", "style": 0},
                {"title": "config2", "style": 1},
                {"title": "equal shares", "style": 2},
            ],
        }
        | figure,
    )


X, Y = np.linspace(2.0, 10.0, 9), np.linspace(6.0, 12.0, 7)


def surface_grid() -> Description:
    values: Any = np.outer(np.sqrt(X), Y).tolist()
    values[8][5] = values[8][6] = None
    return {"x": X.tolist(), "y": Y.tolist(), "values": values}


def contour_map(**drawn: Any) -> Description:
    return one_panel(
        {
            "map": surface_grid() | drawn,
            "series": [{"style": 0, "parts": [[[2, 6], [10, 12]]]}],
            "labels": [{"text": "best", "x": 4, "y": 8, "anchor": "centre"}],
        },
        x={"label": "Lead", "unit": "mm"},
        y={"label": "Rollers", "whole": True},
        colours={"label": "Stiffness", "unit": "N/µm", "from": 8, "to": 38,
                 "levels": [5, 10, 15, 20, 25, 30, 35, 40]},
        styles=[{"dash": "none", "mark": "cross", "colour": "muted"}],
        legend=[{"title": "no answer", "style": 0}],
    )  # fmt: skip


# What a description says.


def test_lines_have_the_points_and_gaps_of_their_parts() -> None:
    ax = draw(shares())
    np.testing.assert_array_equal(data(ax, "config1"), [[1, 40], [2, 33], [3, 27]])
    gap = [[1, 30], [2, 31], [np.nan, np.nan], [4, 29], [5, 28]]
    np.testing.assert_array_equal(data(ax, "config2"), gap)


def test_lines_differ_by_colour_dashes_and_marks() -> None:
    ax = draw(shares())
    first, second = line(ax, "config1"), line(ax, "config2")
    assert first.get_color() != second.get_color()
    assert (first.get_linestyle(), second.get_linestyle()) == ("-", "--")
    assert (first.get_marker(), second.get_marker()) == ("o", "s")
    assert second.get_markerfacecolor() == "white" != first.get_markerfacecolor()


def test_references_cross_the_panel_behind_the_lines() -> None:
    ax = draw(shares())
    across, upright = (each for each in ax.get_lines() if each.get_label() == "equal shares")
    assert list(across.get_ydata()) == [33.0, 33.0] and list(across.get_xdata()) == [0, 1]
    assert list(upright.get_xdata()) == [2.5, 2.5] and list(upright.get_ydata()) == [0, 1]
    assert across.get_zorder() < line(ax, "config1").get_zorder()


def test_axes_have_their_labels_limits_and_scales() -> None:
    ax = draw(shares(x={"label": "Load", "unit": "kN", "logarithmic": True, "from": 0.5}))
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("Load (kN)", "Share of the load (%)")
    assert ax.get_ylim() == (0.0, 42.0)
    assert ax.get_xscale() == "log" and ax.get_xlim()[0] == 0.5 and ax.get_xlim()[1] > 5.0


def test_ticks_are_those_given_with_their_texts() -> None:
    ticks = [{"at": 1, "text": "screw"}, {"at": 3, "text": "nut"}]
    ax = draw(shares(x={"ticks": ticks}, y={"ticks": [{"at": 30}, {"at": 40}]}))
    assert list(ax.get_xticks()) == [1, 3] and list(ax.get_yticks()) == [30, 40]
    assert [text.get_text() for text in ax.get_xticklabels()] == ["screw", "nut"]
    assert [text.get_text() for text in ax.get_yticklabels()] == ["30", "40"]


def test_an_axis_runs_from_its_first_end_to_its_last() -> None:
    assert draw(shares(y={"from": 5, "to": -1})).get_ylim() == (5.0, -1.0)


def test_whole_numbers_have_no_ticks_between_them() -> None:
    ax = draw(shares())
    ax.figure.canvas.draw()
    assert all(tick == round(tick) for tick in ax.get_xticks())


def test_a_hidden_axis_has_neither_ticks_nor_label() -> None:
    ax = draw(shares(x={"label": "x", "hidden": True}))
    assert list(ax.get_xticks()) == [] and ax.get_xlabel() == ""


def test_legends_name_their_entries_in_order_under_the_title() -> None:
    ax = draw(shares(title="Load distribution, 45 kN"))
    assert legend_texts(ax) == ["config1", "config2", "equal shares"]
    figure: Any = ax.figure
    assert figure.legends[0].get_title().get_text() == "Load distribution, 45 kN"


def test_texts_of_users_are_no_formulas_and_stay_visible() -> None:
    ax = draw(shares(legend=[{"title": "_x$y^2$", "style": 0}, {"title": "n" * 80, "style": 1}]))
    ax.figure.canvas.draw()
    assert legend_texts(ax)[0] == r" _x\$y^2\$"
    assert max(map(len, legend_texts(ax)[1].split("\n"))) < 50


def test_points_have_no_line() -> None:
    ax = draw(shares(styles=[{"dash": "none", "mark": "star"}, {}, {}]))
    assert (line(ax, "config1").get_linestyle(), line(ax, "config1").get_marker()) == ("None", "*")


def test_lines_and_points_have_the_colours_of_their_values() -> None:
    parts = [[[1, 5 + k], [2, 6 + k]] for k in range(4)]
    colours = {"label": "Axial load", "unit": "kN", "from": 1, "to": 45}
    series = [{"style": k, "parts": parts, "values": [1, 10, 20, 45]} for k in (0, 1)]
    ax = draw(
        one_panel(
            {"series": series}, colours=colours, styles=[{}, {"dash": "none", "mark": "circle"}]
        )
    )
    assert len({matplotlib.colors.to_hex(each.get_color()) for each in ax.get_lines()}) == 4
    (points,) = ax.collections
    np.testing.assert_array_equal(points.get_offsets(), np.concatenate(parts))
    np.testing.assert_array_equal(points.get_array(), np.repeat([1, 10, 20, 45], 2))
    (bar,) = other_axes(ax)
    assert (bar.get_ylabel(), bar.get_ylim()) == ("Axial load (kN)", (1.0, 45.0))


@pytest.mark.parametrize(
    "scale, ticks",
    [
        ({"from": 1, "to": 20, "whole": True}, [1, 5, 10, 15, 20]),
        ({"from": 0, "to": 4, "levels": [0, 1, 2.5, 4]}, [0, 1, 2.5, 4]),
        ({"from": 1, "to": 100, "logarithmic": True}, [1, 2, 5, 10, 20, 50, 100]),
    ],
)
def test_colour_bars_have_few_round_ticks(scale: Description, ticks: list[float]) -> None:
    series = [{"style": 0, "parts": [rectangle((0, 1), (0, 1))], "values": [2]}]
    ax = draw(one_panel({"series": series}, colours=scale, styles=[{"shape": "area"}]))
    ax.figure.canvas.draw()
    (bar,) = other_axes(ax)
    low, high = bar.get_ylim()
    np.testing.assert_allclose([t for t in bar.get_yticks() if low <= t <= high], ticks)


def test_areas_are_polygons() -> None:
    parts = [rectangle((0, 2), (-0.3, 0.3)), rectangle((0, -1), (0.7, 1.3))]
    ax = draw(one_panel({"series": [{"style": 0, "parts": parts}]}, styles=[{"shape": "area"}]))
    (areas,) = ax.collections
    for path, part in zip(areas.get_paths(), parts, strict=True):
        np.testing.assert_array_equal(path.vertices[:4], part)
    assert ax.get_xlim()[0] < -1.0 and ax.get_xlim()[1] > 2.0


def test_arrows_point_from_tail_to_head() -> None:
    parts = [[[1, 1], [2, 3]], [[4, 1], [4, 0]]]
    ax = draw(one_panel({"series": [{"style": 0, "parts": parts}]}, styles=[{"shape": "arrows"}]))
    arrows: Any = ax.collections[0]
    np.testing.assert_array_equal(arrows.get_offsets(), [[1, 1], [4, 1]])
    np.testing.assert_array_equal(np.column_stack([arrows.U, arrows.V]), [[1, 2], [0, -1]])


def test_labels_stand_where_they_should() -> None:
    labels = [
        {"text": "a", "x": 2, "y": 30},
        {"text": "b", "x": 0.5, "y": 0.9, "in_panel": True, "anchor": "right"},
    ]
    ax = draw(one_panel({"labels": labels}))
    first, second = ax.texts
    assert texts(ax) == ["a", "b"] and first.get_position() == (2, 30)
    assert (first.get_ha(), second.get_ha()) == ("left", "right")
    assert second.get_transform() == ax.transAxes


def test_maps_have_bands_with_labelled_isolines() -> None:
    ax = draw(contour_map())
    filled, lines = ax.collections[:2]
    assert list(filled.levels) == [5, 10, 15, 20, 25, 30, 35, 40]  # type: ignore[attr-defined]
    assert list(lines.levels) == [10, 15, 20, 25, 30, 35]  # type: ignore[attr-defined]
    assert {"10", "25", "best"} <= set(texts(ax))
    assert (ax.get_xlim(), ax.get_ylim()) == ((2.0, 10.0), (6.0, 12.0))
    assert not line(ax, "no answer").get_clip_on()
    (bar,) = other_axes(ax)
    assert bar.get_ylabel() == "Stiffness (N/µm)"


def test_maps_of_cells_have_a_rectangle_per_node() -> None:
    ax = draw(contour_map(cells=True))
    mesh: Any = ax.collections[0]
    drawn = np.ma.filled(mesh.get_array(), np.nan).reshape(len(Y), len(X))
    np.testing.assert_allclose(drawn, np.array(surface_grid()["values"], dtype=float).T)
    np.testing.assert_allclose(mesh.get_coordinates()[0, :2, 0], [1.5, 2.5])


def test_a_map_without_levels_or_of_one_value_is_drawn() -> None:
    described = contour_map(values=np.full((9, 7), 3.0).tolist())
    described["colours"] = {"label": "Stiffness", "from": 3, "to": 3}
    draw(described).figure.canvas.draw()


def test_surfaces_stand_in_space_with_their_points() -> None:
    point = {"name": "A", "x": 4, "y": 8, "z": 16}
    surface = surface_grid() | {"z": {"label": "Stiffness", "unit": "N/µm"}, "points": [point]}
    described = contour_map()
    described["panels"].append({"surface": surface})
    ax: Any = other_axes(draw(described | {"columns": 2}))[0]
    ax.figure.canvas.draw()
    assert ax.get_xlabel() == "Lead (mm)"
    assert texts(ax) == [" A", "Stiffness (N/µm)"]


def test_units_are_as_long_on_both_axes_of_a_drawing_to_scale() -> None:
    axis = {"from": 0, "to": 10}
    for ax in (None, plt.subplots(figsize=(7.0, 3.0))[1]):
        drawn = draw(shares(x=axis, y=axis, to_scale=True), ax)
        drawn.figure.canvas.draw()
        (x0, y0), (x1, y1) = drawn.transData.transform([(0, 0), (10, 10)])
        assert x1 - x0 == pytest.approx(y1 - y0)
        assert drawn.get_xlim()[0] <= 0.0 and drawn.get_xlim()[1] >= 10.0


def several(count: int, **figure: Any) -> Description:
    described = shares(**figure)
    (panel,) = described["panels"]
    described["panels"] = [panel | {"title": f"panel {k}"} for k in range(count)]
    return described


def test_panels_fill_rows_and_share_the_axes_of_the_figure() -> None:
    ax = draw(several(3, columns=2))
    figure: Any = ax.figure
    figure.canvas.draw()
    boxes = [axes.get_window_extent() for axes in figure.axes]
    assert [axes.get_title() for axes in figure.axes] == ["panel 0", "panel 1", "panel 2"]
    assert boxes[0].y0 == pytest.approx(boxes[1].y0) and boxes[0].x1 < boxes[1].x0
    assert boxes[0].x0 == pytest.approx(boxes[2].x0) and boxes[2].y1 < boxes[0].y0
    assert [bool(axes.get_xlabel()) for axes in figure.axes] == [False, True, True]
    assert [bool(axes.get_ylabel()) for axes in figure.axes] == [True, False, True]
    assert len(legend_texts(ax)) == 3


def test_panels_with_their_own_axes_have_their_own_labels() -> None:
    described = several(2, columns=2)
    described["panels"][1]["y"] = {"label": "Pressure", "unit": "MPa", "to": 60}
    first, second = draw(described).figure.axes
    assert (first.get_ylabel(), second.get_ylabel()) == ("Share of the load (%)", "Pressure (MPa)")
    assert (first.get_ylim(), second.get_ylim()[1]) == ((0.0, 42.0), 60.0)


def test_an_overview_fills_the_first_column() -> None:
    ax = draw(several(3, columns=2, overview=1.75))
    figure: Any = ax.figure
    figure.canvas.draw()
    first, second, third = (axes.get_window_extent() for axes in figure.axes)
    assert first.y1 > second.y0 > third.y1 > first.y0 - 1.0
    assert second.x0 == pytest.approx(third.x0) and first.x1 < second.x0
    assert first.width == pytest.approx(1.75 * second.width, rel=0.02)


# Where it is drawn.


def test_the_caller_gives_axes_for_one_panel_alone() -> None:
    ax = plt.subplots()[1]
    with pytest.raises(ValueError, match="the picture has 2 panels; axes take one"):
        draw(several(2), ax)
    with pytest.raises(TypeError, match="ax: got 3; expected axes of matplotlib"):
        draw(shares(), 3)  # type: ignore[arg-type]
    described = one_panel({"surface": surface_grid() | {"z": {}}}, colours={"from": 8, "to": 38})
    with pytest.raises(ValueError, match='a surface needs axes with `projection="3d"`'):
        draw(described, ax)


def test_a_picture_that_fails_leaves_no_figure() -> None:
    with pytest.raises(ValueError, match="no colour"):
        draw(shares(styles=[{"colour": "no colour"}, {}, {}]))
    assert plt.get_fignums() == []


def test_pyplot_is_not_loaded_before_the_first_picture() -> None:
    code = "import sys, rollerscrew.plots; sys.exit('matplotlib.pyplot' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_style_of_the_user_does_not_reach_new_figures() -> None:
    with plt.rc_context({"font.size": 20.0, "xtick.direction": "out", "xtick.major.size": 12.0}):
        ax = draw(shares())
        ax.figure.canvas.draw()
        assert ax.xaxis.label.get_fontsize() == 8.0
        tick = ax.xaxis.get_major_ticks()[-1]
        assert tick.label1.get_fontsize() == 7.5 and tick.tick1line.get_markersize() == 3.0


def test_the_legend_in_given_axes_makes_room_for_itself() -> None:
    figure, ax = plt.subplots(figsize=(5.0, 4.0))
    draw(shares(title="Load distribution"), ax)
    figure.canvas.draw()
    legend: Any = ax.get_legend()
    assert not figure.legends and ax.get_title() == "Load distribution"
    assert_uncovered(legend.get_window_extent(), ax)


def assert_uncovered(box: Any, ax: Axes) -> None:
    for each in ax.get_lines():
        points = each.get_transform().transform(each.get_xydata())
        if len(points) > 2 and each.get_linestyle() != "None":
            assert not box.count_contains(points)


# Pictures of results.


@cache
def long_sweep() -> rs.SolveResult:
    force = "{from: 1 kN, to: 45 kN, steps: 100}"
    return lesson(3).with_(**{"load_cases[0].axial_force": force}).solve()


def result(number: int, command: str) -> Any:
    return answer(number, command)


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
    "displacement": lambda ax: result(3, "solve").plot_displacement(ax),
    "displacement, 100 loads": lambda ax: long_sweep().plot_displacement(ax),
    "butterfly, screw": lambda ax: result(3, "solve").plot_butterfly(ax=ax),
    "butterfly, nut": lambda ax: long_sweep().plot_butterfly("nut", ax),
    "convergence": lambda ax: result(1, "solve").plot_convergence(ax),
    "slip: power": lambda ax: result(9, "slip").plot_power(ax=ax),
    "slip: power by source": lambda ax: result(9, "slip").plot_power_by_source(ax=ax),
    "slip: friction": lambda ax: result(9, "slip").plot_friction("push", ax),
    "slip: heat cycle": lambda ax: result(30, "slip").plot_heat_cycle(ax),
    "slip: load distribution": lambda ax: result(9, "slip").plot_load_distribution(ax=ax),
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


def assert_complete(ax: Axes) -> None:
    """Nothing is cut off or covered by the legend of the figure."""
    figure: Any = ax.figure
    assert figure.get_figwidth() * 25.4 <= 180.5
    figure.draw_without_rendering()  # Laid out; those in given axes are rendered.
    box, room = figure.get_tightbbox(), 0.02
    assert box.x0 > -room and box.y0 > -room
    assert box.x1 < figure.get_figwidth() + room
    assert box.y1 < figure.get_figheight() + room
    for legend in figure.legends:
        extent = legend.get_window_extent()
        for axes in figure.axes:
            inside = axes.get_window_extent()
            assert extent.y0 >= inside.y1 - 1.0 or extent.x0 >= inside.x1 - 1.0
    for axes in figure.axes:
        for axis, side in ((axes.xaxis, "x"), (axes.yaxis, "y")):
            assert_apart([text.get_window_extent() for text in axis.get_ticklabels()], side)

    labels = [axis.label for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)]
    boxes = [label.get_window_extent() for label in labels if label.get_text()]
    titles = [axes.title.get_window_extent() for axes in figure.axes if axes.get_title()]
    for k, box in enumerate([*boxes, *titles]):
        assert not any(box.overlaps(other) for other in [*boxes, *titles][:k])


def assert_apart(boxes: list[Any], side: str) -> None:
    """Texts of ticks do not run together."""
    shown = sorted(
        (box for box in boxes if box.width > 1.0), key=lambda box: getattr(box, f"{side}0")
    )
    for before, after in zip(shown, shown[1:], strict=False):
        assert not before.overlaps(after)


def assert_labels_have_units(ax: Axes) -> None:
    bare = {"Efficiency", "Designs", "Linear solve", "Relative residual", "Friction coefficient"}
    for axes in ax.figure.axes:
        for label in (axes.get_xlabel(), axes.get_ylabel()):
            has_unit = re.search(
                r"\((mm|µm|kN|%|N/µm|GPa|W|.*revolutions|kN/kg|mm/s|µm/kN|N|s|°C)\)", label
            )
            counts = label.startswith(("Thread", "Size by", "Factor over", "Cycles", "Envelope"))
            assert not label or has_unit or counts or label in bare, label


@pytest.mark.parametrize("name", PICTURES)
def test_a_new_figure_shows_all_its_text_and_units_and_no_legend_on_the_axes(name: str) -> None:
    before = dict(matplotlib.rcParams)
    ax = PICTURES[name](None)
    if not name.startswith("study"):
        assert_labels_have_units(ax)
    assert dict(matplotlib.rcParams) == before
    assert plt.get_fignums() == [ax.figure.number]  # type: ignore[union-attr]
    assert_complete(ax)


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
    if legend is not None and ax.get_aspect() == "auto":
        assert_uncovered(legend.get_window_extent(), ax)


#: Figures that were drawn, each once: in the quick run by their names, else as they are.
DRAWN: set[str] = set()


def assert_drawn(described: Description) -> None:
    thorough = os.environ.get("PRS_THOROUGH") == "1"
    this = json.dumps(described) if thorough else described["name"]
    if this in DRAWN:
        return
    DRAWN.add(this)
    ax = draw(described)
    assert len(ax.figure.axes) >= len(described["panels"])
    assert_complete(ax)
    plt.close("all")


@pytest.mark.parametrize("number", [1, 3, 5, 9, 12, 14, 17, 18, 21, 22])
def test_every_description_of_a_result_is_drawn(number: int) -> None:
    (file,) = CONFIGS.glob(f"{number:02d}_*.yaml")
    for command in commands(file):
        for described in result(number, command).figures():
            assert_drawn(described)


def test_functions_draw_what_methods_do() -> None:
    solved = result(1, "solve")
    assert sorted(plots.__all__) == sorted(set(plots.__all__))
    by_method, by_function = solved.plot_pressures([0]), plots.pressures(solved, [0])
    for one, other in zip(by_method.get_lines(), by_function.get_lines(), strict=True):
        np.testing.assert_array_equal(one.get_xydata(), other.get_xydata())


def test_options_choose_what_is_drawn() -> None:
    solved, swept = result(1, "solve"), result(3, "solve")
    names = [case.name for case in solved.load_cases]
    place = names.index("config2-compression")
    for which in (names[place], [names[place]], place, [place - len(names)]):
        drawn = solved.plot_load_distribution(which).get_lines()[0].get_ydata()
        np.testing.assert_allclose(drawn, solved.load_cases[place].screw.load_rate_percent)
    screw, nut = (swept.plot_butterfly(side).get_lines() for side in ("screw", "nut"))
    assert not np.array_equal(screw[0].get_ydata(), nut[0].get_ydata())
    studied = result(16, "study")
    ax = studied.plot_map("screw.peak_pressure_MPa.max", y="load_cases[0].position")
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("Axial force (kN)", "Position (mm)")
    bar = other_axes(ax)[0].get_ylabel().replace("\n", " ")
    assert bar == "Largest peak pressure, screw (GPa)"


def test_pictures_survive_in_json() -> None:
    solved = result(3, "solve")
    document = json.loads(solved.to_json())
    with pytest.raises(ValueError, match="read from JSON has no picture stiffness"):
        rs.SolveResult.from_json(json.dumps(document)).plot_stiffness()
    document["figures"] = solved.figures()
    read = rs.SolveResult.from_json(json.dumps(document))
    assert read.figures() == solved.figures()
    np.testing.assert_array_equal(
        read.plot_stiffness().get_lines()[0].get_xydata(),
        solved.plot_stiffness().get_lines()[0].get_xydata(),
    )


# What cannot be drawn.


REFUSED: dict[str, tuple[Callable[[], object], str]] = {
    "butterfly": (lambda: result(1, "solve").plot_butterfly(), "sweep"),
    "interface": (lambda: result(3, "solve").plot_butterfly("roller"), "interface: got 'roller'"),
    "no grid": (lambda: result(10, "study").plot_map(), "grid"),
    "no envelope": (lambda: result(16, "study").plot_envelope(), "envelope"),
    "no surface": (lambda: result(16, "study").plot_contributions(), "samples"),
    "picture": (lambda: result(3, "solve").plot_figure("cycles"), "there is load_distribution"),
    "one axis": (
        lambda: result(16, "study").plot_map(
            x="load_cases[0].position", y="load_cases[0].position"
        ),
        "two different factors",
    ),
    "companion": (
        lambda: result(21, "study").plot_map(x="mechanism.lead", y="mechanism.contacts_per_roller"),
        "no factor of numbers mechanism.contacts_per_roller",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_not_there_is_told(name: str) -> None:
    draw_it, word = REFUSED[name]
    with pytest.raises(ValueError, match=word):
        draw_it()
    assert plt.get_fignums() == []


@pytest.mark.parametrize(
    "draw_it",
    [
        lambda: result(10, "study").plot("slip.power"),
        lambda: result(16, "study").plot_map("slip.power"),
        lambda: result(15, "study").plot_histogram("slip.power"),
        lambda: result(15, "study").plot_contributions("slip.power"),
        lambda: result(17, "study").plot_elasticities("slip.power"),
    ],
)
def test_an_unknown_response_is_told_with_those_that_there_are(
    draw_it: Callable[[], object],
) -> None:
    with pytest.raises(ValueError, match=r"no response slip\.power; there is ") as told:
        draw_it()
    assert "_" in str(told.value).split("there is ")[1]


def test_an_unknown_factor_is_told() -> None:
    with pytest.raises(ValueError, match=r"no factor of numbers model\.roller"):
        result(16, "study").plot_map(x="model.roller")


def test_a_load_case_that_is_not_there_is_told() -> None:
    with pytest.raises(KeyError, match="no load case 'config9'"):
        result(1, "solve").plot_load_distribution(["config9"])
    with pytest.raises(IndexError):
        result(1, "solve").plot_ellipses(99)


# Designs of the user.


def test_designs_as_points() -> None:
    forces = np.linspace(5.0, 30.0, 7)
    force, stiffness = "load_cases[0].axial_force_kN", "axial_stiffness_N_per_um"
    inputs = {"load_cases[0].axial_force": (forces, "kN")}
    answers = lesson(5).evaluate(inputs, [stiffness])
    drawn = answers.plot(force, stiffness).get_lines()[0].get_xydata()
    np.testing.assert_array_equal(drawn, np.column_stack([forces, answers[stiffness]]))
    ax = answers.plot(force, stiffness, stiffness)
    np.testing.assert_array_equal(ax.collections[0].get_array(), answers[stiffness])
    assert ax.get_ylabel() == other_axes(ax)[0].get_ylabel() == "Axial stiffness (N/µm)"
    assert ax.get_xlabel() == "Axial force (kN)"
    with pytest.raises(KeyError, match="no column 'x'"):
        answers.plot("x", stiffness)


def test_counts_of_designs_have_whole_numbers_beside_them() -> None:
    rollers, stiffness = "mechanism.rollers", "axial_stiffness_N_per_um"
    answers = lesson(1).evaluate({rollers: [9, 10, 11]}, [stiffness])
    bar = other_axes(answers.plot(stiffness, stiffness, rollers))[0]
    assert [each.get_text() for each in bar.get_yticklabels()] == ["9", "10", "11"]
    ax = answers.plot(rollers, stiffness)
    assert all(tick == round(tick) for tick in ax.get_xticks())


# Several pictures in the same axes


def colours(ax: Axes) -> set[Any]:
    return {line.get_color() for line in ax.get_lines() if len(np.asarray(line.get_xdata())) > 2}


def test_pictures_in_the_same_axes_differ() -> None:
    eleven = answer(1, "solve", rs.SolveResult)
    nine = lesson(1).with_({"mechanism.rollers": 9}).solve()
    ax = plt.subplots()[1]
    eleven.plot_load_distribution(0, ax=ax, label="11 rollers")
    first = colours(ax)
    nine.plot_load_distribution(0, ax=ax, label="9 rollers")
    assert len(colours(ax) - first) == 1
    legend = ax.get_legend()
    assert legend is not None
    said = [text.get_text() for text in legend.get_texts()]
    assert {"11 rollers", "9 rollers"} <= set(said) and len(said) == len(set(said))


def test_results_are_compared() -> None:
    results = {"a": answer(1, "solve"), "b": answer(2, "solve")}
    ax = plots.compare(results, "load_distribution", load_cases=0)
    assert len(colours(ax)) == 2
    assert ax.get_legend() is None and ax.figure is not None
    (legend,) = ax.figure.legends
    assert {"a", "b"} <= {text.get_text() for text in legend.get_texts()}
    own = answer(1, "solve", rs.SolveResult).plot_load_distribution(0)
    assert ax.get_ylim()[1] < 1.5 * own.get_ylim()[1], "the legend stands outside"
    assert plots.compare(results, "peak_pressure").get_title() == ""
    with pytest.raises(TypeError, match=r"results\['a'\]: got <Case .*expected what a command"):
        plots.compare({"a": lesson(1)}, "load_distribution")
    with pytest.raises(ValueError, match="picture: got 'nope'; expected one of"):
        plots.compare(results, "nope")


def test_loads_and_stiffness_say_at_rest_or_running() -> None:
    case = rs.new("standard", screw_diameter="30 mm", lead="10 mm", speed="1500 rpm")
    solved, run = case.solve(), case.slip()
    assert (
        solved.load_cases[0].axial_stiffness_N_per_um != run.load_cases[0].axial_stiffness_N_per_um
    )
    for result, loads, words in ((solved, "static", "at rest"), (run, "running", "running")):
        assert words in repr(result) and words in repr(result.load_cases[0])
        assert words in result._repr_html_() and words in result.load_cases[0]._repr_html_()
        assert set(result.load_cases_frame()["loads"]) == {loads}
        assert set(result.threads_frame()["loads"]) == {loads}
        ax = result.plot_load_distribution()
        figure: Any = ax.figure
        assert figure.legends[0].get_title().get_text().replace("\n", " ").endswith(words)
    stiffness = case.responses("slip").set_index("path").loc["axial_stiffness_N_per_um"]
    assert stiffness["loads"] == "running"
    assert set(run.slip_frame()["loads"]) == {"running"}


@pytest.mark.parametrize("width", [85.0, 180.0])
@pytest.mark.parametrize(
    "name", ["load_distribution", "peak_pressure", "contact_xy", "convergence"]
)
def test_a_figure_has_the_width_of_a_column(name: str, width: float) -> None:
    ax = answer(1, "solve", rs.SolveResult).plot_figure(name, width=width)
    figure: Any = ax.figure
    assert figure.get_figwidth() * 25.4 == pytest.approx(width)
    assert_complete(ax)


def test_panels_with_axes_of_their_own_stand_below_each_other_in_a_column() -> None:
    def columns(described: Description, width: float) -> int:
        figure: Any = draw(described, width=width).figure
        figure.canvas.draw()
        return len({round(axes.get_window_extent().x0) for axes in figure.axes})

    shared = several(2, columns=2)
    own = several(2, columns=2)
    for panel in own["panels"]:
        panel["y"] = {"label": "Pressure", "unit": "GPa"}
    assert (columns(shared, 85.0), columns(own, 85.0), columns(own, 180.0)) == (2, 1, 2)
    assert columns(shared, 60.0) == 1


def test_a_width_is_that_of_a_new_figure() -> None:
    results = {"a": answer(1, "solve", rs.SolveResult), "b": answer(2, "solve", rs.SolveResult)}
    compared = plots.compare(results, "load_distribution", width=85.0, load_cases=[0, 1, 2])
    assert compared.figure.get_figwidth() * 25.4 == pytest.approx(85.0)  # type: ignore[union-attr]
    assert_complete(compared)
    with pytest.raises(ValueError, match="width: got it with `ax`"):
        draw(shares(), plt.subplots()[1], width=85.0)
    with pytest.raises(ValueError, match="width: got 8.5; expected 40 to 500, in mm"):
        draw(shares(), width=8.5)


def test_the_last_point_of_a_long_line_has_a_mark() -> None:
    for count in (41, 50, 100, 997):
        parts = [[[k, 1.0] for k in range(count)]]
        ax = draw(
            one_panel({"series": [{"style": 0, "parts": parts}]}, styles=[{"mark": "circle"}])
        )
        marked: Any = ax.get_lines()[0].get_markevery()
        assert marked[0] == 0 and marked[-1] == count - 1 and 12 <= len(marked) <= 15


def test_a_colour_may_be_given() -> None:
    ax = answer(1, "solve", rs.SolveResult).plot_load_distribution(0, color="red", label="mine")
    assert {matplotlib.colors.to_hex(each) for each in colours(ax)} == {"#ff0000"}


def test_notebooks_show_the_picture_alone() -> None:
    shown: Any = answer(1, "solve", rs.SolveResult).plot_load_distribution()
    assert shown._ipython_display_() is None


def test_a_legend_of_ones_own_keeps_the_label() -> None:
    import matplotlib.pyplot as plt

    _, ax = plt.subplots()
    answer(1, "solve", rs.SolveResult).plot_load_distribution(0, ax=ax, label="OD 64")
    ax.plot([1.0], [5.0], "k+", label="FE")
    texts = [text.get_text() for text in ax.legend().get_texts()]
    assert any(text.startswith("OD 64") for text in texts) and "FE" in texts
    assert {"Roller-screw, tension", "Roller-nut, tension"} <= set(texts)
    assert len(texts) == len(set(texts))


def test_numbers_of_ellipses_do_not_run_together_in_one_column() -> None:
    ax = answer(1, "solve", rs.SolveResult).plot_ellipses(0, width=85)
    figure: Any = ax.figure
    figure.draw_without_rendering()
    numbers = [text for text in ax.texts if text.get_text().isdigit()]
    assert {text.get_text() for text in numbers} >= {"1", "10", "20"}
    boxes = [text.get_window_extent() for text in numbers]
    assert not any(a.overlaps(b) for k, a in enumerate(boxes) for b in boxes[:k])
    assert ax.get_window_extent().width > 0.6 * figure.bbox.width
    low, high = ax.get_xlim()
    assert high - low < 1.3 * (max(t.get_position()[0] for t in numbers) - 0.0)


def test_a_legend_of_ones_own_says_which_line_is_of_which_interface() -> None:
    _, ax = plt.subplots()
    answer(1, "solve", rs.SolveResult).plot_load_distribution(0, ax=ax)
    drawn = [text.get_text() for text in ax.get_legend().get_texts()]
    ax.plot([1.0], [5.0], "k+", label="FE")
    own = [text.get_text() for text in ax.legend().get_texts()]
    assert set(own) == {*drawn, "FE"}
    assert any("nut" in text for text in own)


def test_axes_that_are_given_make_room_once() -> None:
    _, ax = plt.subplots()
    result = answer(1, "solve", rs.SolveResult)
    result.plot_pressures(0, ax=ax, label="one")
    first = ax.get_ylim()[1]
    for name in ("two", "three", "four"):
        result.plot_pressures(0, ax=ax, label=name)
    assert ax.get_ylim()[1] < 2.0 * first
    limit = [line for line in ax.lines if list(line.get_ydata()) == [4.0, 4.0]]
    assert len({matplotlib.colors.to_hex(line.get_color()) for line in limit}) == 1
