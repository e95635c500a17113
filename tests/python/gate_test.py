"""The gate on a foreign program's results: written here with nothing but Python's own csv, json and zlib."""
import csv
import json
import math
import os
import pathlib
import random
import struct
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree
import zlib

CLI = os.environ.get("GLISSON_CLI", "/nowhere")
CASES = 30


def closest_points(moving, fixed, rounds):
    """Another's algorithm: the shift that brings a curve in the plane onto another, by so many rounds of closest points."""
    shift = [0.0, 0.0]
    for _ in range(rounds):
        moved = [(x + shift[0], y + shift[1]) for x, y in moving]
        pairs = [(point, min(fixed, key=lambda other: math.dist(point, other))) for point in moved]
        for axis in (0, 1):
            shift[axis] += sum(other[axis] - point[axis] for point, other in pairs) / len(pairs)
    return shift


def png(file, width, height, grey):
    """An 8-bit grey PNG; grey(x, y) gives a byte."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes(grey(x, y) for x in range(width)) for y in range(height))
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def results(folder, version, rounds, spoil=1.0, failing=()):
    """Registers 30 cases and writes them as docs/file-formats.md asks: metrics.csv, about.json, two pictures."""
    folder.mkdir()
    (folder / "about.json").write_text(json.dumps({"program": "closest points", "version": version, "data": "curves"}))
    with open(folder / "metrics.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["case", "error_mm", "points"])
        for number in range(CASES):
            chance = random.Random(number)
            curve = [(10 * k, 20 * math.sin(k + chance.random())) for k in range(12)]
            true = [chance.uniform(3, 4), chance.uniform(1, 2)]
            seen = [(x - true[0] + chance.gauss(0, 1), y - true[1] + chance.gauss(0, 1)) for x, y in curve]
            found = closest_points(seen, curve, rounds)
            error_mm = spoil * math.dist(true, found) * math.exp(random.Random(f"{version} {number}").gauss(0, 0.07))
            table.writerow([f"curve {number}", "failed" if number in failing else repr(error_mm), len(curve)])
            if number in (3, 4):
                drawn = folder / "pictures" / f"curve {number}"
                drawn.mkdir(parents=True)
                png(drawn / "overlay.png", 96, 64, lambda x, y: round(255 / (1 + math.exp(math.hypot(x - 48, y - 32) - 20 - error_mm))))


class Gate(unittest.TestCase):
    def setUp(self):
        if not pathlib.Path(CLI).exists():
            self.skipTest("glisson-cli is not there")
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        results(self.root / "base", "1.0", 2)

    def tearDown(self):
        self.folder.cleanup()

    def judged(self, now, *more):
        out = self.root / f"gate-of-{now}"
        done = subprocess.run([CLI, "gate", self.root / "base", self.root / now, "--out", out, "--json", *more],
                              capture_output=True, text=True)
        return done, json.loads(done.stdout), out

    def test_a_version_that_is_as_good_passes(self):
        results(self.root / "as-good", "1.1", 2)
        done, found, _ = self.judged("as-good")
        self.assertEqual((done.returncode, found["verdict"] == "worse"), (0, False), done.stdout)

    def test_five_percent_worse_is_caught_with_junit_a_page_and_pictures(self):
        results(self.root / "worse", "1.2", 2, spoil=1.07)
        done, found, out = self.judged("worse")
        self.assertEqual(done.returncode, 1)
        error = next(metric for metric in found["metrics"] if metric["name"] == "error_mm")
        self.assertEqual((error["verdict"], error["cases"]), ("worse", CASES))
        self.assertLess(error["p"], 0.05)
        suite = xml.etree.ElementTree.parse(out / "junit.xml").getroot().find("testsuite")
        failed = [case.get("name") for case in suite.iter("testcase") if case.find("failure") is not None]
        self.assertIn("error_mm", failed)
        self.assertNotIn("points", failed)
        self.assertEqual(int(suite.get("failures")), len(failed))
        page = (out / "gate.html").read_text()
        self.assertIn("closest points 1.0", page)
        self.assertIn("error_mm", page)

    def test_the_worst_case_is_shown_though_its_picture_hardly_changed(self):
        results(self.root / "one", "1.3", 2, spoil=1.07)
        table = (self.root / "one" / "metrics.csv").read_text().splitlines()
        table = [line if not line.startswith("curve 3,") else "curve 3,99.0,12" for line in table]
        (self.root / "one" / "metrics.csv").write_text("\n".join(table))
        _, found, out = self.judged("one")
        self.assertEqual(found["worst"][0]["case"], "curve 3")
        self.assertTrue(list((out / "pictures").glob("worst-*.png")))
        self.assertIn("curve 3/overlay.png: error_mm 99", (out / "gate.html").read_text())

    def test_cases_that_fail_now_are_counted_and_never_averaged(self):
        results(self.root / "fails", "1.4", 2, failing=(7, 8))
        done, found, out = self.judged("fails")
        error = next(metric for metric in found["metrics"] if metric["name"] == "error_mm")
        self.assertEqual((done.returncode, error["lost"], error["cases"]), (1, ["curve 7", "curve 8"], CASES - 2))
        self.assertIn("curve 7, curve 8", (out / "gate.html").read_text())

    def test_another_programs_results_are_said_to_be(self):
        results(self.root / "theirs", "1.1", 2)
        about = {"program": "theirs", "version": "1.1", "data": "curves"}
        (self.root / "theirs" / "about.json").write_text(json.dumps(about))
        self.assertIn("two programs", self.judged("theirs")[1]["notes"][0])
        (self.root / "theirs" / "about.json").write_text(json.dumps({**about, "data": "other curves"}))
        done = subprocess.run([CLI, "gate", self.root / "base", self.root / "theirs", "--out", self.root / "x", "--json"],
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, json.loads(done.stdout)["error"]["code"]), (1, "results-other-data"))


if __name__ == "__main__":
    unittest.main()
