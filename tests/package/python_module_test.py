"""The installed Python module tessera: arrays in and out, libraries, results, descriptors; and unusable input.

Environment: PYTHONPATH, TESSERA_DUCKS (docs/matching), TESSERA_LIBRARY (holds bean, corner, drop, leaf, star), TESSERA_RESULT."""

import copy
import gc
import os
import pickle
import shutil
import tempfile
import threading
import time
import unittest

import numpy as np

import tessera

DUCKS = os.environ["TESSERA_DUCKS"]
LIBRARY = os.environ["TESSERA_LIBRARY"]
RESULT = os.environ["TESSERA_RESULT"]


def blob(seed, points=400):
    """A closed curve without symmetry and with a radius of about 2 to 3. The array has the shape (points, 2)."""
    random = np.random.default_rng(seed)
    angle = np.linspace(0, 2 * np.pi, points, endpoint=False)
    radius = np.ones(points)
    for k in range(2, 10):
        radius += random.uniform(0.2, 0.5) / k * np.cos(k * angle + random.uniform(0, 6.28))
    return np.maximum(radius, 0.25)[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def similarity(scale, rotation_rad, tx, ty):
    return tessera.Similarity(scale * np.cos(rotation_rad), scale * np.sin(rotation_rad), tx, ty)


SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=float)


ANGLES = np.linspace(0, 2 * np.pi, 4000, endpoint=False)


def longest_wait(work):
    """The longest wait of this thread for the interpreter while another thread works, as a share of the other thread's time."""
    done = threading.Event()

    def work_to_the_end():
        try:
            work()
        finally:
            done.set()

    thread = threading.Thread(target=work_to_the_end)
    begin = time.monotonic()
    thread.start()  # waits until the other thread runs, which takes long if that thread keeps the lock
    longest = time.monotonic() - begin
    while not done.is_set():
        before = time.monotonic()
        time.sleep(0.001)
        longest = max(longest, time.monotonic() - before)
    thread.join()
    return longest / (time.monotonic() - begin)


