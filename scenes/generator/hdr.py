"""Pictures of all directions with light of any strength, and the Radiance files (.hdr) they are kept in: three mantissas
and a common exponent a pixel, each component of a row run length encoded."""

from dataclasses import dataclass
from math import frexp, ldexp


@dataclass(frozen=True, eq=False)
class Environment:
    """Equirectangular, rows from top to bottom: the middle is +x, to the right of it is +z."""

    name: str
    width: int
    rows: list  # of linear Rec.709 triples; 1 stands for 1000 nits


def rgbe(colour):
    """The four bytes of a colour, mantissas rounded."""
    largest = max(colour)
    if largest <= 0:
        return (0, 0, 0, 0)
    exponent = frexp(largest)[1]
    if round(ldexp(largest, 8 - exponent)) == 256:
        exponent += 1
    return (*(round(ldexp(x, 8 - exponent)) for x in colour), exponent + 128)


def packed(component):
    """Bytes as runs: 128 + n and the byte that n bytes are, or n and n bytes."""
    result, literal, at = bytearray(), bytearray(), 0

    def end_literal():
        for first in range(0, len(literal), 128):
            part = literal[first : first + 128]
            result.extend([len(part), *part])
        literal.clear()

    while at < len(component):
        end = at
        while end < len(component) and end - at < 127 and component[end] == component[at]:
            end += 1
        if end - at >= 4:
            end_literal()
            result.extend([128 + end - at, component[at]])
        else:
            literal.extend(component[at:end])
        at = end
    end_literal()
    return result


def hdr_bytes(environment):
    """The file; the width must be 8 to 32767."""
    header = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {len(environment.rows)} +X {environment.width}\n"
    data = bytearray(header.encode("ascii"))
    for row in environment.rows:
        pixels = [rgbe(colour) for colour in row]
        data += bytes([2, 2, environment.width >> 8, environment.width & 255])
        for component in zip(*pixels):
            data += packed(bytes(component))
    return bytes(data)
