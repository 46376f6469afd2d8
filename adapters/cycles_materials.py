"""Materials, textures and emitter shaders of orbs-scene/1 as Cycles node trees (Blender 3.4), for adapters/cycles.py.

What Cycles computes was read in the kernel sources that Blender ships (addons/cycles/source/kernel):
- Diffuse BSDF with roughness s > 0 is f = c (a + b t), a = 1 / (pi + (3 pi - 4) s / 6), b = s a; t is the Oren-Nayar term
  cos(dphi) sin(alpha) tan(beta) where it is positive, and sin(theta_i) sin(theta_o) cos(dphi) where it is negative.
- Glossy and Refraction GGX use separable Smith masking and no Fresnel factor; alpha = roughness^2.
- Anisotropic GGX is separable as well; exactly along the normal each of its two factors is 2 in place of 1.
- Refraction does not scale radiance by the squared index: the adapter multiplies it in.
- 8-bit sRGB images are interpolated in their encoded form: the adapter hands over decoded float texels instead.
"""

import math
from array import array
from dataclasses import dataclass

import bpy

SRGB_BYTES = [v / 255 / 12.92 if v / 255 <= 0.04045 else ((v / 255 + 0.055) / 1.055) ** 2.4 for v in range(256)]
FLOAT_FORMATS = (".exr", ".hdr", ".pfm")


class Nodes:
    """Builds a node tree; functions take sockets and plain numbers alike."""

    def __init__(self, tree):
        self.tree = tree

    def node(self, kind, inputs=(), **properties):
        node = self.tree.nodes.new(kind)
        for key, value in properties.items():
            setattr(node, key, value)
        for key, value in dict(inputs).items():
            self.connect(value, node.inputs[key])
        return node

    def connect(self, value, socket):
        if isinstance(value, bpy.types.NodeSocket):
            self.tree.links.new(value, socket)
        elif socket.type == "RGBA":
            socket.default_value = (*value, 1.0)
        else:
            socket.default_value = value

    def math(self, operation, *operands):
        return self.node("ShaderNodeMath", enumerate(operands), operation=operation).outputs["Value"]

    def vector(self, operation, *operands):
        node = self.node("ShaderNodeVectorMath", enumerate(operands), operation=operation)
        return node.outputs["Value" if operation in ("DOT_PRODUCT", "LENGTH") else "Vector"]

    def scaled(self, vector, factor):
        node = self.node("ShaderNodeVectorMath", {"Vector": vector, "Scale": factor}, operation="SCALE")
        return node.outputs["Vector"]

    def affine(self, vector, factors, offset):
        """Returns the socket of dot(vector, factors) + offset."""
        return self.math("ADD", self.vector("DOT_PRODUCT", vector, factors), offset)


class Shader(Nodes):
    """The node tree of a new material."""

    def __init__(self, name):
        self.material = bpy.data.materials.new(name)
        self.material.use_nodes = True
        super().__init__(self.material.node_tree)
        self.tree.nodes.clear()

    def finish(self, surface):
        self.node("ShaderNodeOutputMaterial", {"Surface": surface}, target="CYCLES")
        return self.material


# --- textures -------------------------------------------------------------------------------------------------------


def srgb_to_linear(value):
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


@dataclass
class Texture:
    """An image as the scene wraps ("repeat", "clamp" or "mirror" of u and v) and filters it ("linear", "nearest")."""

    image: object
    wraps: tuple
    filter: str


def load_texture(path, encoding="srgb"):
    """Loads the file as linear float texels, so that Cycles filters after the decoding and not before."""
    source = bpy.data.images.load(path)
    source.colorspace_settings.name = "Non-Color"
    source.alpha_mode = "CHANNEL_PACKED"
    width, height = source.size
    if width == 0 or height == 0:
        raise ValueError(f"{path}: Blender cannot read this image")
    texels = array("f", bytes(4 * 4 * width * height))
    source.pixels.foreach_get(texels)
    if encoding == "srgb" and not path.lower().endswith(FLOAT_FORMATS):
        decode = (lambda v: srgb_to_linear(v)) if source.is_float else (lambda v: SRGB_BYTES[round(v * 255)])
        for channel in range(3):
            texels[channel::4] = array("f", map(decode, texels[channel::4]))
    texels[3::4] = array("f", [1.0]) * (width * height)
    bpy.data.images.remove(source)
    return float_image(path, width, height, texels)


