"""A room of a museum in the blue hour: textured things on plinths under spot lights and glass ceilings."""

from generator.gltf import Document
from generator.materials import glass, glossy, lamp, matte, metal
from generator.scenes import gallery_pictures
from generator.shapes import box, box_between, lathe, merged, quad, sphere, spline, torus, torus_knot
from generator.vectors import look_at, turn

LEFT, RIGHT, HEIGHT, BACK, FRONT = -3.2, 3.6, 3.6, -5.0, 4.5
WINDOW_Z, WINDOW_Y = (-4.4, -2.0), (0.8, 3.0)
WALL_THICKNESS = 0.3
TILES = ((RIGHT - LEFT) / 1.6, (FRONT - BACK) / 1.6)  # a picture of four tiles is 1.6 m wide

PLASTER = matte("plaster", (0.75, 0.73, 0.69))
TEAL = matte("teal wall", (0.055, 0.15, 0.165))
WHITE = matte("white lacquer", (0.66, 0.65, 0.63))
BLACK = glossy("black steel", (0.02, 0.02, 0.022), roughness=0.4)
GOLD = metal("gold", (1.0, 0.71, 0.29), roughness=0.28)


def build_room(document):
    floor = quad((LEFT, 0, FRONT), (RIGHT, 0, FRONT), (RIGHT, 0, BACK), (LEFT, 0, BACK), TILES)
    polish = gallery_pictures.worn_polish()
    marble = glossy("marble", roughness=1.0, picture=gallery_pictures.marble_floor(), roughness_picture=polish)
    document.place("floor", floor, marble)
    document.place(
        "back wall", quad((LEFT, 0, BACK), (RIGHT, 0, BACK), (RIGHT, HEIGHT, BACK), (LEFT, HEIGHT, BACK)), TEAL
    )
    ceiling = quad((LEFT, HEIGHT, BACK), (RIGHT, HEIGHT, BACK), (RIGHT, HEIGHT, FRONT), (LEFT, HEIGHT, FRONT))
    right = quad((RIGHT, 0, BACK), (RIGHT, 0, FRONT), (RIGHT, HEIGHT, FRONT), (RIGHT, HEIGHT, BACK))
    front = quad((RIGHT, 0, FRONT), (LEFT, 0, FRONT), (LEFT, HEIGHT, FRONT), (RIGHT, HEIGHT, FRONT))
    outer = LEFT - WALL_THICKNESS
    (z0, z1), (y0, y1) = WINDOW_Z, WINDOW_Y
    around_window = [
        box_between((outer, 0, BACK), (LEFT, HEIGHT, z0)),
        box_between((outer, 0, z1), (LEFT, HEIGHT, FRONT)),
        box_between((outer, 0, z0), (LEFT, y0, z1)),
        box_between((outer, y1, z0), (LEFT, HEIGHT, z1)),
    ]
    document.place("walls and ceiling", merged([ceiling, right, front, *around_window]), PLASTER)
    middle = LEFT - WALL_THICKNESS / 2
    bars = [box_between((middle - 0.03, y0, z), (middle + 0.03, y1, z + 0.05)) for z in (z0 + 0.8, z1 - 0.85)]
    bars.append(box_between((middle - 0.03, 2.2, z0), (middle + 0.03, 2.25, z1)))
    document.place("window bars", merged(bars), WHITE)
    skirting = [box_between((LEFT, 0, BACK), (RIGHT, 0.14, BACK + 0.02))]
    skirting.append(box_between((RIGHT - 0.02, 0, BACK + 0.02), (RIGHT, 0.14, FRONT)))
    document.place("skirting", merged(skirting), WHITE)
    y = HEIGHT - 0.02
    panels = [quad((x, y, -3.6), (x + 1.8, y, -3.6), (x + 1.8, y, 1.6), (x, y, 1.6)) for x in (-2.4, 1.0)]
    document.place("laylights", merged(panels), lamp("frosted glass", (62.0, 64.0, 68.0)))


