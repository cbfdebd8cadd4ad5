"""Cameras, images in device memory, and the frames made of them."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, Dict, Optional, Sequence, Tuple, Union

import numpy as np

from ._library import check, enumerator, ffi, invalid, lib, new

if TYPE_CHECKING:
    import pyopencl
    import pyopencl.array

_FORMATS = ("float32", "float16", "uint32", "image_object")
_SUMS = ("no_sum", "count_in_fourth", "over_sample_count")
_DEPTH_KINDS = ("view", "negative_view", "ray", "hyperbolic", "reversed")


def _images_of(struct: str) -> Tuple[str, ...]:
    return tuple(name for name, field in ffi.typeof(struct).fields if field.type is ffi.typeof("quell_image_view"))


#: Names of the images that a frame may have, and of its outputs. What each holds, in which unit and range, says
#: quell/frame_images.h and the table in Quell's README.
INPUTS = _images_of("quell_frame")
OUTPUTS = _images_of("quell_output")


@dataclasses.dataclass
class Camera:
    """This frame's camera.

    Matrices are 4x4, by rows, for column vectors, from world to clip space, without jitter; NDC x right, y up.
    """

    world_to_clip: Any
    world_to_clip_prev: Any = None  #: None: the denoiser remembers that of the frame before
    jitter: Sequence[float] = (0.0, 0.0)  #: sample position minus pixel centre, pixels, x right, y down, in [-1, 1]

    def _fill(self, camera: Any) -> None:
        for name in ("world_to_clip", "world_to_clip_prev"):
            given = getattr(self, name)
            if given is None:
                continue
            matrix = np.asarray(given, dtype=np.float64)
            if matrix.shape not in ((4, 4), (16,)):
                raise invalid("Camera", name, "a 4x4 matrix", f"shape {matrix.shape}")
            setattr(camera, {"world_to_clip": "worldToClip", "world_to_clip_prev": "worldToClipPrev"}[name],
                    matrix.ravel().tolist())
        camera.jitterPx = [float(pixels) for pixels in self.jitter]


def look_at(eye: Sequence[float], target: Sequence[float], up: Sequence[float] = (0.0, 1.0, 0.0),
            vertical_fov: float = 60.0, aspect: float = 1.0) -> Camera:
    """A pinhole camera at ``eye`` that looks at ``target``, both in scene units; the field of view in degrees, within (0, 180);
    aspect: width by height."""
    camera = ffi.new("quell_camera*")
    vectors = [ffi.new("double[3]", [float(number) for number in vector]) for vector in (eye, target, up)]
    check(lib.quellSetLookAt(camera, *vectors, vertical_fov, aspect))
    return Camera(np.array(list(camera.worldToClip)).reshape(4, 4))


@dataclasses.dataclass(frozen=True)
class View:
    """One image in a buffer or an OpenCL image object: row by row, pixel (0, 0) top left. Strides are in bytes."""

    memory: Optional["pyopencl.MemoryObjectHolder"]  #: may be None where only the layout matters: Denoiser.prepare
    channels: int  #: components used per pixel, 1 to 4
    format: str = "float32"  #: or "float16", "uint32" (object ids only), "image_object"
    offset: int = 0  #: of pixel (0, 0)
    pixel_stride: int = 0  #: from one pixel to the next; 0: packed
    row_pitch: int = 0  #: from one row to the next below it; 0: packed; negative: bottom-up
    sum: str = "no_sum"  #: or "count_in_fourth", "over_sample_count": what a pixel holds where samples are added up
    size: Optional[Tuple[int, int]] = None  #: width and height in pixels, where they are known

    def _fill(self, view: Any, name: str) -> None:
        view.memory = ffi.NULL if self.memory is None else ffi.cast("cl_mem", self.memory.int_ptr)
        view.format = enumerator("View", f"{name}.format", "QUELL_", _FORMATS, self.format)
        view.sum = enumerator("View", f"{name}.sum", "QUELL_", _SUMS, self.sum)
        view.channels = self.channels
        view.offsetBytes = self.offset
        view.pixelStrideBytes = self.pixel_stride
        view.rowPitchBytes = self.row_pitch


Image = Union[View, "pyopencl.Image", "pyopencl.array.Array"]


def packed(memory: Optional["pyopencl.MemoryObjectHolder"], channels: int, format: str = "float32") -> View:
    """A packed image at the start of a buffer."""
    return View(memory, channels, format)


def summed(view: View, sum: str = "count_in_fourth") -> View:
    """A view whose pixels are sums of samples: their number in the fourth component, or Frame.sample_count everywhere."""
    return dataclasses.replace(view, sum=sum)


def bottom_up(view: View, size: Tuple[int, int]) -> View:
    """The same memory with its rows bottom-up; ``view`` says where the memory's first row is."""
    if view.format == "image_object":
        return dataclasses.replace(view, row_pitch=-1)
    pitch = view.row_pitch or size[0] * (view.pixel_stride or view.channels * (2 if view.format == "float16" else 4))
    return dataclasses.replace(view, offset=view.offset + (size[1] - 1) * pitch, row_pitch=-pitch)


