"""Veach's plates: every lamp has the same power, every plate another roughness.

A large lamp in a smooth plate is found by following the reflection, a small lamp in a rough plate by aiming at the
lamp, and only the two together (multiple importance sampling) do well everywhere. Veach and Guibas, "Optimally
combining sampling techniques for Monte Carlo rendering", 1995; his arrangement at a quarter of its size.
"""

from math import pi

from generator.gltf import Document
from generator.materials import lamp, matte, metal
from generator.shapes import icosphere, quad
from generator.vectors import add, cross, normalize, scale, sub

UNIT = 0.25  # metres
EYE = (0, 2, 15)
LAMP_LUMENS = 800
FILL_LUMENS = 60000

# x, radius and colour. Their common height and depth is the origin.
LAMPS = (
    (-3.75, 0.0333, (1.0, 0.55, 0.25)),
    (-1.25, 0.1, (1.0, 0.8, 0.35)),
    (1.25, 0.3, (0.55, 0.9, 0.5)),
    (3.75, 0.9, (0.4, 0.7, 1.0)),
)
# Height and depth of the middle, and alpha = roughness^2, from the smoothest at the back to the front.
PLATES = (((-2.4, -0.15), 0.005), ((-3.05, 0.95), 0.02), ((-3.58, 2.25), 0.05), ((-3.9, 3.6), 0.1))


def sphere_lamp(name, lumens, radius, colour):
    """A sphere of equal radiance emits pi * radiance over its 4 pi r^2."""
    luminance = 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2]
    nits = lumens / (4 * pi**2 * (radius * UNIT) ** 2)
    return lamp(name, scale(colour, nits / luminance))


def plate(middle):
    """An 8 x 1 plate that mirrors the line of lamps to the eye: its normal halves the angle between both."""
    normal = normalize(add(normalize(sub((0, 0, 0), middle)), normalize(sub((0, EYE[1], EYE[2]), middle))))
    across = (4, 0, 0)
    along = scale(cross(across, normal), 1 / 8)
    corners = (sub(along, across), add(along, across), sub(across, along), scale(add(across, along), -1))
    return quad(*(scale(add(middle, corner), UNIT) for corner in corners))


def build():
    document = Document("plates")
    shell = matte("shell", (0.3, 0.3, 0.3))
    floor, wall = -4.15, -2.0
    corners = ((-10, floor, 10), (10, floor, 10), (10, floor, wall), (-10, floor, wall))
    document.place("floor", quad(*(scale(c, UNIT) for c in corners)), shell)
    corners = ((-10, floor, wall), (10, floor, wall), (10, 10, wall), (-10, 10, wall))
    document.place("back wall", quad(*(scale(c, UNIT) for c in corners)), shell)
    for number, ((y, z), alpha) in enumerate(PLATES, 1):
        steel = metal(f"steel, alpha {alpha}", (0.4, 0.41, 0.42), roughness=round(alpha**0.5, 6))
        document.place(f"plate {number}", plate((0, y, z)), steel)
    # Every lamp has as many triangles as the next, so that none is favoured where triangles are drawn with equal odds.
    ball = icosphere(1.0, 2)
    for number, (x, radius, colour) in enumerate(LAMPS, 1):
        name = f"lamp {number}"
        shine = sphere_lamp(name, LAMP_LUMENS, radius, colour)
        document.place(name, ball, shine, (x * UNIT, 0, 0), scale=(radius * UNIT,) * 3)
    fill = sphere_lamp("fill light", FILL_LUMENS, 0.5, (1.0, 1.0, 1.0))
    document.place("fill light", ball, fill, (10 * UNIT, 10 * UNIT, 4 * UNIT), scale=(0.5 * UNIT,) * 3)
    document.camera("camera", scale(EYE, UNIT), (0, -2 * UNIT, 2.5 * UNIT), 28, 1.5)
    return document
