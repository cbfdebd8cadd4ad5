#!/usr/bin/env python3
"""A tour of the package, in cells as editors run them: a wall that is path-traced badly, denoised while the camera moves.

Run as it is, it prints figures; `moving_camera.py OUT` also writes the last frame as PPM pictures into the folder OUT.
"""
# %% The scene: a checkered wall at z = 0 with a lamp that moves, one noisy sample a pixel.
import pathlib
import sys

import numpy as np

import quell

WIDTH, HEIGHT, FRAMES = 320, 180, 12
FOV, ASPECT = 50.0, WIDTH / HEIGHT


def light(position, frame):
    """Irradiance of the wall without noise."""
    lamp = np.array([np.sin(0.1 * frame), 0.5, 1.0])
    to_lamp = lamp - position
    return 3.0 * to_lamp[..., 2:3] / np.linalg.norm(to_lamp, axis=-1, keepdims=True)**3


def trace(frame):
    """The camera, the images that the denoiser reads, and the picture without noise."""
    eye = np.array([0.05 * frame - 0.3, 0.0, 3.0])
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH] + 0.5
    half = np.tan(np.radians(FOV) / 2.0) * eye[2]
    position = np.stack([eye[0] + (2 * x / WIDTH - 1) * half * ASPECT, eye[1] + (1 - 2 * y / HEIGHT) * half,
                         np.zeros_like(x)], axis=-1)
    normal = np.zeros_like(position)
    normal[..., 2] = 1.0
    checks = (np.floor(4 * position[..., 0]) + np.floor(4 * position[..., 1])) % 2
    albedo = np.where(checks[..., None] > 0, [0.8, 0.7, 0.5], [0.2, 0.3, 0.4])
    clean = albedo * light(position, frame) / np.pi
    noise = np.random.default_rng(frame).exponential(size=(HEIGHT, WIDTH, 1))
    images = {"radiance": clean * noise, "normalWorld": normal, "positionWorld": position, "albedo": albedo}
    camera = quell.look_at(eye, eye - [0, 0, 1], vertical_fov=FOV, aspect=ASPECT)
    return camera, {name: image.astype(np.float32) for name, image in images.items()}, clean


# %% What there is to choose from.
for method, summary in quell.methods().items():
    print(f"{method:8s} {summary}")
settings = quell.Settings("quell", toneMap="aces")
print(settings, "reads", [name for name, need in settings.input_needs().items() if need.use != "unused"])

# %% Denoise. The first frame builds the kernels.
denoiser = quell.Denoiser(settings=settings, timers="device")
print(denoiser.queue.device.name)
for number in range(FRAMES):
    scene_camera, arrays, truth = trace(number)
    pictures = denoiser.denoise_arrays(scene_camera, **arrays)
    errors = [float(np.sqrt(np.mean((picture - truth)**2))) for picture in (arrays["radiance"], pictures["linear"])]
    print("frame {:2d}: RMSE {:.4f}, denoised {:.4f}".format(number, *errors))

# %% Where the time went.
times = denoiser.timings()
print(f"frame: {times['frame']['median_ms']:.2f} ms ({times['source']} times)")
for label, stage in times["stages"].items():
    print(f"  {label:28s} {stage['median_ms']:.3f} ms")

# %% Pictures.
if len(sys.argv) > 1:
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    shown = {"noisy": np.clip(arrays["radiance"], 0, 1)**(1 / 2.2), "denoised": pictures["display"]}
    for name, picture in shown.items():
        with open(folder / f"{name}.ppm", "wb") as file:
            file.write(b"P6 %d %d 255\n" % (WIDTH, HEIGHT))
            file.write((255 * picture + 0.5).astype(np.uint8).tobytes())
