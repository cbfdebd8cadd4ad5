"""The denoiser: works on the caller's queue and images; or on numpy arrays, which it brings to the device and back."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from ._arrays import ArrayImages
from ._devices import make_queue
from ._images import OUTPUTS, Camera, Frame, Output
from ._library import check, enumerator, ffi, filled, handle, lib, new, text, value
from ._reports import BackgroundMap, CaptureState, FrameCheck, read_check, read_timings
from ._settings import Settings, as_settings

if TYPE_CHECKING:
    import pyopencl

_TIMERS = ("off", "device", "host")
_KERNEL_STATES = ("missing", "cached", "built")  # as QUELL_KERNEL_MISSING and so on
Progress = Callable[[str, int, int], None]

_MAPPINGS = ("automatic", "narrow", "wide", "wide_4", "wide_8", "wide_16")


class Denoiser:
    """Denoises a sequence of frames on one queue; may be used from several threads by turns, not at once.

    queue: a pyopencl queue; None: one on a device of the library's choice.
    settings: Settings, a method's name, or a mapping of settings of the default method.
    timers: "off", "device" (needs a profiling queue) or "host".
    mapping: "automatic", "narrow", "wide", "wide_4", "wide_8" or "wide_16".
    work_group: of per-pixel kernels, work-items in x and y; fit_group: work-items per block of the fit; 0: chosen.
    cache_directory: of compiled kernels; None: the user's; "": none.
    kept_buffers: intermediate buffers for read_buffer().
    capture_directory: folder for bug reports, see capture_state(); None: $QUELL_CAPTURE; "": none. Of the frames after each
    prepare() capture_skip are left out, and then capture_frames written (0: 8).
    """

    def __init__(self, queue: Optional["pyopencl.CommandQueue"] = None,
                 settings: Union[Settings, str, Mapping[str, Any], None] = None, *, timers: str = "off",
                 mapping: str = "automatic", work_group: Tuple[int, int] = (0, 0), fit_group: int = 0,
                 cache_directory: Optional[str] = None, kept_buffers: Sequence[str] = (),
                 capture_directory: Optional[str] = None, capture_frames: int = 0, capture_skip: int = 0):
        self.queue = queue if queue is not None else make_queue()
        options = new("quell_options")
        options.timers = enumerator("Denoiser", "timers", "QUELL_TIMERS_", _TIMERS, timers)
        options.mapping = enumerator("Denoiser", "mapping", "QUELL_MAPPING_", _MAPPINGS, mapping)
        options.workGroup = list(work_group)
        options.fitGroup = fit_group
        texts = [ffi.new("char[]", given.encode()) for given in (cache_directory or "", ",".join(kept_buffers),
                                                                     capture_directory or "")]
        options.cacheDirectory = ffi.NULL if cache_directory is None else texts[0]
        options.keptBuffers = texts[1]
        options.captureDirectory = ffi.NULL if capture_directory is None else texts[2]
        options.captureFrames, options.captureSkip = capture_frames, capture_skip
        made = value(lib.quellCreateDenoiser, "quell_denoiser*", handle("cl_context", self.queue.context),
                     handle("cl_device_id", self.queue.device), handle("cl_command_queue", self.queue),
                     as_settings(settings)._handle, options)
        self._handle = ffi.gc(made, lib.quellDestroyDenoiser)
        self._arrays: Optional[ArrayImages] = None
        self._progress: Any = None  # the callback of the latest preparation

    @property
    def settings(self) -> Settings:
        """A copy of the denoiser's settings."""
        copy = Settings()
        copy._handle = ffi.gc(value(lib.quellGetDenoiserSettings, "quell_settings*", self._handle),
                              lib.quellDestroySettings)
        return copy

    def prepare(self, frame: Frame, output: Output, *, keep_history: bool = False, settings: Optional[Settings] = None,
                progress: Optional[Progress] = None) -> None:
        """Builds all kernels for these layouts, allocates all memory and warms up; blocks. May be called again for other
        sizes or layouts; the history is reset, or what can be kept is (``keep_history``), resampled after a change of size.
        ``settings``, of the same method, replace those before. ``progress(stage, done, total)`` is called as it goes on,
        and may call cancel_prepare()."""
        options = self._prepare_options(keep_history, settings, progress)
        check(lib.quellPrepareWith(self._handle, frame._struct(), output._struct(), options))

    def prepare_async(self, frame: Frame, output: Output, *, keep_history: bool = False,
                      settings: Optional[Settings] = None, progress: Optional[Progress] = None) -> None:
        """The same on a thread of the library's, which returns at once. What it fails with is raised by the next is_ready()
        or denoise(), once."""
        options = self._prepare_options(keep_history, settings, progress)
        check(lib.quellPrepareAsync(self._handle, frame._struct(), output._struct(), options))

    def is_ready(self) -> bool:
        """Whether denoise() may be called; does not block."""
        return bool(value(lib.quellIsReady, "int", self._handle))

    def cancel_prepare(self) -> None:
        """Ends a preparation after the program that is being compiled, from any thread: it raises Error("NotPrepared")."""
        check(lib.quellCancelPrepare(self._handle))

    def set_settings(self, settings: Settings) -> None:
        """Takes other values of the same method from the next frame on; the history stays, nothing blocks. Raises
        Error("NotPrepared") naming the settings that need prepare(), and changes nothing then."""
        check(lib.quellSetSettings(self._handle, settings._handle))

    def capture_state(self) -> CaptureState:
        """What was written of ``capture_directory`` so far."""
        state = filled(lib.quellGetCaptureState, "quell_capture_state", self._handle)
        return CaptureState(text(state.directory), state.frames, text(state.problem))

    def kernel_states(self, frame: Frame, output: Output) -> Dict[str, str]:
        """Where prepare() would have the machine code of each stage from, by the stage's label: "missing" (is compiled),
        "cached" (on disk or in this process) or "built" (by this denoiser). Compiles nothing."""
        states = {}
        for index in range(value(lib.quellCountStageKernels, "size_t", self._handle, frame._struct(), output._struct())):
            kernel = filled(lib.quellGetStageKernel, "quell_stage_kernel", self._handle, index)
            states[text(kernel.stage)] = _KERNEL_STATES[kernel.state]
        return states

    def denoise(self, frame: Frame, output: Output, wait_for: Sequence["pyopencl.Event"] = (),
                queue: Optional["pyopencl.CommandQueue"] = None) -> "pyopencl.Event":
        """Enqueues one frame, without copies and without blocking; returns the event of its end. Work starts when the
        events of ``wait_for`` have completed. ``queue``: another one of the same context and device for this frame."""
        import pyopencl

        done = value(lib.quellDenoiseOn, "cl_event", self._handle, handle("cl_command_queue", queue or self.queue),
                     frame._struct(), output._struct(), *self._wait_list(wait_for))
        return pyopencl.Event.from_int_ptr(int(ffi.cast("intptr_t", done)), retain=False)

    def denoise_arrays(self, camera: Camera, outputs: Sequence[str] = OUTPUTS, **images: Any) -> Dict[str, np.ndarray]:
        """One frame of numpy arrays, of shape (height, width) or (height, width, channels), float32, float16 or, for object
        ids, uint32; other arguments as those of Frame. Returns arrays of shape (height, width, 3), float32, by the names of
        ``outputs``. The first frame, and every one of another layout, prepares, which takes seconds and resets the
        history."""
        arrays = ArrayImages(self.queue, outputs, images)
        if self._arrays is not None and self._arrays.fits(arrays):
            arrays = self._arrays
        frame, output = arrays.upload(camera, images)
        if arrays is not self._arrays:
            self.prepare(frame, output)
            self._arrays = arrays
        self.denoise(frame, output)
        return arrays.download()

    def reset_history(self) -> None:
        """Forgets all earlier frames, as a cut needs it. Does not block."""
        check(lib.quellResetHistory(self._handle))

    def check(self, frame: Frame, wait_for: Sequence["pyopencl.Event"] = ()) -> FrameCheck:
        """Says what is odd about a frame, and the likely cure. For debugging: reads all images to the host and blocks;
        needs no prepare(). Frames are compared with the one checked before, so check them in a row."""
        found = new("quell_frame_check")
        check(lib.quellCheckFrame(self._handle, frame._struct(), *self._wait_list(wait_for), found))
        return read_check(self._handle, found)

    def timings(self) -> Dict[str, Any]:
        """Times of all frames that have finished so far; never waits for more. Milliseconds, over the latest 4096 frames:
        ``{"source": "device", "frame": {"count": ..., "median_ms": ...}, "stages": {label: {..., "bytes_moved": ...,
        "skipped_share": ...}}}``. Without timers, and before the first frame, there are no stages."""
        return read_timings(self._handle)

    def clear_timings(self) -> None:
        """Starts the statistics of timings() again."""
        check(lib.quellClearTimings(self._handle))

    def memory_use(self) -> Dict[str, int]:
        """Bytes of device memory held since prepare(), by buffer; the caller's images are not included."""
        return self._buffer_bytes(filled(lib.quellGetMemoryUse, "quell_memory_use", self._handle))

    def memory_needed(self, frame: Frame, output: Output) -> Dict[str, int]:
        """The same as prepare() would allocate it for these layouts; allocates and builds nothing."""
        return self._buffer_bytes(filled(lib.quellGetMemoryNeeded, "quell_memory_use", self._handle, frame._struct(),
                                         output._struct()))

    def buffer_names(self) -> List[str]:
        """The method's intermediate buffers, in the order in which a frame touches them; none before prepare()."""
        return [text(value(lib.quellGetBufferName, "const char*", self._handle, i))
                for i in range(value(lib.quellCountBuffers, "size_t", self._handle))]

    def read_buffer(self, name: str) -> np.ndarray:
        """An intermediate buffer as the latest frame has left it, float32, of shape (planes, height, width). Blocks. It
        must be among ``kept_buffers``, or a history."""
        content = filled(lambda *arguments: lib.quellReadBuffer(self._handle, name.encode(), ffi.NULL, 0, *arguments),
                         "quell_buffer_content")
        values = np.empty((content.planes, content.height, content.width), np.float32)
        check(lib.quellReadBuffer(self._handle, name.encode(), ffi.from_buffer("float[]", values), values.size, content))
        return values

    def background_map(self) -> BackgroundMap:
        """What the latest frame left out because it is background (setting ``skip``). Blocks until that frame is done."""
        found = new("quell_background_map")
        check(lib.quellGetBackgroundMap(self._handle, ffi.NULL, 0, found))
        background = np.zeros((found.rows, found.columns), np.uint8)
        check(lib.quellGetBackgroundMap(self._handle, ffi.from_buffer("unsigned char[]", background), background.size,
                                        found))
        stages = [text(value(lib.quellGetBackgroundStage, "const char*", self._handle, i))
                  for i in range(found.stageCount)]
        return BackgroundMap(background.astype(bool), found.itemWidth, found.share, stages)

    def _prepare_options(self, keep_history: bool, settings: Optional[Settings], progress: Optional[Progress]) -> Any:
        options = new("quell_prepare_options")
        options.keepHistory = keep_history
        options.settings = settings._handle if settings is not None else ffi.NULL
        if progress is not None:
            call = progress
            self._progress = ffi.callback("quell_prepare_callback",
                                          lambda stage, done, total, _: call(text(stage), done, total))
            options.progress = self._progress
        return options

    def _wait_list(self, events: Sequence["pyopencl.Event"]) -> Tuple[int, Any]:
        handles = ffi.new("cl_event[]", [handle("cl_event", event) for event in events])
        return len(events), handles

    def _buffer_bytes(self, use: Any) -> Dict[str, int]:
        parts = [filled(lib.quellGetBufferUse, "quell_buffer_use", self._handle, i) for i in range(use.bufferCount)]
        return {text(part.name): part.bytes for part in parts}

