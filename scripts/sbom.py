#!/usr/bin/env python3
"""Software bill of materials: the libraries that a build uses, with their versions.

scripts/sbom.py [BUILD] > prs.cdx.json. CycloneDX 1.5 of what BUILD, by default build/release, was
compiled with (headers, by ninja's record of them) and loads (shared libraries), as Debian packages,
of the Python package's dependencies as they are installed in build/venv, and of the scripts of
pages.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DPKG = Path("/var/lib/dpkg/info")


def output(*command: str | Path) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def headers(build: Path) -> set[str]:
    """All headers of others that sources of the build include."""
    listed = output("ninja", "-C", build, "-t", "deps")
    return {str(Path(f).resolve()) for f in re.findall(r"^ +(/.*)$", listed, re.MULTILINE)}


def shared_libraries(build: Path) -> set[str]:
    """All libraries that the programs and their modules load."""
    programs = [build / "prs/cli/prs"]
    found: set[str] = set()
    for file in [*programs, *sorted((build / "lib/prs").glob("*.so"))]:
        if file.exists():
            listed = re.findall(r" => (/\S+)", output("ldd", file))
            found |= {str(Path(f).resolve()) for f in listed}
    return found


def packages(files: set[str]) -> set[str]:
    """The Debian packages that the files belong to."""
    found = set()
    for listing in DPKG.glob("*.list"):
        owned = (str(Path(f)) for f in listing.read_text().splitlines())
        if any(f in files or "/usr" + f in files for f in owned):
            found.add(listing.stem)
    return found


def debian_component(package: str) -> dict[str, str]:
    shown = "${Package}\t${Version}\t${Architecture}"
    name, version, architecture = output("dpkg-query", "-Wf", shown, package).split("\t")
    return {
        "type": "library",
        "name": name,
        "version": version,
        "purl": f"pkg:deb/debian/{name}@{version}?arch={architecture}",
    }


def python_components() -> list[dict[str, str]]:
    python = ROOT / "build/venv/bin/python"
    if not python.exists():
        return []
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    names = [re.match(r"[\w.-]+", text)[0] for text in project["dependencies"]]  # type: ignore[index]
    ask = "import sys, importlib.metadata as m; print(*map(m.version, sys.argv[1:]))"
    versions = output(python, "-c", ask, *names).split()
    return [
        {"type": "library", "name": n, "version": v, "purl": f"pkg:pypi/{n}@{v}"}
        for n, v in zip(names, versions)
    ]


def page_components() -> list[dict[str, str]]:
    """What is bundled into the scripts of pages."""
    packages = json.loads((ROOT / "web/package-lock.json").read_text())["packages"]
    names = {path: path.rpartition("node_modules/")[2] for path, p in packages.items() if path}
    return [
        {
            "type": "library",
            "name": name,
            "version": packages[path]["version"],
            "purl": f"pkg:npm/{name.replace('@', '%40')}@{packages[path]['version']}",
        }
        for path, name in names.items()
        if not packages[path].get("dev")
    ]


def bill(build: Path) -> dict[str, object]:
    used = packages(headers(build) | shared_libraries(build))
    version = re.search(r'kVersion = "(.*?)"', (ROOT / "prs/version.h").read_text())[1]  # type: ignore[index]
    components = [debian_component(package) for package in sorted(used)]
    components += python_components() + page_components()
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {"component": {"type": "application", "name": "prs", "version": version}},
        "components": components,
    }


if __name__ == "__main__":
    build = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build/release"
    print(json.dumps(bill(build), indent=1))
