"""Faults at every place: limits, full disks, hostile folders, signals, killed ranks.

Whatever happens, the program ends with a status of its own and says why. What stands in the folder
is whole, nothing unfinished is left, and the same command goes on where it can. Signals come at
chosen system calls (strace), not at chosen times. PRS_THOROUGH=1 runs the whole matrices.
"""

from __future__ import annotations

import fcntl
import os
import random
import re
import shutil
import struct
import subprocess
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
CONFIGS = REPOSITORY / "configs"
THOROUGH = "PRS_THOROUGH" in os.environ

STUDY = """
study:
  command: solve
  plan: sobol
  samples: 300
  seed: 3
  factors:
    - {path: mechanism.rollers, values: [7, 8, 9]}
    - {path: materials.youngs_modulus, within: 5 %}
  responses: [axial_displacement_um, nut.peak_pressure_MPa.max]
"""
OPTIMIZE = """
optimize:
  command: solve
  seed: 1
  population: 8
  generations: 3
  variables:
    - {path: structure.nut.outer_diameter, from: 40 mm, to: 55 mm}
    - {path: structure.roller.end_length, from: 3 mm, to: 8 mm}
  objectives:
    - {minimize: screw.load_rate_percent.max}
    - {minimize: nut.peak_pressure_MPa.max}
"""

#: Every command that writes files, to OUT.
WRITING = {
    "check": "check 05_standard_screw.yaml --output OUT",
    "contact": "contact 05_standard_screw.yaml --output OUT",
    "solve": "solve 01_config_1_to_3.yaml --output OUT",
    "slip": "slip 09_slip_and_dissipation.yaml --output OUT",
    "preload": "preload 12_preload.yaml --output OUT",
    "life": "life 14_flight_spectrum.yaml --output OUT",
    "measures": "measures 18_design_measures.yaml --output OUT",
    "full": "solve 24_misalignment.yaml --output OUT",
    "travel": "solve 33_tolerances.yaml --output OUT",
    "response": "response 34_reversal.yaml --output OUT",
    "fit": "fit 37_bench.yaml --output OUT",
    "size": "size 32_press.yaml --output OUT --write 1 OUT/screw.yaml",
    "workbench": "workbench --output OUT/workbench.html",
    "derivatives": "study 17_derivatives.yaml --output OUT",
    "study": "study study.yaml --threads 2 --output OUT",
    "merge": "study merge shard --output OUT",
    "optimize": "optimize optimize.yaml --threads 2 --output OUT",
    "configurations": "configurations --screw-diameter 24mm --lead 8mm --starts 4 --output OUT",
    "validate": f"validate {REPOSITORY}/validation/sandu_2018 --output OUT",
    "report": "report 05_standard_screw.yaml --output OUT/report.html",
    "fmu": "export 09_slip_and_dissipation.yaml --fmu --output OUT/screw.fmu",
    "modelica": "export 09_slip_and_dissipation.yaml --modelica --output OUT/package.mo",
    "new": "new standard OUT/case.yaml",
}
SOME = tuple(WRITING) if THOROUGH else ("solve", "study", "report")

#: Of an interrupted program, as shells report it.
INTERRUPTED = {"HUP": 129, "INT": 130, "TERM": 143}


def program() -> str:
    found = os.environ.get("PRS_EXECUTABLE") or shutil.which("prs")
    assert found
    return str(Path(found).resolve())


Run = Callable[..., "subprocess.CompletedProcess[str]"]


