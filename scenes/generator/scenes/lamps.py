"""A hall with 64 small lamps whose power spreads evenly over four decades, from 1000 lumens to a tenth of one:
which lamp to ask for light is worth a thought."""

from math import cos, pi, radians, sin, sqrt

from generator.gltf import Document
from generator.materials import glossy, lamp, matte
from generator.noise import hashed, unit
from generator.shapes import box, lathe, merged, octahedron, quad, sphere, torus_knot
from generator.vectors import scale, turn

SIDE = 8  # lamps a row, rows
DECADES = 4
BRIGHTEST_LUMENS = 1000
COLOURS = ((1.0, 0.62, 0.28), (1.0, 0.42, 0.3), (1.0, 0.8, 0.5), (0.4, 0.75, 1.0), (0.55, 1.0, 0.7))
CEILING = 3.4


def hang_lamps(document):
    """One lamp in each cell of a grid, at a random place in it; a random order decides which is how strong."""
    count = SIDE * SIDE
    strongest_first = sorted(range(count), key=lambda index: hashed(7, index))
    shape, cord = octahedron(1.0), box(0.006, 1.0, 0.006)
    black = matte("cord", (0.02, 0.02, 0.02))
    for rank, index in enumerate(strongest_first):
        fraction = rank / (count - 1)
        lumens = BRIGHTEST_LUMENS * 10 ** (-DECADES * fraction)
        radius = 0.065 - 0.04 * fraction
        area = 4 * sqrt(3) * radius**2
        colour = COLOURS[hashed(11, index) % len(COLOURS)]
        luminance = 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2]
        x = -3.5 + 7 * (index % SIDE + 0.15 + 0.7 * unit(1, index)) / SIDE
        z = -3.7 + 7 * (index // SIDE + 0.15 + 0.7 * unit(2, index)) / SIDE
        y = 1.55 + 1.4 * unit(3, index)
        name = f"lamp {rank + 1}"
        shine = lamp(name, scale(colour, lumens / (pi * area) / luminance))
        document.place(name, shape, shine, (x, y, z), scale=(radius,) * 3)
        top = y + radius
        document.place(f"cord {rank + 1}", cord, black, (x, top, z), scale=(1, CEILING - top, 1))


def build():
    document = Document("lamps")
    (x0, z0), (x1, z1), y = (-4, -4.2), (4, 5), CEILING
    floor = quad((x0, 0, z1), (x1, 0, z1), (x1, 0, z0), (x0, 0, z0))
    document.place("floor", floor, matte("slate", (0.26, 0.25, 0.25)))
    shell = [
        quad((x0, y, z0), (x1, y, z0), (x1, y, z1), (x0, y, z1)),
        quad((x0, 0, z0), (x1, 0, z0), (x1, y, z0), (x0, y, z0)),
        quad((x1, 0, z1), (x0, 0, z1), (x0, y, z1), (x1, y, z1)),
        quad((x0, 0, z1), (x0, 0, z0), (x0, y, z0), (x0, y, z1)),
        quad((x1, 0, z0), (x1, 0, z1), (x1, y, z1), (x1, y, z0)),
    ]
    document.place("walls and ceiling", merged(shell), matte("plaster", (0.42, 0.44, 0.5)))
    hang_lamps(document)
    stone = matte("stone", (0.5, 0.48, 0.45))
    steps = [(0, 0.36), (0.7, 0.36), (0.7, 0.24), (1.0, 0.24), (1.0, 0.12), (1.3, 0.12), (1.3, 0)]
    document.place("dais", lathe(steps, 48), stone, at=(0, 0, -0.6))
    lacquer = glossy("lacquer", (0.45, 0.03, 0.03), roughness=0.15)
    knot = torus_knot(2, 3, 0.34, 0.15, 0.085, 192, 20)
    document.place("knot", knot, lacquer, at=(0, 0.94, -0.6))
    slab = box(0.5, 1.0, 0.16)
    for i in range(7):
        degrees = 84 + 32 * i  # a ring, open towards the camera
        x, z = 2.3 * sin(radians(degrees)), -0.6 + 2.3 * cos(radians(degrees))
        tall = (1, 0.75 + 0.5 * unit(5, i), 1)
        document.place(f"slab {i + 1}", slab, stone, (x, 0, z), turn((0, 1, 0), degrees), tall)
    balls = (
        ("white ball", (0.8, 0.8, 0.8), (1.75, 0.25), 0.4),
        ("ochre ball", (0.7, 0.42, 0.1), (-1.75, 0.55), 0.3),
        ("blue ball", (0.08, 0.2, 0.4), (-1.3, 1.05), 0.17),
    )
    ball = sphere(1.0, 48, 24)
    for name, colour, (x, z), radius in balls:
        document.place(name, ball, matte(name, colour), (x, radius, z), scale=(radius,) * 3)
    document.camera("camera", (0.0, 1.5, 4.7), (0.0, 1.36, -1.0), 42, 1.5)
    return document
