#!/bin/sh
# Installs a build into a prefix, moves it, and builds and runs the programs of this folder against it, with CMake and
# with pkg-config: run.sh BUILD_DIR WORK_DIR SOURCE_DIR
set -eu
prefix=$2/prefix build=$2/build source=$3/tests/embedding
rm -rf "$2"
cmake --install "$1" --prefix "$2/installed" >/dev/null
mv "$2/installed" "$prefix"

cmake -S "$source" -B "$build" -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$build" >/dev/null
"$build/first_frame"
"$build/first_frame_c"
"$build/queues"

PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name quell.pc)")
export PKG_CONFIG_PATH
# shellcheck disable=SC2046
${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror -DCL_TARGET_OPENCL_VERSION=120 "$source/first_frame.c" \
  -o "$build/first_frame_pkg_config" $(pkg-config --cflags --libs quell)
"$build/first_frame_pkg_config"

"$prefix/bin/quell" --help >/dev/null
