#!/bin/sh
# Installs what is missing, builds everything with warnings as errors and runs all tests.
set -eu
cd "$(dirname "$0")"
scripts/install-dependencies test
cmake --preset test
cmake --build --preset test
ctest --test-dir build/test --output-on-failure --parallel 2 "$@"