class Outlines(unittest.TestCase):
    def test_arrays_in_and_out(self):
        outline = tessera.Outline(SQUARE)
        np.testing.assert_array_equal(outline.curves[0], SQUARE)
        self.assertEqual((outline.closed, outline.area, outline.length), ([True], 1, 4))
        # Numbers of any kind and layout are accepted, and copied.
        for same in (SQUARE.tolist(), [SQUARE], SQUARE.astype(np.int32), np.asfortranarray(SQUARE), SQUARE[None]):
            np.testing.assert_array_equal(tessera.Outline(same).curves[0], SQUARE)
        outline.curves[0][0] = 7
        np.testing.assert_array_equal(outline.curves[0], SQUARE)

    def test_interiors_come_to_lie_on_the_left(self):
        frame = tessera.Outline([SQUARE[::-1] * 10, SQUARE * 4 + 3])
        self.assertAlmostEqual(frame.area, 100 - 16)
        lines = tessera.Outline([SQUARE[:2], SQUARE[1:]], closed=False)
        self.assertEqual((lines.closed, lines.length, lines.area), ([False, False], 3, 0))

    def test_similarities(self):
        f = similarity(2, 0.5, 3, 4)
        np.testing.assert_allclose(f.inverse().apply(f.apply(SQUARE)), SQUARE, atol=1e-12)
        np.testing.assert_allclose((f @ f).apply([1, 2]), f.apply(f.apply([1, 2])))
        self.assertEqual(f.apply(SQUARE).shape, (4, 2))
        self.assertAlmostEqual(f.rotation_rad, 0.5)
        self.assertAlmostEqual(tessera.Outline(SQUARE).mapped(f).area, 4)

    def test_what_is_none_is_named(self):
        million_and_more = np.zeros((4_194_305, 2))
        for curves, message in (
            ([], "an outline without curves"),
            (np.zeros((0, 2)), "an outline without curves"),
            ([[1, 2]], "curve 0: found 1 point, allowed: 3 points or more"),
            (SQUARE[:1], "curve 0: found 1 point"),
            (np.zeros((5, 2)), "all equal"),
            (SQUARE * np.nan, "curve 0: point 0: found the coordinate nan"),
            (np.where(SQUARE > 0, np.inf, 0), "curve 0: point 1: found the coordinate inf"),
            (SQUARE * 1e300, "found the coordinate 1e+300, allowed: -1e15 to 1e15"),
            (np.zeros((4, 3)), r"curve 0: found an array of the shape (4, 3), allowed: an array of the shape (N, 2)"),
            (np.zeros(4), "curve 0: found an array of the shape (4,)"),
            ([SQUARE, 5], "curve 1: found an array of the shape ()"),
            (np.zeros((2, 2, 2, 2)), "curve 0: found an array of the shape (2, 2, 2)"),
            ("a text", "curve 0: found str, which is no array of numbers"),
            ([SQUARE, "text"], "curve 1: found str, which is no array of numbers"),
            ([[1, 2], [3]], "curve 0: found list, which is no array of numbers; allowed: an array of the shape (N, 2)"),
            ([[[1, 2], [3]]], "curve 0: found list, which is no array of numbers; allowed: an array of the shape (N, 2)"),
            ([[[1, 2], [3]], SQUARE], "curve 0: found list, which is no array of numbers"),
            ([SQUARE, [[1, 2], [3]]], "curve 1: found list, which is no array of numbers"),
            (None, "curves: found NoneType"),
            (5, "curves: found int"),
            (million_and_more, "4194305 points"),
            ([SQUARE] * 1001, "1001 curves"),
        ):
            with self.assertRaises(tessera.Error) as raised:
                tessera.Outline(curves)
            self.assertIn(message, str(raised.exception))
            self.assertIsInstance(raised.exception, ValueError)
        with self.assertRaisesRegex(tessera.Error, "smoothing: found -1"):
            tessera.Outline(SQUARE, smoothing=-1)
        with self.assertRaises(TypeError):
            tessera.Outline(SQUARE, smoothing="much")


    def test_copies_and_pickles(self):
        frame = tessera.Outline([SQUARE * 10, SQUARE * 4 + 3], smoothing=0.5)
        lines = tessera.Outline(SQUARE, closed=False)
        for outline in (frame, lines, frame.mapped(similarity(3, 1, 2, 5))):
            for same in (copy.copy(outline), copy.deepcopy(outline), pickle.loads(pickle.dumps(outline))):
                self.assertEqual((same.closed, same.smoothing), (outline.closed, outline.smoothing))
                self.assertEqual(len(same.curves), len(outline.curves))
                for curve, own in zip(same.curves, outline.curves):
                    np.testing.assert_array_equal(curve, own)
        pose = similarity(3, 1, 2, 5)
        same = copy.deepcopy(pose)
        self.assertEqual((same.a, same.b, same.tx, same.ty), (pose.a, pose.b, pose.tx, pose.ty))
        for state, message in ((([SQUARE], [True, True], 0.0), "found 1 curves and 2 values of closed"),
                               (([SQUARE * np.nan], [True], 0.0), "curve 0: point 0: found the coordinate nan")):
            with self.assertRaisesRegex(tessera.Error, message):
                tessera.Outline.__new__(tessera.Outline).__setstate__(state)

    def test_other_threads_go_on(self):
        # There are many curves with many points, and each is searched for in every other one.
        ring = np.stack([np.cos(ANGLES), np.sin(ANGLES)], axis=1)
        rings = [ring * (2 + k / 1000) for k in range(300)]
        self.assertLess(longest_wait(lambda: tessera.Outline(rings)), 0.5)


