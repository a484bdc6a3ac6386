"""The Cornell box with a mirror and a glass sphere: light that only reflection and refraction can carry."""

from generator.materials import glass, metal
from generator.scenes.cornell_room import cornell_room
from generator.shapes import sphere


def build():
    document = cornell_room("cornell-spheres")
    mirror = metal("mirror", (0.95, 0.95, 0.95), roughness=0.0)
    clear = glass("glass", ior=1.5)
    document.place("mirror sphere", sphere(1.05, 96, 48), mirror, at=(3.85, 1.05, 3.75))
    document.place("glass sphere", sphere(0.95, 96, 48), clear, at=(1.55, 0.95, 1.85))
    return document
