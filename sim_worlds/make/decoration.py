"""Lamps, plants, rugs, curtains, pictures, windows, doors and small things."""
import math

import shapes
from model import Model


def floor_lamp(name, about):
    """0.40 across, 1.60 high."""
    model = Model(name, about)
    model.show("graphite", shapes.lathe([(0, 0), (0.15, 0), (0.15, 0.02), (0.02, 0.03), (0.02, 0.05)], 24))
    model.solid_cylinder(0.15, 0.025, (0, 0, 0.0125))
    model.cylinder("brass", 0.012, 1.32, (0, 0, 0.69), segments=10)
    _lamp_shade(model, 0.20, 0.14, 0.30, 1.30)
    return model


def table_lamp(name, about, z=0.0):
    """0.26 across, 0.45 high."""
    model = Model(name, about)
    foot = [(0, 0), (0.07, 0), (0.085, 0.05), (0.07, 0.12), (0.025, 0.20), (0.015, 0.24)]
    model.show("teal", shapes.lathe(foot, 18, True))
    model.solid_cylinder(0.07, 0.20, (0, 0, 0.10))
    _lamp_shade(model, 0.13, 0.09, 0.20, 0.25)
    return model


def pendant_lamp(name, about):
    """Hangs from 2.50; a dome 0.40 across, its rim at 1.85."""
    model = Model(name, about)
    model.show("black", shapes.cylinder(0.004, 0.42, 6), (0, 0, 2.29))
    model.show("black", shapes.cylinder(0.05, 0.03, 12), (0, 0, 2.485))
    dome = [(0.20, 1.85), (0.19, 1.93), (0.15, 2.01), (0.08, 2.07), (0, 2.09)]
    inside = [(r * 0.97, z - 0.004) for r, z in dome]
    model.show("navy", shapes.lathe(dome + inside[::-1] + dome[:1], 24, True))
    model.show("shade", shapes.cushion((0.10, 0.10, 0.10), 12, 8, 1.0), (0, 0, 1.93))
    model.solid_cylinder(0.16, 0.22, (0, 0, 1.97))
    return model


def _lamp_shade(model, low, high, height, z):
    rim = [(low, z), (high, z + height), (high - 0.004, z + height), (low - 0.004, z), (low, z)]
    model.show("shade", shapes.lathe(rim, 24))
    model.show("shade", shapes.cushion((0.07, 0.07, 0.09), 10, 6, 1.0), (0, 0, z + height * 0.45))
    model.solid_cylinder((low + high) / 2, height, (0, 0, z + height / 2))


def _leaf(length, width, droop):
    """A leaf along +x with both sides, folded along its middle."""
    def point(u, v):
        w = width * math.sin(math.pi * min(1.0, 0.04 + u * 0.96)) ** 0.7
        return (length * u, (v - 0.5) * w, -droop * u * u + 0.25 * abs(v - 0.5) * w)

    return _cloth(point, 4, 2, 0.003)


def _cloth(point, nu, nv, thick, repeat=None):
    """A sheet with its other side, closed along the rim, `thick` in the middle."""
    def behind(u, v):
        x, y, z = point(u, v)
        nx, ny, nz = shapes.normal(point, u, v)
        depth = thick * math.sin(math.pi * u) * math.sin(math.pi * v)
        return (x - nx * depth, y - ny * depth, z - nz * depth)

    return shapes.sheet(point, nu, nv, repeat) + shapes.flipped(shapes.sheet(behind, nu, nv, repeat))


def plant_tall(name, about):
    """A rubber tree, 1.45 high, 0.75 across, in a pot 0.36 across."""
    model = Model(name, about)
    _pot(model, "terracotta", 0.18, 0.34)
    stems = (((0, 0), (0.03, 0.02), 1.25), ((0.03, -0.04), (0.10, -0.14), 1.0), ((-0.04, 0.03), (-0.13, 0.09), 0.85))
    for (x0, y0), (x1, y1), top in stems:
        model.show("bark", shapes.tube([(x0, y0, 0.28), ((x0 + x1) / 2, (y0 + y1) / 2, top * 0.6), (x1, y1, top)],
                                       [0.014, 0.011, 0.006], 6))
        for k in range(9):
            t = 0.38 + 0.62 * k / 8
            a = 2.4 * k + 5 * x1
            at = (x0 + (x1 - x0) * t, y0 + (y1 - y0) * t, 0.28 + (top - 0.28) * t)
            size = 0.30 - 0.10 * t
            model.show("leaf" if k % 3 else "leaf_light", _leaf(size, 0.13, 0.10), at, (0, -0.55 - 0.3 * t, a))
    for radius, length, z in ((0.05, 0.30, 0.45), (0.24, 0.35, 0.75), (0.20, 0.35, 1.10)):
        model.solid_cylinder(radius, length, (0, 0, z))
    return model