class Pads(unittest.TestCase):
    def test_columns(self):
        pads = tessera.pads(tessera.Outline(blob(1)), samples=50)
        self.assertEqual(len(pads), 50)
        for column, shape in (("position", (50, 2)), ("along", (50,)), ("curve", (50,)), ("left", (50, 5)),
                              ("right", (50, 5)), ("convexity", (50,))):
            self.assertEqual(getattr(pads, column).shape, shape, column)
        self.assertTrue((np.diff(pads.right, axis=1) > 0).all())
        self.assertTrue(set(pads.convexity) <= {-1, 0, 1})

    def test_distances(self):
        pads = tessera.pads(tessera.Outline(blob(1)))
        turned = tessera.pads(tessera.Outline(blob(1)).mapped(similarity(50, 2, 7, 8)))
        distances = pads.distances(turned)
        self.assertEqual(distances.shape, (64, 64))
        self.assertLess(np.median(np.diag(distances)), 1e-3)
        self.assertLess(np.abs(distances - turned.distances(pads).T).max(), 1e-12)

    def test_missing_levels_are_not_numbers(self):
        pads = tessera.pads(tessera.Outline(blob(1)[:200], closed=False))
        self.assertTrue(np.isnan(pads.left[0]).all())
        self.assertTrue(np.isinf(pads.distances(pads)[0, 0]))
        self.assertFalse(np.isnan(pads.left[32, 0]))

    def test_settings(self):
        for settings in ({"levels": 9}, {"samples": 0}, {"delta_tau_rad": -1}, {"smoothing": float("nan")}):
            with self.assertRaisesRegex(tessera.Error, next(iter(settings))):
                tessera.pads(tessera.Outline(blob(1)), **settings)


class Matches(unittest.TestCase):
    def test_pose_and_runs(self):
        b = tessera.Outline(blob(2))
        pose = similarity(30, 1, 400, -50)
        match, = tessera.match(b.mapped(pose), b)
        self.assertGreater(match.score, 0.97)
        np.testing.assert_allclose(match.a_from_b.apply(SQUARE), pose.apply(SQUARE), atol=0.5)
        self.assertAlmostEqual(match.runs[0].of_b.end - match.runs[0].of_b.start, b.length, delta=0.05 * b.length)
        self.assertFalse(match.runs[0].reversed)
        self.assertIn("score", repr(match))
        self.assertRegex(repr(match.runs[0]),
                         r"^<tessera.MatchedRun: A's curve 0, [0-9.e-]+ to [0-9.e+]+, B's curve 0, [0-9.e-]+ to [0-9.e+]+>$")

    def test_a_million_points(self):
        match, = tessera.match(tessera.Outline(blob(2, 1_000_000)), tessera.Outline(blob(2)))
        self.assertGreater(match.score, 0.97)

    def test_other_threads_go_on(self):
        a, b = (tessera.Outline(blob(seed)) for seed in (3, 4))
        self.assertLess(longest_wait(lambda: [tessera.match(a, b) for _ in range(3)]), 0.7)

    def test_drawings(self):
        a, b = (tessera.read_drawing(os.path.join(DUCKS, name)) for name in ("duck.svg", "duck-4.svg"))
        self.assertAlmostEqual(tessera.match(a, b)[0].score, 0.656, delta=0.01)  # docs/matching.md
        with self.assertRaisesRegex(tessera.Error, "none.svg"):
            tessera.read_drawing("none.svg")


