#!/usr/bin/env python3
"""Shows that layers.py finds what it is there to find: each kind of violation in a made-up tree, and nothing in a good
one."""

import pathlib
import tempfile
import unittest

import layers

GOOD_TREE = {
    "renderer/numeric/fixed.h": "#include <cstdint>\n",
    "renderer/sampling/sobol.h": '#include "numeric/fixed.h"\n',
    "renderer/geometry/ray.h": '#include "numeric/fixed.h"\n#include "sampling/sobol.h"\n',
    "renderer/materials/ggx.h": '#include "geometry/ray.h"\n',
    "renderer/lights/point.h": '#include "geometry/ray.h"\n',
    "renderer/film/film.h": '#include "numeric/fixed.h"\n',
    "renderer/scene/world.h": '#include "lights/point.h"\n#include "materials/ggx.h"\n',
    "renderer/integrators/path.cpp": '#include "film/film.h"\n#include "scene/world.h"\n',
    "platform/display.h": "#include <SDL.h>\n#include <thread>\n",
    "firmware/kiosk.h": '#include "display.h"\n#include "scene/world.h"\n',
    "firmware/main.cpp": '#include "kiosk.h"\n',
}


class LayersTest(unittest.TestCase):
    def violations(self, changed_files):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder)
            for path, text in {**GOOD_TREE, **changed_files}.items():
                (source / path).parent.mkdir(parents=True, exist_ok=True)
                (source / path).write_text(text, encoding="utf-8")
            return layers.check(source)[0]

    def assert_one(self, path, text, *words):
        """The tree with this file in it has one violation, in the file's last line, that has all of `words`."""
        violations = self.violations({path: text})
        self.assertEqual(len(violations), 1, violations)
        self.assertTrue(violations[0].startswith(f"{path}:{len(text.splitlines())}: "), violations)
        for word in words:
            self.assertIn(word, violations[0])

    def test_a_good_tree_has_none(self):
        self.assertEqual(self.violations({}), [])

    def test_every_include_from_a_layer_to_another_is_as_the_table_says(self):
        room = {layer: f"renderer/{layer}" for layer in layers.LAYERS} | {"platform": "platform", "firmware": "firmware"}
        header = {layer: f"{layer}/only_{layer}.h" for layer in layers.LAYERS}
        header |= {"platform": "only_platform.h", "firmware": "only_firmware.h"}
        files = {f"{room[layer]}/only_{layer}.h": "" for layer in layers.LAYERS}
        for includer in layers.LAYERS:
            for included in layers.LAYERS:
                user = {f"{room[includer]}/user.cpp": f'#include "{header[included]}"\n'}
                with self.subTest(includer=includer, included=included):
                    allowed = included in layers.reachable(includer)
                    self.assertEqual(self.violations(files | user) == [], allowed)

    def test_no_layer_stands_on_itself(self):
        for layer, below in layers.LAYERS.items():
            self.assertNotIn(layer, set().union(*map(layers.reachable, below)))

    def test_upward(self):
        self.assert_one("renderer/numeric/up.h", '#pragma once\n#include "geometry/ray.h"\n', "numeric includes")

    def test_sideways(self):
        self.assert_one("renderer/materials/glow.h", '#include "lights/point.h"\n', "materials includes")
        self.assert_one("renderer/film/sky.h", '  #  include   "sampling/sobol.h"\n', "film includes")

    def test_across_the_two_libraries(self):
        self.assert_one("renderer/frame/show.cpp", '#include "display.h"\n', "frame includes")
        self.assert_one("platform/sdl.cpp", '#include "film/film.h"\n', "platform includes")
        self.assert_one("platform/sdl.cpp", '#include "kiosk.h"\n', "platform includes")

    def test_the_renderer_does_not_know_its_host(self):
        for header in ("SDL.h", "thread", "sys/mman.h", "unistd.h"):
            self.assert_one("renderer/frame/host.cpp", f"#include <{header}>\n", "host")

    def test_our_own_header_in_angle_brackets(self):
        self.assert_one("renderer/scene/angle.h", "#include <geometry/ray.h>\n", "use quotes")

    def test_paths_that_are_not_from_a_root(self):
        self.assert_one("renderer/materials/near.h", '#include "ggx.h"\n', "no path from")
        self.assert_one("renderer/materials/climb.h", '#include "../numeric/fixed.h"\n', "no path from")
        self.assert_one("renderer/scene/other.cpp", '#include "tiny_gltf.h"\n', "no path from")

    def test_a_name_that_two_roots_have(self):
        violations = self.violations({"platform/twin.h": "", "firmware/twin.h": "", "firmware/user.h": '#include "twin.h"\n'})
        self.assertEqual(len(violations), 1, violations)
        self.assertIn("rename one", violations[0])

    def test_a_macro_for_a_header(self):
        self.assert_one("renderer/scene/macro.h", "#include SOME_HEADER\n", "macro")

    def test_a_room_that_the_table_does_not_have(self):
        self.assert_one("renderer/cellar/wine.h", "#pragma once\n", "no layer")


if __name__ == "__main__":
    unittest.main()
