"""Pictures of 8-bit RGB, and the PNG files they are kept in (zlib does the packing)."""

import struct
import zlib
from dataclasses import dataclass


@dataclass(frozen=True, eq=False)
class Picture:
    """Rows from top to bottom, three bytes a pixel. Coloured ones are sRGB, data (roughness) is linear."""

    name: str
    width: int
    height: int
    rgb: bytes


def srgb_byte(linear):
    """The sRGB code of a linear value, clamped to [0, 1]."""
    x = min(max(linear, 0.0), 1.0)
    return round(255 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055))


def linear_byte(value):
    return round(255 * min(max(value, 0.0), 1.0))


def paint(name, width, height, pixel, encode=srgb_byte):
    """The picture whose pixel (x, y) has the linear colour `pixel(u, v)` at its centre, u and v in (0, 1)."""
    rgb = bytearray()
    for y in range(height):
        for x in range(width):
            rgb += bytes(map(encode, pixel((x + 0.5) / width, (y + 0.5) / height)))
    return Picture(name, width, height, bytes(rgb))


def png_bytes(picture):
    """The file: each row is stored as differences to the pixel before it (filter 1), which packs smooth rows well."""
    stride = 3 * picture.width
    rows = bytearray()
    for start in range(0, len(picture.rgb), stride):
        row = picture.rgb[start : start + stride]
        rows.append(1)
        rows += bytes((value - left) & 255 for value, left in zip(row, b"\0\0\0" + row))

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(bytes(rows), 9))
        + chunk(b"IEND", b"")
    )
