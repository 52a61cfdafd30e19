"""Triangle meshes from lathes, lofts, tubes, ellipsoids, boxes and extruded outlines. Metres, z up."""
import math

CREASE = math.cos(math.radians(40.0))  # faces that meet at less than this angle look smooth


def _sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _unit(a):
    length = math.sqrt(_dot(a, a)) or 1.0
    return (a[0] / length, a[1] / length, a[2] / length)


class Mesh:
    """Faces are (material, three corners); a corner is (x, y, z, u, v); counter-clockwise seen from outside."""

    def __init__(self, faces=()):
        self.faces = list(faces)

    def __add__(self, other):
        return Mesh(self.faces + other.faces)

    def mapped(self, function):
        return Mesh((m, tuple(function(*c[:3]) + tuple(c[3:]) for c in corners)) for m, corners in self.faces)

    def moved(self, x=0.0, y=0.0, z=0.0):
        return self.mapped(lambda a, b, c: (a + x, b + y, c + z))

    def scaled(self, x=1.0, y=1.0, z=1.0):
        return self.mapped(lambda a, b, c: (a * x, b * y, c * z))

    def turned(self, axis, degrees):
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        turn = {"x": lambda x, y, z: (x, c * y - s * z, s * y + c * z),
                "y": lambda x, y, z: (c * x + s * z, y, c * z - s * x),
                "z": lambda x, y, z: (c * x - s * y, s * x + c * y, z)}[axis]
        return self.mapped(turn)

    def points(self):
        return [c[:3] for _, corners in self.faces for c in corners]

    def bounds(self):
        points = self.points()
        return [min(p[i] for p in points) for i in range(3)], [max(p[i] for p in points) for i in range(3)]

    def volume(self):
        return sum(_dot(a[:3], _cross(b[:3], c[:3])) for _, (a, b, c) in self.faces) / 6.0

    def outwards(self):
        """The faces of a closed body turned so that they are seen from outside."""
        return self if self.volume() >= 0 else Mesh((m, (a, c, b)) for m, (a, b, c) in self.faces)

    def without_slivers(self):
        """Only faces that have an area."""
        def real(corners):
            n = _cross(_sub(corners[1], corners[0]), _sub(corners[2], corners[0]))
            return _dot(n, n) > 1e-20
        return Mesh(f for f in self.faces if real(f[1]))

    def normals(self):
        """For each face the normals of its corners: shared with neighbours unless there is a crease."""
        flat, around = [], {}
        for i, (_, corners) in enumerate(self.faces):
            flat.append(_cross(_sub(corners[1], corners[0]), _sub(corners[2], corners[0])))
            for c in corners:
                around.setdefault(tuple(round(x, 6) for x in c[:3]), []).append(i)
        units = [_unit(n) for n in flat]
        result = []
        for i, (_, corners) in enumerate(self.faces):
            here = []
            for c in corners:
                near = [flat[k] for k in around[tuple(round(x, 6) for x in c[:3])] if _dot(units[i], units[k]) > CREASE]
                here.append(_unit(tuple(sum(n[a] for n in near) for a in range(3))))
            result.append(here)
        return result


def ring(radius_x, radius_y, z, segments=28, power=2.0, x=0.0, y=0.0):
    """A closed outline at height z; power 2 is an ellipse, larger ones go towards a rectangle."""
    points = []
    for i in range(segments):
        a = 2.0 * math.pi * i / segments
        c, s = math.cos(a), math.sin(a)
        k = (abs(c) ** power + abs(s) ** power) ** (-1.0 / power)
        points.append((x + radius_x * c * k, y + radius_y * s * k, z))
    return points


def loft(rings, material, caps=True, v_rows=None):
    """A skin over outlines of equal length from the lowest to the highest; u runs round, v along."""
    faces, n = [], len(rings[0])
    v_rows = v_rows or [i / (len(rings) - 1.0) for i in range(len(rings))]
    for low, high, v0, v1 in zip(rings, rings[1:], v_rows, v_rows[1:]):
        for i in range(n):
            k, u0, u1 = (i + 1) % n, i / n, (i + 1) / n
            a, b = low[i] + (u0, v0), low[k] + (u1, v0)
            c, d = high[k] + (u1, v1), high[i] + (u0, v1)
            faces += [(material, (a, b, c)), (material, (a, c, d))]
    if caps:
        for outline, turn in ((rings[0], -1), (rings[-1], 1)):
            middle = tuple(sum(p[a] for p in outline) / n for a in range(3)) + (0.5, 0.5)
            for i in range(n):
                pair = [outline[i], outline[(i + 1) % n]][::turn]
                faces.append((material, (middle, pair[0] + (0.5, 0.5), pair[1] + (0.5, 0.5))))
    return Mesh(faces).without_slivers()


