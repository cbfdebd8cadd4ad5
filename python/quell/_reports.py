"""What the denoiser says about frames: checks, times, background."""
from __future__ import annotations

import dataclasses
import os
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Union

import numpy as np

from ._devices import make_queue
from ._library import ffi, filled, handle, lib, text

if TYPE_CHECKING:
    import pyopencl

Statistics = Dict[str, Any]


@dataclasses.dataclass(frozen=True)
class Finding:
    """One thing that is odd about a frame; ``str()`` is a sentence made of all the fields."""

    kind: str  #: for example "camera-transposed"; docs/check.md lists them all
    severity: str  #: "note", "doubtful" or "wrong"
    image: str  #: the image that it is about
    expected: str
    got: str  #: what was measured, with units
    cure: str  #: what most likely sets it right
    pixels: int  #: how many show it; 0 where it is about the frame as a whole
    sentence: str

    def __str__(self) -> str:
        return self.sentence


@dataclasses.dataclass(frozen=True)
class FrameCheck:
    """What a check of a frame found out."""

    worst: str  #: severity of the findings; "note" if there are none
    findings: List[Finding]  #: causes before what follows from them
    figures: Dict[str, float]  #: what was measured, by name with its unit: "surface share, %"


@dataclasses.dataclass(frozen=True)
class BackgroundMap:
    """What a frame left out because it is background."""

    background: np.ndarray  #: bool, of shape (rows, work-items across): all pixels of the work-item are background
    item_width: int  #: pixels of a row that one work-item takes, 1 or 16
    share: float  #: of the work-items that are left out, 0 to 1
    stages: List[str]  #: those that leave them out


@dataclasses.dataclass(frozen=True)
class CaptureState:
    """What has become of a capture for a bug report."""

    directory: str  #: the folder of the latest prepare(); empty: nothing is captured
    frames: int  #: that are written there; the others may still be pending
    problem: str  #: a sentence on what ended the capture early; empty: nothing did


@dataclasses.dataclass(frozen=True)
class Replay:
    """Captured frames, run once more; ``str()`` has a line a frame, and what differs."""

    equal: bool  #: all outputs are those that were captured, bit for bit
    frames: int  #: of all folders
    differences: int  #: facts, such as device and driver, that are not the same as where they were captured
    text: str

    def __str__(self) -> str:
        return self.text


def replay(directory: Union[str, "os.PathLike[str]"], queue: Optional["pyopencl.CommandQueue"] = None,
           cache_directory: Optional[str] = None) -> Replay:
    """Runs a captured folder, or all of them that lie in a folder (``capture_directory``, $QUELL_CAPTURE), once more on
    ``queue``, or on a device of the library's choice; blocks. ``cache_directory`` as in Denoiser. Raises
    Error("FileError") for folders that are no captures or are damaged."""
    queue = queue if queue is not None else make_queue()
    found = filled(lib.quellReplay, "quell_replay", os.fsencode(directory), handle("cl_context", queue.context),
                   handle("cl_device_id", queue.device), handle("cl_command_queue", queue),
                   ffi.NULL if cache_directory is None else os.fsencode(cache_directory))
    return Replay(bool(found.equal), found.frameCount, found.differenceCount, text(found.text))


def _finding(denoiser: Any, index: int) -> Finding:
    found = filled(lib.quellGetFinding, "quell_finding", denoiser, index)
    return Finding(text(found.kind), text(lib.quellSeverityName(found.severity)), text(found.image), text(found.expected),
                   text(found.got), text(found.cure), found.pixels, text(found.sentence))


def read_check(denoiser: Any, check: Any) -> FrameCheck:
    """The parts of a check that has just been made."""
    figures = {}
    for index in range(check.figureCount):
        figure = filled(lib.quellGetCheckFigure, "quell_check_figure", denoiser, index)
        figures[", ".join(filter(None, (text(figure.name), text(figure.unit))))] = figure.value
    findings = [_finding(denoiser, index) for index in range(check.findingCount)]
    return FrameCheck(text(lib.quellSeverityName(check.worst)), findings, figures)


def _statistics(time: Any) -> Statistics:
    return {"count": time.count, "median_ms": time.medianMs, "mean_ms": time.meanMs, "min_ms": time.minMs,
            "max_ms": time.maxMs}


def read_timings(denoiser: Any) -> Dict[str, Any]:
    """Times as of Denoiser.timings()."""
    timings = filled(lib.quellGetTimings, "quell_timings", denoiser)
    stages = {}
    for index in range(timings.stageCount):
        stage = filled(lib.quellGetStageTimings, "quell_stage_timings", denoiser, index)
        stages[text(stage.label)] = {**_statistics(stage.time), "bytes_moved": stage.bytesMoved,
                                     "skipped_share": stage.skippedShare if stage.hasSkippedShare else None}
    source = "device" if timings.source == lib.QUELL_TIME_DEVICE else "host"
    return {"source": source, "frame": _statistics(timings.frame), "stages": stages}
