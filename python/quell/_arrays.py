"""numpy arrays as images of a frame: buffers on the device that are filled and read again."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, Dict, Mapping, Sequence, Tuple

import numpy as np

from ._images import INPUTS, Camera, Frame, Output, View, array_layout, packed
from ._library import invalid

if TYPE_CHECKING:
    import pyopencl


class ArrayImages:
    """Device memory for arrays of one layout. ``arguments``: as of Frame, with arrays as images."""

    def __init__(self, queue: "pyopencl.CommandQueue", outputs: Sequence[str], arguments: Mapping[str, Any]):
        self._queue = queue
        self._layouts: Dict[str, View] = {}
        for name, array in arguments.items():
            if name in INPUTS and array is not None:
                self._layouts[name] = self._packed_layout(np.asarray(array), name)
        sizes = {name: view.size for name, view in self._layouts.items()}
        if len(set(sizes.values())) != 1:
            raise invalid("denoise_arrays", "images", "arrays of one height and width", str(sizes or "none"))
        self._outputs = tuple(outputs)
        self._others = {name: given for name, given in arguments.items() if name not in INPUTS}
        self._buffers: Dict[str, "pyopencl.Buffer"] = {}

    @staticmethod
    def _packed_layout(array: np.ndarray, name: str) -> View:
        packed_strides = np.empty(array.shape, array.dtype).strides
        return array_layout(array.shape, packed_strides, array.dtype, name)

    def _layout(self) -> Tuple[Any, ...]:
        fixed = {name: given for name, given in self._others.items() if name in ("demodulated", "depth_kind")}
        fixed["renders_parts"] = self._others.get("render_size") is not None
        return self._layouts, self._outputs, fixed

    def fits(self, other: "ArrayImages") -> bool:
        """Whether frames of the other can go through the memory of this one."""
        return self._layout() == other._layout()

    def upload(self, camera: Camera, arguments: Mapping[str, Any]) -> Tuple[Frame, Output]:
        """Enqueues the copies to the device."""
        import pyopencl

        others = {name: given for name, given in arguments.items() if name not in INPUTS}
        views = {}
        for name, layout in self._layouts.items():
            array = np.ascontiguousarray(arguments[name])
            if name not in self._buffers:
                self._buffers[name] = pyopencl.Buffer(self._queue.context, pyopencl.mem_flags.READ_ONLY, array.nbytes)
            pyopencl.enqueue_copy(self._queue, self._buffers[name], array, is_blocking=True)
            views[name] = dataclasses.replace(layout, memory=self._buffers[name])
        frame = Frame(camera, **{**others, **views})
        width, height = next(iter(self._layouts.values())).size or (0, 0)
        for name in self._outputs:
            if name not in self._buffers:
                self._buffers[name] = pyopencl.Buffer(self._queue.context, pyopencl.mem_flags.WRITE_ONLY,
                                                      width * height * 3 * 4)
        return frame, Output(**{name: packed(self._buffers[name], 3) for name in self._outputs})

    def download(self) -> Dict[str, np.ndarray]:
        """The outputs, once everything that was enqueued before is done."""
        import pyopencl

        width, height = next(iter(self._layouts.values())).size or (0, 0)
        arrays = {name: np.empty((height, width, 3), np.float32) for name in self._outputs}
        self._queue.finish()
        for name, array in arrays.items():
            pyopencl.enqueue_copy(self._queue, array, self._buffers[name], is_blocking=True)
        return arrays
