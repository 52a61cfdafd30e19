"""Measures a world: python3 sim_worlds/make/check.py WORLD.sdf
Floor of each room, floor without furniture, floor that the robot can reach (disc of 0.30 m, up to 1.10 m high), and how
far what is seen lies from what is solid at the height of the laser."""
import math
import os
import sys
import xml.etree.ElementTree as xml

import shapes

CELL, ROBOT_RADIUS, ROBOT_HEIGHT, LASER = 0.025, 0.30, 1.10, 0.184


def pose(element):
    text = element.findtext("pose") if element is not None else None
    values = [float(v) for v in (text or "0 0 0 0 0 0").split()]
    return values[:3], values[3:]


def apply(poses, point):
    for at, rpy in poses:
        point = shapes.add(shapes.rotate(point, rpy), at)
    return point


def load(path):
    """-> [(model name, kind, size, poses from inside out)] of all collisions, meshes as kind 'mesh'."""
    world, parts = xml.parse(path).getroot().find("world"), []
    for model in world.findall("model"):
        parts += _parts(model, model.get("name"), [pose(model)], os.path.dirname(path))
    for include in world.findall("include"):
        folder = os.path.join(os.path.dirname(path), include.findtext("uri"))
        model = xml.parse(os.path.join(folder, "model.sdf")).getroot().find("model")
        parts += _parts(model, include.findtext("name"), [pose(include)], folder)
    frame = [f for f in world.findall("frame") if f.get("name") == "robot_start"][0]
    return parts, pose(frame)[0]


def _parts(model, name, outer, folder):
    parts = []
    for link in model.findall("link"):
        for kind in ("collision", "visual"):
            for item in link.findall(kind):
                poses, geometry = [pose(item), pose(link)] + outer, item.find("geometry")
                if kind == "visual" and geometry.find("mesh") is not None:
                    parts.append((name, "mesh", os.path.join(folder, geometry.findtext("mesh/uri")), poses))
                elif kind == "collision" and geometry.find("box") is not None:
                    size = [float(v) for v in geometry.findtext("box/size").split()]
                    parts.append((name, "box", size, poses))
                elif kind == "collision":
                    radius = float(geometry.findtext("cylinder/radius"))
                    length = float(geometry.findtext("cylinder/length"))
                    parts.append((name, "cylinder", (radius, length), poses))
    return parts


def corners(kind, size):
    if kind == "box":
        x, y, z = [s / 2 for s in size]
        return [(i * x, j * y, k * z) for i in (1, -1) for j in (1, -1) for k in (1, -1)]
    ring = [2 * math.pi * k / 16 for k in range(16)]
    return [(size[0] * math.cos(a), size[0] * math.sin(a), sz * size[1] / 2) for a in ring for sz in (1, -1)]


def hull(points):
    points = sorted(set((round(x, 5), round(y, 5)) for x, y in points))
    result = []
    for chain in (points, points[::-1]):
        half = []
        for p in chain:
            while len(half) > 1 and ((half[-1][0] - half[-2][0]) * (p[1] - half[-2][1])
                                     - (half[-1][1] - half[-2][1]) * (p[0] - half[-2][0])) <= 0:
                half.pop()
            half.append(p)
        result += half[:-1]
    return result


def cells_in(polygon):
    low, high = [[pick(p[i] for p in polygon) for i in (0, 1)] for pick in (min, max)]
    edges = list(zip(polygon, polygon[1:] + polygon[:1]))
    for i in range(math.floor(low[0] / CELL), math.ceil(high[0] / CELL)):
        for j in range(math.floor(low[1] / CELL), math.ceil(high[1] / CELL)):
            x, y = (i + 0.5) * CELL, (j + 0.5) * CELL
            if all((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) >= 0 for a, b in edges):
                yield i, j


def footprint(parts, bottom, top):
    """Cells under solids that reach into that range of heights."""
    cells = set()
    for name, kind, size, poses in parts:
        if kind == "mesh" or name.startswith(("floor_", "ceiling")):
            continue
        points = [apply(poses, p) for p in corners(kind, size)]
        if min(p[2] for p in points) < top and max(p[2] for p in points) > bottom:
            cells.update(cells_in(hull([p[:2] for p in points])))
    return cells


