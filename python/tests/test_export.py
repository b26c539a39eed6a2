"""Models of the screw for other programs, read back by programs of others."""

from __future__ import annotations

import ctypes
import math
import os
import re
import shutil
import subprocess
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import rollerscrew as rs
from conftest import Run, lesson
from numpy.typing import NDArray

LARGEST = 20e3  #: Force of the exported curves [N].

#: Shares of the largest force: tension and compression, none of them a node.
SHARES = [sign * share for share in (0.0131, 0.071, 0.23, 0.52, 0.87) for sign in (1, -1)]


@pytest.fixture(scope="module")
def case() -> rs.Case:
    """Coulomb's friction: its torque is computed in a moment."""
    return lesson(9).with_({"friction": {"model": {"coulomb": 0.08}}})


@pytest.fixture(scope="module")
def unit(case: rs.Case, tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("unit") / "screw.fmu"
    case.export_fmu(file, force=LARGEST)
    return file


def at_force(case: rs.Case, force: float, speed: float) -> rs.Case:
    return case.with_(
        {
            "load_cases[0].axial_force": f"{abs(force)!r} N",
            "load_cases[0].direction": "tension" if force > 0 else "compression",
            "operation.speed": f"{speed!r} rad/s",
        }
    )


Simulated = dict[str, NDArray[np.float64]]


def simulated(
    unit: Path, deflection: list[float], speed: list[float]
) -> tuple[Simulated, list[str]]:
    """Outputs at each pair of inputs, which hold for one step, and what the unit says."""
    fmpy = pytest.importorskip("fmpy")
    said: list[str] = []
    times = np.arange(len(deflection) + 1, dtype=float)
    columns = [times, [*deflection, deflection[-1]], [*speed, speed[-1]]]
    names = [("time", float), ("deflection", float), ("speed", float)]
    inputs = np.array(list(zip(*columns)), dtype=names)

    def listen(_env: Any, _name: Any, _status: Any, _category: Any, message: bytes) -> None:
        said.append(message.decode())

    result = fmpy.simulate_fmu(
        str(unit),
        input=inputs,
        stop_time=times[-1],
        output_interval=1.0,
        fmi_type="CoSimulation",
        logger=listen,
    )
    return {name: result[name][1:] for name in result.dtype.names}, said


def test_unit_is_valid(unit: Path) -> None:
    pytest.importorskip("fmpy")
    from fmpy import read_model_description
    from fmpy.validation import validate_fmu

    assert validate_fmu(str(unit)) == []
    description = read_model_description(str(unit), validate=True)
    units = {v.name: (v.causality, v.unit) for v in description.modelVariables}
    assert units == {
        "deflection": ("input", "m"),
        "speed": ("input", "rad/s"),
        "force": ("output", "N"),
        "stiffness": ("output", "N/m"),
        "torque": ("output", "N.m"),
    }


def test_unit_gives_the_numbers_of_solve_and_slip(case: rs.Case, unit: Path) -> None:
    forces = [share * LARGEST for share in SHARES]
    speeds = [(-1) ** (k // 2) * 3.0 for k in range(len(forces))]
    cases = [at_force(case, f, s) for f, s in zip(forces, speeds)]
    answers = [case.solve().load_cases[0] for case in cases]  # Forces are those at rest.
    signs = np.sign(forces)
    deflection = signs * [1e-6 * answer.axial_displacement_um for answer in answers]
    stiffness = [1e6 * answer["tangent_stiffness_N_per_um"] for answer in answers]
    torque = [case.slip().load_cases[0]["slip"].torque_screw_Nm for case in cases]
    result, said = simulated(unit, list(deflection), speeds)
    assert said == []
    np.testing.assert_allclose(result["force"], forces, rtol=0, atol=1e-6 * LARGEST)
    np.testing.assert_allclose(result["stiffness"], stiffness, rtol=0, atol=1e-4 * max(stiffness))
    np.testing.assert_allclose(result["torque"], torque, rtol=0, atol=3e-4 * np.max(np.abs(torque)))


def test_unit_says_where_it_goes_beyond_its_range(unit: Path) -> None:
    result, said = simulated(unit, [1e-3, 1.1e-3, 1.2e-3], [1.0, 1.0, 1.0])
    assert ["straight line" in text for text in said] == [True, False]  # Told once each.
    assert np.diff(result["force"], 2)[0] == pytest.approx(0.0, abs=1e-6)
    assert result["stiffness"][0] == result["stiffness"][2]


def test_unit_refuses_what_is_no_number(unit: Path) -> None:
    with pytest.raises(Exception, match="fmi2SetReal"):
        simulated(unit, [math.nan], [0.0])


@pytest.mark.parametrize("with_drive", [False, True])
def test_unit_refuses_steps_that_do_not_go_on(unit: Path, tmp_path: Path, with_drive: bool) -> None:
    fmpy = pytest.importorskip("fmpy")
    from fmpy.logging import addLoggerProxy

    said: list[str] = []

    def listen(_env: Any, _name: Any, _status: Any, _category: Any, message: bytes) -> None:
        said.append(message.decode())

    # Of its own: those of fmpy by default call the listener of the last simulation, which is gone.
    callbacks = fmpy.fmi2.fmi2CallbackFunctions()
    callbacks.logger = fmpy.fmi2.fmi2CallbackLoggerTYPE(listen)
    callbacks.allocateMemory = fmpy.fmi2.fmi2CallbackAllocateMemoryTYPE(fmpy.fmi2.calloc)
    callbacks.freeMemory = fmpy.fmi2.fmi2CallbackFreeMemoryTYPE(fmpy.fmi2.free)
    addLoggerProxy(ctypes.byref(callbacks))
    file = str(drive_unit(tmp_path) if with_drive else unit)
    description = fmpy.read_model_description(file)
    slave: Any = fmpy.fmi2.FMU2Slave(
        guid=description.guid,
        unzipDirectory=fmpy.extract(file, str(tmp_path / "unit")),
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="unit",
    )
    slave.instantiate(callbacks=callbacks)
    slave.setupExperiment(startTime=0.0)
    slave.enterInitializationMode()
    slave.exitInitializationMode()
    for time, step in ((0.0, -1e-3), (0.0, math.nan), (0.0, math.inf), (math.nan, 1e-3)):
        with pytest.raises(Exception, match="fmi2DoStep.*error"):
            slave.doStep(time, step)
        assert "expected a finite time and a step >= 0 s" in said.pop()
    slave.doStep(0.0, 1e-3)
    slave.terminate()
    slave.freeInstance()


def test_same_case_same_bytes(case: rs.Case, unit: Path, tmp_path: Path) -> None:
    case.export_fmu(tmp_path / "screw.fmu", force=LARGEST)
    assert (tmp_path / "screw.fmu").read_bytes() == unit.read_bytes()


def test_unit_has_its_sources(unit: Path, tmp_path: Path, compiler: Callable[..., None]) -> None:
    """The shared library compiled from them answers as the one that is shipped."""
    with zipfile.ZipFile(unit) as archive:
        archive.extractall(tmp_path / "unit")
    sources = tmp_path / "unit" / "sources"
    library = tmp_path / "unit" / "binaries" / "linux64" / "screw.so"
    library.unlink()
    compiler("-shared", "-fPIC", *sorted(sources.glob("*.c")), "-o", library, "-lm")
    again = tmp_path / "again.fmu"
    with zipfile.ZipFile(again, "w") as archive:
        for file in (tmp_path / "unit").rglob("*"):
            archive.write(file, file.relative_to(tmp_path / "unit"))
    inputs = [-1e-5, 3e-6, 1.7e-5], [1.0, -2.0, 3.0]
    shipped, _ = simulated(unit, *inputs)
    compiled, _ = simulated(again, *inputs)
    for name in ("force", "stiffness", "torque"):
        np.testing.assert_allclose(compiled[name], shipped[name], rtol=1e-13)


#: Compilers for Windows, and wine, which runs its programs.
FOR_WINDOWS = ("x86_64-w64-mingw32-gcc-win32", "x86_64-w64-mingw32-gcc")
WINE = ("wine64", "/usr/lib/wine/wine64", "wine")


def tool(names: tuple[str, ...]) -> str:
    found = next(filter(None, map(shutil.which, names)), None)
    if found is None:
        pytest.skip(f"no {names[-1]}")
    return found


def drive_unit(folder: Path) -> Path:
    lesson(36).export_fmu(folder / "servo.fmu")
    return folder / "servo.fmu"


def test_units_have_a_library_for_windows(unit: Path, tmp_path: Path) -> None:
    """Of both kinds, with the screw alone and with its drive, by FMPy and by the file's head."""
    fmpy = pytest.importorskip("fmpy")
    tool(FOR_WINDOWS)
    for file in (unit, drive_unit(tmp_path)):
        assert {"win64", "linux64"} <= set(fmpy.supported_platforms(str(file)))
        with zipfile.ZipFile(file) as archive:
            (name,) = [name for name in archive.namelist() if name.endswith(".dll")]
            library = archive.read(name)
        head = int.from_bytes(library[0x3C:0x40], "little")
        assert library[:2] == b"MZ" and library[head : head + 4] == b"PE\0\0"
        assert library[head + 4 : head + 6] == b"\x64\x86"  # x86-64
        with zipfile.ZipFile(file) as archive:
            source = archive.read("sources/unit.c").decode()
        found = re.findall(r"\bFMI2\(\w+, (fmi2\w+)\)|NO_STATUS\((fmi2\w+)", source)
        functions = {full or without for full, without in found}
        assert len(functions) > 25
        assert all(b"\0" + name.encode() + b"\0" in library for name in functions)


@pytest.mark.parametrize("with_drive", [False, True])
def test_library_for_windows_gives_the_same(unit: Path, tmp_path: Path, with_drive: bool) -> None:
    """By a host for Windows under wine, in a folder whose name no code page has."""
    fmpy = pytest.importorskip("fmpy")
    compiler, wine = tool(FOR_WINDOWS), tool(WINE)
    file = drive_unit(tmp_path) if with_drive else unit
    folder = tmp_path / "Größe 大"
    with zipfile.ZipFile(file) as archive:
        archive.extractall(folder)
    (library,) = folder.glob("binaries/win64/*.dll")
    library = library.rename(tmp_path / "unit.dll")
    host = tmp_path / "host.exe"
    source = Path(__file__).with_name("fmi_host.c")
    subprocess.run(
        [compiler, "-std=c99", "-Wall", "-Werror", f"-I{folder / 'sources'}", source, "-o", host],
        check=True,
    )
    description = fmpy.read_model_description(str(file))
    variables = description.modelVariables
    inputs = [v for v in variables if v.causality == "input"]
    outputs = [v for v in variables if v.causality == "output"]
    step, count = 1e-3, 40
    largest = {
        "deflection": 20e-6,
        "speed": 3.0,
        "reference": 1.6e-3,
        "reference_speed": 0.0,
        "external_force": 1500.0,
    }
    rows = [[largest[v.name] * math.sin(0.1 * (k + 1)) for v in inputs] for k in range(count)]
    prefix = {"WINEPREFIX": str(tmp_path / "wine"), "WINEDEBUG": "-all"}
    uri = "file:///Z:" + (folder / "resources").as_uri().removeprefix("file://")
    references = [",".join(str(v.valueReference) for v in some) for some in (inputs, outputs)]
    run = subprocess.run(
        [wine, host, library, description.guid, uri, f"{step!r}", *references],
        input="\n".join(" ".join(f"{value!r}" for value in row) for row in rows),
        env=os.environ | prefix,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    found = np.array([line.split() for line in run.stdout.splitlines()], dtype=float)
    slave: Any = fmpy.fmi2.FMU2Slave(
        guid=description.guid,
        unzipDirectory=fmpy.extract(str(file), str(tmp_path / "here")),
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="here",
    )
    slave.instantiate()
    slave.setupExperiment(startTime=0.0)
    slave.enterInitializationMode()
    expected = []
    for k, row in enumerate(rows):
        slave.setReal([v.valueReference for v in inputs], row)
        if k == 0:
            slave.exitInitializationMode()
        slave.doStep(k * step, step)
        expected.append(slave.getReal([v.valueReference for v in outputs]))
    slave.terminate()
    slave.freeInstance()
    size = np.max(np.abs(expected), axis=0)
    assert found.shape == (count, len(outputs))
    np.testing.assert_allclose(found / size, expected / size, rtol=0, atol=1e-9)


@pytest.fixture
def compiler() -> Callable[..., None]:
    path = shutil.which("cc")
    if path is None:
        pytest.skip("no C compiler")

    def run(*arguments: object) -> None:
        subprocess.run([path, *map(str, arguments)], check=True)

    return run


def test_program_writes_the_same_unit(
    case: rs.Case, program: Run, tmp_path: Path, configs: Path
) -> None:
    file = configs / "09_slip_and_dissipation.yaml"
    options = ("--set", "friction={model: {coulomb: 0.08}}", "--output", tmp_path / "screw.fmu")
    run = program("export", file, "--fmu", "--force", f"{LARGEST} N", *options)
    assert run.returncode == 0, run.stderr
    assert zipfile.is_zipfile(tmp_path / "screw.fmu")


def test_modelica_is_parsed(case: rs.Case, tmp_path: Path) -> None:
    pymoca = pytest.importorskip("pymoca.parser")
    case.export_modelica(tmp_path / "screw.mo", force=LARGEST)
    tree = pymoca.parse((tmp_path / "screw.mo").read_text())
    assert {"Data", "Curves", "Screw"} <= set(tree.classes["screw"].classes)


def test_static_unit_beside_a_robot_is_the_static_unit(
    program: Run, tmp_path: Path, configs: Path
) -> None:
    file = configs / "36_servo_axis.yaml"
    for folder, forms in (("alone", ["--fmu"]), ("both", ["--fmu", "--mjcf"])):
        run = program("export", file, *forms, "--static", "--output", tmp_path / folder)
        assert run.returncode == 0, run.stderr
    (alone,) = (tmp_path / "alone").glob("*.fmu")
    assert alone.read_bytes() == (tmp_path / "both" / alone.name).read_bytes()


def test_wrong_arguments(case: rs.Case, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"expected a name that ends in \.fmu"):
        case.export_fmu(tmp_path / "screw.zip")
    with pytest.raises(ValueError, match="force: got nan; expected a finite number > 0"):
        case.export_fmu(tmp_path / "screw.fmu", force=math.nan)
    with pytest.raises(rs.InputError, match="there is none called `sideways`"):
        case.export_modelica(tmp_path / "screw.mo", load_case="sideways")
    assert list(tmp_path.iterdir()) == []


def test_bodies_without_a_modeller(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    import sys

    monkeypatch.setitem(sys.modules, "build123d", None)
    with pytest.raises(ImportError, match=r"pip install 'rollerscrew\[cad\]'"):
        rs.export_step(lesson(5), tmp_path / "screw.step")


@pytest.mark.parametrize("number", [pytest.param(1, marks=pytest.mark.thorough), 5])
def test_bodies_are_closed_and_have_the_volume_of_their_sections(
    number: int, tmp_path: Path
) -> None:
    """Area of the section times length, by the profile alone (Pappus), in what was read back."""
    b = pytest.importorskip("build123d")
    from rollerscrew import cad

    case = lesson(number)
    file = tmp_path / "screw.step"
    rs.export_step(case, file)
    solids = b.import_step(str(file)).solids()
    check = case.check().resolved_input
    count = int(check["mechanism"]["rollers"])
    assert len(solids) == 2 + count
    assert all(solid.is_valid for solid in solids)

    def mm(text: str) -> float:
        return float(text.removesuffix(" mm"))

    def cylinder(diameter: float, length: float) -> float:
        return math.pi / 4 * diameter**2 * length

    of = cad.threads(case)
    structure = check["structure"]
    nut, ends = structure["nut"], structure["roller"]
    length, outer = mm(nut["length"]), mm(nut["outer_diameter"])
    threaded = int(check["mechanism"]["contacts_per_roller"]) * abs(of["roller"].lead)
    threaded /= of["roller"].starts
    wall = cylinder(outer, length) - of["nut"].area * length
    for flange in nut.get("flanges", []):
        width = mm(flange["to"]) - mm(flange["from"])
        wall += cylinder(mm(flange["outer_diameter"]), width) - cylinder(outer, width)
    expected = [
        of["screw"].area * length - cylinder(mm(structure["screw"]["bore"]), length),
        wall,
        *[
            of["roller"].area * threaded
            + 2 * cylinder(mm(ends["end_diameter"]), mm(ends["end_length"]))
        ]
        * count,
    ]
    np.testing.assert_allclose([solid.volume for solid in solids], expected, rtol=2e-4)
    box = solids[0].bounding_box()
    np.testing.assert_allclose(box.size.Z, length, rtol=1e-6)
    np.testing.assert_allclose(box.size.X, 2 * of["screw"].radius[-1], rtol=1e-4)
    # Rollers stand on the circle of the centre distance, but for the half turns of their threads.
    distance = mm(str(check["mechanism"]["centre_distance"]))
    centres = [math.hypot(*list(solid.center())[:2]) for solid in solids[2:]]
    assert centres == pytest.approx([distance] * count, abs=0.05)


def test_results_write_the_report_of_their_case(tmp_path: Path) -> None:
    case, solved = lesson(5), lesson(5).solve()
    assert solved.report(tmp_path / "result.html")
    assert case.report(tmp_path / "case.html")
    read = rs.SolveResult.from_json(solved.to_json())
    assert read.report(tmp_path / "read.html")
    pages = [(tmp_path / f"{name}.html").read_text() for name in ("result", "case", "read")]
    stiffness = f"{solved.load_cases[0].axial_stiffness_N_per_um:.1f}"
    assert all(stiffness in page for page in pages)


def test_what_cannot_be_written_is_an_error_of_the_system(case: rs.Case, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="cannot write"):
        case.export_fmu(tmp_path / "no folder" / "screw.fmu", force=LARGEST)
    (tmp_path / "folder.mo").mkdir()
    with pytest.raises(OSError, match="cannot write"):
        case.export_modelica(tmp_path / "folder.mo", force=LARGEST)


def test_wrong_options_name_the_argument(case: rs.Case, tmp_path: Path) -> None:
    force: Any = "5 kN"
    with pytest.raises(ValueError, match="force: got '5 kN'; expected a finite number > 0"):
        case.export_fmu(tmp_path / "screw.fmu", force=force)
    load_case: Any = 5
    with pytest.raises(TypeError, match="load_case: got 5; expected a text"):
        case.export_fmu(tmp_path / "screw.fmu", load_case=load_case)