class Libraries(unittest.TestCase):
    def test_contents(self):
        library = tessera.Library(LIBRARY)
        self.assertEqual(len(library), 5)
        self.assertEqual(repr(library), "<tessera.Library: shapes: 5>")
        self.assertEqual(sorted(library.names), ["bean", "corner", "drop", "leaf", "star"])
        star = library.outline(library.names.index("star"))
        self.assertAlmostEqual(star.area, 1, delta=1e-3)
        pads = library.pads(library.names.index("star"), level=3)
        self.assertEqual(pads.left.shape, (128, library.pad_levels))
        self.assertAlmostEqual(tessera.Library.smoothing(0) / tessera.Library.smoothing(1), 2, places=3)
        for wrong in (lambda: library.outline(5), lambda: library.pads(0, level=9)):
            with self.assertRaisesRegex(tessera.Error, "allowed: 0 to 4"):
                wrong()

    def test_what_is_none_is_named(self):
        with tempfile.NamedTemporaryFile(suffix=".h5") as file:
            file.write(b"no library")
            file.flush()
            with self.assertRaisesRegex(tessera.Error, file.name):
                tessera.Library(file.name)
        with self.assertRaisesRegex(tessera.Error, "none.h5"):
            tessera.Library("none.h5")

    def test_recognition(self):
        library = tessera.Library(LIBRARY)
        known = tessera.KnownOutlines(library)
        self.assertEqual(len(known), 5)
        self.assertEqual(repr(known), "<tessera.KnownOutlines: outlines: 5>")
        for shape in range(5):
            query = library.outline(shape).mapped(similarity(200, 1, 5, 6))
            found = known.recognise(query, most=2)
            self.assertEqual(found[0].known, shape)
            self.assertAlmostEqual(found[0].query_from_known.scale, 200, delta=3)
            self.assertLessEqual(len(found), 2)
        # The user's own outlines; the query is half of one of them.
        known = tessera.KnownOutlines([tessera.Outline(blob(seed)) for seed in range(8)])
        half = tessera.Outline(blob(5)[:200], closed=False)
        self.assertEqual(known.recognise(half)[0].known, 5)
        with self.assertRaisesRegex(tessera.Error, "scale: found 0"):
            known.recognise(half, scale=0)
        with self.assertRaisesRegex(tessera.Error, "no known outlines"):
            tessera.KnownOutlines([])

    def test_a_forked_process_is_told(self):
        known = tessera.KnownOutlines([tessera.Outline(blob(1))])
        known.recognise(tessera.Outline(blob(1)))
        child = os.fork()
        if child == 0:
            try:
                known.recognise(tessera.Outline(blob(1)))
                os._exit(1)
            except tessera.Error as error:
                os._exit(0 if "spawn" in str(error) else 2)
        self.assertEqual(os.waitpid(child, 0)[1], 0)


class Roundness(tessera.Descriptor):
    def name(self):
        return "roundness"

    def describe(self, outline):
        return np.array([4 * np.pi * outline.area / outline.length**2])

    def distance(self, query, known):
        return abs(query[0] - known[0])


class Descriptors(unittest.TestCase):
    def test_pad(self):
        known = [tessera.Outline(blob(seed)) for seed in range(6)]
        queries = [outline.mapped(similarity(9, 2, 1, 1)) for outline in known[:4]]
        matrix = tessera.distance_matrix(tessera.pad_descriptor(), queries, known)
        self.assertEqual(matrix.shape, (4, 6))
        self.assertEqual(list(matrix.argmin(axis=1)), [0, 1, 2, 3])
        self.assertEqual(tessera.distance_matrix(tessera.pad_descriptor(), known).shape, (6, 6))
        self.assertEqual(tessera.pad_descriptor().name(), "pad")
        pad = tessera.pad_descriptor()
        self.assertEqual(pad.distance(pad.describe(known[0]), pad.describe(known[0])), 0)

    def test_one_in_python(self):
        angle = np.linspace(0, 2 * np.pi, 1000, endpoint=False)
        circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        outlines = [tessera.Outline(circle), tessera.Outline(SQUARE)]
        matrix = tessera.distance_matrix(Roundness(), outlines)
        gc.collect()
        np.testing.assert_allclose(matrix, [[0, 1 - np.pi / 4], [1 - np.pi / 4, 0]], atol=1e-4)

    def test_mistakes_of_one_in_python(self):
        outlines = [tessera.Outline(SQUARE)]

        class Unfinished(tessera.Descriptor):
            pass

        class Failing(Roundness):
            def distance(self, query, known):
                raise KeyError("mine")

        class Wordy(Roundness):
            def describe(self, outline):
                return "round"

        class Undecided(Roundness):
            def distance(self, query, known):
                return None

        for descriptor, error, message in ((Unfinished(), NotImplementedError, "describe"), (Failing(), KeyError, "mine"),
                                           (Wordy(), tessera.Error, "what describe.. returned: found str"),
                                           (Undecided(), tessera.Error,
                                            "what distance.. returned: found NoneType, allowed: a number")):
            with self.assertRaisesRegex(error, message):
                tessera.distance_matrix(descriptor, outlines)