@dataclass
class Bench:
    """A folder with the input of every command, and what the commands write undisturbed."""

    folder: Path
    expected: dict[tuple[str, str | None], dict[str, bytes]] = field(default_factory=dict)
    outputs: int = 0

    def output(self) -> Path:
        self.outputs += 1
        folder = self.folder / f"out-{self.outputs}"
        folder.mkdir()
        return folder

    def run(
        self, name: str, out: Path, *before: str, **options: Any
    ) -> subprocess.CompletedProcess[str]:
        words = [word.replace("OUT", str(out)) for word in WRITING[name].split()]
        environment = {**os.environ, "PRS_CACHE_DIR": "", **options.pop("env", {})}
        executable = options.pop("executable", program())
        return subprocess.run(
            [*before, executable, *words, "--quiet"],
            cwd=self.folder,
            env=environment,
            capture_output=True,
            text=True,
            check=False,
            timeout=300,  # Who waits for ever fails.
            **options,
        )

    def undisturbed(self, name: str) -> dict[str, bytes]:
        if name not in self.expected:
            out = self.output()
            run = self.run(name, out)
            if "the engine of live pages" in run.stderr:
                pytest.skip(run.stderr)
            assert run.returncode == 0, run.stderr
            self.expected[name] = contents(out)
        return self.expected[name]


def without_time(content: bytes) -> bytes:
    """A page without its time and without the name of its folder."""
    if not content.startswith(b"<!DOCTYPE html>"):
        return content
    return re.sub(rb"out-\d+|\d\d(\d\d)?[-:]\d\d([-:]\d\d)?", b"", content)


def contents(folder: Path) -> dict[str, bytes]:
    """Files by their paths; what is neither a file nor a folder does not count."""
    return {
        str(file.relative_to(folder)): without_time(file.read_bytes())
        for file in sorted(folder.rglob("*"))
        if file.is_file() and not file.is_symlink()
    }


#: It says what was written and when.
FILE_LIST = ".prs-files.json"


def told(run: subprocess.CompletedProcess[str]) -> bool:
    """Whether standard error says in few lines what went wrong."""
    lines = run.stderr.strip().splitlines()
    return 1 <= len(lines) <= 24 and bool(re.search(r"prs: |error: ", run.stderr))


def assert_in_order(
    bench: Bench,
    name: str,
    out: Path,
    run: subprocess.CompletedProcess[str],
    *more: int,
) -> None:
    """Status, message and files of a run."""
    assert run.returncode in {0, 1, *more}, (run.returncode, run.stderr)
    assert run.returncode == 0 or told(run), run.stderr
    assert [str(left) for left in out.rglob("*.tmp")] == []
    written = contents(out)
    expected = bench.undisturbed(name)
    for path, content in written.items():
        # Archives have a time; the next run goes on with a journal and takes the lock again.
        if path == FILE_LIST or path.endswith((".journal", ".lock", ".fmu")):
            continue
        assert content == expected.get(path), path


@pytest.fixture(scope="module")
def bench(tmp_path_factory: pytest.TempPathFactory) -> Bench:
    folder = tmp_path_factory.mktemp("faults")
    for file in CONFIGS.iterdir():
        shutil.copy(file, folder)
    base = (CONFIGS / "01_config_1_to_3.yaml").read_text()
    (folder / "study.yaml").write_text(base + STUDY)
    (folder / "optimize.yaml").write_text(base + OPTIMIZE)
    shard = [program(), "study", "study.yaml", "--shard", "1/1", "--output", "shard", "--quiet"]
    subprocess.run(shard, cwd=folder, check=True)
    return Bench(folder)


@pytest.mark.parametrize("name", SOME)
def test_two_runs_write_the_same_bytes(bench: Bench, name: str) -> None:
    out = bench.output()
    expected = bench.undisturbed(name)
    run = bench.run(name, out)
    assert run.returncode == 0, run.stderr
    assert contents(out).keys() == expected.keys()
    assert_in_order(bench, name, out, run)


@cache
def least_memory() -> int:
    """Bytes of addresses with which the program starts."""
    for mib in range(8, 4096, 8):
        run = subprocess.run(
            ["prlimit", f"--as={mib << 20}", program(), "--version"],
            capture_output=True,
            check=False,
        )
        if run.returncode == 0:
            return mib << 20
    raise AssertionError("does not start")


