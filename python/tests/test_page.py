"""The page of `prs report` in a real browser, opened as a file."""

from __future__ import annotations

import base64
import io
import json
import random
import re
import shutil
import unicodedata
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from conftest import CONFIGS, REPOSITORY, Run, lessons

webdriver = pytest.importorskip("selenium.webdriver")
pypdf = pytest.importorskip("pypdf")

from selenium.common.exceptions import (  # noqa: E402
    MoveTargetOutOfBoundsException,
    StaleElementReferenceException,
)
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402
from selenium.webdriver.remote.webdriver import WebDriver  # noqa: E402
from selenium.webdriver.remote.webelement import WebElement  # noqa: E402
from selenium.webdriver.support.ui import WebDriverWait  # noqa: E402

#: Those that run at once: load cases, contacts from the geometry, a history, all rollers, films.
QUICK = {1, 4, 14, 24, 29}

AXE = REPOSITORY / "web" / "node_modules" / "axe-core" / "axe.min.js"

#: Words of the page that stand on two lines, where no hyphen, slash or bracket lets them.
BROKEN_WORDS = r"""
const broken = [], range = document.createRange();
const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
while (texts.nextNode()) {
  const node = texts.currentNode;
  if (node.parentElement.closest('code, .mono, script, style, svg')) continue;
  for (const { 0: word, index } of node.data.matchAll(/[^\s\-\/,;:.…|–]{2,}/g)) {
    range.setStart(node, index);
    range.setEnd(node, index + word.length);
    if (new Set([...range.getClientRects()].map((box) => Math.round(box.top))).size > 1)
      broken.push(word);
  }
}
return broken;
"""

#: Seconds until something that must come is missing; only a page that hangs takes so long.
PATIENCE = 300

#: What a page says that is static without having been asked to be.
STATIC = "This page is static: the engine"


def each_lesson() -> list[Any]:
    return [
        pytest.param(
            file,
            id=file.stem[:2],
            marks=[] if int(file.stem[:2]) in QUICK else [pytest.mark.thorough],
        )
        for file in lessons()
    ]


class Browser:
    """A window of a phone or a desk, with what it asked for and complained about."""

    def __init__(self, scripts: bool = True, draws: bool = False) -> None:
        options = webdriver.ChromeOptions()
        webgl = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
        for argument in (
            *("--headless=new", "--no-sandbox", "--disable-dev-shm-usage"),
            *(webgl if draws else ("--disable-3d-apis",)),
        ):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        if not scripts:
            options.add_experimental_option(
                "prefs", {"profile.managed_default_content_settings.javascript": 2}
            )
        self.driver = webdriver.Chrome(
            options=options, service=webdriver.ChromeService(shutil.which("chromedriver"))
        )
        self.driver.set_script_timeout(PATIENCE)
        self.resize(1400, 1000)

    def resize(self, width: int, height: int) -> None:
        self.driver.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600},
        )

    def open(self, page: Path) -> None:
        self.driver.get("about:blank")
        for kind in ("browser", "performance"):
            self.driver.get_log(kind)
        self.driver.get(page.as_uri())

    def complaints(self) -> list[str]:
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def requests(self) -> list[str]:
        """What the page loaded besides itself."""
        messages = [
            json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")
        ]
        return [
            message["params"]["request"]["url"]
            for message in messages
            if message["method"] == "Network.requestWillBeSent"
            and message["params"].get("type") != "Document"
        ]

    def find(self, selector: str) -> WebElement:
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def text(self, selector: str) -> str:
        return self.find(selector).get_attribute("textContent") or ""

    def ask(self, question: dict[str, Any]) -> dict[str, Any]:
        """What the engine of the page answers about the case as the page has it."""
        answer: dict[str, Any] = self.driver.execute_async_script(
            "const [question, done] = arguments; prs.ask(question).then(done);", question
        )
        return answer

    def changed(self, act: Callable[[], None]) -> None:
        """Acts, and waits until all numbers follow."""
        self.driver.execute_script(
            "window.completed = false;"
            "document.addEventListener('prs-complete', () => (window.completed = true));"
        )
        act()
        self.wait("window.completed")

    def wait(self, condition: str) -> None:
        WebDriverWait(self.driver, PATIENCE).until(
            lambda driver: driver.execute_script(f"return {condition}"), condition
        )

    def control(self, path: str) -> tuple[WebElement, WebElement]:
        """Field and slider of an input."""
        for place in self.driver.find_elements(By.CSS_SELECTOR, ".control"):
            if path in (place.get_attribute("data-paths") or "").split():
                field, slider = place.find_elements(By.CSS_SELECTOR, "input")
                return field, slider
        raise AssertionError(f"no control of {path}")

    def write(self, path: str, value: str) -> None:
        field, _ = self.control(path)
        self.changed(lambda: field.send_keys(Keys.CONTROL, "a", Keys.NULL, value, Keys.ENTER))

    def tiles(self) -> dict[str, str]:
        """Numbers of the verdict by their titles."""
        return {
            tile.find_element(By.CSS_SELECTOR, "dt").text: tile.find_element(
                By.CSS_SELECTOR, ".value"
            ).text
            for tile in self.driver.find_elements(By.CSS_SELECTOR, ".tiles > div")
        }


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    if not shutil.which("chromedriver"):
        pytest.skip("no browser: install chromium-driver")
    browser = Browser()
    yield browser
    browser.driver.quit()


