"""OpenCL devices, and a queue for those who have none."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, List

from ._library import ffi, filled, lib, text, value

if TYPE_CHECKING:
    import pyopencl


@dataclasses.dataclass(frozen=True)
class Device:
    """One OpenCL device."""

    index: int  #: over all platforms, in the order of enumeration
    platform: str
    name: str
    vendor: str
    version: str  #: OpenCL version text of the device
    driver_version: str
    type: str  #: "GPU", "CPU", "accelerator" or "other"
    compute_units: int
    local_memory_bytes: int  #: per work-group
    global_memory_bytes: int
    max_work_group: int  #: work-items
    images: bool
    half_arithmetic: bool
    profiling: bool
    int_ptr: int = dataclasses.field(repr=False, default=0)  #: the cl_device_id

    @property
    def cl(self) -> "pyopencl.Device":
        """The device as pyopencl has it."""
        import pyopencl

        return pyopencl.Device.from_int_ptr(self.int_ptr)


def _device(info: Any) -> Device:
    return Device(info.index, text(info.platformName), text(info.name), text(info.vendor), text(info.version),
                  text(info.driverVersion), text(info.type), info.computeUnits, info.localMemoryBytes,
                  info.globalMemoryBytes, info.maxWorkGroup, bool(info.images), bool(info.halfArithmetic),
                  bool(info.profiling), int(ffi.cast("intptr_t", info.device)))


def devices() -> List[Device]:
    """Devices of all platforms. Raises Error("NoDevice") if there are none, with a message that says what to install."""
    return [_device(filled(lib.quellGetDevice, "quell_device_info", i))
            for i in range(value(lib.quellCountDevices, "size_t"))]


def choose_device(spec: str = "") -> Device:
    """A device by an index or part of a device or platform name; "": a GPU if there is one, else an accelerator, else a CPU.
    Raises Error("NoDevice") if none fits."""
    return _device(filled(lib.quellChooseDevice, "quell_device_info", spec.encode()))


def make_queue(spec: str = "") -> "pyopencl.CommandQueue":
    """A profiling queue on a context of its own on a device that is chosen as above."""
    import pyopencl

    context = pyopencl.Context([choose_device(spec).cl])
    return pyopencl.CommandQueue(context, properties=pyopencl.command_queue_properties.PROFILING_ENABLE)
