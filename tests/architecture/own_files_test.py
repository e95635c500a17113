"""packaging/dev/own-files lets nothing of others in: own_files_test.py SCRIPT"""
import hashlib
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(sys.argv.pop())


class OwnFiles(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.write("README.md", b"words\n")
        self.write("picture.png", b"\x89PNG\0drawn")
        self.write("tests/architecture/own_files.txt", f"{self.digest('picture.png')} picture.png draw --it\n".encode())

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, content):
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_bytes(content)

    def digest(self, name):
        return hashlib.sha256((self.root / name).read_bytes()).hexdigest()

    def run_with(self, *arguments):
        done = subprocess.run([sys.executable, SCRIPT, "--root", self.root, *arguments], capture_output=True, text=True)
        return done.returncode, done.stdout

    def test_text_and_what_is_listed_pass(self):
        self.assertEqual(self.run_with("--check")[0], 0)

    def test_what_is_neither_is_refused_with_its_name(self):
        for name, content in {"core/organ.bin": b"a\0b", "resources/liver.vtk": b"# vtk DataFile\n", "curve.csv": b"1,2\n",
                              "latin.txt": b"\xe9"}.items():
            self.write(name, content)
            code, said = self.run_with("--check")
            self.assertEqual(code, 1)
            self.assertIn(name, said)
            (self.root / name).unlink()

    def test_a_listed_file_that_changed_or_went_is_said(self):
        self.write("picture.png", b"\x89PNG\0another")
        self.assertIn("picture.png is not what", self.run_with("--check")[1])
        (self.root / "picture.png").unlink()
        self.assertIn("picture.png stands in", self.run_with("--check")[1])

    def test_renewing_takes_the_new_checksum_and_keeps_the_command(self):
        self.write("picture.png", b"\x89PNG\0another")
        self.assertEqual(self.run_with("--renew")[0], 0)
        line = (self.root / "tests/architecture/own_files.txt").read_text()
        self.assertEqual(line, f"{self.digest('picture.png')} picture.png draw --it\n")

    def test_renewing_lets_nothing_new_in(self):
        self.write("other.png", b"\x89PNG\0other")
        self.assertEqual(self.run_with("--renew")[0], 1)


if __name__ == "__main__":
    unittest.main()