@pytest.fixture(scope="module")
def drawing() -> Iterator[Browser]:
    """One with WebGL."""
    if not shutil.which("chromedriver"):
        pytest.skip("no browser: install chromium-driver")
    browser = Browser(draws=True)
    yield browser
    browser.driver.quit()


@pytest.fixture
def page(program: Run, tmp_path: Path) -> Callable[..., Path]:
    """Writes the page of a lesson, by its number, or of a file."""

    def write(case: int | Path, *arguments: str, name: str = "report.html") -> Path:
        if isinstance(case, int):
            (case,) = (file for file in lessons() if file.stem.startswith(f"{case:02d}_"))
        run = program("report", case, "--quiet", "--output", tmp_path / name, *arguments)
        assert run.returncode in (0, 3), run.stderr
        if STATIC in (tmp_path / name).read_text(encoding="utf-8"):
            pytest.skip("the program has no engine of live pages: scripts/web.sh builds it")
        return tmp_path / name

    return write


def assert_close(live: Any, native: Any, path: str = "") -> None:
    """To 1e-12 of each number; depths of flat maxima to 1e-7; what is left over is rounding."""
    if "residual" in path:
        return
    if isinstance(native, dict):
        assert live.keys() == native.keys(), path
        for key in native:
            assert_close(live[key], native[key], f"{path}.{key}")
    elif isinstance(native, list):
        assert len(live) == len(native), path
        largest = max((abs(x) for x in native if isinstance(x, float)), default=0.0)
        if "reactions" in path:  # Where none is needed: rounding of kilonewtons.
            largest = max(largest, 1e3)
        for k, (a, b) in enumerate(zip(live, native)):
            if isinstance(b, float):
                share = 1e-7 if "depth" in path else 1e-12
                assert a == pytest.approx(b, rel=share, abs=share * largest), f"{path}[{k}]"
            else:
                assert_close(a, b, f"{path}[{k}]")
    elif isinstance(native, float):
        share = 1e-7 if "depth" in path else 1e-9 if "tangent" in path else 1e-12
        assert live == pytest.approx(native, rel=share, abs=1e-300), path
    else:
        assert live == native, path


@pytest.mark.parametrize("file", each_lesson())
def test_opens_without_request_or_complaint(
    file: Path, browser: Browser, page: Callable[..., Path]
) -> None:
    browser.open(page(file))
    assert browser.ask({"command": "check"})["status"] == 0
    assert browser.complaints() == []
    assert [url for url in browser.requests() if not url.startswith(("blob:", "data:"))] == []


@pytest.mark.parametrize("file", each_lesson())
def test_says_what_the_program_says(
    file: Path, browser: Browser, page: Callable[..., Path], program: Run
) -> None:
    browser.open(page(file))
    command = "solve" if program("solve", file, "--quiet").returncode in (0, 3) else "contact"
    native = json.loads(program(command, file, "--json").stdout)
    live = browser.ask({"command": command})["document"]
    for document in (native, live):  # Pages have another library for it.
        for load_case in document.get("load_cases", []):
            load_case.pop("factorization", None)
    for key in ("load_cases", "contact"):
        if key in native:
            assert_close(live[key], native[key], key)


