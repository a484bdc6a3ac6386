"""A closed box that glows: every surface emits Le and reflects half of what arrives, so that every direction shows
Le (1 + 1/2 + 1/4 + ...) = 2 Le. What deviates from one flat colour is an error."""

from generator.gltf import Document
from generator.materials import Material
from generator.shapes import box, box_between

LE = (0.4, 0.25, 0.1)


def build():
    document = Document("furnace")
    wall = Material("wall", (0.5, 0.5, 0.5), specular=0.0, emission=LE)
    document.place("box", box_between((-1, -1, -1), (1, 1, 1)).inside_out(), wall)
    document.place("block", box(0.6, 0.8, 0.6), wall, at=(-0.2, -0.8, -0.3))
    document.camera("camera", (0.6, 0.5, 0.8), (-0.2, -0.3, -0.3), 60, 1.0)
    return document