def float_image(name, width, height, texels):
    """Makes a non-colour RGBA float image of `texels`, row by row from the bottom (v = 0)."""
    image = bpy.data.images.new(name, width, height, alpha=True, float_buffer=True, is_data=True)
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "CHANNEL_PACKED"
    image.use_half_precision = False
    image.pixels.foreach_set(texels)
    image.update()
    image.pack()  # Cycles would read an image that is not packed from the path in its name.
    return image


UV_LAYERS = ("uv", "uv1")  # by the set of texture coordinates


def sampled_texture(shader, use, textures):
    """Colour socket of a texture use {name, matrix, uv_set}. Blender wraps both axes alike and mirrors none, so a mirrored axis
    is folded to [0, 1] by nodes; it, and a single clamped axis, is clamped to its outermost texel centres, beyond which
    the edge texels stand alone: the same thing."""
    image, wraps = textures[use["name"]].image, textures[use["name"]].wraps
    m = use["matrix"]
    uv = shader.node("ShaderNodeUVMap", uv_map=UV_LAYERS[use["uv_set"]]).outputs["UV"]
    coordinates = [shader.affine(uv, (m[0], m[1], 0.0), m[3]), shader.affine(uv, (m[4], m[5], 0.0), m[7])]
    for axis, wrap in enumerate(wraps):
        if wrap == "mirror":
            coordinates[axis] = shader.math("PINGPONG", coordinates[axis], 1.0)
        if wrap == "mirror" or (wrap == "clamp" and wraps != ("clamp", "clamp")):
            edge = 0.5 / image.size[axis]
            coordinates[axis] = shader.math("MINIMUM", shader.math("MAXIMUM", coordinates[axis], edge), 1 - edge)
    vector = shader.node("ShaderNodeCombineXYZ", {"X": coordinates[0], "Y": coordinates[1]}).outputs["Vector"]
    extension = "EXTEND" if wraps == ("clamp", "clamp") else "REPEAT"
    interpolation = "Closest" if textures[use["name"]].filter == "nearest" else "Linear"
    return image_lookup(shader, image, vector, extension, interpolation)


def image_lookup(shader, image, vector, extension, interpolation="Linear"):
    properties = {"image": image, "interpolation": interpolation, "extension": extension}
    return shader.node("ShaderNodeTexImage", {"Vector": vector}, **properties).outputs["Color"]


def coloured(shader, colour, use, textures):
    """Returns the constant colour times the texture, if there is one."""
    return shader.vector("MULTIPLY", sampled_texture(shader, use, textures), colour) if use else colour


# --- surfaces -------------------------------------------------------------------------------------------------------


def oren_nayar_mapping(roughness):
    """(roughness, factor on the colour) of the Diffuse BSDF that has the constant term A and the slope B of
    f = rho / pi (A + B max(0, cos(dphi)) sin(alpha) tan(beta)), sigma = roughness pi / 2. B / A < 0.78 for every sigma."""
    sigma2 = (roughness * math.pi / 2) ** 2
    a = 1 - 0.5 * sigma2 / (sigma2 + 0.33)
    b = 0.45 * sigma2 / (sigma2 + 0.09)
    return b / a, a * (1 + (3 * math.pi - 4) / (6 * math.pi) * b / a)


def diffuse(shader, colour, roughness=0.0):
    return shader.node("ShaderNodeBsdfDiffuse", {"Color": colour, "Roughness": roughness}).outputs["BSDF"]


def distribution_of(alpha):
    """The name of the microfacet distribution of this width. Blender 4.0 has dropped SHARP: GGX without width is that."""
    return "SHARP" if alpha == 0 and bpy.app.version < (4, 0) else "GGX"


def glossy(shader, colour, alpha):
    distribution = distribution_of(alpha)
    return shader.node("ShaderNodeBsdfGlossy", {"Color": colour, "Roughness": math.sqrt(alpha)},
                       distribution=distribution).outputs["BSDF"]  # fmt: skip


