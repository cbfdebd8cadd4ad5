#!/bin/sh
# Installs what is missing, builds Quell and denoises a real sequence on the OpenCL device at hand.
set -eu
cd "$(dirname "$0")"
scripts/install-dependencies build
cmake --preset release >build-log.txt 2>&1 && cmake --build --preset release >>build-log.txt 2>&1 || {
  cat build-log.txt
  exit 1
}
rm -f build-log.txt
build/release/quell denoise --input data/colonnade --output out/demo --copy-bandwidth --json out/demo/report.json "$@"
echo "look at out/demo/comparison_0015.png: noisy | denoised | reference"
