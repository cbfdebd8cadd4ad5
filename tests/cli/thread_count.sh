#!/bin/sh
# The output hash does not depend on the number of PoCL's threads: thread_count.sh QUELL_TOOL WORK_DIR
set -eu
mkdir -p "$2"
for method in quell bmfr svgf edagi guided atrous; do
  for threads in 1 2; do
    POCL_MAX_PTHREAD_COUNT=$threads "$1" denoise --method $method --size 131x77 --frame-count 4 \
      --json "$2/$threads.json" >/dev/null 2>&1
  done
  one=$(grep output_hash "$2/1.json")
  two=$(grep output_hash "$2/2.json")
  echo "$method, 1 thread: $one"
  echo "$method, 2 threads: $two"
  [ "$one" = "$two" ]
done
