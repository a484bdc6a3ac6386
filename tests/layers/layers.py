#!/usr/bin/env python3
"""Holds every #include line of renderer/, platform/ and firmware/ against the table of layers below.

A layer may include itself, the layers it stands on, and all that those stand on. Our own headers are included in quotes
by their path from renderer/, platform/ or firmware/ ("scene/scene.h", "display.h"); everything else in angle brackets.
The renderer knows neither the operating system nor a window nor the host's threads.

  layers.py SOURCE_FOLDER    prints each violation as FILE:LINE: what is wrong; exit code 1 when there is one
"""

import pathlib
import re
import sys

# layer: the layers it stands on
LAYERS = {
    "numeric": [],
    "sampling": ["numeric"],
    "geometry": ["sampling"],
    "materials": ["geometry"],
    "lights": ["geometry"],
    "scene": ["materials", "lights"],
    "film": ["numeric"],
    "integrators": ["scene", "film"],
    "frame": ["integrators"],
    "platform": [],
    "firmware": ["frame", "platform"],
}

# What no file of renderer/ may include, as it ties the renderer to its host.
HOST_HEADERS = re.compile(
    r"(thread|future|condition_variable|SDL.*|unistd\.h|fcntl\.h|poll\.h|sched\.h|pthread\.h|gpiod\.\w+|xf86drm.*|"
    r"(sys|linux|libudev|libevdev|systemd)/.*)"
)

SOURCE_SUFFIXES = {".h", ".hpp", ".c", ".cpp", ".cc", ".inl"}
ROOTS = ["renderer", "platform", "firmware"]
INCLUDE = re.compile(r'\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>|(\S.*))')


def reachable(layer):
    """The layer and everything it stands on."""
    return {layer}.union(*(reachable(below) for below in LAYERS[layer]))


def layer_of(path):
    """The layer of a path relative to the source folder, or None where the table has no such room."""
    layer = path.parts[1] if path.parts[0] == "renderer" else path.parts[0]
    return layer if layer in LAYERS else None


def check_include(source, path, quoted, angled):
    """What is wrong with one #include of `path`, or None. `quoted` and `angled`: the header, whichever it is."""
    if not quoted and not angled:
        return "includes a macro; name the header"
    candidates = [pathlib.Path(root) / (quoted or angled) for root in ROOTS]
    targets = [target for target in candidates if (source / target).is_file()]
    if angled:
        if targets:
            return f"includes our own {targets[0]} in angle brackets; use quotes"
        if path.parts[0] == "renderer" and HOST_HEADERS.fullmatch(angled):
            return f"includes <{angled}>, but the renderer does not know its host"
        return None
    if ".." in pathlib.Path(quoted).parts or not targets:
        return f'"{quoted}" is no path from renderer/, platform/ or firmware/; headers of others take angle brackets'
    if len(targets) > 1:
        return f'"{quoted}" may be any of {", ".join(map(str, targets))}; rename one'
    layer, target_layer = layer_of(path), layer_of(targets[0])
    if target_layer not in reachable(layer):
        return f"{layer} includes {targets[0]}, but may include only {', '.join(sorted(reachable(layer)))}"
    return None


def check(source):
    """Every violation under the source folder, as a line of text each, and the number of #include lines read."""
    violations, includes = [], 0
    for root in ROOTS:
        for file in sorted((source / root).rglob("*")):
            if file.suffix not in SOURCE_SUFFIXES:
                continue
            path = file.relative_to(source)
            if layer_of(path) is None:
                violations.append(f"{path}:1: lies in no layer of the table in tests/layers/layers.py")
                continue
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), start=1):
                if match := INCLUDE.match(line):
                    includes += 1
                    if problem := check_include(source, path, match[1], match[2]):
                        violations.append(f"{path}:{number}: {problem}")
    return violations, includes


def main():
    violations, includes = check(pathlib.Path(sys.argv[1]))
    print("\n".join(violations) or f"{includes} #include lines keep to the layers")
    if includes == 0:
        print("no #include line was found: is this the source folder?")
    return 1 if violations or includes == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