LIMITS = {
    "FSIZE": [0, 1, 700, 5000, 30_000, 200_000],
    "NOFILE": [4, 5, 6, 8, 12, 20],
    "AS": [0, 1 << 20, 4 << 20, 16 << 20, 64 << 20, 256 << 20],  # More than to start.
}


@pytest.mark.parametrize("limit", LIMITS)
@pytest.mark.parametrize("name", SOME)
def test_limits_are_told_and_leave_whole_files(bench: Bench, name: str, limit: str) -> None:
    values = LIMITS[limit] if THOROUGH else LIMITS[limit][2::3]
    for value in values:
        out = bench.output()
        number = value + (least_memory() if limit == "AS" else 0)
        run = bench.run(name, out, "prlimit", f"--{limit.lower()}={number}")
        if run.returncode == 127:  # The loader's: libraries of the program itself.
            continue
        assert_in_order(bench, name, out, run, 3)
        if limit == "FSIZE" and run.returncode == 0:
            assert max(map(len, contents(out).values())) <= value


def test_too_many_open_files_are_no_fault_of_the_input(bench: Bench) -> None:
    run = bench.run("solve", bench.output(), "prlimit", "--nofile=4")
    assert run.returncode == 1
    assert "cannot open '01_config_1_to_3.yaml': Too many open files" in run.stderr


def test_too_few_open_files_to_list_what_was_written_are_told(bench: Bench) -> None:
    out = bench.output()
    run = bench.run("solve", out, "prlimit", "--nofile=5")
    assert (run.returncode, (out / FILE_LIST).exists()) == (1, False), run.stderr
    assert "Too many open files" in run.stderr


@pytest.mark.parametrize("name", ["study", "merge", "optimize"])
def test_too_few_open_files_leave_out_no_result(bench: Bench, name: str) -> None:
    expected = bench.undisturbed(name)
    for number in range(4, 16):
        out = bench.output()
        run = bench.run(name, out, "prlimit", f"--nofile={number}")
        assert run.returncode in (0, 1), (number, run.stderr)
        if run.returncode == 0:
            assert contents(out).keys() == expected.keys(), number
        else:
            assert "Too many open files" in run.stderr, (number, run.stderr)
            for wrong in ("filesystem error", "not installed", "Permission denied"):
                assert wrong not in run.stderr, (number, run.stderr)


def test_scarce_memory_is_told_also_where_documents_are_taken_apart(bench: Bench) -> None:
    out = bench.output()
    for more in range(0, 2 << 20, (16 if THOROUGH else 64) << 10):
        run = bench.run("check", out, "prlimit", f"--as={least_memory() + more}")
        assert_in_order(bench, "check", out, run, 127)


def mounting_is_allowed() -> bool:
    run = subprocess.run(
        ["unshare", "-m", "sh", "-c", "mount -t tmpfs none /mnt"], capture_output=True, check=False
    )
    return run.returncode == 0


@pytest.mark.parametrize("name", SOME)
def test_a_full_disk_is_told_and_leaves_whole_files(bench: Bench, name: str) -> None:
    if not shutil.which("unshare") or not mounting_is_allowed():
        pytest.skip("no file system of its own")
    pages = [1, 8, 40, 120] if THOROUGH else [40]
    for size in pages:
        out, kept = bench.output(), bench.output()
        words = [word.replace("OUT", str(out)) for word in WRITING[name].split()]
        script = (
            f"mount -t tmpfs -o size={4 * size}k none '{out}' || exit 99; "
            f'"$@"; status=$?; cp -a "{out}/." "{kept}"; exit $status'
        )
        run = subprocess.run(
            ["unshare", "-m", "sh", "-c", script, "sh", program(), *words, "--quiet"],
            cwd=bench.folder,
            capture_output=True,
            text=True,
            check=False,
        )
        assert_in_order(bench, name, kept, run)


def as_directory(path: Path) -> None:
    path.mkdir()
    (path / "mine").write_text("mine")


