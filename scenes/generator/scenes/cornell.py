"""The Cornell box as published: two white blocks under one lamp."""

from generator.scenes.cornell_room import WHITE, cornell_room, units
from generator.shapes import merged, quad

# Corners of the tops, counter-clockwise seen from above, and their height.
SHORT_BLOCK = ((130, 65), (82, 225), (240, 272), (290, 114)), 165
TALL_BLOCK = ((423, 247), (265, 296), (314, 456), (472, 406)), 330


def block(top, height):
    """The top and the four sides above a footprint; the bottom stands on the floor and is left out."""
    sides = [
        quad(*units((x0, 0, z0), (x1, 0, z1), (x1, height, z1), (x0, height, z0)))
        for (x0, z0), (x1, z1) in zip(top, top[1:] + top[:1])
    ]
    return merged([quad(*units(*((x, height, z) for x, z in top))), *sides])


def build():
    document = cornell_room("cornell")
    document.place("short block", block(*SHORT_BLOCK), WHITE)
    document.place("tall block", block(*TALL_BLOCK), WHITE)
    return document
