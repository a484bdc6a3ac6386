#!/usr/bin/env python3
"""Writes the scenes of the playlist as glTF, and pictures to light others by: scenes/generate.py [--out FOLDER] [NAME...]

A scene is a file in generator/scenes (cornell-spheres: cornell_spheres.py) with a function build() -> Document, and a
row in playlist.toml. A picture of surroundings is a file in generator/environments with build() -> Environment. Needs
Python 3.11 and nothing else.
"""

import argparse
import importlib
import tomllib
from pathlib import Path

from generator.hdr import hdr_bytes

HERE = Path(__file__).resolve().parent


def main():
    playlist = tomllib.loads((HERE / "playlist.toml").read_text(encoding="utf-8"))
    names = [Path(row["file"]).stem for row in playlist["scene"]]
    environments = sorted(path.stem for path in (HERE / "generator/environments").glob("*.py"))
    parser = argparse.ArgumentParser(description="Writes the scenes of the playlist and the environments.")
    parser.add_argument("--out", type=Path, default=HERE, metavar="FOLDER", help="default: beside this script")
    parser.add_argument("name", nargs="*", help=f"default: all of {' '.join(names + environments)}")
    arguments = parser.parse_args()
    unknown = set(arguments.name) - set(names) - set(environments)
    if unknown:
        parser.error(f"neither in playlist.toml nor in generator/environments: {' '.join(sorted(unknown))}")
    arguments.out.mkdir(parents=True, exist_ok=True)
    for name in arguments.name or names + environments:
        if name in environments:
            environment = importlib.import_module(f"generator.environments.{name}").build()
            (arguments.out / f"{name}.hdr").write_bytes(hdr_bytes(environment))
        else:
            module = importlib.import_module(f"generator.scenes.{name.replace('-', '_')}")
            module.build().save(arguments.out)


if __name__ == "__main__":
    main()
