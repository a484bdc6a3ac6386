"""What the committed scenes claim about themselves, measured on the files: geometry_test.py SCENES_FOLDER"""

import math
import sys
import unittest
from collections import Counter
from pathlib import Path

from triangles import File, cross, dot, length, sub

SCENES = Path(sys.argv.pop(1))
FILES = {path.stem: File(path) for path in sorted(SCENES.glob("*.gltf"))}


def emitters(name):
    return [part for part in FILES[name].parts if max(part.nits) > 0]


def hit_distance(origin, direction, triangle):
    """The ray parameter where the triangle is met, or infinity."""
    a, b, c = triangle
    edge1, edge2 = sub(b, a), sub(c, a)
    p = cross(direction, edge2)
    determinant = dot(edge1, p)
    if abs(determinant) < 1e-12:
        return math.inf
    s = sub(origin, a)
    u = dot(s, p) / determinant
    q = cross(s, edge1)
    v = dot(direction, q) / determinant
    t = dot(edge2, q) / determinant
    return t if u >= 0 and v >= 0 and u + v <= 1 and t > 1e-6 else math.inf


class EveryScene(unittest.TestCase):
    def test_has_one_named_camera_and_a_name(self):
        self.assertTrue(FILES, f"no scene in {SCENES}")
        for name, file in FILES.items():
            with self.subTest(name):
                self.assertEqual(file.json["scenes"][0]["name"], name)
                self.assertEqual([camera["name"] for camera, _ in file.cameras], ["camera"])

    def test_triangles_have_area_and_face_along_their_normals(self):
        for name, file in FILES.items():
            for part in file.parts:
                with self.subTest(f"{name}: {part.name}"):
                    for (a, b, c), normals in zip(part.corners, part.normals):
                        face = cross(sub(b, a), sub(c, a))
                        self.assertTrue(length(face) > 0 and all(dot(face, n) > 0 for n in normals))

    def test_glass_is_closed(self):
        for name, file in FILES.items():
            for part in file.parts:
                if "KHR_materials_volume" not in part.material.get("extensions", {}):
                    continue
                with self.subTest(f"{name}: {part.name}"):
                    edges = Counter()
                    for corners in part.corners:
                        a, b, c = (tuple(round(x, 5) for x in corner) for corner in corners)
                        edges.update(((a, b), (b, c), (c, a)))
                    self.assertTrue(all(edges[p, q] == edges[q, p] for p, q in list(edges)))

    def test_is_modest(self):
        self.assertLess(sum(len(part.corners) for file in FILES.values() for part in file.parts), 150_000)


class Claims(unittest.TestCase):
    def test_cornell_lamp(self):
        (lamp,) = emitters("cornell")
        luminance = 0.2126 * 1700 + 0.7152 * 1200 + 0.0722 * 400
        self.assertAlmostEqual(lamp.lumens / (math.pi * luminance * 1.30 * 1.05), 1, places=5)

    def test_plates_lamps_have_equal_power(self):
        lamps = {part.name: part for part in emitters("plates")}
        fill = lamps.pop("fill light")
        self.assertEqual(len(lamps), 4)
        # A faceted sphere is a little smaller than the round one that the 800 lumens are for.
        for lamp in lamps.values():
            self.assertAlmostEqual(lamp.lumens / lamps["lamp 1"].lumens, 1, places=3)
            self.assertTrue(0.97 < lamp.lumens / 800 < 1)
            self.assertEqual(len(lamp.corners), len(fill.corners))

    def test_plates_mirror_the_lamps_to_the_eye(self):
        file = FILES["plates"]
        eye = file.cameras[0][1]((0, 0, 0))
        for number in range(1, 5):
            corners = [corner for triangle in file.part(f"plate {number}").corners for corner in triangle]
            corners = sorted(set(corners))
            middle = tuple(sum(corner[i] for corner in corners) / 4 for i in range(3))
            normal = file.part(f"plate {number}").normals[0][0]
            to_eye, to_lamps = sub((0, eye[1], eye[2]), middle), sub((0, 0, 0), middle)
            self.assertAlmostEqual(dot(normal, to_eye) / length(to_eye), dot(normal, to_lamps) / length(to_lamps), 4)

    def test_lamps_span_four_decades(self):
        powers = sorted(part.lumens for part in emitters("lamps"))
        self.assertEqual(len(powers), 64)
        for weaker, stronger in zip(powers, powers[1:]):
            self.assertAlmostEqual(math.log10(stronger / weaker), 4 / 63, places=3)

    def test_furnace_glows_evenly_and_encloses_the_eye(self):
        file = FILES["furnace"]
        eye = file.cameras[0][1]((0, 0, 0))
        for part in file.parts:
            self.assertEqual(part.nits, (0.4, 0.25, 0.1))
            self.assertEqual(part.material["pbrMetallicRoughness"]["baseColorFactor"][:3], [0.5, 0.5, 0.5])
            self.assertEqual(part.material["extensions"]["KHR_materials_specular"]["specularFactor"], 0)
        for a, _, _ in file.part("box").corners:
            self.assertTrue(all(abs(c) == 1 for c in a))
        for (a, _, _), (normal, _, _) in zip(file.part("box").corners, file.part("box").normals):
            self.assertGreater(dot(normal, sub(eye, a)), 0)

    def test_baffle_shows_nothing_that_its_lamp_shines_on(self):
        file = FILES["baffle"]
        (lamp,) = emitters("baffle")
        lamp_plane = lamp.corners[0][0][0]
        self.assertTrue(all(n == (1, 0, 0) for normals in lamp.normals for n in normals))
        walls = [part for part in file.parts if part is not lamp and len(part.corners) < 40]
        triangles = [triangle for part in walls for triangle in part.corners]
        for part in file.parts:
            if part not in walls and part is not lamp:
                self.assertTrue(all(p[0] < lamp_plane for triangle in part.corners for p in triangle), part.name)
        camera, to_world = file.cameras[0]
        eye, tangent = to_world((0, 0, 0)), math.tan(camera["perspective"]["yfov"] / 2)
        corners = {corner for triangle in lamp.corners for corner in triangle}
        in_front = 0
        # Half as wide again as the camera's own picture, for windows of any shape.
        for column in range(81):
            for row in range(21):
                x, y = (column / 40 - 1) * tangent * 2.25, (row / 10 - 1) * tangent
                ray = sub(to_world((x, y, -1)), eye)
                t = min(hit_distance(eye, ray, triangle) for triangle in triangles)
                self.assertTrue(math.isfinite(t))
                seen = tuple(eye[i] + ray[i] * (t - 1e-4) for i in range(3))
                if seen[0] <= lamp_plane:
                    continue
                in_front += 1
                for corner in corners:
                    away = sub(corner, seen)
                    blocked = any(hit_distance(seen, away, triangle) < 0.999 for triangle in triangles)
                    self.assertTrue(blocked, f"the lamp shines on {seen}")
        self.assertGreater(in_front, 20)


if __name__ == "__main__":
    unittest.main()
