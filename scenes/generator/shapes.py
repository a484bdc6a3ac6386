"""Triangle meshes: plain surfaces first, then surfaces of revolution and tubes along a curve.

All triangles are counter-clockwise seen from outside (from the front of a flat shape), normals point the same way, and
texture coordinates are glTF's, (0, 0) at the upper left of the image. Curved shapes have smooth normals.
"""

import math
from dataclasses import dataclass, field

from generator.vectors import add, cross, dot, normalize, scale, sub


@dataclass(eq=False)
class Mesh:
    positions: list = field(default_factory=list)
    normals: list = field(default_factory=list)
    uvs: list = field(default_factory=list)
    triangles: list = field(default_factory=list)

    def vertex(self, position, normal, uv):
        self.positions.append(position)
        self.normals.append(normal)
        self.uvs.append(uv)
        return len(self.positions) - 1

    def append(self, other):
        """Adds the triangles of `other`."""
        first = len(self.positions)
        self.positions += other.positions
        self.normals += other.normals
        self.uvs += other.uvs
        self.triangles += [tuple(first + i for i in triangle) for triangle in other.triangles]
        return self

    def moved(self, offset):
        return Mesh([add(p, offset) for p in self.positions], self.normals, self.uvs, self.triangles)

    def inside_out(self):
        return Mesh(
            self.positions,
            [scale(n, -1) for n in self.normals],
            self.uvs,
            [(a, c, b) for a, b, c in self.triangles],
        )


def merged(meshes):
    result = Mesh()
    for mesh in meshes:
        result.append(mesh)
    return result


def quad(a, b, c, d, tiles=(1, 1)):
    """The flat quadrilateral a, b, c, d; its texture is upright when `a` is the lower left, repeated `tiles` times."""
    normal = normalize(cross(sub(c, a), sub(d, b)))
    mesh = Mesh()
    u, v = tiles
    for position, uv in zip((a, b, c, d), ((0, v), (u, v), (u, 0), (0, 0))):
        mesh.vertex(position, normal, uv)
    mesh.triangles = [(0, 1, 2), (0, 2, 3)]
    return mesh


def box(width, height, depth):
    """A box that stands on y = 0, centred in x and z."""
    x, y, z = width / 2, height, depth / 2
    return merged(
        (
            quad((-x, 0, z), (x, 0, z), (x, y, z), (-x, y, z)),
            quad((x, 0, -z), (-x, 0, -z), (-x, y, -z), (x, y, -z)),
            quad((x, 0, z), (x, 0, -z), (x, y, -z), (x, y, z)),
            quad((-x, 0, -z), (-x, 0, z), (-x, y, z), (-x, y, -z)),
            quad((-x, y, z), (x, y, z), (x, y, -z), (-x, y, -z)),
            quad((-x, 0, -z), (x, 0, -z), (x, 0, z), (-x, 0, z)),
        )
    )


def box_between(low, high):
    """The box with opposite corners `low` and `high`."""
    size = sub(high, low)
    return box(*size).moved((low[0] + size[0] / 2, low[1], low[2] + size[2] / 2))


def octahedron(radius):
    """Eight flat faces: the cheapest lamp that shines all around."""
    mesh = Mesh()
    for x in (-radius, radius):
        for y in (-radius, radius):
            for z in (-radius, radius):
                corners = [(x, 0, 0), (0, y, 0), (0, 0, z)]
                if x * y * z < 0:
                    corners.reverse()
                normal = normalize((x, y, z))
                mesh.triangles.append(tuple(mesh.vertex(corner, normal, (0, 0)) for corner in corners))
    return mesh


def icosphere(radius, level):
    """A sphere of 20 * 4^level almost equal triangles, without poles."""
    golden = (1 + math.sqrt(5)) / 2
    points = [
        normalize(p)
        for s in (-1, 1)
        for t in (-golden, golden)
        for p in ((0, s, t), (s, t, 0), (t, 0, s))
    ]
    edge = min(dot(sub(p, q), sub(p, q)) for p in points for q in points if p is not q) * 1.01
    near = lambda i, j: dot(sub(points[i], points[j]), sub(points[i], points[j])) < edge
    triangles = []
    for i in range(12):
        for j in range(i + 1, 12):
            for k in range(j + 1, 12):
                if near(i, j) and near(j, k) and near(i, k):
                    outward = dot(cross(sub(points[j], points[i]), sub(points[k], points[i])), points[i]) > 0
                    triangles.append((i, j, k) if outward else (i, k, j))
    for _ in range(level):
        middles = {}

        def middle(i, j):
            key = (min(i, j), max(i, j))
            if key not in middles:
                middles[key] = len(points)
                points.append(normalize(add(points[i], points[j])))
            return middles[key]

        finer = []
        for i, j, k in triangles:
            ij, jk, ki = middle(i, j), middle(j, k), middle(k, i)
            finer += [(i, ij, ki), (ij, j, jk), (ki, jk, k), (ij, jk, ki)]
        triangles = finer
    return Mesh([scale(p, radius) for p in points], points, [(0, 0)] * len(points), triangles)


