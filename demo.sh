#!/bin/sh
# Installs what is missing, builds the tool and denoises a real sequence on the OpenCL device at hand.
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
build/demo/quell denoise --input data/colonnade --output out/demo --copy-bandwidth --json out/demo/report.json \
  --no-cache "$@"
echo "look at out/demo/comparison_0015.png: noisy | denoised | reference"
