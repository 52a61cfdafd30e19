"""Kitchen and bathroom; backs towards -x."""
import math

import shapes
from model import Model


def _basin(model, material, size, at, thick=0.012):
    """An open tub sunk below z of `at`: four sides and a bottom."""
    (dx, dy, depth), (x, y, z) = size, at
    for side in (1, -1):
        model.box(material, (thick, dy, depth), (x + side * (dx - thick) / 2, y, z - depth / 2))
        model.box(material, (dx, thick, depth), (x, y + side * (dy - thick) / 2, z - depth / 2))
    model.box(material, (dx, dy, thick), (x, y, z - depth + thick / 2))


def _tap(model, at):
    x, y, z = at
    arc = [(x, y, z), (x, y, z + 0.20)]
    arc += [(x + 0.08 - 0.08 * math.cos(a), y, z + 0.20 + 0.08 * math.sin(a)) for a in (0.5, 1.1, 1.6, 2.2, 2.8)]
    model.show("steel", shapes.tube(arc + [(x + 0.16, y, z + 0.17)], 0.011, 8))
    model.show("steel", shapes.tube([(x, y, z + 0.05), (x, y + 0.07, z + 0.075)], 0.007, 6))
    model.solid_cylinder(0.012, 0.24, (x, y, z + 0.12))
    model.solid_box((0.15, 0.022, 0.03), (x + 0.08, y, z + 0.265))


SINK = 0.62     # y of the sink in the counter


def kitchen_sink(name, about):
    """Basin and tap for the hole in a counter: stands where the counter stands."""
    model = Model(name, about)
    _sink(model)
    return model


def _sink(model):
    _basin(model, "steel", (0.385, 0.505, 0.045), (0, SINK, 0.908))
    _tap(model, (-0.245, SINK, 0.905))


def kitchen_counter(name, about, fitted=True):
    """0.62 x 2.85, 0.91 high: from the left (+y) drawers, sink, dish washer, stove with oven, drawers. Not `fitted`: a
    hole where the sink goes, and nothing on it."""
    model, width = Model(name, about), 2.85
    model.box("graphite", (0.52, width - 0.01, 0.10), (-0.035, 0, 0.05))
    model.box("white", (0.56, width, 0.765), (-0.03, 0, 0.4825))
    model.solid_box((0.018, width, 0.76), (0.26, 0, 0.4825))
    left, right, sink = width / 2, -width / 2, SINK
    model.box("stone", (0.62, left - sink - 0.25, 0.04), (0, (left + sink + 0.25) / 2, 0.885), bevel=0.004)
    model.box("stone", (0.62, sink - 0.25 - right, 0.04), (0, (sink - 0.25 + right) / 2, 0.885), bevel=0.004)
    model.box("stone", (0.12, 0.50, 0.04), (0.25, sink, 0.885), bevel=0.004)
    model.box("stone", (0.12, 0.50, 0.04), (-0.25, sink, 0.885), bevel=0.004)
    if fitted:
        _sink(model)
    units = ((1.13, 0.58, "drawers"), (0.54, 0.60, "door"), (-0.06, 0.60, "washer"), (-0.66, 0.60, "stove"),
             (-1.19, 0.46, "drawers"))
    for y, wide, kind in units:
        _front(model, y, wide, kind)
    _hob(model, -0.66)
    if fitted:
        _on_counter(model)
    return model


def _on_counter(model):
    red = [(0, 0), (0.10, 0), (0.105, 0.13), (0.108, 0.13), (0.098, 0.128), (0.095, 0.135), (0.05, 0.15), (0, 0.152)]
    model.show("red", shapes.lathe(red, 20, False), (-0.11, -0.79, 0.914))
    model.show("black", shapes.cushion((0.04, 0.04, 0.03), 10, 5, 0.8), (-0.11, -0.79, 1.075))
    model.solid_cylinder(0.104, 0.15, (-0.11, -0.79, 0.99))
    model.box("oak", (0.30, 0.20, 0.02), (0.05, -1.15, 0.915), (0, 0, 0.2), bevel=0.004)
    for k, (y, r, paint) in enumerate(((1.20, 0.05, "terracotta"), (1.30, 0.04, "cream"), (1.08, 0.045, "sage"))):
        model.cylinder(paint, r, 0.20 - 0.03 * k, (-0.18, y, 1.005 - 0.015 * k), segments=16)
        model.show("oak", shapes.cylinder(r * 0.9, 0.02, 16), (-0.18, y, 1.115 - 0.03 * k))


