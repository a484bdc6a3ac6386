"""Reads the triangles of a glTF file as it lies on disk, apart from the code that wrote it."""

import json
import struct
from dataclasses import dataclass

_COMPONENTS = {5126: "f", 5123: "H", 5125: "I"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}


@dataclass
class Part:
    """The triangles of a node in world space: three corners each, and their normals (not unit after scaling)."""

    name: str
    material: dict
    corners: list
    normals: list

    @property
    def nits(self):
        strength = self.material.get("extensions", {}).get("KHR_materials_emissive_strength", {})
        factor = self.material.get("emissiveFactor", (0, 0, 0))
        return tuple(c * strength.get("emissiveStrength", 1) for c in factor)

    @property
    def lumens(self):
        """What a Lambertian emitter gives: pi * luminance * area."""
        r, g, b = self.nits
        areas = (length(cross(sub(q, p), sub(s, p))) / 2 for p, q, s in self.corners)
        return 3.14159265358979 * (0.2126 * r + 0.7152 * g + 0.0722 * b) * sum(areas)


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return dot(a, a) ** 0.5


def rotated(quaternion, v):
    x, y, z, w = quaternion
    t = tuple(2 * c for c in cross((x, y, z), v))
    u = cross((x, y, z), t)
    return tuple(v[i] + w * t[i] + u[i] for i in range(3))


class File:
    def __init__(self, path):
        self.json = json.loads(path.read_text(encoding="utf-8"))
        self._binary = (path.parent / self.json["buffers"][0]["uri"]).read_bytes()
        self.parts, self.cameras = [], []
        for root in self.json["scenes"][0]["nodes"]:
            self._visit(root, [])

    def part(self, name):
        return next(part for part in self.parts if part.name == name)

    def _visit(self, index, above):
        node = self.json["nodes"][index]
        place = node.get("translation", (0, 0, 0)), node.get("rotation", (0, 0, 0, 1)), node.get("scale", (1, 1, 1))
        steps = [place, *above]
        if "camera" in node:
            self.cameras.append((self.json["cameras"][node["camera"]], self._to_world(steps)))
        if "mesh" in node:
            for primitive in self.json["meshes"][node["mesh"]]["primitives"]:
                self._add_part(node["name"], primitive, steps)
        for child in node.get("children", ()):
            self._visit(child, steps)

    def _add_part(self, name, primitive, steps):
        indices = [i for (i,) in self._accessor(primitive["indices"])]
        points = [self._to_world(steps)(p) for p in self._accessor(primitive["attributes"]["POSITION"])]
        normals = [self._normal_to_world(steps)(n) for n in self._accessor(primitive["attributes"]["NORMAL"])]
        triangles = [indices[i : i + 3] for i in range(0, len(indices), 3)]
        corners = [[points[i] for i in triangle] for triangle in triangles]
        normals = [[normals[i] for i in triangle] for triangle in triangles]
        self.parts.append(Part(name, self.json["materials"][primitive["material"]], corners, normals))

    def _accessor(self, index):
        accessor = self.json["accessors"][index]
        width, code = _WIDTHS[accessor["type"]], _COMPONENTS[accessor["componentType"]]
        start = self.json["bufferViews"][accessor["bufferView"]]["byteOffset"]
        values = struct.unpack_from(f"<{width * accessor['count']}{code}", self._binary, start)
        return [values[i : i + width] for i in range(0, len(values), width)]

    @staticmethod
    def _to_world(steps):
        def apply(point):
            for translation, rotation, scale in steps:
                point = rotated(rotation, tuple(p * s for p, s in zip(point, scale)))
                point = tuple(p + t for p, t in zip(point, translation))
            return point

        return apply

    @staticmethod
    def _normal_to_world(steps):
        def apply(normal):
            for _, rotation, scale in steps:
                normal = rotated(rotation, tuple(n / s for n, s in zip(normal, scale)))
            return normal

        return apply