def dielectric(shader, m, alpha, scales_radiance):
    """Glass of the description `m`. Cycles keeps radiance as it is at a refraction. With `scales_radiance` the factor
    ior^2 on entry and 1 / ior^2 on exit is put in; a camera path meets it the other way round: 1 / ior^2 at a front
    (outside) hit, ior^2 at a back hit. Without it the Glass BSDF is the same thing with less noise."""
    colour, ior, distribution = m["colour"], m["ior"], distribution_of(alpha)
    common = {"Roughness": math.sqrt(alpha), "IOR": ior}
    if not scales_radiance:
        node = shader.node("ShaderNodeBsdfGlass", {"Color": colour, **common}, distribution=distribution)
        return node.outputs["BSDF"]
    inside = shader.node("ShaderNodeNewGeometry").outputs["Backfacing"]
    scale = shader.math("MULTIPLY_ADD", inside, ior**2 - ior**-2, ior**-2)
    inputs = {"Color": shader.scaled(colour, scale), **common}
    refraction = shader.node("ShaderNodeBsdfRefraction", inputs, distribution=distribution).outputs["BSDF"]
    fresnel = shader.node("ShaderNodeFresnel", {"IOR": ior}).outputs["Fac"]
    mix = shader.node("ShaderNodeMixShader", {0: fresnel, 1: refraction, 2: glossy(shader, colour, alpha)})
    return mix.outputs["Shader"]


def emission(shader, radiance, strength=1.0):
    return shader.node("ShaderNodeEmission", {"Color": radiance, "Strength": strength}).outputs["Emission"]


@dataclass
class Surroundings:
    """Holds what the materials of a scene share: images and wraps by texture name, whether glass scales radiance, the
    parts of blends, and Blender's units per metre."""

    textures: dict
    scales_radiance: bool
    descriptions: dict  # of all materials, by name
    scale: float = 1.0


def _lambert(shader, m, around):
    return diffuse(shader, coloured(shader, m["reflectance"], m.get("texture"), around.textures))


def _oren_nayar(shader, m, around):
    roughness, factor = oren_nayar_mapping(m["roughness"])
    colour = [factor * channel for channel in m["reflectance"]]
    return diffuse(shader, coloured(shader, colour, m.get("texture"), around.textures), roughness)


def _mirror(shader, m, _):
    return glossy(shader, m["reflectance"], 0.0)


def _glass(shader, m, around):
    return dielectric(shader, m, 0.0, around.scales_radiance)


def _ggx(shader, m, _):
    return glossy(shader, m["colour"], m["alpha"])


def _anisotropic_ggx(shader, m, _):
    """alpha (1 - a) along and alpha / (1 - a) across, alpha = roughness^2; the other way round for negative a."""
    along, across = m["alpha_x"], m["alpha_y"]
    alpha = math.sqrt(along * across)
    anisotropy = 1 - along / alpha if along <= across else across / alpha - 1
    tangent = shader.node("ShaderNodeTangent", direction_type="UV_MAP", uv_map="uv").outputs["Tangent"]
    inputs = {"Color": m["colour"], "Roughness": math.sqrt(alpha), "Anisotropy": anisotropy,
              "Rotation": m["rotation"] / 360, "Tangent": tangent}
    return shader.node("ShaderNodeBsdfAnisotropic", inputs, distribution="GGX").outputs["BSDF"]


def red_of(shader, use, textures):
    return shader.node("ShaderNodeSeparateColor", {"Color": sampled_texture(shader, use, textures)}).outputs["Red"]


def _varying_ggx(shader, m, around):
    """Roughness is the root of alpha, taken behind the filter."""
    held = red_of(shader, m["texture"], around.textures)
    alpha = shader.math("SUBTRACT", 1.0, held) if m["holds"] == "glossiness" else shader.math("MULTIPLY", held, m["alpha"])
    inputs = {"Color": m["colour"], "Roughness": shader.math("SQRT", alpha)}
    return shader.node("ShaderNodeBsdfGlossy", inputs, distribution="GGX").outputs["BSDF"]


def _blend(shader, m, around):
    first, second = (around.descriptions[m[key]] for key in ("first", "second"))
    weight = m["weight"]
    if m.get("texture"):
        weight = shader.math("MULTIPLY", red_of(shader, m["texture"], around.textures), weight)
    parts = {0: weight, 1: surface_of(shader, first, around), 2: surface_of(shader, second, around)}
    return shader.node("ShaderNodeMixShader", parts).outputs["Shader"]


