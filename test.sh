#!/bin/sh
# Installs what is missing, builds everything with warnings as errors and runs all tests.
set -eu
cd "$(dirname "$0")"
scripts/install-dependencies test
cmake --preset dev
cmake --build --preset dev
ctest --test-dir build/dev --output-on-failure --parallel 2 "$@"
