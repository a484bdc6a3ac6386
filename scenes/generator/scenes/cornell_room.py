"""The room of the Cornell box: the vertices that Cornell University published (555-unit box, here 100 units a metre),
with its reflectances as linear Rec.709. The front is open; seen from there x grows to the left."""

from generator.gltf import Document
from generator.materials import lamp, matte
from generator.shapes import merged, quad

WHITE = matte("white", (0.725, 0.71, 0.68))
RED = matte("red", (0.63, 0.065, 0.05))
GREEN = matte("green", (0.14, 0.45, 0.091))

# The measured lamp has the colour 17 : 12 : 4. 1700 nits over its 1.3 x 1.05 m make a well-lit room.
LAMP = lamp("lamp", (1700.0, 1200.0, 400.0))
# The published lamp lies in a hole of the ceiling; here it hangs this far below a whole one.
LAMP_DROP = 1.0


def units(*corners):
    """Published units to metres."""
    return [tuple(round(c / 100, 6) for c in corner) for corner in corners]


def cornell_room(name):
    """A document with the walls, the lamp and the published camera."""
    document = Document(name)
    floor = quad(*units((552.8, 0, 0), (0, 0, 0), (0, 0, 559.2), (549.6, 0, 559.2)))
    ceiling = quad(*units((556, 548.8, 0), (556, 548.8, 559.2), (0, 548.8, 559.2), (0, 548.8, 0)))
    back = quad(*units((549.6, 0, 559.2), (0, 0, 559.2), (0, 548.8, 559.2), (556, 548.8, 559.2)))
    document.place("floor, ceiling and back wall", merged((floor, ceiling, back)), WHITE)
    left = quad(*units((552.8, 0, 0), (549.6, 0, 559.2), (556, 548.8, 559.2), (556, 548.8, 0)))
    document.place("left wall", left, RED)
    right = quad(*units((0, 0, 559.2), (0, 0, 0), (0, 548.8, 0), (0, 548.8, 559.2)))
    document.place("right wall", right, GREEN)
    y = 548.8 - LAMP_DROP
    document.place("lamp", quad(*units((343, y, 227), (343, y, 332), (213, y, 332), (213, y, 227))), LAMP)
    # Published: focal length 0.035, film 0.025 x 0.025.
    document.camera("camera", (2.78, 2.73, -8.0), (2.78, 2.73, 0.0), 39.307648, 1.0)
    return document
