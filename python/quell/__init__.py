"""Quell removes the noise from real-time path tracing on any OpenCL device.

On a renderer's own queue and images, without copies::

    denoiser = quell.Denoiser(queue, quell.Settings("quell", taa=False))
    frame = quell.Frame(camera, radiance=radiance, normalWorld=normal, positionWorld=position, albedo=albedo)
    output = quell.Output(display=display)
    denoiser.prepare(frame, output)            # once
    event = denoiser.denoise(frame, output)    # every frame

With numpy arrays: ``quell.Denoiser().denoise_arrays(camera, radiance=..., ...)``. Sequences on disk: ``denoise_sequence`` and
``compare``. All failures are ``quell.Error``.
"""
from ._denoiser import Denoiser
from ._devices import Device, choose_device, devices, make_queue
from ._images import INPUTS, OUTPUTS, Camera, Frame, Output, View, bottom_up, look_at, packed, summed
from ._library import Error
from ._library import version as __version__
from ._reports import BackgroundMap, CaptureState, Finding, FrameCheck, Replay, replay
from ._settings import InputNeed, SettingInfo, Settings, describe, methods
from ._tool import compare, denoise_sequence

__all__ = [
    "BackgroundMap", "Camera", "CaptureState", "Denoiser", "Device", "Error", "Finding", "Frame", "FrameCheck", "INPUTS",
    "InputNeed", "OUTPUTS", "Output", "Replay", "SettingInfo", "Settings", "View", "bottom_up", "choose_device",
    "compare", "denoise_sequence", "describe", "devices", "look_at", "make_queue", "methods", "packed", "replay", "summed"
]
