"""The committed scenes are what scenes/generate.py makes, byte for byte: generated_test.py SCENES_FOLDER

Pictures are compared after unpacking, for zlib builds pack the same pixels differently.
"""

import struct
import subprocess
import sys
import tempfile
import tomllib
import unittest
import zlib
from pathlib import Path

SCENES = Path(sys.argv.pop(1))
MADE = {".gltf", ".bin", ".png", ".hdr"}


def unpacked(png):
    """The chunks of a PNG file, the picture data inflated."""
    chunks, data, place = [], b"", 8
    while place < len(png):
        (length,) = struct.unpack(">I", png[place : place + 4])
        kind, body = png[place + 4 : place + 8], png[place + 8 : place + 8 + length]
        if kind == b"IDAT":
            data += body
        else:
            chunks.append((kind, body))
        place += 12 + length
    return chunks, zlib.decompress(data)


class Generated(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        command = [sys.executable, "-B", SCENES / "generate.py", "--out", cls.folder.name]
        subprocess.run(command, check=True)
        cls.made = {path.name: path for path in Path(cls.folder.name).iterdir()}

    def test_same_files(self):
        committed = {path.name for path in SCENES.iterdir() if path.suffix in MADE}
        self.assertEqual(committed, set(self.made), "run scenes/generate.py, remove what it does not make")

    def test_same_contents(self):
        for name, path in self.made.items():
            with self.subTest(name):
                made, committed = path.read_bytes(), (SCENES / name).read_bytes()
                if path.suffix == ".png":
                    made, committed = unpacked(made), unpacked(committed)
                self.assertTrue(made == committed, f"{name} differs: run scenes/generate.py and commit")

    def test_playlist_is_whole(self):
        rows = tomllib.loads((SCENES / "playlist.toml").read_text(encoding="utf-8"))["scene"]
        self.assertEqual({row["file"] for row in rows}, {name for name in self.made if name.endswith(".gltf")})
        for row in rows:
            with self.subTest(row["file"]):
                self.assertLessEqual(row.keys(), {"file", "title", "caption", "mode"})
                self.assertTrue(row["title"] and row["caption"].isascii())


if __name__ == "__main__":
    unittest.main()