def array_layout(shape: Tuple[int, ...], strides: Tuple[int, ...], dtype: Any, name: str) -> View:
    """How an array of rows, columns and, if there are several, channels lies in memory."""
    if len(shape) not in (2, 3) or 0 in shape:
        raise invalid("Frame", name, "an array of shape (height, width) or (height, width, channels)", f"shape {shape}")
    kind = np.dtype(dtype).name
    if kind not in _FORMATS:
        raise invalid("Frame", name, "float32, float16 or, for object ids, uint32", kind)
    channels = shape[2] if len(shape) == 3 else 1
    if channels > 1 and strides[2] != np.dtype(dtype).itemsize:
        raise invalid("Frame", name, "the channels of a pixel beside each other", f"strides {strides}")
    return View(None, channels, kind, 0, strides[1], strides[0], size=(shape[1], shape[0]))


def as_view(image: Image, name: str) -> View:
    """What an image of the caller is; nothing is copied."""
    if isinstance(image, View):
        return image
    import pyopencl

    if isinstance(image, pyopencl.Image):
        return View(image, min(image.format.channel_count, 4), "image_object", size=(image.width, image.height))
    if hasattr(image, "base_data"):  # pyopencl.array.Array
        layout = array_layout(image.shape, image.strides, image.dtype, name)
        return dataclasses.replace(layout, memory=image.base_data,  # type: ignore[arg-type]
                                   offset=image.offset)
    raise invalid("Frame", name, "a pyopencl image or array, or a buffer in quell.packed() or quell.View",
                  type(image).__name__)


def _views(given: Dict[str, Image], known: Sequence[str], function: str) -> Dict[str, View]:
    for name in given:
        if name not in known:
            raise invalid(function, name, "one of " + ", ".join(known), "another name")
    return {name: as_view(image, name) for name, image in given.items() if image is not None}


class Frame:
    """Inputs of one frame: ``Frame(camera, radiance=..., normalWorld=..., positionWorld=..., albedo=...)``.

    Images are named as in INPUTS; they are pyopencl arrays of shape (height, width, channels), pyopencl images, or View.
    They are read until the event of Denoiser.denoise has completed.
    """

    def __init__(self, camera: Camera, *, size: Optional[Tuple[int, int]] = None, demodulated: bool = False,
                 depth_kind: str = "view", depth_near: float = 0.0, depth_far: float = 0.0,
                 motion_scale: Sequence[float] = (1.0, 1.0), sample_count: float = 1.0,
                 render_size: Optional[Tuple[int, int]] = None, **images: Image):
        self.camera = camera
        self.views = _views(images, INPUTS, "Frame")
        #: Width and height in pixels; by default those of an image that knows them.
        self.size = size or next((view.size for view in self.views.values() if view.size), None)
        self.demodulated = demodulated  #: light is divided by albedo and gloss colour already
        self.depth_kind = depth_kind  #: or "negative_view", "ray", "hyperbolic", "reversed"
        self.depth_near = depth_near  #: planes of depth buffers, scene units
        self.depth_far = depth_far  #: 0: infinitely far, of depth_kind "reversed" only
        self.motion_scale = motion_scale  #: motion times this is in pixels, x right, y down, previous minus current
        self.sample_count = sample_count  #: of images with the sum "over_sample_count"
        #: Dynamic resolution: width and height that this frame renders, from pixel (0, 0) on, up to ``size``; None: all of it.
        #: Denoiser.prepare must have had such a size, too.
        self.render_size = render_size

    def _struct(self) -> Any:
        if self.size is None:
            raise invalid("Frame", "size", "(width, height) in pixels where no image knows it", "None")
        frame = new("quell_frame")
        frame.width, frame.height = self.size
        frame.renderWidth, frame.renderHeight = self.render_size or (0, 0)
        self.camera._fill(frame.camera)
        frame.demodulated = bool(self.demodulated)
        frame.depthKind = enumerator("Frame", "depth_kind", "QUELL_DEPTH_", _DEPTH_KINDS, self.depth_kind)
        frame.depthNear, frame.depthFar = self.depth_near, self.depth_far
        frame.motionScale = [float(scale) for scale in self.motion_scale]
        frame.sampleCount = self.sample_count
        for name, view in self.views.items():
            view._fill(getattr(frame, name), name)
        return frame


class Output:
    """Outputs of one frame, either or both: ``linear`` radiance, and ``display``, which is encoded in [0, 1]."""

    def __init__(self, **images: Image):
        self.views = _views(images, OUTPUTS, "Output")

    def _struct(self) -> Any:
        output = new("quell_output")
        for name, view in self.views.items():
            view._fill(getattr(output, name), name)
        return output
