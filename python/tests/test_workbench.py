"""The page of `prs workbench` in a real browser, opened as a file."""

from __future__ import annotations

import json
import random
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from conftest import CONFIGS, REPOSITORY, Run

pytest.importorskip("selenium.webdriver")

from test_page import Browser  # noqa: E402

#: One roller with its share, all rollers.
QUICK = {5, 24}

AXE = REPOSITORY / "web" / "node_modules" / "axe-core" / "axe.min.js"


def files() -> list[Any]:
    return [
        pytest.param(
            file,
            id=file.stem[:2],
            marks=[] if int(file.stem[:2]) in QUICK else [pytest.mark.thorough],
        )
        for file in sorted(CONFIGS.glob("[0-9]*.yaml"))
    ]


class Workbench(Browser):
    """The page with its functions, `prs`."""

    def js(self, code: str, *arguments: Any) -> Any:
        """What an asynchronous function answers; its arguments are `args`."""
        answer = self.driver.execute_async_script(
            "const done = arguments[arguments.length - 1], args = arguments;"
            f"(async () => {{ {code} }})()"
            ".then((value) => done({ value }), (error) => done({ error: String(error) }));",
            *arguments,
        )
        assert "error" not in answer, answer["error"]
        return answer["value"]

    def open_case(self, text: str) -> dict[str, Any]:
        answer: dict[str, Any] = self.js("return await prs.open(args[0])", text)
        return answer

    def set(self, path: str, text: str) -> dict[str, Any]:
        answer: dict[str, Any] = self.js("return await prs.set(args[0], args[1])", path, text)
        return answer

    def yaml(self) -> str:
        return str(self.driver.execute_script("return prs.yaml()"))

    def paths(self) -> set[str]:
        fields = self.driver.execute_script(
            "return [...document.querySelectorAll('[data-path]')].map((f) => f.dataset.path)"
        )
        return set(fields)

    def headlines(self) -> dict[str, str]:
        found: dict[str, str] = self.driver.execute_script(
            "return Object.fromEntries([...document.querySelectorAll('[data-quantity]')]"
            ".map((tile) => [tile.dataset.quantity, tile.textContent]))"
        )
        return found


