"""Glass in the beam of one small spot of light: what it gathers on the floor can only be found by light that has
gone through the glass."""

from math import cos, pi, sin

from generator.gltf import Document
from generator.materials import glass, lamp, matte
from generator.shapes import Mesh, disc, lathe, sphere, spline, torus
from generator.vectors import look_at, turn

LAMP_AT, LAMP_AIM, LAMP_RADIUS = (-1.9, 2.4, -1.1), (0.05, 0.1, 0.1), 0.1
LAMP_NITS = (200000.0, 183000.0, 155000.0)


def backdrop():
    """A floor that bends up into a wall, as photographers use it."""
    bend, depth, half_width, steps = 1.2, -1.2, 4.5, 24
    profile = [(3.5, 0.0, 0.0)]  # z, y, angle of the normal from upright
    for i in range(steps + 1):
        angle = pi / 2 * i / steps
        profile.append((depth - bend * sin(angle), bend - bend * cos(angle), angle))
    profile.append((depth - bend, 4.5, pi / 2))
    mesh = Mesh()
    for z, y, angle in profile:
        for x in (-half_width, half_width):
            mesh.vertex((x, y, z), (0, cos(angle), sin(angle)), (0, 0))
    for i in range(0, 2 * len(profile) - 2, 2):
        mesh.triangles += [(i, i + 1, i + 3), (i, i + 3, i + 2)]
    return mesh


def goblet():
    """The inside of the bowl upwards, the rim, the outside, the stem and the foot down to its underside."""
    inside = spline([(0.0, 0.42), (0.1, 0.45), (0.185, 0.58), (0.19, 0.72), (0.165, 0.88)], 8)
    rim = [(0.168, 0.884), (0.173, 0.885), (0.177, 0.88)]
    outside = spline([(0.203, 0.72), (0.198, 0.57), (0.11, 0.425), (0.028, 0.36), (0.016, 0.24)], 8)
    foot = spline([(0.018, 0.1), (0.045, 0.04), (0.15, 0.016), (0.165, 0.008)], 6)
    return lathe([*inside, *rim, *outside, *foot, (0.16, 0.0), (0.0, 0.0)], 96)


def build():
    document = Document("caustic")
    document.place("backdrop", backdrop(), matte("paper", (0.5, 0.49, 0.48)))
    clear = glass("glass", ior=1.5)
    # A hair above the floor: glass and paper must not share a plane.
    document.place("glass sphere", sphere(0.34, 96, 48), clear, at=(-0.5, 0.341, 0.0))
    document.place("goblet", goblet(), clear, at=(0.42, 0.001, -0.28))
    amber = glass("amber glass", ior=1.55, colour=(1.0, 0.7, 0.3))
    document.place("amber ring", torus(0.21, 0.065, 96, 32), amber, (0.1, 0.066, 0.62), turn((0, 1, 0), 0))
    shine = lamp("lamp", LAMP_NITS)
    document.place("lamp", disc(LAMP_RADIUS, 16), shine, LAMP_AT, look_at(LAMP_AIM, LAMP_AT))
    document.environment(zenith=[2.0, 3.0, 5.0], horizon=[3.0, 3.0, 3.0], ground=[0.3, 0.3, 0.3])
    document.camera("camera", (0.45, 1.3, 2.7), (0.2, 0.3, 0.0), 31, 1.5)
    return document