def grown(cells, radius):
    reach = int(radius / CELL)
    span = range(-reach, reach + 1)
    disc = [(i, j) for i in span for j in span if math.hypot(i, j) * CELL <= radius]
    edge = [(i, j) for i, j in cells if not {(i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)} <= cells]
    return cells | {(i + a, j + b) for i, j in edge for a, b in disc}


def reachable(start, blocked, floor):
    seen, queue = {start}, [start]
    while queue:
        i, j = queue.pop()
        for cell in ((i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)):
            if cell in floor and cell not in blocked and cell not in seen:
                seen.add(cell)
                queue.append(cell)
    return seen


def outline(path, poses, height):
    """Points of the mesh at that height."""
    vertices, points = [], []
    with open(path, encoding="ascii") as file:
        for line in file:
            if line.startswith("v "):
                vertices.append(apply(poses, tuple(float(v) for v in line.split()[1:])))
            elif line.startswith("f "):
                a = [vertices[int(c.split("/")[0]) - 1] for c in line.split()[1:]]
                for p, q in zip(a, a[1:] + a[:1]):
                    if (p[2] - height) * (q[2] - height) < 0:
                        t = (height - p[2]) / (q[2] - p[2])
                        points.append((p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t))
    return points


def gap(point, parts, height):
    """How far a seen point lies outside of all solids, or inside below their surface (level parts only)."""
    best = math.inf
    for kind, size, poses in parts:
        local = (point[0], point[1], height)
        for at, rpy in reversed(poses):
            local = shapes.sub(local, at)
            for turn in ((0, 0, -rpy[2]), (0, -rpy[1], 0), (-rpy[0], 0, 0)):
                local = shapes.rotate(local, turn)
        if kind == "box":
            outside = [abs(local[i]) - size[i] / 2 for i in range(3)]
        else:
            outside = [math.hypot(local[0], local[1]) - size[0], abs(local[2]) - size[1] / 2]
        far = math.sqrt(sum(max(0.0, d) ** 2 for d in outside))
        best = min(best, far if far > 0 else -max(outside))
    return best


def main():
    parts, start = load(sys.argv[1])
    walls = footprint([p for p in parts if p[0].startswith(("wall_", "door_entrance"))], 0, 0.1)
    solid, tall = footprint(parts, 0.005, 0.3), footprint(parts, 0.005, ROBOT_HEIGHT)
    rooms, floor = {}, set()
    for name, kind, size, poses in parts:
        if name.startswith("floor_") and kind == "box":
            rooms[name] = set(cells_in(hull([apply(poses, p)[:2] for p in corners("box", size)]))) - walls
            floor |= rooms[name]
    reach = reachable((int(start[0] / CELL), int(start[1] / CELL)), grown(tall, ROBOT_RADIUS), floor)
    swept = grown(reach, ROBOT_RADIUS) & floor
    for name, cells in sorted(rooms.items()) + [("all", floor)]:
        print("%-16s %6.1f m2, free up to 0.3 m %5.1f, up to %.1f m %5.1f, "
              "robot's middle can be in %5.1f, it covers %5.1f" % (
            (name,) + tuple(len(c) * CELL ** 2 * f for c, f in ((cells, 1), (cells - solid, 1))) + (ROBOT_HEIGHT,)
            + tuple(len(c) * CELL ** 2 for c in (cells - tall, cells & reach, cells & swept))))
    near = min(math.hypot((i + 0.5) * CELL - start[0], (j + 0.5) * CELL - start[1]) for i, j in tall)
    print("robot_start: %.2f m to the nearest thing" % near)
    for name in sorted({p[0] for p in parts if not p[0].startswith("wall_")}):   # halves of walls meet inside
        solids = [p[1:] for p in parts if p[0] == name and p[1] != "mesh"]
        points = [q for p in parts if p[0] == name and p[1] == "mesh" for q in outline(p[2], p[3], LASER)]
        worst = max((gap(q, solids, LASER) for q in points), default=0)
        if worst > 0.02:
            print("%-18s seen and solid differ by up to %.3f m at %.3f m" % (name, worst, LASER))


if __name__ == "__main__":
    main()