def lathe(profile, material, segments=28):
    """Turn (radius, height) pairs round the z axis. Start and end on the axis to get a closed body."""
    length = [0.0]
    for (r0, z0), (r1, z1) in zip(profile, profile[1:]):
        length.append(length[-1] + math.hypot(r1 - r0, z1 - z0))
    rings = [ring(r, r, z, segments) for r, z in profile]
    return loft(rings, material, caps=False, v_rows=[s / length[-1] for s in length])


def cylinder(radius, z0, z1, material, segments=28):
    return lathe([(0, z0), (radius, z0), (radius, z1), (0, z1)], material, segments)


def ellipsoid(rx, ry, rz, material, segments=16):
    rings = []
    for i in range(segments // 2 + 1):
        t = math.pi * (i / (segments // 2) - 0.5)
        rings.append(ring(rx * math.cos(t), ry * math.cos(t), rz * math.sin(t), segments))
    return loft(rings, material, caps=False)


def tube(path, radii, material, segments=10, closed=False):
    """A skin round a path; a ring at each of its points. Closed: the end joins the beginning."""
    rings, side = [], None
    for i, p in enumerate(path):
        ahead = path[(i + 1) % len(path)] if closed or i + 1 < len(path) else p
        back = path[i - 1] if closed or i > 0 else p
        forward = _unit(_sub(ahead, back))
        if side is None:
            side = (0, 0, 1) if abs(forward[2]) < 0.9 else (1, 0, 0)
        up = _unit(_cross(forward, side))
        side = _unit(_cross(up, forward))
        r = radii[i] if isinstance(radii, (list, tuple)) else radii
        rings.append([tuple(p[a] + r * (math.cos(t) * side[a] - math.sin(t) * up[a]) for a in range(3))
                      for t in (-2.0 * math.pi * k / segments for k in range(segments))])
    if closed:
        return loft(rings + [rings[0]], material, caps=False).outwards()
    return loft(rings, material).outwards()


def box(size, material, centre=(0, 0, 0), cells=None):
    """cells: face (+x -x +y -y +z -z) -> rectangle (u0, v0, u1, v1) of the picture."""
    faces = []
    for axis in range(3):
        for sign in (1, -1):
            normal = [0.0, 0.0, 0.0]
            normal[axis] = sign
            up = [0.0, 1.0, 0.0] if axis == 2 else [0.0, 0.0, 1.0]
            right = _cross(up, normal)
            u0, v0, u1, v1 = (cells or {}).get("+-"[sign < 0] + "xyz"[axis], (0, 0, 1, 1))
            corners = []
            for r, h, u, v in ((-1, -1, u0, v0), (1, -1, u1, v0), (1, 1, u1, v1), (-1, 1, u0, v1)):
                corners.append(tuple(centre[a] + 0.5 * size[a] * (normal[a] + r * right[a] + h * up[a])
                                     for a in range(3)) + (u, v))
            faces += [(material, tuple(corners[:3])), (material, (corners[0], corners[2], corners[3]))]
    return Mesh(faces)


def _inside(p, a, b, c):
    def side(u, v):
        return (v[0] - u[0]) * (p[1] - u[1]) - (v[1] - u[1]) * (p[0] - u[0])
    return side(a, b) >= 0 and side(b, c) >= 0 and side(c, a) >= 0


def _ears(outline):
    """Triangles of a simple polygon that runs counter-clockwise."""
    left, triangles = list(range(len(outline))), []
    while len(left) > 3:
        for k in range(len(left)):
            i, j, m = left[k - 1], left[k], left[(k + 1) % len(left)]
            a, b, c = outline[i], outline[j], outline[m]
            convex = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 1e-12
            if convex and not any(_inside(outline[q], a, b, c) for q in left if q not in (i, j, m)):
                triangles.append((i, j, m))
                del left[k]
                break
        else:
            raise ValueError("the outline crosses itself or runs clockwise")
    return triangles + [tuple(left)]


def extrude(outline, z0, z1, material):
    """A prism over a polygon [(x, y), ...] that runs counter-clockwise."""
    low, high = [(x, y, z0) for x, y in outline], [(x, y, z1) for x, y in outline]
    mesh = loft([low, high], material, caps=False)
    for i, j, k in _ears(outline):
        mesh.faces.append((material, tuple(high[m] + (0.5, 0.5) for m in (i, j, k))))
        mesh.faces.append((material, tuple(low[m] + (0.5, 0.5) for m in (k, j, i))))
    return mesh
