"""One object of the catalogue and its files: model.sdf, visual.obj with .mtl, label.png, hull.obj."""
from dataclasses import dataclass, field


@dataclass
class Paint:
    """Colour 0 .. 1 (sRGB), shine 0 matt .. 1 mirror, and a picture that is multiplied with the colour."""
    colour: tuple
    shine: float = 0.1
    picture: object = None


@dataclass
class Thing:
    """mesh: what is seen. collisions: ("box", centre, size, rpy), ("cylinder", centre, radius, length, rpy),
    ("sphere", centre, radius) or ("hull", mesh), of which the physics takes the convex hull."""
    name: str
    mass: float
    mesh: object
    paints: dict
    collisions: list = field(default_factory=list)
    friction: float = 0.6
    note: str = ""

    def size(self):
        low, high = self.mesh.bounds()
        return [b - a for a, b in zip(low, high)]

    def standing(self):
        """The same with the origin in the middle of the bottom."""
        low, high = self.mesh.bounds()
        shift = (-(low[0] + high[0]) / 2, -(low[1] + high[1]) / 2, -low[2])
        def move(c):
            if c[0] == "hull":
                return ("hull", c[1].moved(*shift))
            return (c[0], tuple(a + s for a, s in zip(c[1], shift))) + tuple(c[2:])
        return Thing(self.name, self.mass, self.mesh.moved(*shift), self.paints, [move(c) for c in self.collisions],
                     self.friction, self.note)


def number(x):
    text = f"{x:.5f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def numbers(values):
    return " ".join(number(v) for v in values)


def obj_text(mesh, library=None):
    """Wavefront OBJ with shared corners, faces in the order of their materials."""
    out, known = [f"mtllib {library}"] if library else [], ({}, {}, {})
    lists = ([], [], [])
    def index(kind, values):
        key = numbers(values)
        if key not in known[kind]:
            known[kind][key] = len(lists[kind]) + 1
            lists[kind].append(key)
        return known[kind][key]
    groups = {}
    for (material, corners), normals in zip(mesh.faces, mesh.normals()):
        ids = (f"{index(0, c[:3])}/{index(1, [round(t, 4) for t in c[3:]])}/{index(2, [round(a, 3) for a in n])}"
               for c, n in zip(corners, normals))
        groups.setdefault(material, []).append("f " + " ".join(ids))
    for tag, values in zip(("v", "vt", "vn"), lists):
        out += [f"{tag} {v}" for v in values]
    for material, faces in groups.items():
        out += ([f"usemtl {material}"] if library else []) + faces
    return "\n".join(out) + "\n"


def mtl_text(paints):
    out = []
    for name, paint in paints.items():
        out += [f"newmtl {name}", f"Kd {numbers(paint.colour)}", f"Ks {numbers([paint.shine] * 3)}"]
        out += [f"map_Kd {name}.png"] if paint.picture else []
    return "\n".join(out) + "\n"


def _geometry(shape):
    if shape[0] == "box":
        return f"<box><size>{numbers(shape[2])}</size></box>"
    if shape[0] == "cylinder":
        return f"<cylinder><radius>{number(shape[2])}</radius><length>{number(shape[3])}</length></cylinder>"
    if shape[0] == "sphere":
        return f"<sphere><radius>{number(shape[2])}</radius></sphere>"
    return "<mesh><uri>hull.obj</uri></mesh>"


def _pose(shape):
    if shape[0] == "hull":
        return ""
    turn = shape[-1] if isinstance(shape[-1], tuple) and len(shape) > (3 if shape[0] == "box" else 4) else (0, 0, 0)
    return f"<pose>{numbers(shape[1])} {numbers(turn)}</pose>"


def sdf_text(thing):
    x, y, z = thing.size()
    m = thing.mass / 12.0
    inertia = "".join(f"<{k}>{v:.3e}</{k}>" for k, v in (("ixx", m * (y * y + z * z)), ("iyy", m * (x * x + z * z)),
                                                        ("izz", m * (x * x + y * y))))
    surface = f"<surface><friction><ode><mu>{number(thing.friction)}</mu><mu2>{number(thing.friction)}</mu2></ode></friction></surface>"
    collisions = "".join(f"""      <collision name="collision_{i}">
        {_pose(c)}<geometry>{_geometry(c)}</geometry>
        {surface}
      </collision>
""" for i, c in enumerate(thing.collisions))
    return f"""<?xml version="1.0"?>
<sdf version="1.7">
  <model name="{thing.name}">
    <link name="link">
      <inertial>
        <pose>0 0 {number(z / 2)} 0 0 0</pose>
        <mass>{number(thing.mass)}</mass>
        <inertia>{inertia}</inertia>
      </inertial>
      <visual name="visual"><geometry><mesh><uri>visual.obj</uri></mesh></geometry></visual>
{collisions}    </link>
  </model>
</sdf>
"""


def save(thing, folder):
    """Write the files of a thing that stands on its origin."""
    folder.mkdir(exist_ok=True)
    for old in folder.iterdir():
        old.unlink()
    (folder / "model.sdf").write_text(sdf_text(thing))
    (folder / "visual.obj").write_text(obj_text(thing.mesh, "visual.mtl"))
    (folder / "visual.mtl").write_text(mtl_text(thing.paints))
    for name, paint in thing.paints.items():
        if paint.picture:
            (folder / f"{name}.png").write_bytes(paint.picture.png())
    for shape in thing.collisions:
        if shape[0] == "hull":
            (folder / "hull.obj").write_text(obj_text(shape[1]))