@pytest.mark.parametrize("file", each_lesson())
def test_follows_as_set_does(file: Path, browser: Browser, page: Callable[..., Path]) -> None:
    browser.open(page(file))
    places = browser.driver.find_elements(By.CSS_SELECTOR, ".control")
    assert places
    field, slider = places[0].find_elements(By.CSS_SELECTOR, "input")
    paths = (places[0].get_attribute("data-paths") or "").split()
    unit = slider.get_attribute("data-unit")
    value = f"{float(slider.get_attribute('value') or 0) * 0.75:g} {unit}".strip()
    browser.write(paths[0], value)
    assert browser.text("#trouble") == ""
    live = browser.tiles()
    sets = [word for path in paths for word in ("--set", f"{path}={value}")]
    browser.open(page(file, "--static", *sets, name="set.html"))
    assert live == browser.tiles()


def test_keyboard_alone_moves_a_slider(browser: Browser, page: Callable[..., Path]) -> None:
    browser.open(page(4))
    field, slider = browser.control("structure.nut.outer_diameter")
    browser.driver.execute_script("arguments[0].focus()", field)
    field.send_keys(Keys.TAB)
    assert browser.driver.switch_to.active_element == slider
    before = browser.tiles()
    browser.changed(lambda: slider.send_keys(Keys.ARROW_RIGHT))
    assert field.get_attribute("value") != "46 mm"
    assert browser.tiles()["Axial stiffness"] != before["Axial stiffness"]
    assert "Diameter of the nut" in browser.text("#changed")
    assert "report: " in browser.text("#verdict")
    reset = browser.find("#reset")
    browser.changed(lambda: reset.send_keys(Keys.ENTER))
    assert browser.tiles() == before
    assert not browser.find("#changed").is_displayed()
    assert field.get_attribute("value") == "46 mm"


def test_a_wrong_value_is_told_and_changes_nothing(
    browser: Browser, page: Callable[..., Path]
) -> None:
    browser.open(page(4))
    before = browser.tiles()
    path = "structure.nut.outer_diameter"
    browser.write(path, "90 kg")
    assert f"{path}: got 90 kg" in browser.text("#trouble")
    assert browser.control(path)[0].get_attribute("aria-invalid") is not None
    assert "cannot be computed" in browser.text("#changed")
    assert browser.tiles() == before
    browser.write(path, "60 mm")
    assert browser.text("#trouble") == ""
    assert browser.tiles() != before


#: Whether each state of the verdict has the colour of a remark, neither green nor red.
IS_GREY = """
const quiet = getComputedStyle(document.querySelector('.where')).color;
return [...document.querySelectorAll('#verdict .state')]
  .map((state) => getComputedStyle(state).color === quiet);
"""


def reference_tile(browser: Browser) -> str:
    return browser.text('[data-tile="references"]')


def test_a_reference_follows(browser: Browser, page: Callable[..., Path], program: Run) -> None:
    browser.open(page(38))
    assert "not met" not in reference_tile(browser)
    path = "structure.nut.outer_diameter"
    browser.write(path, "90 mm")
    assert "computed when" not in reference_tile(browser)
    run = program("check", CONFIGS / "38_reference.yaml", "--json", "--set", f"{path}=90 mm")
    (own,) = (c for c in json.loads(run.stdout)["verdict"]["criteria"] if c["name"] == "references")
    shown = browser.text('[data-tile="references"] .value')
    assert float(shown) == pytest.approx(own["value"], rel=2e-3)
    assert (own["state"] == "red") == ("not met" in reference_tile(browser))
    # While a value moves the others follow later: neither green nor red.
    browser.driver.execute_script(
        "window.moving = setInterval(() => arguments[0].dispatchEvent(new Event('input')), 100)",
        browser.control(path)[1],
    )
    try:
        browser.wait("document.querySelector('[data-tile=references].stale') !== null")
        assert "computed when the values rest" in reference_tile(browser)
        assert browser.find('[data-tile="references"]').get_attribute("class") == "stale"
    finally:
        browser.changed(lambda: browser.driver.execute_script("clearInterval(window.moving)"))
    assert "computed when" not in reference_tile(browser)
    # Where a value cannot be computed all that stands is grey.
    browser.write(path, "90 kg")
    assert set(browser.driver.execute_script(IS_GREY)) == {True}
    browser.write(path, "46 mm")
    assert not all(browser.driver.execute_script(IS_GREY))


