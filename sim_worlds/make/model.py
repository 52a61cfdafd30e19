"""A piece of furniture: one mesh to be seen, boxes and cylinders to be felt, written as model.sdf, .obj and .mtl.
Origin on the floor in the middle of the footprint; x to the front, y to the left, z up; metres and radians."""
import os
import random

import shapes
from materials import MATERIALS


def numbers(values):
    return " ".join(("%.4f" % v).rstrip("0").rstrip(".") if abs(v) > 5e-5 else "0" for v in values)


class Model:
    def __init__(self, name, about):
        self.name, self.about = name, about
        self.seen = {}      # material -> shape
        self.solids = []    # (name, kind, size, at, rpy)
        self.random = random.Random(name)

    def show(self, material, shape, at=(0, 0, 0), rpy=(0, 0, 0)):
        """Something to be seen only."""
        assert material in MATERIALS, material
        self.seen.setdefault(material, []).extend(shapes.moved(shape, at, rpy))

    def solid_box(self, size, at, rpy=(0, 0, 0)):
        self.solids.append(("box", size, at, rpy))

    def solid_cylinder(self, radius, length, at, rpy=(0, 0, 0)):
        self.solids.append(("cylinder", (radius, length), at, rpy))

    def box(self, material, size, at, rpy=(0, 0, 0), bevel=0.0, skip=()):
        """A board or block: seen and solid."""
        grain = (self.random.random(), self.random.random())
        self.show(material, shapes.box(size, bevel, grain, skip), at, rpy)
        self.solid_box(size, at, rpy)

    def trim(self, material, size, at, rpy=(0, 0, 0), bevel=0.0, skip=()):
        """A thin front, handle or line on something solid: seen only."""
        grain = (self.random.random(), self.random.random())
        self.show(material, shapes.box(size, bevel, grain, skip), at, rpy)

    def cylinder(self, material, radius, length, at, rpy=(0, 0, 0), segments=12, top_radius=None):
        self.show(material, shapes.cylinder(radius, length, segments, top_radius), at, rpy)
        mean = radius if top_radius is None else (radius + top_radius) / 2
        self.solid_cylinder(mean, length, at, rpy)

    def cushion(self, material, size, at, rpy=(0, 0, 0), roundness=0.3, segments=16, rings=8):
        """Soft: the solid box is a little smaller, as the corners are round."""
        self.show(material, shapes.cushion(size, segments, rings, roundness), at, rpy)
        self.solid_box([s * 0.97 for s in size], at, rpy)

    def triangles(self):
        return sum(len(shape) for shape in self.seen.values())

    def extent(self):
        points = [p for shape in self.seen.values() for triangle in shape for p, _, _ in triangle]
        return [(min(p[i] for p in points), max(p[i] for p in points)) for i in range(3)]

    def save(self, folder):
        self.save_mesh(folder)
        for file, text in (("model.sdf", self._sdf()), ("model.config", self._config())):
            with open(os.path.join(folder, file), "w", encoding="ascii") as out:
                out.write(text)

    def save_mesh(self, folder):
        os.makedirs(folder, exist_ok=True)
        for file, text in ((self.name + ".obj", self._obj()), (self.name + ".mtl", self._mtl())):
            with open(os.path.join(folder, file), "w", encoding="ascii") as out:
                out.write(text)

    def _obj(self):
        lines = ["# %s: metres, z up, x to the front" % self.about, "mtllib %s.mtl" % self.name]
        tables, body = ({}, {}, {}), []
        for material in sorted(self.seen):
            body.append("usemtl " + material)
            for triangle in self.seen[material]:
                corners = []
                for p, n, t in triangle:
                    texts = ("v " + numbers(p), "vt " + numbers(t), "vn " + numbers(n))
                    corners.append("/".join(str(table.setdefault(text, len(table) + 1))
                                            for table, text in zip(tables, texts)))
                body.append("f " + " ".join(corners))
        return "\n".join(lines + [text for table in tables for text in table] + body) + "\n"

    def _mtl(self):
        lines = []
        for name in sorted(self.seen):
            colour, texture, glow = MATERIALS[name]
            lines += ["newmtl " + name, "Ka " + numbers(colour), "Kd " + numbers(colour), "Ks 0 0 0"]
            lines += ["Ke " + numbers(glow)] if glow else []
            lines += ["map_Kd ../../textures/%s.png" % texture] if texture else []
        return "\n".join(lines) + "\n"

    def sdf_lines(self, folder="", indent="  "):
        """<model> with the mesh in that folder."""
        lines = ['<model name="%s">' % self.name, "  <static>true</static>", '  <link name="link">',
                 '    <visual name="visual">',
                 "      <geometry><mesh><uri>%s%s.obj</uri></mesh></geometry>" % (folder, self.name), "    </visual>"]
        for index, (kind, size, at, rpy) in enumerate(self.solids, 1):
            if kind == "box":
                geometry = "<box><size>%s</size></box>" % numbers(size)
            else:
                geometry = "<cylinder><radius>%s</radius><length>%s</length></cylinder>" % tuple(
                    numbers([value]) for value in size)
            lines += ['    <collision name="part_%d">' % index,
                      "      <pose>%s</pose>" % numbers(list(at) + list(rpy)),
                      "      <geometry>%s</geometry>" % geometry, "    </collision>"]
        return [indent + line for line in lines + ["  </link>", "</model>"]]

    def _sdf(self):
        head = ['<?xml version="1.0"?>', "<!-- %s. -->" % self.about, '<sdf version="1.7">']
        return "\n".join(head + self.sdf_lines() + ["</sdf>"]) + "\n"

    def open_materials(self):
        """Those whose surface has an edge with a triangle on one side only: they cannot be culled."""
        result = []
        for material, shape in self.seen.items():
            edges = {}
            for triangle in shape:
                keys = [numbers(p) for p, _, _ in triangle]
                for a, b in zip(keys, keys[1:] + keys[:1]):
                    if a != b:
                        edges[a, b] = edges.get((a, b), 0) + 1
            if any(edges.get((b, a), 0) != count for (a, b), count in edges.items()):
                result.append(material)
        return sorted(result)

    def _config(self):
        return ('<?xml version="1.0"?>\n<model>\n  <name>%s</name>\n  <version>1.0</version>\n'
                '  <sdf version="1.7">model.sdf</sdf>\n  <description>%s</description>\n</model>\n'
                % (self.name, self.about))