def as_link(path: Path) -> None:
    target = path.parent.parent / "outside.txt"
    target.write_text("outside")
    path.symlink_to(target)


def as_read_only(path: Path) -> None:
    path.write_text("old")
    path.chmod(0o444)


def as_somebodys(path: Path) -> None:
    path.write_text("old")
    path.chmod(0o600)
    give_away(path)


def give_away(path: Path) -> None:
    if os.geteuid() != 0:
        pytest.skip("needs the right to give files away")
    try:
        os.chown(path, 65534, 65534)
    except OSError as error:  # A container may have no other users.
        pytest.skip(f"cannot give files away: {error}")


#: Root otherwise reads and writes whatever these are.
WITH_RIGHTS = ("read-only", "other owner", "no access")


def as_anybody(kind: str) -> tuple[str, ...]:
    """What the program is run by, so that owners and modes count for root too."""
    if kind not in WITH_RIGHTS or os.geteuid() != 0:
        return ()
    words = ("setpriv", "--bounding-set=-all", "--inh-caps=-all")
    if subprocess.run([*words, "true"], capture_output=True, check=False).returncode != 0:
        pytest.skip("root cannot give up its rights")
    return words


HOSTILE: dict[str, Callable[[Path], None]] = {
    "directory": as_directory,
    "fifo": lambda path: os.mkfifo(path),
    "link": as_link,
    "dangling link": lambda path: path.symlink_to("/nonexistent/place"),
    "read-only": as_read_only,
    "other owner": as_somebodys,
}

#: They put their file into a folder that they are given.
EXPORTS = ("fmu", "modelica")


@pytest.mark.parametrize("kind", HOSTILE)
@pytest.mark.parametrize("name", SOME)
def test_what_stands_in_place_of_a_file_is_replaced_or_told(
    bench: Bench, name: str, kind: str
) -> None:
    for path in sorted(bench.undisturbed(name)):
        if not THOROUGH and path.endswith(".svg"):
            continue
        around = bench.output()
        out = around / "out"
        file = out / path
        file.parent.mkdir(parents=True)
        HOSTILE[kind](file)
        run = bench.run(name, out, *as_anybody(kind))
        assert run.returncode in (0, 1, 2), run.stderr
        assert run.returncode == 0 or told(run), run.stderr
        assert list(around.rglob("*.tmp")) == []
        outside = around / "outside.txt"
        assert not outside.exists() or outside.read_text() == "outside"
        if kind == "directory":
            assert run.returncode in ((0,) if name in EXPORTS else (1, 2)), path
            assert (file / "mine").read_text() == "mine"
        elif run.returncode == 0 and path != FILE_LIST:
            assert file.is_file(), path


@pytest.mark.parametrize(
    "kind", ["file", "fifo", "dangling link", "plots is a file", "no access", "other owner"]
)
@pytest.mark.parametrize("name", SOME)
def test_hostile_folders_are_told(bench: Bench, name: str, kind: str) -> None:
    around = bench.output()
    out = around / "out"
    if kind == "file":
        out.write_text("mine")
    elif kind == "fifo":
        os.mkfifo(out)
    elif kind == "dangling link":
        out.symlink_to("/nonexistent/place/below")
    elif kind == "plots is a file":
        out.mkdir()
        (out / "plots").write_text("mine")
    elif kind == "no access":
        out.mkdir(mode=0o500)
    else:
        out.mkdir()
        give_away(out)
    run = bench.run(name, out, *as_anybody(kind))
    draws = any(path.startswith("plots/") for path in bench.undisturbed(name))
    if kind != "plots is a file" or draws:
        assert run.returncode in (1, 2), run.stderr
        assert told(run), run.stderr
    assert list(around.rglob("*.tmp")) == []
    if kind == "file":
        assert out.read_text() == "mine"


# Signals

CALLS = "openat,read,write,rename,mkdir,unlink,rmdir,wait4,fsync,futex"