def plant_small(name, about):
    """A pot plant, 0.38 high, 0.30 across: for window sills, boards and tables."""
    model = Model(name, about)
    _pot(model, "ceramic", 0.075, 0.13)
    for k in range(14):
        t = k / 14
        model.show("leaf_light" if k % 2 else "leaf", _leaf(0.22 - 0.04 * t, 0.045, 0.09), (0, 0, 0.11),
                   (0, -0.45 - 0.95 * t, 2.4 * k))
    model.solid_cylinder(0.11, 0.22, (0, 0, 0.25))
    return model


def _pot(model, material, radius, height):
    profile = [(0, 0), (radius * 0.72, 0), (radius * 0.96, height * 0.86), (radius, height * 0.86), (radius, height),
               (radius * 0.9, height), (radius * 0.86, height * 0.88)]
    model.show(material, shapes.lathe(profile, 18))
    model.show("soil", shapes.lathe([(radius * 0.9, height * 0.88), (0, height * 0.9)], 18))
    model.solid_cylinder(radius * 0.86, height * 0.86, (0, 0, height * 0.43))
    model.solid_cylinder(radius, height * 0.14, (0, 0, height * 0.93))


def rug(name, about, material, length, width):
    """Flat, 1.5 mm, to be seen only; length along x."""
    model = Model(name, about)
    top = shapes.sheet(lambda u, v: ((u - 0.5) * length, (v - 0.5) * width, 0.0015), 1, 1, (1, 1))
    model.show(material, top)
    return model


def picture(name, about, material, width, height, frame):
    """A framed picture; its back at x = 0, its middle at z = 0: hang it on a wall."""
    model = Model(name, about)
    bar = 0.03
    for side in (1, -1):
        model.trim(frame, (0.025, width + 2 * bar, bar), (0.0125, 0, side * (height + bar) / 2), bevel=0.004)
        model.trim(frame, (0.025, bar, height), (0.0125, side * (width + bar) / 2, 0), bevel=0.004)
    model.show("white", shapes.image(width, height), (0.010, 0, 0))
    model.show(material, shapes.image(width - 0.09, height - 0.09), (0.012, 0, 0))
    return model


def curtain(name, about):
    """A gathered curtain 0.50 wide, from 0.03 to 2.32; its back at x = 0."""
    model = Model(name, about)

    def point(u, v):
        depth = 0.065 + 0.028 * math.sin(2 * math.pi * 5 * u) * (0.55 + 0.45 * (1 - v))
        return (depth, (u - 0.5) * (0.50 - 0.05 * math.sin(math.pi * v)), 0.03 + 2.29 * v)

    model.show("curtain", _cloth(point, 40, 3, 0.006, (1.0, 1.0)))
    model.solid_box((0.05, 0.46, 2.29), (0.065, 0, 1.175))
    return model


def curtain_rod(name, about, width):
    """Over a window at 2.34; its back at x = 0."""
    model = Model(name, about)
    model.show("brass", shapes.tube([(0.065, -width / 2, 2.34), (0.065, width / 2, 2.34)], 0.012, 8))
    for side in (1, -1):
        model.show("brass", shapes.cushion((0.045, 0.045, 0.045), 10, 6, 1.0), (0.065, side * width / 2, 2.34))
        model.trim("brass", (0.07, 0.012, 0.02), (0.035, side * (width / 2 - 0.08), 2.34))
    model.solid_box((0.024, width, 0.024), (0.065, 0, 2.34))
    return model


def window(name, about, width, height):
    """Fills a hole of that size: frame, two panes and a view; its middle in the origin, room towards +x."""
    model, bar = Model(name, about), 0.06
    for side in (1, -1):
        model.box("white", (0.07, width, bar), (0, 0, side * (height - bar) / 2), bevel=0.006)
        model.box("white", (0.07, bar, height - 2 * bar), (0, side * (width - bar) / 2, 0), bevel=0.006)
    model.box("white", (0.07, 0.07, height - 2 * bar), (0, 0, 0), bevel=0.006)
    model.solid_box((0.02, width - 0.1, height - 0.1), (-0.015, 0, 0))
    model.show("view", shapes.image(width - 2 * bar, height - 2 * bar), (-0.005, 0, 0))
    model.trim("steel", (0.03, 0.02, 0.11), (0.045, 0, -0.05), bevel=0.005)
    return model


