#!/bin/sh
# Installs a build into a prefix and builds and runs the example against it: run.sh BUILD_DIR WORK_DIR SOURCE_DIR
set -eu
rm -rf "$2"
cmake --install "$1" --prefix "$2/prefix" >/dev/null
cmake -S "$3/tests/package" -B "$2/build" -DCMAKE_PREFIX_PATH="$2/prefix" >/dev/null
cmake --build "$2/build" >/dev/null
"$2/build/first_frame"
"$2/prefix/bin/quell" --help >/dev/null
