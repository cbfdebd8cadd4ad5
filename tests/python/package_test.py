"""The Python package against the built library: same pictures by every path, errors in the library's words, reports.

Run by ctest with PYTHONPATH at the staged package; exits with 77 where a module that it needs is missing.
"""
import os
import pathlib
import sys
import tempfile
import unittest

try:
    import cffi  # noqa: F401
    import numpy as np
    import pyopencl as cl
    import pyopencl.array
except ImportError as missing:
    print(f"SKIPPED: {missing}; scripts/install-dependencies test installs it")
    sys.exit(77)

import quell

WIDTH, HEIGHT, FRAMES = 48, 20, 3
CONSTANT = 0.25  # radiance; 0.25^(1/2.2) in the display output
DATA = pathlib.Path(__file__).resolve().parents[2] / "data"


def scene(number):
    """A wall at z = -2 with a brighter half, noisy, and sky above: arrays by the names of images."""
    random = np.random.default_rng(number)
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    position = np.stack([(x + 0.5) / WIDTH * 4.0 - 2.0, 1.0 - (y + 0.5) / HEIGHT * 2.0, np.full(x.shape, -2.0)], -1)
    normal = np.zeros((HEIGHT, WIDTH, 3))
    normal[HEIGHT // 4:, :, 2] = 1.0  # without a normal above: background
    radiance = random.exponential(np.where(x < WIDTH // 2, 0.2, 0.5)[..., None] * np.ones(3))
    albedo = np.full((HEIGHT, WIDTH, 3), 0.5)
    arrays = {"radiance": radiance, "normalWorld": normal, "positionWorld": position, "albedo": albedo}
    return {name: array.astype(np.float32) for name, array in arrays.items()}


def camera():
    """Sees the wall of scene() to the pixel."""
    return quell.Camera(np.array([[1, 0, 0, 0], [0, 2, 0, 0], [0, 0, -1, -1], [0, 0, -1, 0]], float))


def denoiser(**options):
    """One on the device of the tests that leaves no files."""
    queue = quell.make_queue(os.environ.get("QUELL_TEST_DEVICE", ""))
    return quell.Denoiser(queue, quell.Settings("atrous", iterations=2), cache_directory="", **options)


class Pictures(unittest.TestCase):
    """Every path gives the same bits."""

    @classmethod
    def setUpClass(cls):
        cls.arrays = denoiser(timers="host", kept_buffers=["irradiance"])
        for number in range(FRAMES):
            cls.expected = cls.arrays.denoise_arrays(camera(), **scene(number))

    def test_denoised(self):
        wall = self.expected["linear"][HEIGHT // 4:, :WIDTH // 2]
        noisy = scene(FRAMES - 1)["radiance"][HEIGHT // 4:, :WIDTH // 2]
        self.assertLess(wall.std(), 0.5 * noisy.std())
        self.assertAlmostEqual(float(wall.mean()), 0.2, delta=0.03)

    def test_device_memory_without_copies(self):
        other = denoiser()
        linear = cl.array.zeros(other.queue, (HEIGHT, WIDTH, 3), np.float32)
        formats = cl.ImageFormat(cl.channel_order.RGBA, cl.channel_type.FLOAT)
        create_image = getattr(cl, "create_image", cl.Image)  # before pyopencl 2024
        display = create_image(other.queue.context, cl.mem_flags.WRITE_ONLY, formats, (WIDTH, HEIGHT))
        output = quell.Output(linear=linear, display=display)
        for number in range(FRAMES):
            images = {name: cl.array.to_device(other.queue, array) for name, array in scene(number).items()}
            images["albedo"] = quell.packed(images["albedo"].base_data, 3)  # a bare buffer
            frame = quell.Frame(camera(), **images)
            if number == 0:
                steps = []
                other.prepare_async(frame, output, progress=lambda stage, done, total: steps.append((done, total)))
                while not other.is_ready():
                    pass
                self.assertEqual(steps[-1][0], steps[-1][1])
            gate = cl.UserEvent(other.queue.context)
            queue = cl.CommandQueue(other.queue.context) if number == 1 else None
            done = other.denoise(frame, output, wait_for=[gate], queue=queue)
            self.assertNotEqual(done.command_execution_status, cl.command_execution_status.COMPLETE)
            gate.set_status(cl.command_execution_status.COMPLETE)
            done.wait()
        np.testing.assert_array_equal(linear.get(), self.expected["linear"])
        pixels = np.empty((HEIGHT, WIDTH, 4), np.float32)
        cl.enqueue_copy(other.queue, pixels, display, origin=(0, 0), region=(WIDTH, HEIGHT))
        np.testing.assert_array_equal(pixels[..., :3], self.expected["display"])

    def test_render_size(self):
        other = denoiser()
        size = (WIDTH // 2, HEIGHT)
        whole = quell.Output(linear=cl.array.zeros(other.queue, (HEIGHT, WIDTH, 3), np.float32))
        images = {name: cl.array.to_device(other.queue, array) for name, array in scene(0).items()}
        frame = quell.Frame(camera(), render_size=size, **images)
        other.prepare(frame, whole)
        self.assertEqual(set(other.kernel_states(frame, whole).values()), {"built"})
        other.denoise(frame, whole).wait()
        linear = whole.views["linear"].memory
        pixels = np.empty((HEIGHT, WIDTH, 3), np.float32)
        cl.enqueue_copy(other.queue, pixels, linear)
        self.assertTrue((pixels[:, size[0]:] == 0.0).all())
        self.assertGreater(pixels[HEIGHT // 2:, :size[0]].min(), 0.0)
        frame.render_size = (WIDTH + 1, HEIGHT)
        with self.assertRaises(quell.Error) as raised:
            other.denoise(frame, whole)
        self.assertEqual(raised.exception.buffer, "renderSize")

    def test_replay(self):
        with tempfile.TemporaryDirectory() as folder:
            captured = denoiser(capture_directory=folder, capture_frames=2)
            for number in range(FRAMES):
                captured.denoise_arrays(camera(), **scene(number))
            while captured.capture_state().frames < 2:  # files are written a little after the frames
                self.assertEqual(captured.capture_state().problem, "")
            replayed = quell.replay(folder, captured.queue, cache_directory="")
            self.assertTrue(replayed.equal, str(replayed))
            self.assertEqual((replayed.frames, replayed.differences), (2, 0))
            self.assertIn("bit for bit", str(replayed))
        with self.assertRaises(quell.Error) as raised:
            quell.replay("no/such/folder", captured.queue)
        self.assertEqual(raised.exception.code, "FileError")

    def test_reports(self):
        times = self.arrays.timings()
        while times["frame"]["count"] < FRAMES:  # callbacks may come a little after the queue has finished
            times = self.arrays.timings()
        self.assertEqual(times["source"], "host")
        self.assertGreater(times["stages"]["remodulate"]["median_ms"], 0.0)
        self.assertTrue(any(stage["skipped_share"] for stage in times["stages"].values()))
        self.assertGreater(sum(self.arrays.memory_use().values()), WIDTH * HEIGHT * 4)
        self.assertIn("irradiance", self.arrays.buffer_names())
        kept = self.arrays.read_buffer("irradiance")
        self.assertEqual(kept.shape, (3, HEIGHT, WIDTH))
        background = self.arrays.background_map()
        self.assertEqual(background.background.shape[0], HEIGHT)
        self.assertAlmostEqual(background.share, 0.25)
        self.assertEqual(self.arrays.settings["iterations"], 2)
        self.assertEqual(self.arrays.capture_state().directory, "")
        settings = self.arrays.settings
        settings["iterations"] = 3
        with self.assertRaises(quell.Error) as raised:
            self.arrays.set_settings(settings)
        self.assertEqual(raised.exception.code, "NotPrepared")
        self.assertIn("iterations", str(raised.exception))


class Checks(unittest.TestCase):
    """What is odd about frames, and what is refused."""

    def test_frame_check(self):
        checker = denoiser()
        arrays = scene(0)
        arrays["normalWorld"][..., 2] = 1.0
        images = {name: cl.array.to_device(checker.queue, array) for name, array in arrays.items()}
        good = checker.check(quell.Frame(camera(), **images))
        self.assertNotEqual(good.worst, "wrong", good.findings)
        self.assertIn("surface share, %", good.figures)
        turned = quell.Camera(np.diag([-1.0, 1.0, 1.0, 1.0]) @ camera().world_to_clip)
        found = checker.check(quell.Frame(turned, **images))
        self.assertEqual(found.worst, "wrong")
        self.assertIn("image-flipped-x", [finding.kind for finding in found.findings])

    def refused(self, code, buffer, call):
        with self.assertRaises(quell.Error) as raised:
            call()
        self.assertEqual((raised.exception.code, raised.exception.buffer), (code, buffer), str(raised.exception))
        self.assertIn(code, str(raised.exception))

    def test_refusals(self):
        self.refused("UnknownSetting", "method", lambda: quell.Settings("nothing"))
        self.refused("UnknownSetting", "nothing", lambda: quell.Settings(nothing=1))
        self.refused("OutOfRange", "exposure", lambda: quell.Settings(exposure=1e9))
        self.refused("InvalidArgument", "colour", lambda: quell.Frame(camera(), colour=None))
        self.refused("InvalidArgument", "timers", lambda: denoiser(timers="maybe"))
        self.refused("NoDevice", "no such device", lambda: quell.choose_device("no such device"))
        double = {name: array.astype(float) for name, array in scene(0).items()}
        self.refused("InvalidArgument", "radiance", lambda: denoiser().denoise_arrays(camera(), **double))
        views = {name: quell.packed(None, 3) for name in scene(0)}
        frame = quell.Frame(camera(), size=(WIDTH, HEIGHT), **views)
        output = quell.Output(linear=quell.packed(None, 3))
        unprepared = denoiser()
        with self.assertRaises(quell.Error) as raised:
            unprepared.denoise(frame, output)
        self.assertEqual(raised.exception.code, "NotPrepared")
        self.assertGreater(sum(unprepared.memory_needed(frame, output).values()), WIDTH * HEIGHT * 4)


class Names(unittest.TestCase):
    """Settings and images, needing no device."""

    def test_settings(self):
        settings = quell.Settings("svgf", taa=False, luminanceSigma=2.5, toneMap="aces")
        self.assertEqual((settings["taa"], settings["luminanceSigma"], settings["toneMap"]), (False, 2.5, "aces"))
        self.assertEqual(repr(quell.Settings("svgf", taa="off")), "Settings('svgf', taa=False)")
        self.assertEqual(list(settings), [info.name for info in quell.describe("svgf")])
        self.assertIn("svgf", quell.methods())
        self.assertEqual(settings.input_needs()["normalWorld"].use, "required")
        self.assertEqual(tuple(settings.input_needs()), quell.INPUTS)

    def test_layouts(self):
        view = quell.bottom_up(quell.packed(None, 3), (WIDTH, HEIGHT))
        self.assertEqual((view.offset, view.row_pitch), ((HEIGHT - 1) * WIDTH * 12, -WIDTH * 12))
        seen = quell.look_at((0, 0, 1), (0, 0, 0), aspect=2.0)
        np.testing.assert_allclose(seen.world_to_clip @ [0, 0, 0, 1], [0, 0, (seen.world_to_clip @ [0, 0, 0, 1])[2], 1])


@unittest.skipUnless(os.environ.get("QUELL_TOOL"), "QUELL_TOOL names no tool")
class Files(unittest.TestCase):
    """Sequences on disk, through the tool."""

    def test_compare(self):
        reference = sorted((DATA / "colonnade").glob("ref_a_color_*.exr"))[0]
        report = quell.compare(reference, [reference])
        self.assertEqual(report["images"][0]["rmse"], 0.0)

    def test_denoise(self):
        with self.assertRaises(quell.Error) as raised:
            quell.denoise_sequence("no/such/folder")
        self.assertEqual(raised.exception.code, "FileError")


if __name__ == "__main__":
    unittest.main()
