"""What surfaces are made of: a glTF material in a few numbers, and the kinds that the scenes use."""

from dataclasses import dataclass
from typing import Optional

from generator.png import Picture


@dataclass(frozen=True, eq=False)
class Material:
    """Colours are linear Rec.709, `emission` is in nits; a texture multiplies the factors of its kind."""

    name: str
    base: tuple = (1.0, 1.0, 1.0)
    metallic: float = 0.0
    roughness: float = 1.0
    base_picture: Optional[Picture] = None
    metallic_roughness_picture: Optional[Picture] = None
    emission: tuple = (0.0, 0.0, 0.0)
    specular: float = 1.0
    ior: float = 1.5
    transmission: float = 0.0
    thickness: float = 0.0

    @property
    def textured(self):
        return self.base_picture is not None or self.metallic_roughness_picture is not None


def matte(name, colour=(1.0, 1.0, 1.0), picture=None):
    """Pure Lambert: no specular reflection at all."""
    return Material(name, colour, specular=0.0, base_picture=picture)


def glossy(name, colour=(1.0, 1.0, 1.0), roughness=0.1, picture=None, roughness_picture=None):
    """A dielectric coat (index 1.5) over a matte base: plastic, polish, varnish."""
    return Material(
        name, colour, roughness=roughness, base_picture=picture, metallic_roughness_picture=roughness_picture
    )


def metal(name, colour, roughness, picture=None):
    """`picture`: roughness in green, metalness in blue."""
    return Material(name, colour, 1.0, roughness, metallic_roughness_picture=picture)


def glass(name, ior=1.5, colour=(1.0, 1.0, 1.0)):
    """A clear solid that refracts: its mesh must be closed."""
    return Material(name, colour, roughness=0.0, ior=ior, transmission=1.0, thickness=1.0)


def lamp(name, nits):
    """Shines from its front face only and reflects nothing."""
    return Material(name, (0.0, 0.0, 0.0), specular=0.0, emission=nits)
