"""Sofas, chairs and the bed. x to the front, y to the left."""
import math

import shapes
from model import Model


def legs(model, material, radius, height, x, y, top_radius=None, centre=(0.0, 0.0)):
    """Four round legs at +-x, +-y of the centre; top_radius makes them taper downwards."""
    for sx in (1, -1):
        for sy in (1, -1):
            model.cylinder(material, radius, height, (centre[0] + sx * x, centre[1] + sy * y, height / 2),
                           segments=10, top_radius=top_radius)


def sofa(name, about, fabric, pillows, seats, width):
    """Depth 0.92, height 0.84; legs 0.11 high, arms with rounded tops, loose seat and back cushions."""
    model, arm = Model(name, about), 0.18
    legs(model, "walnut", 0.016, 0.12, 0.36, width / 2 - 0.12, 0.024)
    model.box(fabric, (0.84, width - 2 * arm + 0.02, 0.17), (0.0, 0, 0.195), bevel=0.015)
    model.box(fabric, (0.14, width - 2 * arm + 0.02, 0.48), (-0.37, 0, 0.50), (0, -0.10, 0), bevel=0.04)
    for side in (1, -1):
        y = side * (width / 2 - arm / 2)
        model.box(fabric, (0.88, arm, 0.40), (0.0, y, 0.31), bevel=0.03)
        model.show(fabric, shapes.moved(shapes.cylinder(0.095, 0.88, 20), rpy=(0, math.pi / 2, 0)), (0.0, y, 0.515))
        model.solid_cylinder(0.095, 0.88, (0.0, y, 0.515), (0, math.pi / 2, 0))
    seat = (width - 2 * arm) / seats
    for k in range(seats):
        y = (k - (seats - 1) / 2) * seat
        model.cushion(fabric, (0.68, seat - 0.008, 0.17), (0.10, y, 0.355), roundness=0.22)
        model.cushion(fabric, (0.17, seat - 0.012, 0.44), (-0.235, y, 0.62), (0, -0.20, 0), roundness=0.32)
    for k, pillow in enumerate(pillows):
        side = 1 if k % 2 == 0 else -1
        model.cushion(pillow, (0.13, 0.42, 0.42), (-0.06 + 0.03 * k, side * (width / 2 - arm - 0.23), 0.62),
                      (0.12 * side, -0.36, -0.25 * side), roundness=0.5)
    return model


def dining_chair(name, about, wood, fabric):
    """0.47 x 0.44, seat 0.46, back 0.86 high: tapered legs, apron, padded seat, two curved back rails."""
    model = Model(name, about)
    for side in (1, -1):
        y = side * 0.185
        model.cylinder(wood, 0.013, 0.43, (0.19, y, 0.215), top_radius=0.019, segments=10)
        post = [(-0.225, y, 0), (-0.20, y, 0.44), (-0.215, y, 0.66), (-0.25, y, 0.86)]
        model.show(wood, shapes.tube(post, [0.014, 0.019, 0.018, 0.014], 10))
        model.solid_cylinder(0.016, 0.44, (-0.2125, y, 0.22), (0, 0.057, 0))
        model.solid_cylinder(0.016, 0.43, (-0.225, y, 0.65), (0, -0.118, 0))
        model.box(wood, (0.38, 0.018, 0.05), (-0.005, y, 0.405))
    for x in (0.19, -0.20):
        model.box(wood, (0.018, 0.36, 0.05), (x, 0, 0.405))
    model.cushion(fabric, (0.45, 0.44, 0.055), (0.0, 0, 0.452), roundness=0.18, segments=20, rings=6)
    for z, height, lean in ((0.78, 0.11, -0.235), (0.61, 0.05, -0.212)):
        _curved_rail(model, wood, lean, z, height)
    return model


def _curved_rail(model, wood, x, z, height):
    """A back rail bent round the sitter."""
    def point(u, v, inset):
        y = (u - 0.5) * 0.37
        return (x + inset - 0.035 * (1 - (y / 0.185) ** 2) - 0.10 * (v - 0.5) * height, y, z + (v - 0.5) * height)

    model.show(wood, shapes.sheet(lambda u, v: point(u, v, 0.010), 8, 1))
    model.show(wood, shapes.flipped(shapes.sheet(lambda u, v: point(u, v, -0.010), 8, 1)))
    for v, turn in ((1, 1), (0, -1)):
        rim = shapes.sheet(lambda a, b: point(a, v, 0.010 - 0.020 * b), 8, 1)
        model.show(wood, rim if turn == 1 else shapes.flipped(rim))
        end = shapes.sheet(lambda a, b: point(v, a, 0.010 - 0.020 * b), 1, 1)
        model.show(wood, shapes.flipped(end) if turn == 1 else end)
    for side in (1, -1):
        model.solid_box((0.024, 0.125, height), (x - 0.012, side * 0.123, z), (0, 0, side * 0.19))
    model.solid_box((0.024, 0.125, height), (x - 0.033, 0, z))


