"""Triangle shapes. A shape is a list of triangles, a triangle three corners (position, normal, uv), seen
counter-clockwise from outside. Lengths in metres; a texture repeats once a metre unless a shape says otherwise."""
import math


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(a[0] ** 2 + a[1] ** 2 + a[2] ** 2)
    return scale(a, 1 / length) if length > 1e-12 else (0.0, 0.0, 1.0)


def rotate(p, rpy):
    """Turns by roll about x, then pitch about y, then yaw about z (the order of SDF)."""
    x, y, z = p
    (sr, cr), (sp, cp), (sy, cy) = [(math.sin(a), math.cos(a)) for a in rpy]
    y, z = cr * y - sr * z, sr * y + cr * z
    x, z = cp * x + sp * z, -sp * x + cp * z
    return (cy * x - sy * y, sy * x + cy * y, z)


def moved(shape, at=(0, 0, 0), rpy=(0, 0, 0)):
    return [[(add(rotate(p, rpy), at), rotate(n, rpy), t) for p, n, t in triangle] for triangle in shape]


def flipped(shape):
    """The same surface seen from its other side."""
    return [[(p, scale(n, -1), t) for p, n, t in reversed(triangle)] for triangle in shape]


def mapped(shape, turned=False, offset=(0.0, 0.0)):
    """Texture coordinates in metres, each triangle seen along the axis that it faces."""
    result = []
    for (p0, n0, _), (p1, n1, _), (p2, n2, _) in shape:
        face = cross(sub(p1, p0), sub(p2, p0))
        axis = max(range(3), key=lambda i: abs(face[i]))
        u, v = [(1, 2), (0, 2), (0, 1)][axis]
        if turned:
            u, v = v, u
        result.append([(p, n, (p[u] + offset[0], p[v] + offset[1])) for p, n in ((p0, n0), (p1, n1), (p2, n2))])
    return result


def quad(a, b, c, d, normals):
    corners = [(p, n, (0.0, 0.0)) for p, n in zip((a, b, c, d), normals)]
    return [[corners[0], corners[1], corners[2]], [corners[0], corners[2], corners[3]]]


def facing(shape):
    """Turns each triangle so that it is wound the way its normals point; drops those without area."""
    result = []
    for triangle in shape:
        (a, na, _), (b, nb, _), (c, nc, _) = triangle
        face = cross(sub(b, a), sub(c, a))
        if max(map(abs, face)) < 1e-10:
            continue
        normal = add(add(na, nb), nc)
        towards = sum(face[i] * normal[i] for i in range(3))
        result.append(triangle if towards >= 0 else triangle[::-1])
    return result


def box(size, bevel=0.0, offset=(0.0, 0.0), skip=()):
    """A box round its middle; `bevel` rounds its edges; the grain of a texture runs along the longer side of each
    face. `skip` names faces to leave out: '+x', '-z', ..."""
    half = [s / 2 for s in size]
    inner = [h - bevel for h in half]
    axes = [(axis, sign) for axis in range(3) for sign in (1, -1)]
    normal = {(a, s): tuple(float(s) if i == a else 0.0 for i in range(3)) for a, s in axes}

    def corner(axis, signs):
        return tuple(signs[i] * (half[i] if i == axis else inner[i]) for i in range(3))

    shape = []
    for axis, sign in axes:
        if "+-"[sign < 0] + "xyz"[axis] in skip:
            continue
        u, v = [i for i in range(3) if i != axis]
        points = []
        for su, sv in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
            signs = [0, 0, 0]
            signs[axis], signs[u], signs[v] = sign, su, sv
            points.append(corner(axis, signs))
        face = facing(quad(*points, [normal[axis, sign]] * 4))
        if size[u] >= size[v]:
            shape += [[(p, n, (p[u] + offset[0], p[v] + offset[1])) for p, n, _ in t] for t in face]
        else:
            shape += [[(p, n, (p[v] + offset[0], p[u] + offset[1])) for p, n, _ in t] for t in face]
    return shape + (mapped(_bevels(corner, normal), offset=offset) if bevel > 0 else [])


def _bevels(corner, normal):
    shape = []
    for a, b in ((0, 1), (0, 2), (1, 2)):
        c = 3 - a - b
        for sa in (1, -1):
            for sb in (1, -1):
                ends = []
                for sc in (1, -1):
                    signs = [0, 0, 0]
                    signs[a], signs[b], signs[c] = sa, sb, sc
                    ends.append((corner(a, signs), corner(b, signs)))
                shape += quad(ends[0][0], ends[0][1], ends[1][1], ends[1][0],
                              [normal[a, sa], normal[b, sb], normal[b, sb], normal[a, sa]])
    for signs in [(x, y, z) for x in (1, -1) for y in (1, -1) for z in (1, -1)]:
        shape.append([(corner(i, signs), normal[i, signs[i]], (0.0, 0.0)) for i in range(3)])
    return facing(shape)


