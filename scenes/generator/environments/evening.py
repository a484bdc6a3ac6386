"""A clear evening: a low sun of a degree and a half, a glow around it, a blue sky that is red at the horizon, dark land.
Most of the light comes from the sun: from a twenty thousandth of all directions."""

from math import cos, exp, pi, radians, sin

from generator.hdr import Environment

WIDTH, HEIGHT = 256, 128
SUN_AZIMUTH, SUN_ELEVATION, SUN_RADIUS = radians(50), radians(14), radians(0.75)  # azimuth: from +x towards +z
SUN, GLOW = (9000.0, 5800.0, 2900.0), (1.6, 0.75, 0.3)
ZENITH, HAZE, LAND = (0.10, 0.19, 0.45), (0.75, 0.48, 0.34), (0.05, 0.045, 0.04)
SUN_AT = (cos(SUN_ELEVATION) * cos(SUN_AZIMUTH), sin(SUN_ELEVATION), cos(SUN_ELEVATION) * sin(SUN_AZIMUTH))
SUBPIXELS = 8  # a side, where the sun is


def direction(u, v):
    azimuth, polar = 2 * pi * (u - 0.5), pi * v
    return (sin(polar) * cos(azimuth), cos(polar), sin(polar) * sin(azimuth))


def mix(a, b, x):
    return tuple(p + (q - p) * x for p, q in zip(a, b))


def sky(w):
    """Without the sun's disc."""
    towards_sun = sum(p * q for p, q in zip(w, SUN_AT))
    colour = mix(ZENITH, HAZE, exp(-6 * max(0.0, w[1])))
    colour = tuple(c + g * exp(-14 * (1 - towards_sun)) for c, g in zip(colour, GLOW))
    return mix(colour, LAND, min(1.0, max(0.0, -w[1] / 0.02)))


def pixel(x, y):
    colour = sky(direction((x + 0.5) / WIDTH, (y + 0.5) / HEIGHT))
    inside = 0
    for i in range(SUBPIXELS * SUBPIXELS):
        w = direction((x + (i % SUBPIXELS + 0.5) / SUBPIXELS) / WIDTH, (y + (i // SUBPIXELS + 0.5) / SUBPIXELS) / HEIGHT)
        inside += sum(p * q for p, q in zip(w, SUN_AT)) > cos(SUN_RADIUS)
    return mix(colour, SUN, inside / SUBPIXELS**2) if inside else colour


def build():
    return Environment("evening", WIDTH, [[pixel(x, y) for x in range(WIDTH)] for y in range(HEIGHT)])
