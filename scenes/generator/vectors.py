"""Three-vectors as tuples, and rotations as glTF's unit quaternions (x, y, z, w)."""

import math


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normalize(a):
    return scale(a, 1 / math.sqrt(dot(a, a)))


def turn(axis, degrees):
    """The rotation by `degrees` about `axis`, counter-clockwise when the axis points at the viewer."""
    half = math.radians(degrees) / 2
    x, y, z = scale(normalize(axis), math.sin(half))
    return (x, y, z, math.cos(half))


def look_at(eye, target, up=(0, 1, 0)):
    """The rotation that turns -z from `eye` to `target`, as cameras and punctual lights look in glTF."""
    z = normalize(sub(eye, target))
    x = normalize(cross(up, z))
    y = cross(z, x)
    # The largest of the four components is found from the diagonal, the others from sums across it.
    squares = (1 + x[0] - y[1] - z[2], 1 - x[0] + y[1] - z[2], 1 - x[0] - y[1] + z[2], 1 + x[0] + y[1] + z[2])
    rows = (
        (squares[0], y[0] + x[1], z[0] + x[2], y[2] - z[1]),
        (y[0] + x[1], squares[1], z[1] + y[2], z[0] - x[2]),
        (z[0] + x[2], z[1] + y[2], squares[2], x[1] - y[0]),
        (y[2] - z[1], z[0] - x[2], x[1] - y[0], squares[3]),
    )
    largest = max(range(4), key=lambda i: squares[i])
    length = math.sqrt(sum(c * c for c in rows[largest]))
    return tuple(c / length for c in rows[largest])