def tracing() -> bool:
    if not shutil.which("strace"):
        return False
    run = subprocess.run(["strace", "-o", "/dev/null", "true"], capture_output=True, check=False)
    return run.returncode == 0


def calls_of(bench: Bench, name: str) -> tuple[list[int], list[int]]:
    """The calls from the first on that finds signals answered, and those on unfinished files."""
    log = bench.folder / "calls.txt"
    trace = f"trace={CALLS},rt_sigaction"
    run = bench.run(name, bench.output(), "strace", "-o", str(log), "-e", trace)
    assert run.returncode == 0, run.stderr
    count, answered = 0, False
    calls: list[int] = []
    unfinished: list[int] = []
    for line in log.read_text().splitlines():
        if line.startswith("rt_sigaction(SIGTERM, {sa_handler=0x"):
            answered = True
        elif re.match(CALLS.replace(",", "|"), line):
            count += 1
            calls += [count] if answered else []
            unfinished += [count] if ".tmp" in line else []
    assert calls
    return calls, unfinished or calls


@pytest.mark.parametrize("signals", ["HUP", "INT", "TERM", "INT twice"])
@pytest.mark.parametrize("name", SOME)
def test_signals_leave_nothing_unfinished(bench: Bench, name: str, signals: str) -> None:
    if not tracing():
        pytest.skip("no strace")
    calls, unfinished = calls_of(bench, name)
    signal = signals.split()[0]
    drawn = random.Random(f"{name} {signals}")
    for k in range(12 if THOROUGH else 2):
        out = bench.output()
        when = drawn.choice(calls if k % 3 == 2 else unfinished) + drawn.randint(0, 3)
        step = f"+{drawn.randint(1, 10)}" if signals.endswith("twice") else ""
        inject = f"inject={CALLS}:signal={signal}:when={when}{step}"
        run = bench.run(
            name, out, "strace", "-o", "/dev/null", "-e", f"trace={CALLS}", "-e", inject
        )
        assert_in_order(bench, name, out, run, INTERRUPTED[signal])
        if name not in ("study", "optimize"):
            continue
        again = bench.run(name, out)  # Goes on, or begins again.
        assert again.returncode == 0, again.stderr
        assert_in_order(bench, name, out, again)
        assert contents(out).keys() == bench.undisturbed(name).keys()


@pytest.mark.parametrize("name", ["study", "merge"])
def test_a_signal_while_results_are_written_leaves_no_lock(bench: Bench, name: str) -> None:
    if not tracing():
        pytest.skip("no strace")
    out = bench.output()
    inject = "inject=rename:signal=INT:when=1"
    run = bench.run(
        name, out, "strace", "-f", "-o", "/dev/null", "-e", "trace=rename", "-e", inject
    )
    assert run.returncode == 130, run.stderr
    assert not (out / "study.lock").exists()
    assert ("the same command continues from there" in run.stderr) == (name == "study")


# Names, locks and leftovers


def run_prs(
    folder: Path, *words: str, before: tuple[str, ...] = (), env: dict[str, str] | None = None
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*before, program(), *words],
        cwd=folder,
        env={**os.environ, "PRS_CACHE_DIR": "", **(env or {})},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )


def test_a_percent_sign_in_a_name_is_drawn(bench: Bench) -> None:
    out = bench.output()
    name = "load_cases[0].name=pull 50 %"
    lesson = "09_slip_and_dissipation.yaml"
    words = ("slip", lesson, "--set", name, "--output", str(out), "--quiet")
    run = run_prs(bench.folder, *words)
    assert (run.returncode, run.stderr) == (0, "")
    assert "pull 50 %<" in (out / "plots" / "power_by_source.svg").read_text()