def _front(model, y, wide, kind):
    x = 0.26
    if kind == "drawers":
        for z, tall in ((0.765, 0.19), (0.52, 0.29), (0.24, 0.26)):
            model.trim("sage", (0.02, wide - 0.008, tall), (x, y, z), bevel=0.003)
            model.trim("brass", (0.022, 0.18, 0.012), (x + 0.019, y, z + tall / 2 - 0.045))
    elif kind in ("door", "washer"):
        model.trim("sage", (0.02, wide - 0.008, 0.75), (x, y, 0.485), bevel=0.003)
        model.trim("brass", (0.022, 0.30, 0.012), (x + 0.019, y, 0.80))
    else:
        model.trim("steel", (0.02, wide - 0.008, 0.11), (x, y, 0.805), bevel=0.003)
        for k in range(5):
            model.show("black", shapes.moved(shapes.cylinder(0.017, 0.02, 12), rpy=(0, math.pi / 2, 0)),
                       (x + 0.018, y + 0.09 * (k - 2), 0.805))
        model.trim("black", (0.02, wide - 0.008, 0.50), (x, y, 0.49), bevel=0.003)
        model.trim("graphite", (0.004, 0.40, 0.28), (x + 0.011, y, 0.47))
        model.trim("steel", (0.03, 0.48, 0.018), (x + 0.024, y, 0.70))
        model.trim("sage", (0.02, wide - 0.008, 0.125), (x, y, 0.17), bevel=0.003)


def _hob(model, y):
    model.trim("black", (0.50, 0.56, 0.008), (0, y, 0.909), bevel=0.002)
    for x, dy, r in ((0.11, 0.13, 0.09), (0.11, -0.13, 0.075), (-0.11, 0.13, 0.075), (-0.11, -0.13, 0.10)):
        model.show("graphite", shapes.cylinder(r, 0.001, 20), (x, y + dy, 0.9135))


def kitchen_wall_unit(name, about):
    """On the wall above the counter, 0.35 x 2.85, from 1.45 to 2.15; cooker hood over the stove; tiles below."""
    model = Model(name, about)
    model.trim("tiles_splash", (0.012, 2.85, 0.54), (-0.169, 0, 1.18))
    for y0, y1 in ((-1.425, -0.98), (-0.34, 0.42), (0.42, 1.425)):
        wide, doors = y1 - y0, 1 if y1 - y0 < 0.6 else 2
        model.box("white", (0.33, wide - 0.002, 0.70), (-0.01, (y0 + y1) / 2, 1.80))
        for k in range(doors):
            leaf = wide / doors
            y = y0 + (k + 0.5) * leaf
            model.trim("sage", (0.02, leaf - 0.008, 0.69), (0.165, y, 1.80), bevel=0.003)
            side = -1 if k == 0 and doors == 2 else 1
            model.trim("brass", (0.022, 0.012, 0.14), (0.184, y - side * (leaf / 2 - 0.04), 1.56))
    model.box("steel", (0.34, 0.60, 0.05), (-0.005, -0.66, 1.60), bevel=0.008)
    model.box("steel", (0.24, 0.26, 0.53), (-0.05, -0.66, 1.885), bevel=0.006)
    return model


def fridge(name, about):
    """0.66 x 0.60, 1.85 high."""
    model = Model(name, about)
    model.box("graphite", (0.56, 0.56, 0.06), (-0.02, 0, 0.03))
    model.box("steel", (0.60, 0.60, 1.79), (-0.02, 0, 0.955), bevel=0.01)
    for z, tall in ((0.40, 0.64), (1.285, 1.10)):
        model.box("steel", (0.05, 0.595, tall), (0.30, 0, z), bevel=0.012)
    for z, tall in ((0.52, 0.34), (1.08, 0.50)):
        model.trim("graphite", (0.03, 0.022, tall), (0.338, 0.25, z))
    for k, paint in enumerate(("red", "yellow", "teal")):
        model.trim(paint, (0.004, 0.05, 0.05), (0.326, -0.10 + 0.10 * k, 1.55 - 0.07 * (k % 2)))
    model.trim("white", (0.002, 0.15, 0.21), (0.326, -0.14, 1.32))
    return model


def bathtub(name, about):
    """0.75 x 1.70, 0.57 high, hollow; long side to the front."""
    model = Model(name, about)
    for side in (1, -1):
        model.box("ceramic", (0.06, 1.70, 0.57), (side * 0.345, 0, 0.285), bevel=0.015)
        model.box("ceramic", (0.66, 0.10, 0.57), (0, side * 0.80, 0.285), bevel=0.015)
    model.solid_box((0.64, 1.52, 0.20), (0, 0, 0.10))

    def inside(u, v):
        a, depth = 2 * math.pi * u, 1 - v
        wide = 1.0 if depth < 0.01 else 1.0 - 0.28 * v ** 3
        return (0.318 * wide * math.copysign(abs(math.cos(a)) ** 0.45, math.cos(a)),
                0.755 * wide * math.copysign(abs(math.sin(a)) ** 0.45, math.sin(a)), 0.565 - 0.37 * min(1, 1.15 * v))

    model.show("enamel", shapes.sheet(inside, 32, 5))

    def bottom(u, v):
        x, y, _ = inside(u, 1.0)
        return (x * (1 - v), y * (1 - v), 0.195)

    model.show("enamel", shapes.sheet(bottom, 32, 1))
    for sx in (1, -1):
        for sy in (1, -1):
            model.show("ceramic", shapes.box((0.10, 0.10, 0.01)), (sx * 0.28, sy * 0.715, 0.552))
    model.show("steel", shapes.tube([(0, 0.80, 0.57), (0, 0.80, 0.68), (0, 0.70, 0.70), (0, 0.66, 0.67)], 0.014, 8))
    model.solid_box((0.03, 0.16, 0.13), (0, 0.73, 0.63))
    return model


