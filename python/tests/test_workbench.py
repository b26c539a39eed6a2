"""The page of `prs workbench` in a real browser, opened as a file."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from conftest import CONFIGS, REPOSITORY, Run

pytest.importorskip("selenium.webdriver")

from test_page import Browser  # noqa: E402

#: Six load cases, a full mechanism, a requirement.
QUICK = {1, 24, 32}

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
    assert after[line] == before[line].replace(entry["written"], value, 1)
    assert browser.driver.execute_script("return prs.undo()")
    assert browser.yaml() == text
    assert browser.driver.execute_script("return prs.redo()")
    assert browser.yaml() == changed


def differences(live: Any, native: Any, path: str = "", largest: float = 0.0) -> Iterator[str]:
    """Numbers beyond 1e-10, of a list of its largest; depths of flat maxima beyond 1e-6."""
    if "residual" in path or path.endswith("].factorization"):
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
