"""Writes a world: floors, walls with holes, ceiling, lights, and the furniture that it includes."""
import math

from model import numbers

HEIGHT, DOOR = 2.5, (1.04, 2.08)        # m: rooms; hole for models/door_frame
BARE = ("facade", "tiles_wall")          # sides without a skirting board
SURFACES = {                            # colour or texture
    "white": (0.95, 0.94, 0.91), "sand": (0.94, 0.88, 0.77), "sky": (0.74, 0.82, 0.86), "sage": (0.78, 0.84, 0.75),
    "facade": (0.80, 0.77, 0.72), "teal": (0.36, 0.52, 0.54), "linen": (0.93, 0.88, 0.79), "skirting": (0.95, 0.95, 0.94),
    "parquet": "parquet", "parquet_dark": "parquet_dark", "laminate": "laminate", "carpet": "carpet",
    "tiles_kitchen": "tiles_kitchen", "tiles_bath": "tiles_bath", "tiles_wall": "tiles_wall", "wallpaper": "wallpaper",
}


def material(surface):
    look = SURFACES[surface]
    colour = numbers((1, 1, 1) if isinstance(look, str) else look) + " 1"
    pbr = ""
    if isinstance(look, str):
        pbr = "<pbr><metal><albedo_map>textures/%s.png</albedo_map></metal></pbr>" % look
    return "<material><ambient>%s</ambient><diffuse>%s</diffuse>%s</material>" % (colour, colour, pbr)


def box(kind, name, size, at, surface=None):
    return ['      <%s name="%s">' % (kind, name), "        <pose>%s 0 0 0</pose>" % numbers(at),
            "        <geometry><box><size>%s</size></box></geometry>" % numbers(size),
            *(["        " + material(surface)] if surface else []), "      </%s>" % kind]


class World:
    def __init__(self, name, about, robot_start):
        self.name, self.about, self.robot_start = name, about, robot_start
        self.body, self.count = [], {}

    def model(self, name, parts):
        self.body += ['    <model name="%s">' % name, "      <static>true</static>", '      <link name="link">',
                      *["  " + line for line in parts], "      </link>", "    </model>"]

    def floor(self, room, x0, y0, x1, y1, surface):
        size, at = (x1 - x0, y1 - y0, 0.1), ((x0 + x1) / 2, (y0 + y1) / 2, -0.05)
        self.model("floor_" + room, box("visual", "visual", size, at, surface) + box("collision", "collision", size, at))

    def ceiling(self, x0, y0, x1, y1):
        size, at = (x1 - x0, y1 - y0, 0.05), ((x0 + x1) / 2, (y0 + y1) / 2, HEIGHT + 0.025)
        self.model("ceiling", box("visual", "visual", size, at, "white"))

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
        parts = []
        for k, (a, b, bottom, top) in enumerate(p for p in pieces if p[1] - p[0] > 1e-6 and p[3] - p[2] > 1e-6):
            parts += self._piece(k, along, (a, b, bottom, top), start[1 - along], thick, sides)
        self.model("wall_" + name, parts)

    def _piece(self, k, along, span, middle, thick, sides):
        a, b, bottom, top = span

        def place(depth, shift, z0, z1):
            size, at = [b - a, depth], [(a + b) / 2, middle + shift]
            if along == 1:
                size, at = size[::-1], at[::-1]
            return size + [z1 - z0], at + [(z0 + z1) / 2]

        parts = box("collision", "part_%d" % k, *place(thick, 0, bottom, top))
        for side, sign in ((0, 1), (1, -1)):
            parts += box("visual", "side_%d_%d" % (k, side), *place(thick / 2, sign * thick / 4, bottom, top), sides[side])
            if bottom == 0 and sides[side] not in BARE:
                parts += box("visual", "skirting_%d_%d" % (k, side), *place(0.012, sign * (thick / 2 + 0.006), 0, 0.07),
                             "skirting")
        return parts

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
        head = ['<?xml version="1.0"?>', "<!-- %s. Metres, z up, floor at z = 0. -->" % self.about, '<sdf version="1.9">',
                '  <world name="%s">' % self.name,
                '    <frame name="robot_start"><pose>%s</pose></frame>' % numbers((x, y, 0, 0, 0, math.radians(degrees))),
                "    <scene><ambient>0.72 0.72 0.73 1</ambient><background>0.75 0.84 0.92 1</background>"
                "<shadows>false</shadows></scene>",
                *_light("sun", (-0.35, 0.45, -0.82), 0.40), *_light("fill", (0.60, -0.55, -0.30), 0.20),
                *_light("bounce", (0, 0, 1), 0.22)]
        with open(path, "w", encoding="ascii") as out:
            out.write("\n".join(head + self.body + ["  </world>", "</sdf>"]) + "\n")


def _light(name, direction, strength):
    colour = numbers((strength, strength * 0.98, strength * 0.94)) + " 1"
    return ['    <light type="directional" name="%s">' % name, "      <pose>0 0 10 0 0 0</pose>",
            "      <diffuse>%s</diffuse><specular>0 0 0 1</specular>" % colour,
            "      <direction>%s</direction><cast_shadows>false</cast_shadows>" % numbers(direction), "    </light>"]