def mixed_colours(colour, rest, mix):
    """The colours of the glossy and the diffuse part after one gave way, so that they are at most 1 together."""
    if mix == "per_component":
        return colour, [min(d, 1 - r) for r, d in zip(colour, rest)]
    if mix == "sum":
        shares = [1 / max(1, r + d) for r, d in zip(colour, rest)]
        return [r * s for r, s in zip(colour, shares)], [d * s for d, s in zip(rest, shares)]
    taken = max(colour) if mix == "maximum" else sum(colour) / 3
    share = min(1, (1 - taken) / max(rest)) if max(rest) > 0 else 1
    return colour, [d * share for d in rest]


def _ggx_lambert(shader, m, _):
    colour, rest = mixed_colours(m["colour"], m["diffuse"], m["mix"])
    both = {0: glossy(shader, colour, m["alpha"]), 1: diffuse(shader, rest)}
    return shader.node("ShaderNodeAddShader", both).outputs["Shader"]


def _rough_glass(shader, m, around):
    return dielectric(shader, m, m["alpha"], around.scales_radiance)


def _emission(shader, m, around):
    return emission(shader, coloured(shader, m["radiance"], m.get("texture"), around.textures))


# Each type of material: its required keys, its optional keys, and the function that builds its surface.
MATERIAL_TYPES = {
    "lambert": ({"reflectance"}, {"texture"}, _lambert),
    "oren_nayar": ({"reflectance", "roughness"}, {"texture"}, _oren_nayar),
    "mirror": ({"reflectance"}, set(), _mirror),
    "glass": ({"colour", "ior"}, set(), _glass),
    "ggx": ({"colour", "alpha"}, set(), _ggx),
    "anisotropic_ggx": ({"colour", "alpha_x", "alpha_y", "rotation", "masking"}, set(), _anisotropic_ggx),
    "varying_ggx": ({"colour", "holds", "masking", "texture"}, {"alpha"}, _varying_ggx),
    "blend": ({"first", "second", "weight"}, {"texture"}, _blend),
    "ggx_lambert": ({"colour", "alpha", "diffuse", "mix"}, set(), _ggx_lambert),
    "rough_glass": ({"colour", "ior", "alpha"}, set(), _rough_glass),
    "emission": ({"radiance"}, {"texture"}, _emission),
}


# What any material may have beside its type.
DETAIL_KEYS = {"opacity", "opacity_texture", "normal_map", "bump_map"}


def detail_normal(shader, m, around):
    """Normal socket of a normal or bump map, None without. The strength is written into the map: Blender's own mixes
    normals. Heights are metres of the world, as Bump takes them with the distance 1."""
    if "normal_map" in m:
        strength = m["normal_map"].get("strength", 1.0)
        texel = sampled_texture(shader, m["normal_map"]["texture"], around.textures)
        offset = (0.5 - 0.5 * strength, 0.5 - 0.5 * strength, 0.0)
        stretched = shader.vector("ADD", shader.vector("MULTIPLY", texel, (strength, strength, 1.0)), offset)
        node = shader.node("ShaderNodeNormalMap", {"Color": stretched}, space="TANGENT", uv_map=UV_LAYERS[m["normal_map"]["texture"]["uv_set"]])
        return node.outputs["Normal"]
    if "bump_map" in m:
        texel = sampled_texture(shader, m["bump_map"]["texture"], around.textures)
        height = shader.affine(texel, (m["bump_map"]["height"] * around.scale, 0.0, 0.0), 0.0)
        return shader.node("ShaderNodeBump", {"Height": height, "Strength": 1.0, "Distance": 1.0}).outputs["Normal"]
    return None


def turn_normals(shader, normal):
    for node in list(shader.tree.nodes):
        if node.bl_idname.startswith("ShaderNodeBsdf") and "Normal" in node.inputs:
            shader.connect(normal, node.inputs["Normal"])


