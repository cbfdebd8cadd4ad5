#!/bin/sh
# Installs what is missing, builds the tool, and traces and denoises a scene on the OpenCL device at hand.
set -eu
cd "$(dirname "$0")"
scripts/install-dependencies build
cmake --preset demo >build-log.txt 2>&1 || {
  cat build-log.txt
  exit 1
}
rm -f build-log.txt
echo "building, about two minutes on two cores"
NINJA_STATUS="%p, step %f of %t: " cmake --build --preset demo
# Without binaries of kernels for the next run: to give them, PoCL compiles every kernel twice.
build/demo/quell demo --scene roughness --size 640x360 --frames 16 --reference 32 --output out/demo \
  --json out/demo/report.json --no-cache "$@"
echo "without a browser: out/demo/comparison_0015.png, noisy | denoised | reference"
