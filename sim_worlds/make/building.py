"""Writes a world: floors, walls with holes, ceiling, lights, and the furniture that it includes. What is seen of floors
and walls are meshes in models/<world>_building, as not every renderer lays textures on boxes in metres."""
import math
import os

import shapes
from model import Model, numbers

HEIGHT, DOOR = 2.5, (1.04, 2.08)        # m: rooms; hole for models/door_frame
BARE = ("facade", "tiles_wall")         # sides without a skirting board


class World:
    def __init__(self, name, about, robot_start):
        self.name, self.about, self.robot_start = name, about, robot_start
        self.folder = "models/%s_building" % name
        self.body, self.count, self.meshes = [], {}, []

    def floor(self, room, x0, y0, x1, y1, surface):
        self._slab("floor_" + room, (x1 - x0, y1 - y0, 0.1), ((x0 + x1) / 2, (y0 + y1) / 2, -0.05), surface, True)

    def ceiling(self, x0, y0, x1, y1):
        size, at = (x1 - x0, y1 - y0, 0.05), ((x0 + x1) / 2, (y0 + y1) / 2, HEIGHT + 0.024)
        self._slab("ceiling", size, at, "ceiling", False)

    def _slab(self, name, size, at, surface, solid):
        model = Model(name, name)
        model.show(surface, shapes.mapped(shapes.moved(shapes.box(size), at)))
        if solid:
            model.solid_box(size, at)
        self._add(model)

    def _add(self, model):
        self.meshes.append(model)
        self.body += model.sdf_lines(self.folder + "/", "    ")

    def wall(self, name, start, end, thick, sides, holes=()):
        """From start to end (x, y along one axis): its middle line. sides = surface on the side of larger and smaller
        y (or x). holes = (from, to, bottom, top) along the wall in world coordinates."""
        along = 0 if abs(end[0] - start[0]) > abs(end[1] - start[1]) else 1
        low, high = sorted((start[along], end[along]))
        pieces, done = [], low
        for a, b, bottom, top in sorted(holes):
            pieces += [(done, a, 0, HEIGHT), (a, b, 0, bottom), (a, b, top, HEIGHT)]
            done = b
        pieces.append((done, high, 0, HEIGHT))
        model = Model("wall_" + name, "wall_" + name)
        for span in pieces:
            if span[1] - span[0] > 1e-6 and span[3] - span[2] > 1e-6:
                _piece(model, along, span, start[1 - along], thick, sides)
        self._add(model)

    def put(self, kind, x, y, degrees=0.0, z=0.0, name=None):
        """Includes models/<kind>, its front (+x) turned by that angle; names count from 1."""
        name = name or kind
        self.count[name] = self.count.get(name, 0) + 1
        pose = numbers((x, y, z, 0, 0, math.radians(degrees)))
        self.body += ["    <include>", "      <name>%s_%d</name>" % (name, self.count[name]),
                      "      <uri>models/%s</uri>" % kind, "      <pose>%s</pose>" % pose, "    </include>"]

    def door(self, x, y, degrees):
        """A frame in the hole in the middle of which x, y lies."""
        self.put("door_frame", x, y, degrees)

    def save(self, path):
        x, y, degrees = self.robot_start
        about = "<!-- %s. Metres, z up, floor at z = 0. -->" % self.about
        start = numbers((x, y, 0, 0, 0, math.radians(degrees)))
        head = ['<?xml version="1.0"?>', about, '<sdf version="1.9">',
                '  <world name="%s">' % self.name,
                '    <frame name="robot_start"><pose>%s</pose></frame>' % start,
                "    <scene><ambient>0.72 0.72 0.73 1</ambient><background>0.75 0.84 0.92 1</background>"
                "<shadows>false</shadows></scene>",
                *_light("sun", (-0.35, 0.45, -0.82), 0.40), *_light("bounce", (0.50, -0.45, 0.75), 0.30)]
        for mesh in self.meshes:
            mesh.save_mesh(os.path.join(os.path.dirname(path), self.folder))
        with open(path, "w", encoding="ascii") as out:
            out.write("\n".join(head + self.body + ["  </world>", "</sdf>"]) + "\n")


def _piece(model, along, span, middle, thick, sides):
    """A block of wall: two halves with the colours of their rooms, skirting boards, a dark cap for views from above."""
    a, b, bottom, top = span

    def block(depth, shift, z0, z1):
        size, at = [b - a, depth], [(a + b) / 2, middle + shift]
        if along == 1:
            size, at = size[::-1], at[::-1]
        return size + [z1 - z0], at + [(z0 + z1) / 2]

    def show(surface, size, at):
        model.show(surface, shapes.mapped(shapes.moved(shapes.box(size), at)))

    model.solid_box(*block(thick, 0, bottom, top))
    for surface, sign in zip(sides, (1, -1)):
        show(surface, *block(thick / 2, sign * thick / 4, bottom, top))
        if bottom == 0 and surface not in BARE:
            show("skirting", *block(0.012, sign * (thick / 2 + 0.006), 0, 0.07))
    if top == HEIGHT:
        show("wall_top", *block(thick, 0, HEIGHT, HEIGHT + 0.004))


def _light(name, direction, strength):
    colour = numbers((strength, strength * 0.98, strength * 0.94)) + " 1"
    return ['    <light type="directional" name="%s">' % name, "      <pose>0 0 10 0 0 0</pose>",
            "      <diffuse>%s</diffuse><specular>0 0 0 1</specular>" % colour,
            "      <direction>%s</direction><cast_shadows>false</cast_shadows>" % numbers(direction), "    </light>"]