#: What the page says that is of its values; where they cannot be computed its numbers are none.
SAID = """
const main = document.querySelector('main').cloneNode(true);
for (const other of main.querySelectorAll('.stale, #thread, [hidden]')) other.remove();
const wrong = document.body.classList.contains('is-wrong');
return [wrong || main.textContent, wrong || document.querySelector('header').textContent,
  ...['trouble', 'state', 'changed'].map((id) => document.getElementById(id).textContent)];
"""


def test_any_walk_of_values_says_what_a_fresh_page_says(
    browser: Browser, page: Callable[..., Path]
) -> None:
    chance = random.Random(38)
    values = {
        "structure.nut.outer_diameter": ("46 mm", "60 mm", "90 kg", "1 mm"),
        "mechanism.contacts_per_roller": ("20", "18", "-3", "many"),
    }

    def put(path: str, value: str) -> None:
        if browser.control(path)[0].get_attribute("value") != value:
            browser.write(path, value)

    file = page(4)
    browser.open(file)
    stand: dict[str, str] = {}
    seen = []
    for _ in range(12):
        path, choices = chance.choice(list(values.items()))
        stand[path] = chance.choice([value for value in choices if value != stand.get(path)])
        put(path, stand[path])
        seen.append((dict(stand), browser.driver.execute_script(SAID)))
    assert {True, False} == {said[0] is True for _, said in seen}
    for written, said in seen[-4:]:
        browser.open(file)
        for path, value in written.items():
            put(path, value)
        assert browser.driver.execute_script(SAID) == said, written


def test_copies_are_the_changed_case(
    browser: Browser, page: Callable[..., Path], program: Run, tmp_path: Path
) -> None:
    browser.open(page(24))
    browser.write("load_cases[0].misalignment.nut_tilt.z", "0.05 deg")
    live = browser.tiles()
    browser.find("#copy-yaml").send_keys(Keys.ENTER)
    browser.wait("document.getElementById('copy').open")
    yaml = browser.find("#copy-text").get_attribute("value") or ""
    assert "# Lesson 24" in yaml
    (tmp_path / "copied.yaml").write_text(yaml)
    browser.find("#copy button").click()
    browser.find("#copy-set").send_keys(Keys.ENTER)
    command = browser.find("#copy-text").get_attribute("value") or ""
    assert command.endswith("--set 'load_cases[0].misalignment.nut_tilt.z=0.05 deg'")
    browser.open(page(tmp_path / "copied.yaml", "--static", name="copied.html"))
    assert browser.tiles() == live


@pytest.fixture
def screw(program: Run, tmp_path: Path) -> Path:
    """A case of which diameter and lead alone are given."""
    case = tmp_path / "screw.yaml"
    run = program("new", "standard", case, "--screw-diameter", "25mm", "--lead", "5mm")
    assert run.returncode == 0, run.stderr
    return case


def test_one_load_drives_all_that_has_it(
    browser: Browser, page: Callable[..., Path], screw: Path
) -> None:
    browser.open(page(screw))
    browser.write("load_cases[0].axial_force", "200 kN")
    assert browser.text("#state") == "All numbers follow."
    live = browser.tiles()
    paths = [f"load_cases[{k}].axial_force" for k in (0, 1)] + ["life.spectrum[0].force"]
    sets = [word for path in paths for word in ("--set", f"{path}=200 kN")]
    browser.open(page(screw, "--static", *sets, name="set.html"))
    assert live == browser.tiles()


