#!/bin/sh
# Installs a build into a prefix, moves it, and builds and runs the programs of this folder against it, with CMake (the
# shared library and the static one, where both are there) and with pkg-config: run.sh BUILD_DIR WORK_DIR SOURCE_DIR
set -eu
prefix=$2/prefix source=$3/tests/embedding
rm -rf "$2"
cmake --install "$1" --prefix "$2/installed" >/dev/null
mv "$2/installed" "$prefix"

build_against_prefix() {
  cmake -S "$1" -B "$2" -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
  cmake --build "$2" >/dev/null
}
build_against_prefix "$source" "$2/cxx"
build_against_prefix "$source/c" "$2/c"
"$2/cxx/queues"
"$2/c/frame_loop"
for program in "$2"/cxx/first_frame* "$2"/c/first_frame*; do
  [ -d "$program" ] || "$program"
done

PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name quell.pc)")
LD_LIBRARY_PATH=$(pkg-config --variable=libdir "$PKG_CONFIG_PATH/quell.pc")
export PKG_CONFIG_PATH LD_LIBRARY_PATH
# shellcheck disable=SC2046
${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror -DCL_TARGET_OPENCL_VERSION=120 "$source/c/first_frame.c" \
  -o "$2/first_frame_pkg_config" $(pkg-config --cflags --libs quell)
"$2/first_frame_pkg_config"

"$prefix/bin/quell" --help >/dev/null
grep -q '^\.TH QUELL' "$(find "$prefix" -name quell.1)"
find "$prefix" -path '*doc/quell/LICENSE' | grep -q .
