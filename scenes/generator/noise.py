"""Repeatable randomness: integer hashing, and value noise that tiles. No state, the same on every machine."""

_MASK = 0xFFFFFFFF


def hashed(*integers):
    """32 well mixed bits of some integers."""
    bits = 0x9E3779B9
    for integer in integers:
        bits ^= integer & _MASK
        bits = (bits ^ bits >> 16) * 0x7FEB352D & _MASK
        bits = (bits ^ bits >> 15) * 0x846CA68B & _MASK
        bits ^= bits >> 16
    return bits


def unit(*integers):
    """A number in [0, 1) of some integers."""
    return hashed(*integers) / 2**32


class TiledNoise:
    """Smooth noise in [0, 1] over the unit square, `cells` lattice cells a side, that continues across its edges."""

    def __init__(self, cells_u, cells_v, seed):
        self._lattice = [[unit(seed, i, j) for i in range(cells_u)] for j in range(cells_v)]
        self._cells_u, self._cells_v = cells_u, cells_v

    def at(self, u, v):
        x, y = u * self._cells_u, v * self._cells_v
        i, j = int(x // 1), int(y // 1)
        s, t = x - i, y - j
        s, t = s * s * (3 - 2 * s), t * t * (3 - 2 * t)
        i0, i1 = i % self._cells_u, (i + 1) % self._cells_u
        row0, row1 = self._lattice[j % self._cells_v], self._lattice[(j + 1) % self._cells_v]
        a = row0[i0] + (row0[i1] - row0[i0]) * s
        b = row1[i0] + (row1[i1] - row1[i0]) * s
        return a + (b - a) * t


class Fractal:
    """A sum of octaves of tiled noise, each twice as fine and half as strong, in [0, 1]."""

    def __init__(self, cells_u, cells_v, octaves, seed):
        self._octaves = [
            (TiledNoise(cells_u << k, cells_v << k, seed + k), 0.5**k) for k in range(octaves)
        ]
        self._total = sum(weight for _, weight in self._octaves)

    def at(self, u, v):
        return sum(noise.at(u, v) * weight for noise, weight in self._octaves) / self._total