class Results(unittest.TestCase):
    def test_pieces_job_and_card(self):
        result = tessera.read_result(RESULT)
        self.assertTrue(result.finished)
        self.assertEqual(len(result.pieces), 2)
        self.assertEqual(result.card["quality"]["pieces"], 2)
        self.assertEqual(tessera.read_card(RESULT), result.card)
        self.assertEqual(result.job["stop"]["pieces"], 2)
        library = tessera.Library(LIBRARY)
        for index, piece in enumerate(result.pieces):
            self.assertEqual(piece.index, index)
            # The shape's outline in its pose on the canvas is the piece's polygon.
            outline = library.outline(library.names.index(piece.shape))
            placed = piece.canvas_from_shape.apply(outline.curves[0])
            np.testing.assert_allclose(placed, piece.polygon[0], atol=0.01)
            self.assertAlmostEqual(tessera.Outline(piece.polygon).area, piece.scale_px**2, delta=0.01 * piece.scale_px**2)

    def test_what_is_missing_or_damaged_is_named(self):
        def feature(index, number):
            return (f'{{"features": [{{"properties": {{"index": {index}, "shape": "a", "mirrored": false, "canvas_from_shape": '
                    f'[1, 0, 0, 0]}}, "geometry": {{"coordinates": [[[0, 0], [{number}, 0], [0, 1], [0, 0]]]}}}}]}}')

        with self.assertRaisesRegex(tessera.Error, "none/manifest.json: not found; allowed: the folder of a result"):
            tessera.read_result("none")
        with tempfile.TemporaryDirectory() as folder:
            for file, content, message in (("pieces.geojson", "{}", "no list of features"),
                                           ("pieces.geojson", '{"features": [{"properties": {}}]}', "piece 0: damaged"),
                                           ("pieces.geojson", "[" * 100000, "damaged"),
                                           ("pieces.geojson", feature("1e999", 1), "piece 0: damaged: OverflowError"),
                                           ("pieces.geojson", feature("Infinity", 1), "piece 0: damaged: OverflowError"),
                                           ("pieces.geojson", feature("0", "1" + "0" * 400), "piece 0: damaged: OverflowError"),
                                           ("pieces.geojson", feature("0", "1e999"), "piece 0: damaged: .*not finite"),
                                           ("manifest.json", "[1]", "found list, allowed: an object"),
                                           ("job.toml", "a =", "damaged"), ("card.json", "{", "damaged"),
                                           ("manifest.json", b"\xff\xfe", "damaged")):
                shutil.copytree(RESULT, folder, dirs_exist_ok=True)
                with open(os.path.join(folder, file), "wb") as damaged:
                    damaged.write(content if isinstance(content, bytes) else content.encode())
                with self.assertRaisesRegex(tessera.Error, f"{file}:.*{message}"):
                    tessera.read_result(folder)
            shutil.copytree(RESULT, folder, dirs_exist_ok=True)
            os.remove(os.path.join(folder, "card.json"))
            self.assertIsNone(tessera.read_result(folder).card)


class Documentation(unittest.TestCase):
    def test_all_that_is_public_is_described(self):
        for name in tessera.__all__:
            self.assertTrue(hasattr(tessera, name), name)
            if name != "__version__":
                self.assertTrue(getattr(tessera, name).__doc__, name)
                self.assertNotIn("_tessera", getattr(tessera, name).__doc__)
        self.assertEqual(tessera.Outline.__module__, "tessera")


if __name__ == "__main__":
    unittest.main()
