"""Pixels as a screen's memory holds them: which bits of a word are red, green and blue, and what becomes of a picture
that has more bits than these. The dither is stated here anew, from its definition and not from the program's code:
level = floor((value * (2^bits - 1) + floor((bayer(x mod 8, y mod 8) * 255 + 127) / 64)) / 255),
with Bayer's matrix grown by M -> [[4M, 4M+2], [4M+3, 4M+1]]. So what must be in memory is known to the last bit."""
from dataclasses import dataclass

from PIL import Image


@dataclass(frozen=True)
class Layout:
    """Red, green and blue as (first bit, how many), bytes a pixel, and the bits that say "opaque"."""
    red: tuple
    green: tuple
    blue: tuple
    bytes: int
    opaque: int = 0

    @property
    def colours(self):
        return self.red, self.green, self.blue


# By the names that the device tree's binding of simple-framebuffer gives them.
LAYOUTS = {
    "r5g6b5": Layout((11, 5), (5, 6), (0, 5), 2),
    "r5g5b5a1": Layout((11, 5), (6, 5), (1, 5), 2, opaque=1),
    "r8g8b8": Layout((16, 8), (8, 8), (0, 8), 3),
    "a8b8g8r8": Layout((0, 8), (8, 8), (16, 8), 4, opaque=0xFF000000),
    "x2r10g10b10": Layout((20, 10), (10, 10), (0, 10), 4),
}


def _bayer(size):
    if size == 1:
        return [[0]]
    half = _bayer(size // 2)
    return [[4 * value + more for more in row for value in line]
            for row in ((0, 2), (3, 1)) for line in half]


_OFFSETS = [[(value * 255 + 127) // 64 for value in row] for row in _bayer(8)]


def level(value, bits, x, y):
    """What 8 bits of a colour become in `bits`, at a place of the screen: dithered, or with more bits the nearest."""
    offset = _OFFSETS[y % 8][x % 8] if bits <= 8 else 127
    return (value * ((1 << bits) - 1) + offset) // 255


def _brightness(colour, bits):
    return colour * 255 // ((1 << bits) - 1)


def shown_in(layout, picture):
    """The picture as a screen of that layout shows it."""
    bits = [bits for _, bits in LAYOUTS[layout].colours]
    values = bytearray(picture.tobytes())
    for at, value in enumerate(values):
        y, x = divmod(at // 3, picture.width)
        values[at] = _brightness(level(value, bits[at % 3], x, y), bits[at % 3])
    return Image.frombytes("RGB", picture.size, bytes(values))


def seen_in(layout, screenshot):
    """A screenshot in which the layout's bits are the uppermost of 8, in the brightnesses of shown_in()."""
    return screenshot.point([_brightness(value >> 8 - bits, bits)
                             for _, bits in LAYOUTS[layout].colours for value in range(256)])


@dataclass(frozen=True)
class FrameBuffer:
    """Memory that a screen shows: `layout` of LAYOUTS, `stride` in bytes from row to row."""
    width: int
    height: int
    stride: int
    layout: str
    address: int

    @property
    def size(self):
        return self.width, self.height

    @property
    def bytes(self):
        return self.stride * self.height

    def memory(self, picture):
        """What must be in it when it shows a picture of its size: nothing was ever written between the rows."""
        layout = LAYOUTS[self.layout]
        values = picture.tobytes()
        memory = bytearray(self.bytes)
        for y in range(self.height):
            for x in range(self.width):
                pixel = layout.opaque
                for value, (first, bits) in zip(values[(y * self.width + x) * 3:], layout.colours):
                    pixel |= level(value, bits, x, y) << first
                at = y * self.stride + x * layout.bytes
                memory[at:at + layout.bytes] = pixel.to_bytes(layout.bytes, "little")
        return bytes(memory)

    def picture(self, memory):
        """What a screen shows of these bytes: a channel of n bits from 0 to 2^n-1 is dark to full."""
        layout = LAYOUTS[self.layout]
        shown = bytearray()
        for y in range(self.height):
            row = memory[y * self.stride:y * self.stride + self.width * layout.bytes]
            for x in range(0, len(row), layout.bytes):
                pixel = int.from_bytes(row[x:x + layout.bytes], "little")
                shown += bytes(_brightness(pixel >> first & (1 << bits) - 1, bits) for first, bits in layout.colours)
        return Image.frombytes("RGB", self.size, bytes(shown))
