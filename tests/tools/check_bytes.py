#!/usr/bin/env python3
"""Checks that the bytes that stages declare are those that their kernels touch: check_bytes.py QUELL PLUGIN FOLDER [RUNS]

Runs methods in Oclgrind with the plugin of touched_bytes_plugin.cpp, with and without background, with short and long
histories, and compares each stage of the last frame with what the report of the tool says. Where a stage leaves out the
sky above, what its taps touch there, up to a filter's reach beyond the horizon, is not counted. RUNS is how many of the runs
below to do, all if not given.
"""
import json
import os
import subprocess
import sys

WIDTH, HEIGHT = 64, 48
FRAMES = 2
RECORDS = ",surfaces,changeSums,changeSumsPrev,recentChange,recentChangePrev,changeWeights,lightSums,lightGain,gramTiles,fitRecords,moments,windowMoments,coefficients,windowCoefficients,boxInput,boxOutput,cellConfidence,windowConfidence,"
TOLERANCE = 0.05  # of the declared bytes
TILES = 64  # bytes: where surfaces end within a row of tiles
CELLS = 1024  # bytes: rows of cells are shorter than a vector here
LONG = ["--set", "temporalVarianceFrames=1"]  # every history is long enough for the variance over time
STILL = ["--set", "changeThreshold=100"]  # noise never counts as change
RUNS = [  # those with most stages first
    ["--method", "quell", *STILL, *LONG, "--sky-share", "0.6"],
    ["--method", "bmfr", "--set", "solver=gram", "--sky-share", "0.5"],
    ["--method", "quell", *STILL],
    ["--method", "svgf", "--sky-share", "0.5", *LONG],
    ["--method", "guided", "--sky-share", "0.5", "--set", "subsampling=1", "--set", "radius=2"],  # wider, loads reach beyond so small a grid
    ["--method", "edagi"],
    ["--method", "atrous"],
]
BUILD = "-cl-opt-disable -DQUELL_PLAIN_INLINE -DQUELL_F_BETA_SAMPLES=1"


def sky_rows(arguments):
    share = float(arguments[arguments.index("--sky-share") + 1]) if "--sky-share" in arguments else 0.0
    return round(share * HEIGHT)


def run(tool, plugin, folder, arguments):
    """The stages of the report, and as many launches of the last frame, both in order."""
    counts, report = os.path.join(folder, "touched.jsonl"), os.path.join(folder, "report.json")
    environment = dict(os.environ, TOUCHED_BYTES=counts, TOUCHED_RECORDS=RECORDS, TOUCHED_IMAGE=f"{WIDTH}x{HEIGHT}+{sky_rows(arguments)}", OCLGRIND_PLUGINS=plugin)
    command = ["oclgrind", "--build-options", BUILD, tool, "denoise", "--device", "oclgrind", "--no-cache", "--mapping",
               "wide16", "--timers", "host", "--size", f"{WIDTH}x{HEIGHT}", "--frame-count", str(FRAMES), "--still-camera", "--json", report]
    subprocess.run(command + arguments, env=environment, check=True, stdout=subprocess.DEVNULL)
    with open(report) as file:
        stages = json.load(file)["stages"]
    with open(counts) as file:
        launches = [json.loads(line) for line in file]
    return stages, launches[-len(stages):]


def main():
    tool, plugin, folder = sys.argv[1:4]
    runs = RUNS[:int(sys.argv[4])] if len(sys.argv) > 4 else RUNS
    os.makedirs(folder, exist_ok=True)
    worst = 0.0
    for arguments in runs:
        print(" ".join(arguments))
        for stage, launch in zip(*run(tool, plugin, folder, arguments)):
            assert stage["name"] == launch["kernel"], (stage["name"], launch["kernel"])
            leaves_out_sky = "skipped_share" in stage and stage["name"] != "background"
            touched = sum(a.get("read", 0) + a.get("written", 0) - (a.get("above", 0) if leaves_out_sky else 0)
                          for a in launch["arguments"])
            error = touched / stage["bytes"] - 1.0
            if abs(touched - stage["bytes"]) <= TILES or touched <= CELLS:
                error = 0.0
            worst = max(worst, abs(error))
            wrong = abs(error) > TOLERANCE
            print(f"  {stage['label']:<28}{stage['bytes']:>9.0f} declared {touched:>9} touched {error:>+8.1%}{'  WRONG' if wrong else ''}")
            if wrong:
                for a in launch["arguments"]:
                    print("      ", a["name"], a.get("size"), a.get("read"), a.get("written"))
    print(f"largest difference {worst:.1%}, allowed {TOLERANCE:.0%}")
    return 0 if worst <= TOLERANCE else 1


if __name__ == "__main__":
    sys.exit(main())