def door_leaf(name, about, material, fields, width, height):
    """0.04 thick, two fields and handles on both sides; hinged at -y."""
    model = Model(name, about)
    model.box(material, (0.04, width, height), (0, 0, 0.005 + height / 2))
    for side in (1, -1):
        for z, tall in ((1.45, 0.90), (0.50, 0.70)):
            model.trim(fields, (0.008, width - 0.34, tall), (side * 0.021, 0, z), bevel=0.003)
            model.trim(material, (0.008, width - 0.42, tall - 0.08), (side * 0.024, 0, z), bevel=0.003)
        y = width / 2 - 0.06
        model.trim("steel", (0.006, 0.035, 0.16), (side * 0.023, y, 1.03))
        bar = [(side * 0.02, y, 1.06), (side * 0.06, y, 1.06), (side * 0.06, y - 0.10, 1.06)]
        model.show("steel", shapes.tube(bar, 0.009, 6))
        model.solid_box((0.05, 0.12, 0.02), (side * 0.045, y - 0.05, 1.06))
    return model


def door_frame(name, about):
    """Lines a hole of 1.04 x 2.08 in a wall up to 0.13 thick; 0.98 x 2.05 stay clear; one walks along x."""
    model = Model(name, about)
    for side in (1, -1):
        model.box("white", (0.15, 0.03, 2.08), (0, side * 0.505, 1.04))
        for face in (1, -1):
            model.box("white", (0.014, 0.06, 2.14), (face * 0.069, side * 0.548, 1.07))
    model.box("white", (0.15, 0.98, 0.03), (0, 0, 2.065))
    for face in (1, -1):
        model.trim("white", (0.014, 1.036, 0.06), (face * 0.069, 0, 2.11))
    return model


def mirror(name, about):
    """0.50 x 1.40 on a wall; its back at x = 0, its middle at z = 0."""
    model = Model(name, about)
    model.box("oak", (0.025, 0.50, 1.40), (0.0125, 0, 0), bevel=0.005)
    model.show("mirror_view", shapes.image(0.44, 1.34), (0.0255, 0, 0))
    return model


def coat_rack(name, about):
    """0.90 wide on a wall at 1.65: a board, hooks, two coats and a bag; its back at x = 0."""
    model = Model(name, about)
    model.box("oak", (0.02, 0.90, 0.12), (0.01, 0, 1.68), bevel=0.004)
    for k in range(5):
        y = 0.18 * (k - 2)
        model.show("brass", shapes.tube([(0.02, y, 1.67), (0.06, y, 1.66), (0.07, y, 1.70)], 0.007, 6))
    for y, paint, wide, low in ((0.36, "navy", 0.34, 0.78), (-0.02, "terracotta", 0.30, 0.92)):
        tall = 1.66 - low
        model.cushion(paint, (0.11, wide, tall), (0.075, y, low + tall / 2), roundness=0.45, segments=14)
    model.cushion("leather", (0.10, 0.30, 0.26), (0.07, -0.36, 1.27), roundness=0.35)
    model.show("leather", shapes.tube([(0.07, -0.46, 1.36), (0.065, -0.36, 1.66), (0.07, -0.26, 1.36)], 0.008, 6))
    return model


def basket(name, about, material, low, high, height, filled):
    """A round bin or basket, open at the top."""
    model = Model(name, about)
    profile = [(0, 0), (low, 0), (high, height), (high - 0.012, height), (low - 0.012, 0.05), (0, 0.05)]
    model.show(material, shapes.lathe(profile, 22))
    model.solid_cylinder((low + high) / 2, height, (0, 0, height / 2))
    if filled:
        for k, paint in enumerate(("linen", "teal", "cream")):
            model.show(paint, shapes.cushion((high * 1.3, high * 1.2, 0.14), 12, 6, 0.7),
                       (0.03 * (k - 1), 0.04 * (1 - k), height - 0.03 + 0.02 * k), (0.2 * k, 0.1, k))
    return model


def towel_rail(name, about):
    """0.60 wide on a wall: a rail at 1.20 with two towels; its back at x = 0."""
    model = Model(name, about)
    model.show("steel", shapes.tube([(0.06, -0.30, 1.20), (0.06, 0.30, 1.20)], 0.009, 8))
    for side in (1, -1):
        model.trim("steel", (0.06, 0.014, 0.014), (0.03, side * 0.28, 1.20))
    for y, paint in ((0.13, "linen"), (-0.14, "teal")):
        model.box(paint, (0.035, 0.22, 0.48), (0.06, y, 0.98), bevel=0.014)
    return model
