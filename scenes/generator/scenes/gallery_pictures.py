"""The painted and woven surfaces of the gallery: every picture is a function of (u, v), none is drawn by hand."""

from math import exp, pi, sin

from generator.noise import Fractal, TiledNoise
from generator.png import linear_byte, paint


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def smooth_step(low, high, x):
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3 - 2 * t)


def marble_floor():
    """Two by two tiles, dark and light, with veins where a warped noise crosses its middle."""
    cloud, warp = Fractal(4, 4, 4, seed=21), Fractal(3, 3, 3, seed=31)

    def pixel(u, v):
        tile = (int(2 * u), int(2 * v))
        bend = 0.35 * warp.at(u, v)
        vein = abs(cloud.at(u + bend + 0.37 * tile[0], v - bend + 0.61 * tile[1]) - 0.5)
        streak = exp(-vein * 38)
        edge = min(2 * u % 1, 1 - 2 * u % 1, 2 * v % 1, 1 - 2 * v % 1)
        if sum(tile) % 2:
            colour = mix((0.018, 0.022, 0.024), (0.22, 0.24, 0.23), streak)
        else:
            colour = mix((0.62, 0.58, 0.52), (0.3, 0.27, 0.24), 0.7 * streak)
        return mix((0.06, 0.055, 0.05), colour, smooth_step(0.004, 0.01, edge))

    return paint("floor", 512, 512, pixel)


def worn_polish():
    """Roughness in green: polish that many feet have dulled in patches."""
    wear = Fractal(5, 5, 3, seed=41)

    def pixel(u, v):
        return (1.0, 0.12 + 0.3 * smooth_step(0.35, 0.75, wear.at(u, v)), 0.0)

    return paint("floor-roughness", 128, 128, pixel, linear_byte)


def wood():
    """Boards cut along the trunk: rings stretched along u."""
    grain, fibre = Fractal(2, 6, 3, seed=51), TiledNoise(8, 128, seed=61)

    def pixel(u, v):
        ring = 0.5 + 0.5 * sin(2 * pi * (5 * v + 3.2 * grain.at(u, v)))
        colour = mix((0.23, 0.1, 0.04), (0.42, 0.22, 0.095), ring)
        return mix(colour, (0.12, 0.05, 0.02), 0.35 * fibre.at(u, v))

    return paint("wood", 256, 256, pixel)


def brushed():
    """Roughness in green, metalness in blue: fine scratches around the turned axis, with tarnished bands."""
    scratch, tarnish = TiledNoise(4, 192, seed=71), Fractal(3, 3, 3, seed=81)

    def pixel(u, v):
        roughness = 0.2 + 0.22 * scratch.at(u, v) + 0.25 * smooth_step(0.5, 0.75, tarnish.at(u, v))
        return (1.0, roughness, 1.0)

    return paint("brushed", 256, 256, pixel, linear_byte)


# One period of a Greek key, rows from the top.
MEANDER = (
    "##########",
    ".........#",
    "#######..#",
    "#.....#..#",
    "#..####..#",
    "#..#.....#",
    "#..#######",
    "#.........",
    "##########",
)


def pottery():
    """Black figures on red clay: bands, a Greek key, rays above the foot. u goes around, v down the wall."""
    blotch = Fractal(6, 6, 3, seed=91)
    clay, glaze = (0.5, 0.2, 0.085), (0.025, 0.02, 0.018)
    keys, key_top, key_height = 20, 0.36, 0.085

    def painted(u, v):
        if key_top <= v < key_top + key_height:
            row = MEANDER[int((v - key_top) / key_height * len(MEANDER))]
            return row[int(u * keys % 1 * len(row))] == "#"
        if 0.74 < v < 0.9:
            return abs(u * 24 % 1 - 0.5) < 0.5 * (v - 0.74) / 0.16
        bands = ((0.0, 0.13), (0.33, 0.345), (0.46, 0.475), (0.5, 0.51), (0.6, 0.7), (0.9, 1.0))
        return any(low <= v < high for low, high in bands)

    def pixel(u, v):
        return mix(glaze if painted(u, v) else clay, (0.3, 0.14, 0.07), 0.35 * blotch.at(u, v))

    return paint("pottery", 512, 256, pixel)


def landscape():
    """The painting: a low sun between ranges of hills, over a lake."""
    ridges = [Fractal(2 + k, 1, 4, seed=101 + 10 * k) for k in range(4)]
    ripple, canvas = TiledNoise(6, 90, seed=151), TiledNoise(256, 170, seed=161)
    sun, horizon = (0.66, 0.25), 0.66

    def sky(u, v):
        colour = mix((0.03, 0.07, 0.2), (0.75, 0.3, 0.1), smooth_step(0.0, 0.5, v))
        distance = ((u - sun[0]) ** 2 * 2.25 + (v - sun[1]) ** 2) ** 0.5
        colour = mix(colour, (1.0, 0.72, 0.34), 0.8 * exp(-distance * 7))
        return mix((1.0, 0.93, 0.72), colour, smooth_step(0.05, 0.058, distance))

    def land(u, v):
        colour = sky(u, v)
        for k, ridge in enumerate(ridges):
            top = 0.36 + 0.09 * k - 0.2 * (1 - 0.15 * k) * (ridge.at(u, 0.0) - 0.42)
            haze = mix((0.4, 0.17, 0.13), (0.015, 0.03, 0.045), k / 3)
            colour = mix(colour, haze, smooth_step(top - 0.002, top + 0.002, v))
        return colour

    def pixel(u, v):
        if v < horizon:
            colour = land(u, v)
        else:
            depth = (v - horizon) / (1 - horizon)
            shake = (ripple.at(u, v) - 0.5) * (0.01 + 0.05 * depth)
            colour = mix(land(u + shake, horizon - 0.9 * (v - horizon) + shake), (0.03, 0.06, 0.1), 0.3 + 0.25 * depth)
        return mix(colour, (0.0, 0.0, 0.0), 0.12 * canvas.at(u, v))

    return paint("landscape", 512, 512, pixel)