def test_what_does_not_follow_is_grey_and_says_so(
    browser: Browser, page: Callable[..., Path], screw: Path
) -> None:
    browser.open(page(screw, "--set", "life.spectrum[0].force=9 kN"))
    before = browser.text("#life")
    browser.write("load_cases[0].axial_force", "12 kN")
    assert browser.text("#state").startswith("Not all numbers follow")
    assert "does not follow the axial force of the load cases" in browser.text("#life")
    assert browser.find("#life .stale").is_displayed()
    browser.write("life.spectrum[0].force", "12 kN")
    assert browser.text("#state") == "All numbers follow."
    assert browser.driver.find_elements(By.CSS_SELECTOR, "main .stale") == []
    assert browser.text("#life") != before


def test_head_and_basis_follow(browser: Browser, page: Callable[..., Path], screw: Path) -> None:
    browser.open(page(screw))
    assert "11 rollers" in browser.text("header")
    browser.write("mechanism.rollers", "6")
    assert "6 rollers" in browser.text("header")
    (row,) = (
        row
        for row in browser.driver.find_elements(By.CSS_SELECTOR, "#inputs tr")
        if "mechanism.rollers" in (row.get_attribute("textContent") or "")
    )
    assert (row.get_attribute("textContent") or "").endswith("6given")


def test_a_number_alone_has_the_unit_beside_it(browser: Browser, page: Callable[..., Path]) -> None:
    browser.open(page(4))
    path = "structure.nut.outer_diameter"
    for written, read in (("60", "60 mm"), ("6.1 cm", "6.1 cm"), ("6.2", "6.2 cm")):
        browser.write(path, written)
        assert browser.text("#trouble") == ""
        assert browser.control(path)[0].get_attribute("value") == read
    browser.write("mechanism.contacts_per_roller", "18")
    assert browser.text("#trouble") == ""


def test_a_thread_is_looked_at(browser: Browser, page: Callable[..., Path]) -> None:
    browser.open(page(29))
    number = browser.find("#thread-number")
    browser.driver.execute_script("arguments[0].scrollIntoView()", number)
    browser.wait("document.querySelectorAll('#thread figure').length === 3")
    first = browser.text("#thread .body")
    number.send_keys(Keys.ARROW_UP)
    WebDriverWait(browser.driver, PATIENCE).until(
        lambda _: browser.text("#thread .body") != first, "another thread"
    )

    def first_is_picked(driver: WebDriver) -> bool:
        """Clicks again where the page still moved as a picture above was drawn."""
        picture = browser.find("#loads .pick")
        driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", picture)
        webdriver.ActionChains(driver).move_to_element_with_offset(
            picture, -picture.rect["width"] / 2 + 3, 0
        ).click().perform()
        return number.get_attribute("value") == "1"

    moved = [MoveTargetOutOfBoundsException, StaleElementReferenceException]
    WebDriverWait(browser.driver, PATIENCE, ignored_exceptions=moved).until(
        first_is_picked, "the first thread is picked"
    )


def thread_in_view(browser: Browser) -> tuple[int, int, list[float]]:
    """The roller, the thread and its loads and pressures that the view tells."""
    told = browser.text(".mechanism-view .told")
    place = re.match(r"Roller (\d+), thread (\d+), at rest: ", told)
    assert place, told
    numbers = [float(number) for number in re.findall(r"([\d.]+) (?:N|MPa)\b", told)]
    return int(place[1]), int(place[2]), numbers


