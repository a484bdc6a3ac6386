"""Pictures as the tests compare them: a PIL image in RGB. They come from files, from QEMU's screen, and from memory
that holds the pixels as a frame buffer has them."""
from dataclasses import dataclass

from PIL import Image, ImageChops

# Bits of red, green and blue in a pixel: (first bit, how many), and how many bytes a pixel has.
_LAYOUTS = {
    "r5g6b5": ((11, 5), (5, 6), (0, 5), 2),
    "x1r5g5b5": ((10, 5), (5, 5), (0, 5), 2),
    "r8g8b8": ((16, 8), (8, 8), (0, 8), 3),
    "x8r8g8b8": ((16, 8), (8, 8), (0, 8), 4),
    "a8b8g8r8": ((0, 8), (8, 8), (16, 8), 4),  # red and blue swapped
}


@dataclass(frozen=True)
class FrameBuffer:
    """Pixels in memory: `layout` as in the device tree's binding of simple-framebuffer, `stride` in bytes."""
    width: int
    height: int
    stride: int
    layout: str
    address: int = 0x4F000000

    @property
    def bytes(self):
        return self.stride * self.height

    def picture(self, memory):
        """What a screen shows of these bytes: a channel of n bits from 0 to 2^n-1 is dark to full."""
        *channels, size = _LAYOUTS[self.layout]
        pixels = bytearray()
        for y in range(self.height):
            row = memory[y * self.stride:y * self.stride + self.width * size]
            for x in range(0, len(row), size):
                pixel = int.from_bytes(row[x:x + size], "little")
                for first, bits in channels:
                    pixels.append(((pixel >> first) & ((1 << bits) - 1)) * 255 // ((1 << bits) - 1))
        return Image.frombytes("RGB", (self.width, self.height), bytes(pixels))


def load(path):
    with Image.open(path) as picture:
        return picture.convert("RGB")


def turned(picture, degrees):
    """Turned clockwise, as somebody sees it who looks at a panel mounted that way."""
    return picture.rotate(-degrees, expand=True)


def differing(one, other):
    """How many pixels differ; all of them where the sizes do."""
    if one.size != other.size:
        return max(one.width * one.height, other.width * other.height)
    difference = ImageChops.difference(one, other)
    any_channel = difference.split()
    worst = ImageChops.lighter(ImageChops.lighter(any_channel[0], any_channel[1]), any_channel[2])
    return one.width * one.height - worst.histogram()[0]


def largest_step(one, other):
    """The largest difference of a channel between two pictures of one size, of 255."""
    return max(high for _, high in ImageChops.difference(one, other).getextrema())
