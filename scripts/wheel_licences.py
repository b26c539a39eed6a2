#!/usr/bin/env python3
"""Adds to a repaired wheel the licences of what it holds of others: shared libraries that
auditwheel put in and header libraries that became part of the programs, as Debian's packages have
them, and scripts of pages (web/licences.txt).

wheel_licences.py WHEEL. A bundled library that is not in the table below is an error.
"""

from __future__ import annotations

import re
import subprocess
import sys
from importlib.metadata import distribution
from pathlib import Path

from auditwheel.wheeltools import InWheelCtx

#: Licence by source package, without the version that some have in their name.
LIBRARIES = {
    "atlas": "BSD-3-Clause",
    "boost": "BSL-1.0",
    "gcc-": "GPL-3.0-or-later WITH GCC-exception-3.1",
    "lapack": "BSD-3-Clause",
    "metis": "Apache-2.0",
    "suitesparse": "(LGPL-2.1-or-later AND GPL-2.0-or-later)",
    "fmtlib": "MIT",
    "libcsv": "LGPL-2.1-or-later",
    "openblas": "BSD-3-Clause",
    "nettle": "(LGPL-3.0-or-later OR GPL-2.0-or-later)",
    "onetbb": "Apache-2.0",
    "pagmo": "(LGPL-3.0-or-later OR GPL-3.0-or-later)",
    "sundials": "BSD-3-Clause",
    "yaml-cpp": "MIT",
}
#: Header libraries: Debian's package and the licence.
HEADERS = {
    "libboost-dev": "BSL-1.0",
    "libcli11-dev": "BSD-3-Clause",
    "libeigen3-dev": "MPL-2.0",
    "libspectra-dev": "MPL-2.0",
    "libxsimd-dev": "BSD-3-Clause",
    "nlohmann-json3-dev": "MIT",
}
#: Of the scripts in pages.
PAGES = Path(__file__).resolve().parents[1] / "web" / "licences.txt"


def output(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def debian_package(library: Path) -> str:
    """The package that a library was taken from; auditwheel adds eight digits to its name."""
    name = re.sub(r"-[0-9a-f]{8}(?=\.so)", "", library.name)
    return output("dpkg-query", "-S", f"*/{name}").split(":")[0]


def source_package(package: str) -> str:
    return re.sub(
        r"[\d.]+$", "", output("dpkg-query", "-Wf", "${source:Package}\n", package).split()[0]
    )


def debian_copyright(package: str) -> str:
    return Path("/usr/share/doc", package, "copyright").read_text(encoding="utf-8")


def collect(libraries: list[Path]) -> tuple[dict[str, str], list[str]]:
    """Texts by name, and the licences in SPDX's words."""
    texts, licences = {}, ["BSD-3-Clause"]
    for library in libraries:
        package = debian_package(library)
        licence = LIBRARIES.get(source_package(package))
        if licence is None:
            sys.exit(
                f"wheel_licences: {library.name} of {package} is bundled; add its licence here, "
                "or exclude the library in scripts/package.sh"
            )
        texts[package] = debian_copyright(package)
        licences.append(licence)
    for package, licence in HEADERS.items():
        texts[package] = debian_copyright(package)
        licences.append(licence)
    nanobind = Path(str(distribution("nanobind").locate_file("nanobind"))).parent
    (licence_file,) = nanobind.glob("nanobind-*.dist-info/licenses/LICENSE")
    texts["pages"] = PAGES.read_text(encoding="utf-8")
    licences += ["MIT", "ISC"]
    texts["nanobind"] = licence_file.read_text(encoding="utf-8")
    return texts, list(dict.fromkeys(licences))


def main() -> None:
    wheel = Path(sys.argv[1])
    with InWheelCtx(wheel, wheel) as context:
        root = Path(context.path)
        (info,) = root.glob("*.dist-info")
        texts, licences = collect(sorted(root.glob("*.libs/*")))
        folder = info / "licenses" / "bundled"
        folder.mkdir(parents=True)
        for name, text in texts.items():
            (folder / name).write_text(text, encoding="utf-8")
        files = "".join(f"License-File: bundled/{name}\n" for name in texts)
        metadata = (info / "METADATA").read_text(encoding="utf-8")
        metadata, expressions = re.subn(
            "^License-Expression: .*\n",
            f"License-Expression: {' AND '.join(licences)}\n{files}",
            metadata,
            flags=re.MULTILINE,
        )
        assert expressions == 1, "no License-Expression in METADATA"
        (info / "METADATA").write_text(metadata, encoding="utf-8")
    print(f"{wheel.name}: {' AND '.join(licences)}")


if __name__ == "__main__":
    main()