def office_chair(name, about, fabric):
    """0.64 round, seat 0.47, back 0.98 high: five spokes on castors, gas spring, arm rests, bent back."""
    model = Model(name, about)
    for k in range(5):
        a = 2 * math.pi * k / 5 + math.pi / 5
        end = (0.29 * math.cos(a), 0.29 * math.sin(a))
        model.show("graphite", shapes.tube([(0.03 * math.cos(a), 0.03 * math.sin(a), 0.115), (end[0], end[1], 0.072)],
                                           [0.026, 0.015], 8))
        model.solid_box((0.27, 0.036, 0.036), (0.16 * math.cos(a), 0.16 * math.sin(a), 0.093), (0, 0.16, a))
        wheel = shapes.moved(shapes.cylinder(0.028, 0.044, 12), rpy=(math.pi / 2, 0, a))
        model.show("black", wheel, (end[0], end[1], 0.028))
        model.solid_box((0.05, 0.044, 0.056), (end[0], end[1], 0.028), (0, 0, a))
    model.cylinder("graphite", 0.034, 0.20, (0, 0, 0.18), segments=14)
    model.cylinder("steel", 0.020, 0.14, (0, 0, 0.34))
    model.box("graphite", (0.24, 0.20, 0.035), (0, 0, 0.412), bevel=0.008)
    model.cushion(fabric, (0.48, 0.50, 0.085), (0.02, 0, 0.462), roundness=0.28, segments=20)
    model.cushion(fabric, (0.075, 0.45, 0.46), (-0.235, 0, 0.755), (0, -0.14, 0), roundness=0.30, segments=20)
    model.show("graphite", shapes.tube([(-0.05, 0, 0.40), (-0.20, 0, 0.405), (-0.265, 0, 0.46), (-0.285, 0, 0.72)],
                                       0.018, 8))
    model.solid_box((0.036, 0.036, 0.30), (-0.272, 0, 0.57), (0, -0.06, 0))
    for side in (1, -1):
        y = side * 0.275
        model.show("graphite", shapes.tube([(-0.02, side * 0.16, 0.41), (-0.02, y, 0.43), (-0.03, y, 0.645)], 0.014, 8))
        model.solid_box((0.028, 0.028, 0.22), (-0.025, y, 0.535))
        model.box("black", (0.26, 0.065, 0.03), (0.01, y, 0.66), bevel=0.012)
    return model


def stool(name, about, wood):
    """0.36 round, 0.46 high: three splayed legs and a turned seat."""
    model = Model(name, about)
    for k in range(3):
        a = 2 * math.pi * k / 3
        foot, top = (0.16 * math.cos(a), 0.16 * math.sin(a), 0), (0.11 * math.cos(a), 0.11 * math.sin(a), 0.44)
        model.show(wood, shapes.tube([foot, top], [0.013, 0.018], 10))
        model.solid_cylinder(0.016, 0.43, (0.135 * math.cos(a), 0.135 * math.sin(a), 0.22), (0, -0.113, a))
    profile = [(0, 0.425), (0.15, 0.425), (0.18, 0.435), (0.18, 0.452), (0.165, 0.46), (0.09, 0.452), (0, 0.45)]
    model.show(wood, shapes.lathe(profile, 24, True))
    model.solid_cylinder(0.178, 0.03, (0, 0, 0.442))
    return model


def bed_double(name, about):
    """1.70 x 2.12, mattress 1.60 x 2.00 with its top at 0.50, head board 1.05 high; head towards -x."""
    model = Model(name, about)
    legs(model, "oak", 0.028, 0.13, 0.98, 0.78)
    for side in (1, -1):
        model.box("oak", (2.04, 0.035, 0.20), (0.02, side * 0.832, 0.22), bevel=0.005)
    model.box("oak", (0.035, 1.70, 0.20), (1.042, 0, 0.22), bevel=0.005)
    model.box("oak", (2.0, 1.62, 0.04), (0.02, 0, 0.20))
    model.box("fabric_grey", (0.08, 1.70, 0.80), (-1.02, 0, 0.65), bevel=0.03)
    for k in range(4):
        model.show("fabric_grey", shapes.cushion((0.06, 0.415, 0.50), 12, 6, 0.3), (-0.975, (k - 1.5) * 0.42, 0.76))
    model.box("linen", (1.99, 1.60, 0.22), (0.015, 0, 0.34), bevel=0.035)
    model.show("duvet", _duvet())
    model.solid_box((1.42, 1.66, 0.10), (0.31, 0, 0.475))
    for side in (1, -1):
        model.solid_box((1.40, 0.03, 0.24), (0.31, side * 0.845, 0.37))
        model.cushion("linen", (0.44, 0.68, 0.15), (-0.72, side * 0.39, 0.515), (0, -0.14, 0), roundness=0.42)
    return model


def _duvet():
    """A thick cover with soft folds that hangs over the sides of the mattress."""
    def point(u, v):
        x, s = -0.40 + 1.42 * u, (v - 0.5) * 2.32
        fold = 0.010 * math.sin(9 * x + 2.5 * s) + 0.008 * math.sin(5 * s - 4 * x)
        over = abs(s) - 0.80
        if over <= 0:
            return (x, s, 0.512 + fold)
        bend = min(over / 0.06, 1.0)
        drop = max(0.0, over - 0.04)
        return (x, math.copysign(0.80 + 0.055 * math.sin(bend * math.pi / 2), s),
                0.512 - 0.055 * (1 - math.cos(bend * math.pi / 2)) - drop * 0.95 + 0.006 * math.sin(14 * x))

    top = shapes.sheet(point, 16, 24)

    def hanging(x, swell, low):
        """From the end of the cover at that x straight down to the height `low`."""
        def side(u, v):
            _, y, z = point((x + 0.40) / 1.42, v)
            return (x + swell * math.sin(u * math.pi), y, z + min(0.0, low - z) * u)
        return side

    end = shapes.sheet(hanging(1.02, 0.03, 0.31), 4, 24)
    head = shapes.flipped(shapes.sheet(hanging(-0.40, 0.0, 0.44), 1, 24))
    return top + end + head
