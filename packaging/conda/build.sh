#!/usr/bin/env bash
# What the recipe runs in a copy of the sources with libcsv/ and spectra/: PREFIX is where the libraries are
# and the program goes.
set -euo pipefail
own=$PWD/build/conda/own  # Of the build alone.
mkdir -p "$own/include" "$own/lib"
"${CC:-cc}" -O2 -fPIC -c libcsv/libcsv.c -I libcsv -o "$own/libcsv.o"
"${AR:-ar}" rcs "$own/lib/libcsv.a" "$own/libcsv.o"
cp libcsv/csv.h "$own/include"
cmake -S spectra -B build/conda/spectra -G Ninja -DCMAKE_INSTALL_PREFIX="$own" -DCMAKE_PREFIX_PATH="$PREFIX" >/dev/null
cmake --install build/conda/spectra >/dev/null

cmake -S . -B build/conda/prs -G Ninja -DCMAKE_BUILD_TYPE=Release -DPRS_BUILD_TESTS=OFF -DCMAKE_UNITY_BUILD=ON \
  -DCMAKE_PREFIX_PATH="$own;$PREFIX" -DCMAKE_INSTALL_PREFIX="$PREFIX" -DCMAKE_INSTALL_LIBDIR=lib
cmake --build build/conda/prs --target prs
cmake --install build/conda/prs --component program --strip