def test_mechanism_in_three_dimensions_tells_its_threads(
    drawing: Browser, page: Callable[..., Path], program: Run
) -> None:
    (lesson,) = (file for file in lessons() if file.stem.startswith("24_"))
    cases = json.loads(program("solve", lesson, "--json").stdout)["load_cases"]

    def assert_told() -> tuple[int, int]:
        roller, thread, told = thread_in_view(drawing)
        shown = cases[int(drawing.find("#thread-case").get_attribute("value") or 0)]
        assert told == [
            pytest.approx(shown[side][key][roller - 1][thread - 1], rel=5e-4)
            for side in ("screw", "nut")
            for key in ("normal_load_N", "peak_pressure_MPa")
        ]
        for field, number in (("roller", roller), ("number", thread)):
            assert drawing.find(f"#thread-{field}").get_attribute("value") == str(number)
        return roller, thread

    drawing.open(page(24))
    drawing.driver.execute_script(
        "document.documentElement.style.scrollBehavior = 'auto';"
        "document.getElementById('mechanism').scrollIntoView()"
    )
    drawing.wait("document.querySelector('.mechanism-view canvas')?.getAttribute('aria-label')")
    canvas = drawing.find(".mechanism-view canvas")
    label = canvas.get_attribute("aria-label") or ""
    most = max(
        max(max(row) for row in case[side]["normal_load_N"])
        for case in cases
        for side in ("screw", "nut")
    )
    assert "11 rollers with 20 threads each" in label
    assert f"{most:.4g} N" in label
    first = assert_told()
    # By a click on the roller in the middle of the picture, then by keys.
    canvas.click()
    clicked = assert_told()
    assert clicked != first
    assert drawing.driver.switch_to.active_element == canvas
    canvas.send_keys(Keys.PAGE_DOWN)
    number = clicked[1] % 20 + 1
    assert assert_told()[1] == number
    drawing.find("#thread-number").send_keys(Keys.ARROW_UP if number < 20 else Keys.ARROW_DOWN)
    assert abs(assert_told()[1] - number) == 1
    printed = drawing.driver.execute_cdp_cmd("Page.printToPDF", {})["data"]
    paper = pypdf.PdfReader(io.BytesIO(base64.b64decode(printed)))
    assert "Reset view" not in " ".join(sheet.extract_text() for sheet in paper.pages)
    # What is hidden is not drawn.
    drawing.driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvas)
    whole = canvas.screenshot_as_png
    drawing.find(".mechanism-view input[type=checkbox]").click()
    WebDriverWait(drawing.driver, PATIENCE).until(
        lambda _: canvas.screenshot_as_png != whole, "the nut is hidden"
    )
    assert drawing.complaints() == []
    assert [url for url in drawing.requests() if not url.startswith(("blob:", "data:"))] == []


def test_mechanism_has_its_picture_without_webgl(
    browser: Browser, page: Callable[..., Path]
) -> None:
    browser.open(page(4))
    browser.driver.execute_script("document.getElementById('mechanism').scrollIntoView()")
    assert browser.ask({"command": "check"})["status"] == 0  # After what the view has asked.
    browser.wait("document.querySelectorAll('body > script[type=module]').length === 3")
    assert browser.driver.find_elements(By.CSS_SELECTOR, ".mechanism-view") == []
    assert browser.find("#mechanism svg").is_displayed()
    assert browser.complaints() == []


def test_hostile_names_stay_text(
    browser: Browser, page: Callable[..., Path], tmp_path: Path
) -> None:
    hostile = "</script><img src=x onerror=\"document.title='got'\">"
    (file,) = (file for file in lessons() if file.stem.startswith("01_"))
    text = file.read_text().replace("config1-tension", f"'{hostile.replace(chr(39), chr(39) * 2)}'")
    case = tmp_path / "<b>case.yaml"
    case.write_text(text)
    browser.open(page(case))
    browser.write("load_cases[0].axial_force", "40000 N")
    assert browser.driver.find_elements(By.CSS_SELECTOR, "img, b") == []
    assert "got" not in browser.driver.title
    assert hostile in browser.text("#thread-case")
    assert browser.complaints() == []


def test_prints_every_section_on_a4(browser: Browser, page: Callable[..., Path]) -> None:
    browser.open(page(14))
    titles = [
        heading.text
        for heading in browser.driver.find_elements(By.CSS_SELECTOR, "main h2")
        if heading.is_displayed()
    ]
    assert {"Verdict", "Load distribution", "Life", "Provenance"} <= set(titles)
    printed = browser.driver.execute_cdp_cmd("Page.printToPDF", {"preferCSSPageSize": True})
    pdf = pypdf.PdfReader(io.BytesIO(base64.b64decode(printed["data"])))
    size = pdf.pages[0].mediabox
    assert (round(size.width), round(size.height)) == (595, 842)
    text = " ".join(page.extract_text() for page in pdf.pages)
    text = re.sub(r"\s+", " ", unicodedata.normalize("NFKC", text))  # Ligatures as letters.
    for title in set(titles) - {"One thread", "Data", "Glossary"}:
        assert title in text
    assert "One thread" not in text  # Nothing was chosen: no heading over nothing.
    assert re.search(r"Sheet 1 of \d", text)
    assert "Try other values" not in text