def test_a_line_end_in_a_name_is_a_blank(bench: Bench) -> None:
    run = run_prs(bench.folder, "check", "no\nsuch/case.yaml")
    assert (run.returncode, run.stderr.count("\n")) == (2, 1), run.stderr
    assert run.stderr.startswith("no such/case.yaml:1:1: error: ")
    written = bench.output() / "a\nb.yaml"
    run = run_prs(bench.folder, "new", "standard", str(written))
    assert (run.returncode, run.stderr.count("\n")) == (0, 1), run.stderr
    assert written.exists()


def test_a_candidate_is_printed_alone(bench: Bench) -> None:
    file = bench.output() / "screw.yaml"
    written = ("--write", "1", str(file), "--write", "1", "-")
    run = run_prs(bench.folder, "size", "32_press.yaml", *written)
    assert run.returncode in (0, 3), run.stderr
    assert run.stdout == file.read_text()


def test_a_page_that_cannot_be_written_leaves_no_temporary_folder(bench: Bench) -> None:
    out = bench.output()
    limit = (shutil.which("prlimit") or "", "--fsize=1000")
    page = ("explore", "05_standard_screw.yaml")
    run = run_prs(bench.folder, *page, before=limit, env={"TMPDIR": str(out)})
    if "the engine of live pages" in run.stderr:
        pytest.skip(run.stderr)
    assert run.returncode == 1, run.stderr
    assert list(out.iterdir()) == []


def dead_process() -> int:
    process = subprocess.Popen(["true"])
    process.wait()
    return process.pid


def test_a_folder_in_use_is_told_and_left_alone(bench: Bench) -> None:
    out = bench.output()
    assert bench.run("solve", out).returncode == 0
    before = contents(out)
    words = ("contact", "05_standard_screw.yaml", "--output", str(out), "--quiet")
    with open(out / "study.lock", "w+") as lock:
        lock.write(f"{os.getpid()}\nprs slip\nof another case\n")
        lock.flush()
        fcntl.flock(lock, fcntl.LOCK_EX)
        run = run_prs(bench.folder, *words)
        assert run.returncode == 2
        assert f"(prs slip, number {os.getpid()})" in run.stderr
        assert told(run)
        (out / "study.lock").unlink()
        assert contents(out) == before
    # Of a run that was killed.
    (out / "study.lock").write_text(f"{dead_process()}\nprs slip\nof another case\n")
    assert run_prs(bench.folder, *words).returncode == 0
    assert not (out / "study.lock").exists()


def test_what_killed_runs_left_goes_and_other_files_stay(bench: Bench) -> None:
    out = bench.output()
    (out / "plots").mkdir(parents=True)
    left = [out / f"{name}.{dead_process()}-0.tmp" for name in ("plots/power.svg", "slip.csv")]
    mine = [out / f"slip.csv.{os.getpid()}-0.tmp", out / "my.tmp", out / "a.1-x.tmp"]
    for file in (*left, *mine):
        file.write_text("x")
    assert bench.run("solve", out).returncode == 0
    assert [file for file in left if file.exists()] == []
    assert [file for file in mine if not file.exists()] == []


LIVES = "study: {command: life, factors: [{path: mechanism.rollers, values: [9, 10]}]}\n"


def crc32c(data: bytes) -> int:
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


def forged(journal: bytes, recorded: str, other: str) -> bytes:
    """A sound journal whose header has another override."""

    def text(content: str) -> bytes:
        return struct.pack("<Q", len(content)) + content.encode()

    (length,) = struct.unpack("<Q", journal[8:16])
    assert text(recorded) in journal[16 : length + 8]
    head = journal[16:length].replace(text(recorded), text(other))
    sealed = struct.pack("<Q", len(head) + 16) + head
    return journal[:8] + sealed + struct.pack("<Q", crc32c(sealed)) + journal[8 + length :]