def lathe(profile, segments=16, smooth=False):
    """Turns (radius, z) points about z. The profile runs with the outside on its right: upwards outside,
    downwards inside; smooth=True rounds the bends of the profile. An end off the axis is closed by a disc, unless the
    profile comes back to where it began."""
    if profile[0] != profile[-1]:
        first, last = profile[0], profile[-1]
        profile = ([(0, first[1])] if first[0] > 0 else []) + profile + ([(0, last[1])] if last[0] > 0 else [])
    slopes = []
    for (r0, z0), (r1, z1) in zip(profile, profile[1:]):
        slopes.append(unit((z1 - z0, 0.0, r0 - r1)))
    shape = []
    for i, ((r0, z0), (r1, z1)) in enumerate(zip(profile, profile[1:])):
        low = high = slopes[i]
        if smooth and i > 0:
            low = unit(add(slopes[i - 1], slopes[i]))
        if smooth and i + 1 < len(slopes):
            high = unit(add(slopes[i], slopes[i + 1]))
        for k in range(segments):
            spin = [(0, 0, 2 * math.pi * (k + j) / segments) for j in (0, 1)]
            corners = [((r, 0, z), n, s) for r, z, n, s in
                       ((r0, z0, low, 0), (r0, z0, low, 1), (r1, z1, high, 1), (r1, z1, high, 0))]
            corners = [(rotate(p, spin[s]), rotate(n, spin[s])) for p, n, s in corners]
            shape += quad(*[p for p, _ in corners], [n for _, n in corners])
    return mapped(facing(shape))


def cylinder(radius, length, segments=16, top_radius=None, offset=(0.0, 0.0)):
    """Round z through its middle, with caps; top_radius makes it a cone. The grain of a long one runs along it."""
    top = radius if top_radius is None else top_radius
    h = length / 2
    return mapped(lathe([(0, -h), (radius, -h), (top, h), (0, h)], segments), length > 3 * radius, offset)


def cushion(size, segments=16, rings=8, roundness=0.35):
    """A soft block: a superellipsoid of that size. roundness 0 is a box, 1 an ellipsoid."""
    def power(value, exponent):
        return math.copysign(abs(value) ** exponent, value) if abs(value) > 1e-9 else 0.0

    def vertex(i, j):
        a = 2 * math.pi * (i + 0.5) / segments
        b = math.pi * (j / rings - 0.5)
        e = roundness
        ca, sa, cb, sb = math.cos(a), math.sin(a), math.cos(b), math.sin(b)
        p = (power(cb, e) * power(ca, e), power(cb, e) * power(sa, e), power(sb, e))
        n = (power(cb, 2 - e) * power(ca, 2 - e) / size[0], power(cb, 2 - e) * power(sa, 2 - e) / size[1],
             power(sb, 2 - e) / size[2])
        return tuple(p[k] * size[k] / 2 for k in range(3)), unit(n)

    return mapped(facing(_grid(vertex, segments, rings)))


def _grid(vertex, nu, nv):
    shape = []
    for i in range(nu):
        for j in range(nv):
            corners = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]
            shape += quad(*[p for p, _ in corners], [n for _, n in corners])
    return shape


def normal(point, u, v):
    """Of the surface point(u, v)."""
    d = 1e-4
    return unit(cross(sub(point(u + d, v), point(u - d, v)), sub(point(u, v + d), point(u, v - d))))


def sheet(point, nu, nv, repeat=None):
    """The surface point(u, v), u and v in 0..1, seen from where u turns to v counter-clockwise. `repeat` = how many
    textures along u and v; without it the texture lies on in metres."""
    def vertex(i, j):
        return point(i / nu, j / nv), normal(point, i / nu, j / nv)

    shape = _grid(vertex, nu, nv)
    if repeat is None:
        return mapped(shape)
    result = []
    for index, triangle in enumerate(shape):
        i, j = (index // 2) // nv, (index // 2) % nv
        uv = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
        uv = [uv[0], uv[1], uv[2]] if index % 2 == 0 else [uv[0], uv[2], uv[3]]
        result.append([(p, n, (a / nu * repeat[0], b / nv * repeat[1])) for (p, n, _), (a, b) in zip(triangle, uv)])
    return result


def image(width, height, area=(0.0, 0.0, 1.0, 1.0)):
    """An upright picture that looks along +x, its middle in the origin; `area` = part of the texture (u0, v0, u1, v1),
    v upwards."""
    u0, v0, u1, v1 = area
    w, h, n = width / 2, height / 2, (1.0, 0.0, 0.0)
    a, b, c, d = [((0.0, y, z), n, (u, v)) for y, z, u, v in
                  ((-w, -h, u0, v0), (w, -h, u1, v0), (w, h, u1, v1), (-w, h, u0, v1))]
    return [[a, b, c], [a, c, d]]


def tube(points, radius, segments=8):
    """A round bar along the points, closed at both ends. radius: one number or one for each point."""
    radii = radius if isinstance(radius, (list, tuple)) else [radius] * len(points)
    rings = []
    for i, p in enumerate(points):
        along = unit(sub(points[min(i + 1, len(points) - 1)], points[max(i - 1, 0)]))
        side = unit(cross(along, (0, 0, 1) if abs(along[2]) < 0.9 else (0, 1, 0)))
        up = cross(side, along)
        ring = []
        for k in range(segments):
            a = 2 * math.pi * k / segments
            n = add(scale(side, math.cos(a)), scale(up, math.sin(a)))
            ring.append((add(p, scale(n, radii[i])), n))
        rings.append(ring)
    shape = []
    for low, high in zip(rings, rings[1:]):
        for k in range(segments):
            corners = [low[k], low[(k + 1) % segments], high[(k + 1) % segments], high[k]]
            shape += quad(*[p for p, _ in corners], [n for _, n in corners])
    for ring, middle, outward in ((rings[0], points[0], unit(sub(points[0], points[1]))),
                                  (rings[-1], points[-1], unit(sub(points[-1], points[-2])))):
        for k in range(segments):
            shape.append([(p, outward, (0.0, 0.0)) for p in (middle, ring[k][0], ring[(k + 1) % segments][0])])
    return mapped(facing(shape), turned=True)