def toilet(name, about):
    """0.68 x 0.38, seat 0.42, cistern 0.80 high."""
    model = Model(name, about)
    bowl = shapes.lathe([(0, 0), (0.62, 0), (0.55, 0.10), (0.62, 0.22), (0.95, 0.34), (1.0, 0.39), (0, 0.39)], 24, True)
    bowl = [[((p[0] * 0.24, p[1] * 0.185, p[2]), n, t) for p, n, t in tri] for tri in bowl]
    model.show("ceramic", bowl, (0.09, 0, 0))
    model.solid_cylinder(0.125, 0.26, (0.05, 0, 0.13))
    model.solid_cylinder(0.125, 0.26, (0.12, 0, 0.13))
    model.solid_box((0.42, 0.32, 0.15), (0.09, 0, 0.315))
    model.box("ceramic", (0.24, 0.26, 0.38), (-0.16, 0, 0.19), bevel=0.02)
    lid = shapes.lathe([(0, 0.395), (1.0, 0.395), (1.03, 0.41), (0.98, 0.425), (0, 0.43)], 24, True)
    model.show("white", [[((p[0] * 0.235, p[1] * 0.19, p[2]), n, t) for p, n, t in tri] for tri in lid], (0.09, 0, 0))
    model.solid_box((0.40, 0.33, 0.035), (0.09, 0, 0.412))
    model.box("ceramic", (0.17, 0.38, 0.38), (-0.255, 0, 0.60), bevel=0.02)
    model.box("white", (0.18, 0.39, 0.025), (-0.25, 0, 0.80), bevel=0.008)
    model.show("steel", shapes.cylinder(0.025, 0.01, 14), (-0.25, 0, 0.816))
    return model


def washbasin(name, about):
    """0.48 x 0.80, 0.86 high: cupboard with two drawers, basin, tap; a mirror on the wall above."""
    model = Model(name, about)
    model.box("oak", (0.44, 0.78, 0.66), (-0.02, 0, 0.46), bevel=0.004)
    model.box("graphite", (0.36, 0.70, 0.13), (-0.04, 0, 0.065))
    for z in (0.30, 0.62):
        model.trim("oak", (0.018, 0.77, 0.31), (0.208, 0, z), bevel=0.003)
        model.trim("graphite", (0.022, 0.24, 0.012), (0.226, 0, z + 0.10))
    for side in (1, -1):
        model.box("ceramic", (0.48, 0.12, 0.07), (0, side * 0.34, 0.825), bevel=0.012)
    for x, deep in ((0.20, 0.08), (-0.18, 0.12)):
        model.box("ceramic", (deep, 0.58, 0.07), (x, 0, 0.825), bevel=0.012)
    model.box("ceramic", (0.30, 0.58, 0.02), (0.02, 0, 0.80))
    _tap(model, (-0.19, 0, 0.858))
    model.box("white", (0.02, 0.72, 0.92), (-0.23, 0, 1.56), bevel=0.004)
    model.show("mirror_view", shapes.image(0.68, 0.88), (-0.219, 0, 1.56))
    model.box("white", (0.05, 0.05, 0.14), (-0.14, 0.28, 0.93), bevel=0.012)
    return model


def washing_machine(name, about):
    """0.60 x 0.60, 0.85 high."""
    model, side = Model(name, about), math.pi / 2
    model.box("white", (0.58, 0.60, 0.85), (-0.01, 0, 0.425), bevel=0.01)
    model.show("grey", shapes.moved(shapes.cylinder(0.20, 0.03, 28), rpy=(0, side, 0)), (0.285, 0, 0.45))
    model.show("black", shapes.moved(shapes.lathe([(0.15, 0), (0.14, 0.02), (0.08, 0.035), (0, 0.04)], 24, True),
                                     rpy=(0, side, 0)), (0.298, 0, 0.45))
    model.solid_cylinder(0.20, 0.03, (0.285, 0, 0.45), (0, side, 0))
    model.solid_cylinder(0.14, 0.035, (0.316, 0, 0.45), (0, side, 0))
    model.trim("grey", (0.006, 0.56, 0.11), (0.281, 0, 0.77))
    model.show("steel", shapes.moved(shapes.cylinder(0.03, 0.02, 18), rpy=(0, side, 0)), (0.293, 0.02, 0.77))
    model.trim("white", (0.008, 0.16, 0.08), (0.282, 0.18, 0.77))
    model.trim("black", (0.006, 0.10, 0.04), (0.284, -0.16, 0.77))
    return model
