#!/usr/bin/env python3
"""Writes the scenes of the playlist as glTF: scenes/generate.py [--out FOLDER] [SCENE...]

A scene is a file in generator/scenes (cornell-spheres: cornell_spheres.py) with a function build() -> Document, and a
row in playlist.toml. Needs Python 3.11 and nothing else.
"""

import argparse
import importlib
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent


def main():
    playlist = tomllib.loads((HERE / "playlist.toml").read_text(encoding="utf-8"))
    names = [Path(row["file"]).stem for row in playlist["scene"]]
    parser = argparse.ArgumentParser(description="Writes the scenes of the playlist as glTF.")
    parser.add_argument("--out", type=Path, default=HERE, metavar="FOLDER", help="default: beside this script")
    parser.add_argument("scene", nargs="*", help=f"default: all of {' '.join(names)}")
    arguments = parser.parse_args()
    unknown = set(arguments.scene) - set(names)
    if unknown:
        parser.error(f"not in playlist.toml: {' '.join(sorted(unknown))}")
    arguments.out.mkdir(parents=True, exist_ok=True)
    for name in arguments.scene or names:
        module = importlib.import_module(f"generator.scenes.{name.replace('-', '_')}")
        module.build().save(arguments.out)


if __name__ == "__main__":
    main()