def build_painting(document, wood):
    """Hangs in a gold fillet and a wooden frame, a little off the wall."""
    half_width, half_height = 1.2, 0.8
    painting = document.group("painting", at=(0.0, 2.0, BACK))
    canvas = glossy("canvas", roughness=0.45, picture=gallery_pictures.landscape())
    corners = [(x * half_width, y * half_height, 0.03) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    document.place("landscape", quad(*corners), canvas, parent=painting)

    def border(inset, width, depth):
        x, y = half_width + inset, half_height + inset
        return merged(
            (
                box_between((-x - width, y, 0.0), (x + width, y + width, depth)),
                box_between((-x - width, -y - width, 0.0), (x + width, -y, depth)),
                box_between((-x - width, -y, 0.0), (-x, y, depth)),
                box_between((x, -y, 0.0), (x + width, y, depth)),
            )
        )

    document.place("fillet", border(-0.01, 0.03, 0.05), GOLD, parent=painting)
    document.place("frame", border(0.02, 0.1, 0.08), wood, parent=painting)


def build_plinth(document, name, at, height):
    """A white block with a shadow gap and a slab; returns the group whose origin is the middle of its top.
    What is placed there is shown a quarter larger than it is modelled."""
    x, z = at
    body = box(0.5, height - 0.06, 0.5)
    gap = box(0.46, 0.02, 0.46).moved((0, height - 0.06, 0))
    slab = box(0.54, 0.04, 0.54).moved((0, height - 0.04, 0))
    document.place(f"plinth of the {name}", merged((body, gap, slab)), WHITE, at=(x, 0, z))
    return document.group(name, at=(x, height, z), scale=(1.25,) * 3)


def build_spot(document, name, at, target, candela, colour=(1.0, 0.82, 0.6)):
    """A lamp under the ceiling, its housing and its light turned to `target`."""
    spot = document.group(f"spot on the {name}", at=at, rotation=look_at(at, target))
    can = lathe([(0, 0.16), (0.05, 0.15), (0.06, 0.1), (0.06, 0.0), (0.052, 0.0), (0.052, 0.06), (0, 0.06)], 24)
    document.place(f"housing on the {name}", can, BLACK, rotation=turn((1, 0, 0), 90), parent=spot)
    document.spot_light(name, candela, colour, 8, 20, parent=spot, at=(0, 0, -0.01))


def build():
    document = Document("gallery")
    wood = glossy("wood", roughness=0.35, picture=gallery_pictures.wood())
    build_room(document)
    build_painting(document, wood)

    knot = build_plinth(document, "knot", (-1.45, -0.7), 0.95)
    document.place("gold knot", torus_knot(2, 3, 0.17, 0.075, 0.042), GOLD, (0, 0.29, 0), parent=knot)
    foot = lathe([(0, 0.03), (0.07, 0.03), (0.07, 0), (0, 0)], 48)
    document.place("foot", foot, BLACK, parent=knot)

    pebbles = build_plinth(document, "pebbles", (1.75, -0.6), 0.85)
    ball = sphere(1.0, 64, 32)
    stack = (
        ("red", (0.55, 0.015, 0.012), (0, 0.115, 0), (0.2, 0.115, 0.17), 0),
        ("yellow", (0.8, 0.42, 0.02), (0.02, 0.3, 0), (0.14, 0.075, 0.12), 8),
        ("blue", (0.02, 0.1, 0.42), (0, 0.46, 0), (0.085, 0.09, 0.085), 0),
    )
    for name, colour, at, radii, degrees in stack:
        plastic = glossy(f"{name} plastic", colour, roughness=0.08)
        document.place(f"{name} pebble", ball, plastic, at, turn((0, 0, 1), degrees), radii, parent=pebbles)

    amphora = build_plinth(document, "amphora", (-1.65, -3.6), 0.85)
    wall = spline([(0.1, 0.66), (0.075, 0.6), (0.08, 0.52), (0.2, 0.4), (0.21, 0.28), (0.12, 0.1), (0.06, 0.035)], 8)
    profile = [(0.0, 0.55), (0.07, 0.58), (0.095, 0.66), *wall, (0.1, 0.03), (0.1, 0.0), (0.0, 0.0)]
    clay = matte("painted clay", picture=gallery_pictures.pottery())
    document.place("clay amphora", lathe(profile, 96), clay, parent=amphora)

    urn = build_plinth(document, "urn", (1.75, -3.6), 0.85)
    wall = spline([(0.13, 0.52), (0.09, 0.46), (0.19, 0.36), (0.2, 0.24), (0.1, 0.08), (0.07, 0.05)], 8)
    profile = [(0.0, 0.42), (0.075, 0.46), (0.125, 0.52), *wall, (0.11, 0.02), (0.11, 0.0), (0.0, 0.0)]
    bronze = metal("brushed bronze", (0.78, 0.46, 0.28), 1.0, gallery_pictures.brushed())
    document.place("bronze urn", lathe(profile, 96), bronze, parent=urn)

    crystal = build_plinth(document, "crystal", (0.15, -2.2), 0.55)
    clear = glass("crystal", ior=1.5)
    document.place("crystal ball", sphere(0.2, 96, 48), clear, (0, 0.235, 0), parent=crystal)
    document.place("ball stand", torus(0.11, 0.03, 64, 24), GOLD, (0, 0.03, 0), parent=crystal)

    bench = [box(1.5, 0.06, 0.42).moved((0, 0.4, 0))]
    bench += [box(0.06, 0.4, 0.36).moved((x, 0, 0)) for x in (-0.6, 0.6)]
    document.place("bench", merged(bench), wood, (2.6, 0, 0.9), turn((0, 1, 0), 90))

    y = HEIGHT - 0.35
    build_spot(document, "painting, left", (-1.0, y, -2.6), (-0.5, 2.0, BACK), 800)
    build_spot(document, "painting, right", (1.0, y, -2.6), (0.5, 2.0, BACK), 800)
    build_spot(document, "knot", (-0.8, y, 0.8), (-1.45, 1.3, -0.7), 1500)
    build_spot(document, "pebbles", (1.0, y, 0.9), (1.75, 1.15, -0.6), 1400)
    build_spot(document, "amphora", (-1.9, y, -2.0), (-1.65, 1.25, -3.6), 1400)
    build_spot(document, "urn", (2.1, y, -1.9), (1.8, 1.15, -3.6), 1400)
    build_spot(document, "crystal", (-0.5, y, -1.4), (0.15, 0.8, -2.2), 1000)
    document.environment(zenith=[5.0, 13.0, 42.0], horizon=[20.0, 24.0, 38.0], ground=[2.5, 2.5, 3.0])
    document.camera("camera", (0.12, 1.55, 3.6), (0.0, 1.33, -2.0), 39, 1.5)
    return document