def test_the_sheet_to_sign_is_one_sheet(
    browser: Browser, screw: Path, program: Run, tmp_path: Path
) -> None:
    """With a whole title block, limits, and assumptions that fill their list."""
    blocks = """
limits: {life: 5000 h, static_safety: 3, peak_pressure: 2.5 GPa, efficiency: 75 %}
report: {title: Feed axis, customer: ACME, number: Z-001, revision: A, author: J. Doe}
"""
    screw.write_text(screw.read_text() + blocks)
    assert program("report", screw, "--summary", "--output", tmp_path / "page.html").returncode == 0
    browser.open(tmp_path / "page.html")
    printed = browser.driver.execute_cdp_cmd("Page.printToPDF", {"preferCSSPageSize": True})
    assert len(pypdf.PdfReader(io.BytesIO(base64.b64decode(printed["data"]))).pages) == 1


@pytest.mark.parametrize("case", ["24_misalignment", "32_press", "37_bench"])
def test_words_are_whole_and_the_page_is_accessible(
    case: str, browser: Browser, program: Run, tmp_path: Path
) -> None:
    file, report = CONFIGS / f"{case}.yaml", tmp_path / "page.html"
    assert program("report", file, "--static", "--output", report).returncode == 0
    if not AXE.is_file():
        pytest.skip("no axe-core: run `npm ci` in web/")
    report.write_text(re.sub(r"<meta http-equiv[^>]*>", "", report.read_text()))  # Lets axe in.
    try:
        for width in (390, 800, 1600):
            browser.resize(width, 1000)
            browser.open(report)
            assert browser.driver.execute_script(BROKEN_WORDS) == [], width
            browser.driver.execute_script(AXE.read_text(encoding="utf-8"))
            violations = browser.driver.execute_async_script(
                "axe.run().then(({ violations }) => arguments[0](violations.map((v) => v.id)))"
            )
            assert violations == [], width
    finally:
        browser.resize(1400, 1000)


def test_a_word_of_the_glossary_is_reached_by_keyboard(
    browser: Browser, program: Run, tmp_path: Path
) -> None:
    case, report = CONFIGS / "04_contacts_from_geometry.yaml", tmp_path / "page.html"
    assert program("report", case, "--static", "--output", report).returncode == 0
    browser.open(report)
    for _ in range(60):
        browser.driver.switch_to.active_element.send_keys(Keys.TAB)
        word = browser.driver.switch_to.active_element
        if word.get_attribute("class") == "term":
            break
    assert word.get_attribute("class") == "term"
    assert word.value_of_css_property("outline-style") == "solid"
    word.send_keys(Keys.ENTER)
    browser.wait("document.querySelector('.terms dt:target').getClientRects().length > 0")


@pytest.mark.parametrize("file", each_lesson())
def test_fits_a_phone(file: Path, browser: Browser, page: Callable[..., Path]) -> None:
    browser.resize(375, 700)
    try:
        browser.open(page(file))
        browser.wait("!document.getElementById('live').hidden")
        assert browser.driver.execute_script("return document.documentElement.scrollWidth") == 375
        browser.find("#live summary").click()
        assert browser.driver.execute_script("return document.documentElement.scrollWidth") == 375
        assert browser.find("#live").rect["height"] < 400
    finally:
        browser.resize(1400, 1000)


def test_reads_without_scripts(page: Callable[..., Path]) -> None:
    if not shutil.which("chromedriver"):
        pytest.skip("no browser: install chromium-driver")
    reader = Browser(scripts=False)
    try:
        reader.open(page(4))
        assert reader.tiles()["Axial stiffness"]
        assert reader.find("#loads svg").is_displayed()
        assert not reader.find("#live").is_displayed()
    finally:
        reader.driver.quit()


def test_static_has_no_script(page: Callable[..., Path]) -> None:
    text = page(4, "--static").read_text(encoding="utf-8")
    assert re.findall(r"<script[^>]*>", text) == ['<script type="application/json" id="data">']
    assert "script-src" not in text