@pytest.fixture(scope="module")
def page(program: Run, tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("workbench") / "workbench.html"
    run = program("workbench", "--quiet", "--output", file)
    if "the engine of live pages" in run.stderr:
        pytest.skip(run.stderr)
    assert run.returncode == 0, run.stderr
    assert file.stat().st_size <= 4_500_000
    return file


@pytest.fixture(scope="module")
def browser(page: Path) -> Iterator[Workbench]:
    if not shutil.which("chromedriver"):
        pytest.skip("no browser: install chromium-driver")
    browser = Workbench()
    browser.open(page)
    browser.wait("globalThis.prs !== undefined")
    yield browser
    complaints = browser.complaints()
    requests = [url for url in browser.requests() if not url.startswith(("blob:", "data:"))]
    browser.driver.quit()
    assert complaints == []
    assert requests == []


def opened(browser: Workbench, *paths: Path) -> None:
    """By the dialog of the page, until all is computed."""
    dialog = browser.find("#open-file")
    browser.changed(lambda: dialog.send_keys("\n".join(str(path) for path in paths)))


@pytest.mark.parametrize("file", files())
def test_the_dialog_asks_for_no_file_that_is_there(file: Path, browser: Workbench) -> None:
    opened(browser, file)
    assert browser.yaml() == file.read_text(encoding="utf-8")
    assert browser.driver.find_elements("css selector", ".note") == []
    assert browser.driver.find_elements("css selector", "#view > .trouble") == []


def test_a_reference_that_is_not_there_is_asked_for(browser: Workbench, tmp_path: Path) -> None:
    case, curve = tmp_path / "case.yaml", tmp_path / "my curve.csv"
    block = 'references: [{file: "curves/my curve.csv", tolerance: 30 % of the mean}]'
    case.write_text(f"{LESSON}\n{block}\n", encoding="utf-8")
    curve.write_text("load_case,axial_displacement_um\ntension,1000\n", encoding="utf-8")
    opened(browser, case)
    assert "The case names curves/my curve.csv: open that file too." in browser.text(".note")

    def judged() -> str:
        (row,) = (
            row.text
            for row in browser.driver.find_elements("css selector", ".verdict tbody tr")
            if "Deviation over tolerance" in row.text
        )
        return row

    assert "not computed" in judged()
    dialog = browser.find("#missing-file")
    browser.changed(lambda: dialog.send_keys(str(curve)))
    assert browser.driver.find_elements("css selector", ".note") == []
    assert "missed" in judged() and "source." not in judged()
    summary = browser.find("#section-references summary")
    browser.driver.execute_script("arguments[0].click()", summary)
    browser.wait("document.querySelector('#section-references table') !== null")
    assert "my curve" in browser.text("#section-references")
    browser.driver.execute_script("arguments[0].click()", summary)


#: What a page says that is computed: not what stands in grey until the text can be read again.
SHOWN = """
const view = document.getElementById('view').cloneNode(true);
for (const stale of view.querySelectorAll('.stale, .mechanism-place')) stale.remove();
const wrong = [...document.querySelectorAll('[aria-invalid]')].map((field) => field.dataset.path);
const states = [...view.querySelectorAll('.state')].map((state) => state.className);
const said = [...document.querySelectorAll('.note, .variants .status')].map((n) => n.textContent);
return [view.textContent, states, wrong, said];
"""


def test_any_walk_of_edits_shows_what_a_fresh_page_shows(browser: Workbench, page: Path) -> None:
    chance = random.Random(38)
    edits = [
        ("structure.nut.outer_diameter", ("66 mm", "70 mm", "90 kg", "20 mm")),
        ("mechanism.rollers", ("10", "9", "900", "many")),
        ("load_cases[0].axial_force", ("20 kN", "30 kN", "-5 kN")),
        ("operation.speed", ("200 rpm", "fast")),
        ("materials.youngs_modulus", ("[", "209 GPa", "{a: 1}")),
    ]
    browser.open_case(LESSON)
    browser.find(".pane-of-yaml").click()
    seen = {}
    for _ in range(24):
        act = chance.choice(("set", "set", "set", "undo", "redo", "broken"))
        if act == "set":
            path, values = chance.choice(edits)
            browser.set(path, chance.choice(values))
        elif act == "broken":
            editor = browser.driver.execute_script(
                "return document.querySelector('.editor-place').shadowRoot"
                ".querySelector('.cm-content')"
            )
            browser.driver.execute_script("arguments[0].focus()", editor)
            editor.send_keys(chance.choice(("{", "a: ", "\n- ", "# ")))
        else:
            browser.driver.execute_script(f"prs.{act}()")
        browser.wait("document.querySelector('.variants .status button') === null")
        seen[browser.yaml()] = browser.driver.execute_script(SHOWN)
    browser.find(".pane-of-form").click()
    assert len(seen) > 8
    assert len({str(shown) for shown in seen.values()}) > 5
    for text, shown in seen.items():
        browser.open(page)
        browser.wait("globalThis.prs !== undefined")
        browser.open_case(text)
        browser.wait("document.querySelector('.variants .status button') === null")
        assert browser.driver.execute_script(SHOWN) == shown, text


def stated(program: Run, file: Path) -> list[dict[str, Any]]:
    inputs = json.loads(program("check", file, "--json").stdout)["input"]
    return [entry for entry in inputs if not entry.get("default", "written" not in entry)]


@pytest.mark.parametrize("file", files())
def test_opens_sets_and_goes_back(file: Path, browser: Workbench, program: Run) -> None:
    text = file.read_text(encoding="utf-8")
    assert browser.open_case(text)["status"] in (0, 3)
    assert browser.yaml() == text
    inputs = stated(program, file)
    assert {entry["path"] for entry in inputs} - browser.paths() == set()
    entry = next(e for e in inputs if e["value"].split()[-1] in ("mm", "s", "kN"))
    number, unit = entry["value"].split()
    value = f"{float(number) * 1.01:.6g} {unit}"
    browser.set(entry["path"], value)
    changed = browser.yaml()
    before, after = text.split("\n"), changed.split("\n")
    assert len(before) == len(after)
    (line,) = (k for k in range(len(before)) if before[k] != after[k])
    assert after[line] == before[line].replace(entry.get("written", entry["value"]), value, 1)
    assert browser.driver.execute_script("return prs.undo()")
    assert browser.yaml() == text
    assert browser.driver.execute_script("return prs.redo()")
    assert browser.yaml() == changed


#: What rounding leaves, and what only the program has.
LEFT_OVER = ("residual", "residue", "interpolation_error", "axial_error_um", "factorization")


def differences(live: Any, native: Any, path: str = "", largest: float = 0.0) -> Iterator[str]:
    """Numbers beyond 1e-10, of a list of its largest; depths of flat maxima beyond 1e-6."""
    if path.endswith(LEFT_OVER):
        return
    if isinstance(native, dict):
        if live.keys() != native.keys():
            yield f"{path}: {live.keys() ^ native.keys()}"
        for key in live.keys() & native.keys():
            yield from differences(live[key], native[key], f"{path}.{key}")
    elif isinstance(native, list):
        if len(live) != len(native):
            yield f"{path}: {len(live)}, {len(native)}"
        largest = max((abs(x) for x in native if isinstance(x, float)), default=0.0)
        if "reactions" in path or "friction_force" in path:  # Zeros: rounding of kilonewtons.
            largest = max(largest, 1e3)
        for k, (a, b) in enumerate(zip(live, native)):
            yield from differences(a, b, f"{path}[{k}]", largest)
    elif isinstance(native, float):
        share = 1e-6 if "depth" in path else 1e-10
        if abs(live - native) > share * max(abs(native), largest):
            yield f"{path}: {live}, {native}"
    elif live != native:
        yield f"{path}: {live}, {native}"


def of_results(document: dict[str, Any]) -> dict[str, Any]:
    head = {"case_file", "input_sha256", "resolved_input"}
    return {key: value for key, value in document.items() if key not in head}


@pytest.mark.parametrize("file", files())
def test_every_command_says_what_the_program_says(
    file: Path, browser: Workbench, program: Run
) -> None:
    browser.open_case(file.read_text(encoding="utf-8"))
    check = browser.js("return (await prs.ask({ command: 'check' })).document")
    commands = [name for name, state in check["commands"].items() if state["ready"]]
    compared = 0
    for command in commands:
        if command in ("study", "optimize", "compare"):
            continue
        run = program(command, file, "--json")
        live = browser.js("return await prs.ask({ command: args[0] })", command)
        assert live["status"] == run.returncode
        native = json.loads(run.stdout)
        found = list(differences(of_results(live["document"]), of_results(native)))
        assert found == [], command
        compared += 1
    assert compared > 0


LESSON = (CONFIGS / "05_standard_screw.yaml").read_text(encoding="utf-8")
STIFFNESS = "axial_stiffness_N_per_um"


def test_four_variants_side_by_side(browser: Workbench) -> None:
    browser.open_case(LESSON)
    for name, rollers in (("nine", "9"), ("eight", "8"), ("seven", "7")):
        browser.js("return await prs.addVariant(args[0])", name)
        browser.set("mechanism.rollers", rollers)
    variants = browser.js("return prs.variants()")
    assert [variant["name"] for variant in variants] == ["case", "nine", "eight", "seven"]
    assert variants[0]["yaml"] == LESSON
    with pytest.raises(AssertionError, match="at most 4"):
        browser.js("return await prs.addVariant('five')")
    browser.find("#tab-compare").click()
    browser.wait("document.querySelectorAll('.compare tbody tr:first-child .change').length === 3")
    browser.wait("document.querySelectorAll('.charts .chart polyline').length >= 16")
    changes = browser.driver.find_elements("css selector", ".compare tr:first-child .change")
    shown = [float(change.text.split()[0].replace("−", "-")) for change in changes]
    numbers = [
        browser.js(
            "return (await prs.ask({ command: 'solve', set: [['mechanism.rollers', args[0]]] }))"
            ".document.load_cases[0].axial_stiffness_N_per_um",
            rollers,
        )
        for rollers in ("10", "9", "8", "7")
    ]
    assert shown == pytest.approx([100 * (x / numbers[0] - 1) for x in numbers[1:]], abs=0.05)
    browser.find("#tab-results").click()


def test_a_study_is_that_of_the_program(browser: Workbench, program: Run, tmp_path: Path) -> None:
    study = """
study:
  command: solve
  factors: [{path: "load_cases[0].axial_force", values: {from: 10 kN, to: 60 kN, steps: 4}}]
  responses: [axial_stiffness_N_per_um, screw.peak_pressure_MPa.max]
"""
    case = tmp_path / "study.yaml"
    case.write_text(LESSON + study, encoding="utf-8")
    designs = json.loads(program("study", case, "--json", "--quiet").stdout)["designs"][1:]
    browser.open_case(LESSON)
    for response in (STIFFNESS, "screw.peak_pressure_MPa.max"):
        found = browser.js(
            "return await prs.study({ path: 'load_cases[0].axial_force', from: '10 kN',"
            " to: '60 kN', steps: 4 }, args[0])",
            response,
        )
        assert found["values"] == pytest.approx(
            [design["settings"]["load_cases[0].axial_force"]["number"] for design in designs]
        )
        assert found["responses"] == pytest.approx(
            [design["responses"][response] for design in designs], rel=1e-10
        )


def test_both_units(browser: Workbench) -> None:
    browser.open_case(LESSON)
    root = browser.find("html")
    si = browser.headlines()[STIFFNESS].split()
    try:
        browser.driver.execute_script("prs.units('us')")
        assert root.get_attribute("data-units") == "us"
        browser.wait(
            f"document.querySelector('[data-quantity=\"{STIFFNESS}\"]').textContent.includes('lbf')"
        )
        us = browser.headlines()[STIFFNESS].split()
        assert (si[1], us[1]) == ("N/µm", "lbf/µin")
        # 1 lbf = 4.4482216152605 N, 1 in = 25.4 mm, by definition.
        assert float(us[0]) == pytest.approx(float(si[0]) * 0.0254 / 4.4482216152605, rel=1e-3)
    finally:
        browser.driver.execute_script("prs.units('si')")


def test_what_is_typed_is_computed_and_a_wrong_value_is_told(browser: Workbench) -> None:
    browser.open_case(LESSON)
    before = browser.headlines()[STIFFNESS]
    field = browser.find("[data-path='structure.nut.outer_diameter']")
    browser.driver.execute_script("arguments[0].closest('details').open = true", field)
    field.clear()
    field.send_keys("70\n")
    browser.wait("prs.yaml().includes('outer_diameter: 70 mm')")
    assert field.get_attribute("value") == "70 mm"
    browser.wait(
        f"document.querySelector('[data-quantity={STIFFNESS}]').textContent !== '{before}'"
    )
    answer = browser.set("structure.nut.outer_diameter", "90 kg")
    assert answer["status"] == 2
    assert "got 90 kg" in answer["messages"][0]
    browser.wait("document.querySelector('[data-path][aria-invalid]') !== null")
    assert browser.find("[role=alert]").is_displayed()
    browser.driver.execute_script("prs.undo()")
    browser.wait("document.querySelector('[data-path][aria-invalid]') === null")
    assert browser.set("mechanism.no_such_key", "1")["status"] == 2
    assert "no_such_key" not in browser.yaml()


def test_a_unit_behind_a_decimal_comma_stays_the_unit(browser: Workbench) -> None:
    browser.open_case(LESSON.replace("outer_diameter: 66 mm", "outer_diameter: 66,5 mm"))
    field = browser.find("[data-path='structure.nut.outer_diameter']")
    browser.driver.execute_script("arguments[0].closest('details').open = true", field)
    field.clear()
    field.send_keys("71.5\n")
    browser.wait("prs.yaml().includes('outer_diameter: 71.5 mm')")
    browser.open_case(LESSON)


def test_aliases_of_aliases_are_refused_as_on_the_terminal(
    browser: Workbench, program: Run, tmp_path: Path
) -> None:
    lines = ["a: &a [x,x,x,x,x,x,x,x,x]"]
    for k in range(8):
        inner = ",".join([f"*{chr(97 + k)}"] * 9)
        lines.append(f"{chr(98 + k)}: &{chr(98 + k)} [{inner}]")
    text = LESSON + "\n".join(lines) + "\n"
    answer = browser.open_case(text)
    assert answer["status"] == 2
    file = tmp_path / "case.yaml"
    file.write_text(text)
    said = program("check", file).stderr
    assert "aliases expanded" in said
    assert said.split(": error: ")[1].splitlines()[0] in answer["messages"][0]
    browser.open_case(LESSON)


def test_the_text_is_in_step(browser: Workbench) -> None:
    browser.open_case(LESSON)
    shown = "return document.querySelector('.editor-place').shadowRoot.querySelector('.cm-content')"
    editor = browser.driver.execute_script(shown)
    browser.find(".pane-of-yaml").click()
    browser.set("mechanism.rollers", "9")
    browser.wait(f"({shown[7:]}).textContent.includes('rollers: 9')")
    browser.driver.execute_script("arguments[0].focus()", editor)
    editor.send_keys("# mine\n")
    browser.wait("prs.yaml().includes('# mine')")
    browser.driver.execute_script("prs.undo()")
    assert browser.yaml() == LESSON.replace("rollers: 10", "rollers: 9")
    browser.find(".pane-of-form").click()


def test_hostile_names_stay_text(browser: Workbench) -> None:
    hostile = "</script><img src=x onerror=\"document.title='got'\">"
    browser.open_case(LESSON.replace("name: tension", f"name: '{hostile.replace(chr(39), '’')}'"))
    browser.js("return await prs.addVariant('<img src=x onerror=\"document.title=1\">')")
    browser.find("#tab-compare").click()
    browser.find("#tab-results").click()
    assert browser.driver.find_elements("css selector", "img") == []
    assert "<img" in browser.text(".variants")
    assert "got" not in browser.driver.title.split("·")[-1]


def test_a_case_of_catalogue_data(browser: Workbench, program: Run) -> None:
    made = browser.js(
        "return await prs.ask({ command: 'new', new: { type: 'standard', screw_diameter: '30 mm',"
        " lead: '10 mm', starts: 5 } })"
    )
    run = program(
        *("new", "standard", "--screw-diameter", "30 mm", "--lead", "10 mm", "--starts", "5")
    )
    assert made["document"]["yaml"] == run.stdout
    refused = browser.js("return await prs.ask({ command: 'new', new: { lead: '10 mm' } })")
    assert refused["status"] == 2
    assert "--screw-diameter" in refused["messages"][0]


def test_starts_with_a_file(browser: Workbench, page: Path, program: Run, tmp_path: Path) -> None:
    file = tmp_path / "workbench.html"
    case = CONFIGS / "05_standard_screw.yaml"
    run = program("workbench", case, "--set", "mechanism.rollers=9", "--output", file)
    assert run.returncode == 0, run.stderr
    assert browser.complaints() == []
    try:
        browser.open(file)
        browser.wait("globalThis.prs?.yaml().includes('rollers: 9')")
        assert browser.yaml() == LESSON.replace("rollers: 10", "rollers: 9")
        assert browser.complaints() == []
    finally:
        browser.open(page)
        browser.wait("globalThis.prs !== undefined")


@pytest.mark.skipif(not AXE.is_file(), reason="no axe-core: run `npm ci` in web/")
def test_is_accessible(browser: Workbench) -> None:
    browser.open_case(LESSON)
    browser.driver.execute_script(AXE.read_text(encoding="utf-8"))
    for tab in ("results", "compare", "studies", "commands"):
        browser.find(f"#tab-{tab}").click()
        violations = browser.js(
            "return (await axe.run()).violations.map((v) => [v.id, v.nodes.map((n) => n.html)])"
        )
        assert violations == [], tab
    browser.find("#tab-results").click()


def test_fits_a_phone(browser: Workbench) -> None:
    browser.resize(375, 700)
    try:
        browser.open_case(LESSON)
        for pane in ("form", "yaml", "results"):
            browser.find(f".pane-of-{pane}").click()
            width = browser.driver.execute_script("return document.documentElement.scrollWidth")
            assert width == 375, pane
    finally:
        browser.resize(1400, 1000)