def let_rays_pass(shader, surface, m, around):
    """A mix with what lies behind: Transparent is not counted among the bounces of diffuse and glossy surfaces."""
    if m.get("opacity", 1.0) == 1 and "opacity_texture" not in m:
        return surface
    share = m.get("opacity", 1.0)
    if "opacity_texture" in m:
        texel = sampled_texture(shader, m["opacity_texture"], around.textures)
        node = shader.node("ShaderNodeSeparateXYZ", {"Vector": texel})
        largest = shader.math("MAXIMUM", node.outputs["X"], shader.math("MAXIMUM", node.outputs["Y"], node.outputs["Z"]))
        share = shader.math("MULTIPLY", largest, share)
    behind = shader.node("ShaderNodeBsdfTransparent").outputs["BSDF"]
    return shader.node("ShaderNodeMixShader", {0: share, 1: behind, 2: surface}).outputs["Shader"]


def surface_of(shader, description, around):
    return MATERIAL_TYPES[description["type"]][2](shader, description, around)


def make_material(description, around):
    shader = Shader(description["name"])
    surface = surface_of(shader, description, around)
    normal = detail_normal(shader, description, around)
    if normal is not None:
        turn_normals(shader, normal)
    return shader.finish(let_rays_pass(shader, surface, description, around))


# --- lights ---------------------------------------------------------------------------------------------------------


def make_light_material(name, radiance, ies=None):
    """Emits constant radiance in front, none behind; `ies` = (Grid, to_local 3x3 rows, centre or None) scales it."""
    shader = Shader(name)
    back = shader.node("ShaderNodeNewGeometry").outputs["Backfacing"]
    strength = shader.math("SUBTRACT", 1.0, back)
    if ies:
        strength = shader.math("MULTIPLY", strength, ies_factor(shader, name, *ies))
    return shader.finish(emission(shader, radiance, strength))


def ies_factor(shader, name, grid, to_local, centre):
    """candela / max candela towards the receiver. With a centre (point_area) the direction runs from there to the
    receiver, which is the shaded point plus its view vector times the ray's length; both hold in light sampling too."""
    geometry = shader.node("ShaderNodeNewGeometry")
    direction = geometry.outputs["Incoming"]
    if centre is not None:
        length = shader.node("ShaderNodeLightPath").outputs["Ray Length"]
        to_receiver = shader.scaled(direction, length)
        receiver = shader.vector("ADD", geometry.outputs["Position"], to_receiver)
        direction = shader.vector("SUBTRACT", receiver, centre)
    return profile_share(shader, name, grid, to_local, direction)


def profile_share(shader, name, grid, to_local, direction):
    """candela / max candela in a direction of the world."""
    x, y, z = (shader.vector("DOT_PRODUCT", direction, row) for row in to_local)
    across = shader.math("SQRT", shader.math("MULTIPLY_ADD", x, x, shader.math("MULTIPLY", z, z)))
    vertical = shader.math("ARCTAN2", across, shader.math("MULTIPLY", y, -1.0))  # 0 = local -Y
    turns = shader.math("FRACT", shader.math("DIVIDE", shader.math("ARCTAN2", z, x), 2 * math.pi))  # 0 = +X, 1/4 = +Z
    return grid_lookup(shader, name, grid, vertical, turns)


def grid_lookup(shader, name, grid, vertical_rad, turns):
    first, last = math.radians(grid.first_vertical_deg), math.radians(grid.last_vertical_deg)
    texels = array("f", (v for value in grid.values for v in (value, value, value, 1.0)))
    image = float_image(name, grid.columns, grid.rows, texels)
    # Angles map to texel centres, because value k of n is at (k + 0.5) / n.
    u = shader.math("MULTIPLY_ADD", turns, (grid.columns - 1) / grid.columns, 0.5 / grid.columns)
    slope = (grid.rows - 1) / grid.rows / (last - first) if grid.rows > 1 else 0.0
    v = shader.math("MULTIPLY_ADD", vertical_rad, slope, 0.5 / grid.rows - first * slope)
    vector = shader.node("ShaderNodeCombineXYZ", {"X": u, "Y": v}).outputs["Vector"]
    factor = image_lookup(shader, image, vector, "EXTEND")
    # LM-63: no light outside the stored vertical range. Beyond 180 deg there is nothing, in spite of rounding.
    if last < math.radians(179.99):
        factor = shader.math("MULTIPLY", factor, shader.math("LESS_THAN", vertical_rad, last))
    if first > 0:
        factor = shader.math("MULTIPLY", factor, shader.math("GREATER_THAN", vertical_rad, first))
    return factor
