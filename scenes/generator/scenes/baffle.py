"""A room that no lamp shines into: everything in sight is lit by light that was scattered at least once.

Seen from above, the camera C looks up the page. The lamp L hangs on the far side of the partition and shines to the
right: nothing left of it meets it. What the camera sees of the alcove is in the shadow of the fin F. The wall on the
right, out of sight, is what lights the room.

    +-------------+-----------+  z = -3
    |             : alcove    |
    |    table    :           |
    |             :           |
    |             +===F       |  z = -0.4
    |             |L          |
    |             +-----------+  z = 1.1
    |          C  |
    +-------------+              z = 3
"""

from generator.gltf import Document
from generator.materials import lamp, matte
from generator.shapes import box, box_between, lathe, merged, quad, sphere, spline
from generator.vectors import turn

LEFT, PARTITION, THICK, RIGHT = -2.6, 1.0, 0.12, 3.2
BACK, FIN, CHAMBER_END, FRONT = -3.0, -0.4, 1.1, 3.0
HEIGHT = 2.7

WHITE = matte("plaster", (0.78, 0.76, 0.72))
APRICOT = matte("apricot", (0.82, 0.58, 0.36))
BLUE = matte("dusty blue", (0.5, 0.6, 0.7))
SAGE = matte("sage", (0.25, 0.34, 0.3))
BOARDS = matte("boards", (0.5, 0.37, 0.26))


def build_walls(document):
    x0, x1, x2, y, z0, z1, z2 = LEFT, PARTITION, RIGHT, HEIGHT, BACK, CHAMBER_END, FRONT
    inner = x1 + THICK
    floor = [((x0, x1), (z0, z2)), ((x1, x2), (z0, z1))]
    floors = [quad((a, 0, d), (b, 0, d), (b, 0, c), (a, 0, c)) for (a, b), (c, d) in floor]
    ceilings = [quad((a, y, c), (b, y, c), (b, y, d), (a, y, d)) for (a, b), (c, d) in floor]
    document.place("floor", merged(floors), BOARDS)
    back = quad((x1, 0, z0), (x2, 0, z0), (x2, y, z0), (x1, y, z0))
    front = quad((x1, 0, z2), (x0, 0, z2), (x0, y, z2), (x1, y, z2))
    partition = box_between((x1, 0, FIN), (inner, y, z2))
    document.place("plastered walls and ceiling", merged([*ceilings, back, front, partition]), WHITE)
    document.place("back wall", quad((x0, 0, z0), (x1, 0, z0), (x1, y, z0), (x0, y, z0)), SAGE)
    document.place("left wall", quad((x0, 0, z2), (x0, 0, z0), (x0, y, z0), (x0, y, z2)), BLUE)
    right = quad((x2, 0, z0), (x2, 0, z1), (x2, y, z1), (x2, y, z0))
    end = quad((x2, 0, z1), (inner, 0, z1), (inner, y, z1), (x2, y, z1))
    document.place("chamber walls", merged((right, end)), APRICOT)
    document.place("fin", box_between((inner, 0, FIN), (1.55, y, FIN + 0.08)), WHITE)
    x = inner + 0.01
    shine = lamp("lamp", (9000.0, 8200.0, 6800.0))
    document.place("lamp", quad((x, 0.5, 0.9), (x, 0.5, -0.2), (x, 2.2, -0.2), (x, 2.2, 0.9)), shine)


def build_still_life(document):
    """Plaster solids on a table, as drawing classes have them."""
    leg = box(0.06, 0.7, 0.06)
    legs = [leg.moved((x, 0, z)) for x in (-0.8, 0.8) for z in (-0.34, 0.34)]
    table = document.group("table", at=(-0.8, 0, -1.8), rotation=turn((0, 1, 0), 8))
    document.place("table top", merged([box(1.8, 0.05, 0.86).moved((0, 0.7, 0)), *legs]), BOARDS, parent=table)
    top = document.group("still life", at=(0, 0.75, 0), scale=(1.35,) * 3, parent=table)
    vase = spline([(0.055, 0.46), (0.05, 0.38), (0.14, 0.24), (0.15, 0.13), (0.075, 0.0)], 8)
    rim = [(0, 0.44), (0.045, 0.44), (0.045, 0.46)]
    solids = (
        ("cube", box(0.3, 0.3, 0.3), (-0.42, 0, -0.1), 25),
        ("sphere", sphere(0.15, 64, 32), (0.02, 0.15, 0.13), 0),
        ("cone", lathe([(0, 0.42), (0.17, 0), (0, 0)]), (0.17, 0, -0.14), 0),
        ("vase", lathe([*rim, *vase, (0, 0)]), (0.47, 0, 0.0), 0),
        ("cylinder", lathe([(0, 0.12), (0.1, 0.12), (0.1, 0), (0, 0)]), (-0.24, 0, 0.16), 0),
    )
    for name, mesh, at, degrees in solids:
        document.place(name, mesh, WHITE, at, turn((0, 1, 0), degrees), parent=top)


def build():
    document = Document("baffle")
    build_walls(document)
    build_still_life(document)
    document.camera("camera", (0.3, 1.5, 2.75), (-0.3, 1.05, -1.8), 33, 1.5)
    return document