def test_a_journal_of_lives_is_merged_without_opening_what_it_names(tmp_path: Path) -> None:
    history = tmp_path / "history.csv"
    shutil.copy(CONFIGS / "14_flight_spectrum.csv", history)
    lesson = (CONFIGS / "14_flight_spectrum.yaml").read_text()
    (tmp_path / "lives.yaml").write_text(lesson + LIVES)
    named = f"life.history.file={history}"
    study = ("study", "lives.yaml", "--set", named, "--quiet", "--output")
    assert run_prs(tmp_path, *study, "alone").returncode == 0
    assert run_prs(tmp_path, *study, "part", "--shard", "1/1").returncode == 0
    history.rename(tmp_path / "elsewhere.csv")
    merge = ("study", "merge", "part", "--quiet", "--output", "merged")
    merged = run_prs(tmp_path, *merge)
    assert merged.returncode == 0, merged.stderr
    ours, alone = ((tmp_path / folder / "study.csv").read_text() for folder in ("merged", "alone"))
    assert ours == alone

    journal = tmp_path / "part" / "study.1-of-1.journal"
    secret = tmp_path / "secret.csv"
    secret.write_text("secret")
    journal.write_bytes(forged(journal.read_bytes(), named, f"life.history.file={secret}"))
    if not tracing():
        pytest.skip("no strace")
    log = tmp_path / "trace"
    strace = (shutil.which("strace") or "", "-f", "-o", str(log), "-e", "trace=openat,open")
    run = run_prs(tmp_path, *merge, before=strace)
    assert (run.returncode, told(run)) == (2, True), run.stderr
    assert "study.1-of-1.journal" in log.read_text()
    assert "secret" not in log.read_text()


def test_missing_lessons_and_temporary_folders_are_told(tmp_path: Path) -> None:
    (tmp_path / "lessons").mkdir()
    new = ("new", "--lesson", "1", "case.yaml")
    run = run_prs(tmp_path, *new, env={"PRS_SHARE": str(tmp_path)})
    assert (run.returncode, told(run)) == (1, True), run.stderr
    assert "PRS_SHARE" in run.stderr
    lesson = str(CONFIGS / "15_sensitivity.yaml")
    run = run_prs(tmp_path, "study", lesson, env={"TMPDIR": "/nope"})
    assert (run.returncode, told(run)) == (1, True), run.stderr
    assert "TMPDIR: got /nope" in run.stderr


def test_what_did_not_converge_is_told_beside_a_document(bench: Bench) -> None:
    text = (bench.folder / "01_config_1_to_3.yaml").read_text() + OPTIMIZE
    limit = "  constraints: [{response: axial_stiffness_N_per_um, at_least: 1e9}]\n"
    (bench.folder / "limited.yaml").write_text(text + limit)
    run = run_prs(bench.folder, "optimize", "limited.yaml", "--json")
    assert run.returncode == 3, run.stderr
    assert "No design keeps all constraints" in run.stderr
    slip = ("report", "09_slip_and_dissipation.yaml", "--static", "--output", "page.html")
    jammed = ("--set", "carrier.nut_torque=150 N m", "--set", "load_cases[0].axial_force=80 kN")
    run = run_prs(bench.folder, *slip, *jammed)
    assert run.returncode == 3, run.stderr
    assert "slip did not converge" in run.stderr


@pytest.mark.parametrize("name", ["study", "optimize"])
def test_scarce_memory_ends_with_a_message(bench: Bench, name: str) -> None:
    lesson = {
        "study": ("15_sensitivity.yaml", "--restart"),
        "optimize": ("23_crowning.yaml", "--set", "optimize.generations=3"),
    }[name]
    for more in range(16, 72) if THOROUGH else {"study": (60,), "optimize": (42,)}[name]:
        limit = (shutil.which("prlimit") or "", f"--as={least_memory() + (more << 20)}")
        words = (name, *lesson, "--threads", "2", "--quiet", "--output", str(bench.output()))
        run = run_prs(bench.folder, *words, before=limit)
        assert run.returncode in (0, 1, 127), (more, run.returncode, run.stderr)
        assert run.returncode != 1 or "error: " in run.stderr, run.stderr