def spline(points, steps=6):
    """A smooth polyline through `points` (Catmull-Rom), `steps` pieces between each two."""
    padded = [points[0], *points, points[-1]]
    result = []
    for a, b, c, d in zip(padded, padded[1:], padded[2:], padded[3:]):
        for i in range(steps):
            t = i / steps
            weights = (
                (-t + 2 * t * t - t * t * t) / 2,
                (2 - 5 * t * t + 3 * t * t * t) / 2,
                (t + 4 * t * t - 3 * t * t * t) / 2,
                (t * t * t - t * t) / 2,
            )
            result.append(tuple(sum(w * p[k] for w, p in zip(weights, (a, b, c, d))) for k in range(len(b))))
    return [*result, points[-1]]


def lathe(profile, slices=64, crease_degrees=40):
    """Turns the polyline of (radius, height) points about the y axis; its outside lies to the right of its direction
    (a profile from the top down makes an outer wall). Bends sharper than `crease_degrees` stay edges."""
    segments = []
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        length = math.hypot(r1 - r0, y1 - y0)
        segments.append(((y0 - y1) / length, (r1 - r0) / length))
    crease = math.cos(math.radians(crease_degrees))
    along = [0.0]
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        along.append(along[-1] + math.hypot(r1 - r0, y1 - y0))

    def normal_at(segment, neighbour):
        here = segments[segment]
        if not 0 <= neighbour < len(segments):
            return here
        there = segments[neighbour]
        if here[0] * there[0] + here[1] * there[1] < crease:
            return here
        total = (here[0] + there[0], here[1] + there[1])
        length = math.hypot(*total)
        return (total[0] / length, total[1] / length)

    mesh = Mesh()

    def ring(point, normal, v):
        vertices = []
        for i in range(slices + 1):
            # The seam repeats the first column exactly, so that the surface is closed.
            angle = 2 * math.pi * (i % slices) / slices
            c, s = math.cos(angle), math.sin(angle)
            position = (point[0] * s, point[1], point[0] * c)
            vertices.append(mesh.vertex(position, (normal[0] * s, normal[1], normal[0] * c), (i / slices, v)))
        return vertices

    lower, lower_normal = None, None
    for s in range(len(segments)):
        start, end = normal_at(s, s - 1), normal_at(s, s + 1)
        if start == lower_normal:
            upper = lower
        else:
            upper = ring(profile[s], start, along[s] / along[-1])
        lower, lower_normal = ring(profile[s + 1], end, along[s + 1] / along[-1]), end
        for i in range(slices):
            if profile[s + 1][0] > 0:
                mesh.triangles.append((upper[i], lower[i], lower[i + 1]))
            if profile[s][0] > 0:
                mesh.triangles.append((upper[i], lower[i + 1], upper[i + 1]))
    return mesh


def sphere(radius, slices=64, stacks=32):
    """A sphere about the origin."""
    angles = [math.pi * i / stacks for i in range(stacks + 1)]
    profile = [(radius * math.sin(a), radius * math.cos(a)) for a in angles]
    profile[0], profile[-1] = (0, radius), (0, -radius)
    mesh = lathe(profile, slices)
    mesh.normals = [scale(p, 1 / radius) for p in mesh.positions]
    return mesh


def disc(radius, segments=32):
    """A flat disc about the origin that faces +z."""
    mesh = Mesh()
    centre = mesh.vertex((0, 0, 0), (0, 0, 1), (0.5, 0.5))
    for i in range(segments):
        c, s = math.cos(2 * math.pi * i / segments), math.sin(2 * math.pi * i / segments)
        mesh.vertex((radius * c, radius * s, 0), (0, 0, 1), (0.5 + c / 2, 0.5 - s / 2))
    for i in range(segments):
        mesh.triangles.append((centre, 1 + i, 1 + (i + 1) % segments))
    return mesh


def tube(curve, radius, steps, sides):
    """A closed tube about `curve`, a function of t in [0, 1) that goes around the origin and returns to its start."""
    mesh = Mesh()
    for i in range(steps):
        here, ahead = curve(i / steps), curve((i + 0.01) / steps)
        tangent = normalize(sub(ahead, here))
        side = normalize(cross(tangent, add(ahead, here)))
        out = cross(side, tangent)
        for j in range(sides):
            angle = 2 * math.pi * j / sides
            normal = add(scale(out, math.cos(angle)), scale(side, math.sin(angle)))
            mesh.vertex(add(here, scale(normal, radius)), normal, (i / steps, j / sides))
    for i in range(steps):
        for j in range(sides):
            a, b = i * sides + j, i * sides + (j + 1) % sides
            c, d = (i + 1) % steps * sides + j, (i + 1) % steps * sides + (j + 1) % sides
            mesh.triangles += [(a, b, d), (a, d, c)]
    return mesh


def torus(ring_radius, tube_radius, steps=96, sides=32):
    """A ring about the y axis."""

    def circle(t):
        angle = 2 * math.pi * t
        return (ring_radius * math.cos(angle), 0, ring_radius * math.sin(angle))

    return tube(circle, tube_radius, steps, sides)


def torus_knot(turns, twists, ring_radius, winding_radius, tube_radius, steps=256, sides=24):
    """A knot that goes `turns` times around the z axis and `twists` times around the ring."""

    def knot(t):
        around, through = 2 * math.pi * turns * t, 2 * math.pi * twists * t
        distance = ring_radius + winding_radius * math.cos(through)
        return (distance * math.cos(around), distance * math.sin(around), winding_radius * math.sin(through))

    return tube(knot, tube_radius, steps, sides)
