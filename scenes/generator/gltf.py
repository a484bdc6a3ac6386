"""A glTF 2.0 scene under construction, and its files: NAME.gltf, NAME.bin and a PNG a picture.

Numbers are rounded before they are written, so that the last bit of a machine's sine does not change a file.
"""

import json
import math
import struct

from generator.png import png_bytes
from generator.vectors import look_at

_FLOAT, _UINT16, _UINT32 = 5126, 5123, 5125
_VERTICES, _INDICES = 34962, 34963


def _rounded(values, digits=9):
    # Adding zero turns -0.0 into 0.0.
    return [round(float(value), digits) + 0.0 for value in values]


class Document:
    """Everything is placed with `place`, `camera`, `spot_light`, ...; `save` writes the files."""

    def __init__(self, name):
        self.name = name
        self._nodes = []
        self._roots = []
        self._meshes = []
        self._mesh_of = {}
        self._geometry_of = {}
        self._materials = []
        self._material_of = {}
        self._pictures = []
        self._lights = []
        self._cameras = []
        self._accessors = []
        self._views = []
        self._binary = bytearray()
        self._extensions = set()
        self._environment = None

    def place(self, name, mesh, material, at=None, rotation=None, scale=None, parent=None):
        """A node that shows `mesh` in `material`; the same pair placed again shares its data. Returns the node."""
        if (mesh, material) not in self._mesh_of:
            self._mesh_of[mesh, material] = len(self._meshes)
            self._meshes.append({"name": name, "primitives": [self._primitive(mesh, material)]})
        return self._node(name, parent, at, rotation, scale, mesh=self._mesh_of[mesh, material])

    def group(self, name, at=None, rotation=None, scale=None, parent=None):
        """A node to place others under."""
        return self._node(name, parent, at, rotation, scale)

    def camera(self, name, eye, target, yfov_degrees, aspect):
        yfov = round(math.radians(yfov_degrees), 9)
        perspective = {"yfov": yfov, "aspectRatio": aspect, "znear": 0.01}
        self._cameras.append({"name": name, "type": "perspective", "perspective": perspective})
        self._node(name, None, eye, look_at(eye, target), None, camera=len(self._cameras) - 1)

    def spot_light(self, name, candela, colour, inner_degrees, outer_degrees, parent, at=None):
        """Shines along the -z of its parent. `candela` at the centre of the cone."""
        spot = {"innerConeAngle": math.radians(inner_degrees), "outerConeAngle": math.radians(outer_degrees)}
        light = {"name": name, "type": "spot", "color": colour, "intensity": candela}
        light["spot"] = {key: round(angle, 9) for key, angle in spot.items()}
        self._lights.append(light)
        self._extensions.add("KHR_lights_punctual")
        reference = {"KHR_lights_punctual": {"light": len(self._lights) - 1}}
        self._node(name, parent, at, None, None, extensions=reference)

    def environment(self, zenith, horizon, ground):
        """The sky around the scene, in nits."""
        self._environment = {"zenith": zenith, "horizon": horizon, "ground": ground}

    def save(self, folder):
        for picture in self._pictures:
            (folder / self._picture_file(picture)).write_bytes(png_bytes(picture))
        (folder / f"{self.name}.bin").write_bytes(self._binary)
        (folder / f"{self.name}.gltf").write_text(_one_item_a_line(self._json()), encoding="utf-8", newline="\n")

    def _node(self, name, parent, at, rotation, scale, **content):
        node = {"name": name, **content}
        if at is not None:
            node["translation"] = _rounded(at)
        if rotation is not None:
            node["rotation"] = _rounded(rotation)
        if scale is not None:
            node["scale"] = _rounded(scale)
        self._nodes.append(node)
        index = len(self._nodes) - 1
        if parent is None:
            self._roots.append(index)
        else:
            self._nodes[parent].setdefault("children", []).append(index)
        return index

    def _primitive(self, mesh, material):
        key = (mesh, material.textured)
        if key not in self._geometry_of:
            self._geometry_of[key] = self._geometry(mesh, material.textured)
        return {**self._geometry_of[key], "material": self._material(material)}

    def _geometry(self, mesh, textured):
        attributes = {"POSITION": self._vectors(mesh.positions, "VEC3", with_bounds=True)}
        attributes["NORMAL"] = self._vectors(mesh.normals, "VEC3")
        if textured:
            attributes["TEXCOORD_0"] = self._vectors(mesh.uvs, "VEC2")
        wide = len(mesh.positions) > 65535
        indices = [index for triangle in mesh.triangles for index in triangle]
        packed = struct.pack(f"<{len(indices)}{'I' if wide else 'H'}", *indices)
        accessor = self._accessor(packed, _INDICES, _UINT32 if wide else _UINT16, len(indices), "SCALAR")
        return {"attributes": attributes, "indices": accessor}

    def _vectors(self, vectors, kind, with_bounds=False):
        rows = [struct.pack(f"<{len(vector)}f", *_rounded(vector, 6)) for vector in vectors]
        accessor = self._accessor(b"".join(rows), _VERTICES, _FLOAT, len(rows), kind)
        if with_bounds:
            # Bounds must equal the stored 32-bit values, so they are read back.
            columns = list(zip(*(struct.unpack("<3f", row) for row in rows)))
            self._accessors[accessor]["min"] = [min(column) for column in columns]
            self._accessors[accessor]["max"] = [max(column) for column in columns]
        return accessor

    def _accessor(self, data, target, component, count, kind):
        view = {"buffer": 0, "byteOffset": len(self._binary), "byteLength": len(data), "target": target}
        self._binary += data + b"\0" * (-len(data) % 4)
        self._views.append(view)
        index = len(self._views) - 1
        self._accessors.append({"bufferView": index, "componentType": component, "count": count, "type": kind})
        return len(self._accessors) - 1

    def _material(self, material):
        if material not in self._material_of:
            self._material_of[material] = len(self._materials)
            self._materials.append(self._material_json(material))
        return self._material_of[material]

    def _material_json(self, material):
        surface = {"metallicFactor": material.metallic, "roughnessFactor": material.roughness}
        if material.base != (1.0, 1.0, 1.0):
            surface["baseColorFactor"] = [*_rounded(material.base), 1.0]
        if material.base_picture:
            surface["baseColorTexture"] = {"index": self._texture(material.base_picture)}
        if material.metallic_roughness_picture:
            surface["metallicRoughnessTexture"] = {"index": self._texture(material.metallic_roughness_picture)}
        extensions = {}
        result = {"name": material.name, "pbrMetallicRoughness": surface}
        strength = max(material.emission)
        if strength > 0:
            result["emissiveFactor"] = _rounded(nits / max(strength, 1) for nits in material.emission)
        if strength > 1:
            extensions["KHR_materials_emissive_strength"] = {"emissiveStrength": round(strength, 9)}
        if material.specular != 1:
            extensions["KHR_materials_specular"] = {"specularFactor": material.specular}
        if material.transmission > 0:
            extensions["KHR_materials_transmission"] = {"transmissionFactor": material.transmission}
            extensions["KHR_materials_volume"] = {"thicknessFactor": material.thickness}
            extensions["KHR_materials_ior"] = {"ior": material.ior}
        if extensions:
            result["extensions"] = extensions
        self._extensions |= extensions.keys()
        return result

    def _texture(self, picture):
        if picture not in self._pictures:
            self._pictures.append(picture)
        return self._pictures.index(picture)

    def _picture_file(self, picture):
        return f"{self.name}-{picture.name}.png"

    def _json(self):
        scene = {"name": self.name, "nodes": self._roots}
        if self._environment:
            scene["extras"] = {"vitrine": {"environment": self._environment}}
        result = {"asset": {"version": "2.0", "generator": "vitrine scenes/generate.py"}}
        result |= {"scene": 0, "scenes": [scene], "nodes": self._nodes, "meshes": self._meshes}
        result |= {"cameras": self._cameras, "materials": self._materials}
        if self._pictures:
            repeating_bilinear = {"magFilter": 9729, "minFilter": 9729}
            pictures = range(len(self._pictures))
            result["samplers"] = [repeating_bilinear]
            result["textures"] = [{"sampler": 0, "source": i} for i in pictures]
            result["images"] = [{"name": p.name, "uri": self._picture_file(p)} for p in self._pictures]
        result |= {"accessors": self._accessors, "bufferViews": self._views}
        result["buffers"] = [{"byteLength": len(self._binary), "uri": f"{self.name}.bin"}]
        if self._lights:
            result["extensions"] = {"KHR_lights_punctual": {"lights": self._lights}}
        if self._extensions:
            result["extensionsUsed"] = sorted(self._extensions)
        return result


def _one_item_a_line(document):
    """JSON with one line for every node, mesh, material, ...: short enough to read, fine enough to compare."""
    members = []
    for key, value in document.items():
        if isinstance(value, list):
            body = "[\n" + ",\n".join("    " + json.dumps(item) for item in value) + "\n  ]"
        else:
            body = json.dumps(value)
        members.append(f"  {json.dumps(key)}: {body}")
    return "{\n" + ",\n".join(members) + "\n}\n"
