"""Small things that always stand about: on desks, counters, boards and sofas. Origin in the middle of the bottom."""
import math

import shapes
from model import Model


def _turned(shape, scale_y):
    """A lathe shape made oval: y times scale_y."""
    return [[((p[0], p[1] * scale_y, p[2]), n, t) for p, n, t in triangle] for triangle in shape]


def monitor(name, about, width):
    """A screen on a foot, 0.50 high; looks to +x."""
    model = Model(name, about)
    model.box("graphite", (0.20, 0.24, 0.012), (0, 0, 0.006), bevel=0.004)
    model.box("graphite", (0.022, 0.055, 0.22), (-0.035, 0, 0.12))
    tall = width * 0.60
    model.box("black", (0.028, width, tall), (0, 0, 0.13 + tall / 2), bevel=0.006)
    model.show("desktop", shapes.image(width - 0.02, tall - 0.02), (0.0145, 0, 0.13 + tall / 2))
    return model


def keyboard(name, about):
    """0.13 x 0.43, its keys one by one; the user sits at +x."""
    model = Model(name, about)
    model.box("graphite", (0.135, 0.43, 0.014), (0, 0, 0.007), bevel=0.004)
    for row in range(5):
        x = -0.05 + 0.025 * row
        if row == 4:
            widths = (0.03, 0.03, 0.19, 0.03, 0.03, 0.03)
        else:
            widths = (0.024,) * 15
        y = -sum(widths) / 2 - 0.0015 * (len(widths) - 1)
        for wide in widths:
            model.trim("grey", (0.021, wide - 0.003, 0.006), (x, y + wide / 2, 0.0165), skip=("-z",))
            y += wide + 0.003
    return model


def mouse(name, about):
    """0.11 x 0.06."""
    model = Model(name, about)
    model.cushion("graphite", (0.108, 0.062, 0.036), (0, 0, 0.018), roundness=0.65, segments=14, rings=7)
    return model


def laptop(name, about):
    """Open, 0.24 x 0.34, its lid leaning back; the user sits at +x."""
    model = Model(name, about)
    model.box("steel", (0.235, 0.335, 0.016), (0, 0, 0.008), bevel=0.004)
    for row in range(5):
        model.trim("black", (0.019, 0.28, 0.002), (-0.075 + 0.024 * row, 0, 0.0165), skip=("-z",))
    lean = -0.30
    model.box("steel", (0.008, 0.335, 0.225), (-0.150, 0, 0.118), (0, lean, 0), bevel=0.002)
    screen = shapes.moved(shapes.image(0.31, 0.195), (0.0045, 0, 0.004))
    model.show("desktop", screen, (-0.150, 0, 0.118), (0, lean, 0))
    return model


def desk_lamp(name, about):
    """0.45 high: foot, two arms, a bell over the desk towards +x."""
    model = Model(name, about)
    model.show("red", shapes.lathe([(0.085, 0), (0.085, 0.012), (0.03, 0.024), (0.012, 0.03)], 20))
    model.solid_cylinder(0.085, 0.02, (0, 0, 0.01))
    model.show("steel", shapes.tube([(0, 0, 0.02), (-0.10, 0, 0.26), (0.09, 0, 0.43)], 0.008, 8))
    bell = [(0.07, 0), (0.06, 0.05), (0.025, 0.095), (0.02, 0.11), (0, 0.11)]
    inside = [(r * 0.95, z - 0.003) for r, z in bell[:-1]]
    model.show("red", shapes.lathe(bell + [(0, 0.106)] + inside[::-1] + bell[:1], 20), (0.115, 0, 0.355), (0, 0.35, 0))
    model.show("shade", shapes.cushion((0.05, 0.05, 0.06), 10, 6, 1.0), (0.115, 0, 0.39))
    model.solid_box((0.26, 0.03, 0.03), (-0.05, 0, 0.14), (0, -1.18, 0))
    model.solid_box((0.26, 0.03, 0.03), (-0.005, 0, 0.345), (0, -0.73, 0))
    model.solid_cylinder(0.06, 0.10, (0.125, 0, 0.40))
    return model


def printer(name, about):
    """0.40 x 0.44, 0.24 high, paper at the back and in the tray."""
    model = Model(name, about)
    model.box("grey", (0.38, 0.44, 0.09), (0, 0, 0.045), bevel=0.01)
    model.box("graphite", (0.34, 0.43, 0.10), (-0.02, 0, 0.14), bevel=0.015)
    model.box("white", (0.12, 0.22, 0.004), (0.22, 0, 0.065), (0, 0.1, 0))
    model.box("white", (0.006, 0.21, 0.20), (-0.19, 0, 0.26), (0, -0.35, 0))
    model.trim("steel", (0.09, 0.12, 0.006), (0.08, 0.12, 0.192), bevel=0.002)
    for k in range(3):
        model.trim("sage", (0.02, 0.02, 0.008), (0.10, -0.10 + 0.04 * k, 0.192))
    return model


def telephone(name, about):
    """0.20 x 0.18 with a handset across its back."""
    model = Model(name, about)
    model.box("black", (0.20, 0.18, 0.045), (0, 0, 0.0225), bevel=0.008)
    for i in range(4):
        for j in range(3):
            model.trim("grey", (0.016, 0.018, 0.006), (0.075 - 0.024 * i, 0.025 - 0.026 * j, 0.047), skip=("-z",))
    model.show("black", shapes.tube([(-0.06, 0.10, 0.052), (-0.06, 0.06, 0.078), (-0.06, -0.06, 0.078),
                                     (-0.06, -0.10, 0.052)], 0.018, 10))
    model.solid_box((0.036, 0.20, 0.045), (-0.06, 0, 0.068))
    return model


def paper_tray(name, about):
    """Three trays on posts, 0.25 x 0.34 x 0.21, papers in them."""
    model = Model(name, about)
    for k in range(3):
        z = 0.01 + 0.075 * k
        model.box("graphite", (0.25, 0.33, 0.006), (0, 0, z))
        for x in (0.122, -0.122):
            model.box("graphite", (0.006, 0.33, 0.035), (x, 0, z + 0.0175))
        model.box("white", (0.22, 0.30, 0.006 + 0.008 * (2 - k)), (0.0, 0.005, z + 0.006 + 0.004 * (2 - k)))
        if k < 2:
            for x in (0.12, -0.12):
                for y in (0.155, -0.155):
                    model.box("steel", (0.01, 0.01, 0.045), (x, y, z + 0.05))
    return model


def pen_cup(name, about):
    """0.10 high, pens standing out of it."""
    model = Model(name, about)
    cup = [(0, 0), (0.038, 0), (0.042, 0.10), (0.036, 0.10), (0.033, 0.01), (0, 0.01)]
    model.show("navy", shapes.lathe(cup, 16))
    for k, paint in enumerate(("yellow", "red", "black", "sage")):
        a = 1.7 * k
        tip = (0.034 * math.cos(a), 0.034 * math.sin(a), 0.165 + 0.008 * (k % 3))
        model.show(paint, shapes.tube([(-0.2 * tip[0], -0.2 * tip[1], 0.012), tip], 0.0045, 6))
    model.solid_cylinder(0.041, 0.10, (0, 0, 0.05))
    model.solid_cylinder(0.030, 0.06, (0, 0, 0.13))
    return model


def coffee_machine(name, about):
    """For espresso, 0.34 x 0.27, 0.36 high: tank, head with a spout over the drip tray, cup warmer; front +x."""
    model = Model(name, about)
    model.box("black", (0.33, 0.26, 0.045), (0, 0, 0.0225), bevel=0.008)
    model.trim("steel", (0.15, 0.22, 0.006), (0.08, 0, 0.047), bevel=0.002)
    for k in range(6):
        model.trim("graphite", (0.13, 0.012, 0.004), (0.08, 0.09 - 0.036 * k, 0.051), skip=("-z",))
    model.box("red", (0.16, 0.26, 0.29), (-0.085, 0, 0.19), bevel=0.015)
    model.box("red", (0.17, 0.26, 0.11), (0.075, 0, 0.285), bevel=0.015)
    model.trim("steel", (0.006, 0.22, 0.07), (0.161, 0, 0.285), bevel=0.002)
    for y in (0.06, -0.06):
        model.show("black", shapes.moved(shapes.cylinder(0.018, 0.02, 14), rpy=(0, math.pi / 2, 0)), (0.172, y, 0.285))
    model.cylinder("steel", 0.034, 0.035, (0.085, 0, 0.215), segments=18)
    model.show("black", shapes.tube([(0.10, 0, 0.21), (0.215, 0, 0.20)], [0.011, 0.016], 10))
    model.solid_box((0.12, 0.03, 0.03), (0.155, 0, 0.205))
    model.show("steel", shapes.tube([(0.04, -0.115, 0.24), (0.07, -0.125, 0.16), (0.075, -0.125, 0.09)], 0.006, 8))
    model.trim("steel", (0.27, 0.24, 0.008), (-0.01, 0, 0.343), bevel=0.003)
    return model


def kettle(name, about):
    """0.24 high; its spout to +x, its handle to -x."""
    model = Model(name, about)
    model.cylinder("black", 0.085, 0.02, (0, 0, 0.01), segments=22)
    body = [(0.082, 0.02), (0.080, 0.06), (0.062, 0.18), (0.055, 0.20), (0.03, 0.212), (0, 0.215)]
    model.show("steel", shapes.lathe(body, 22, True))
    model.solid_cylinder(0.072, 0.19, (0, 0, 0.115))
    model.show("black", shapes.cushion((0.03, 0.03, 0.025), 10, 6, 0.9), (0, 0, 0.225))
    model.show("steel", shapes.tube([(0.055, 0, 0.145), (0.10, 0, 0.19)], [0.022, 0.012], 10))
    model.show("black", shapes.tube([(-0.05, 0, 0.20), (-0.115, 0, 0.205), (-0.125, 0, 0.12), (-0.075, 0, 0.06)],
                                    0.012, 8))
    model.solid_box((0.05, 0.026, 0.16), (-0.10, 0, 0.13))
    return model


def toaster(name, about):
    """0.18 x 0.30, 0.20 high, two slots."""
    model = Model(name, about)
    model.box("cream", (0.165, 0.28, 0.17), (0, 0, 0.10), bevel=0.03)
    model.box("graphite", (0.15, 0.26, 0.02), (0, 0, 0.01))
    for x in (0.032, -0.032):
        model.trim("black", (0.022, 0.21, 0.004), (x, 0, 0.185))
    model.box("steel", (0.03, 0.02, 0.014), (0, 0.148, 0.13), bevel=0.004)
    return model


def knife_block(name, about):
    """A leaning block with five handles."""
    model = Model(name, about)
    model.box("walnut", (0.10, 0.10, 0.19), (0, 0, 0.115), (0, -0.35, 0), bevel=0.006)
    model.box("walnut", (0.11, 0.10, 0.03), (0.01, 0, 0.015))
    for k in range(5):
        y, x = 0.035 - 0.035 * (k % 3), -0.02 + 0.035 * (k // 3)
        handle = shapes.moved(shapes.box((0.016, 0.022, 0.09), 0.004), (x, y, 0.135))
        model.show("black", handle, (0, 0, 0.115), (0, -0.35, 0))
    model.solid_box((0.07, 0.10, 0.09), (-0.045, 0, 0.242), (0, -0.35, 0))
    return model


def utensils(name, about):
    """A stoneware jar of cooking spoons."""
    model = Model(name, about)
    jar = [(0, 0), (0.05, 0), (0.062, 0.05), (0.058, 0.15), (0.052, 0.15), (0.05, 0.02), (0, 0.02)]
    model.show("ceramic", shapes.lathe(jar, 18, True))
    for k in range(5):
        a, paint = 1.26 * k, ("oak", "birch", "black", "steel", "oak")[k]
        tip = (0.055 * math.cos(a), 0.055 * math.sin(a), 0.26 + 0.015 * (k % 3))
        model.show(paint, shapes.tube([(-0.3 * tip[0], -0.3 * tip[1], 0.03), tip], 0.006, 6))
        model.show(paint, shapes.cushion((0.045, 0.03, 0.06), 10, 6, 0.9), (tip[0], tip[1], tip[2] + 0.02), (0, 0, a))
    model.solid_cylinder(0.056, 0.15, (0, 0, 0.075))
    model.solid_cylinder(0.065, 0.15, (0, 0, 0.225))
    return model


def dish_rack(name, about):
    """Wires, 0.32 x 0.42, with plates of the house in it."""
    model = Model(name, about)
    for x in (0.15, -0.15):
        for z in (0.02, 0.10):
            model.show("steel", shapes.tube([(x, -0.20, z), (x, 0.20, z)], 0.005, 6))
    for y in (0.20, -0.20):
        for z in (0.02, 0.10):
            model.show("steel", shapes.tube([(-0.15, y, z), (0.15, y, z)], 0.005, 6))
        for x in (0.15, -0.15):
            model.show("steel", shapes.tube([(x, y, 0), (x, y, 0.10)], 0.005, 6))
    for k in range(8):
        y = -0.16 + 0.045 * k
        model.show("steel", shapes.tube([(-0.15, y, 0.02), (0.15, y, 0.02)], 0.003, 5))
        if k < 5:
            plate = shapes.lathe([(0, 0), (0.06, 0), (0.115, 0.012), (0.115, 0.016), (0.06, 0.006), (0, 0.006)], 22)
            model.show("sage" if k % 2 else "ceramic", shapes.moved(plate, rpy=(math.pi / 2, 0, 0)), (0, y, 0.14),
                       (-0.12, 0, 0))
    model.solid_box((0.31, 0.41, 0.10), (0, 0, 0.05))
    model.solid_box((0.23, 0.21, 0.14), (0, -0.07, 0.16))
    return model


def pot(name, about):
    """A cooking pot with a lid and two handles."""
    model = Model(name, about)
    body = [(0, 0), (0.10, 0), (0.105, 0.13), (0.108, 0.13), (0.098, 0.135), (0.05, 0.15), (0, 0.152)]
    model.show("navy", shapes.lathe(body, 24))
    model.show("black", shapes.cushion((0.04, 0.04, 0.03), 10, 5, 0.8), (0, 0, 0.162))
    for side in (1, -1):
        model.show("black", shapes.tube([(-0.03, side * 0.10, 0.105), (0, side * 0.135, 0.108),
                                         (0.03, side * 0.10, 0.105)], 0.008, 6))
    model.solid_cylinder(0.104, 0.15, (0, 0, 0.075))
    return model


def vase(name, about):
    """Slender, 0.30 high."""
    model = Model(name, about)
    shape = [(0, 0), (0.05, 0), (0.08, 0.09), (0.065, 0.17), (0.028, 0.25), (0.038, 0.30), (0.030, 0.30),
             (0.020, 0.25)]
    model.show("teal", shapes.lathe(shape, 20, True))
    model.solid_cylinder(0.072, 0.18, (0, 0, 0.09))
    model.solid_cylinder(0.035, 0.12, (0, 0, 0.24))
    return model


def book_pile(name, about):
    """Four books, one on the other, a little askew."""
    model = Model(name, about)
    z = 0.0
    for k, (paint, thick) in enumerate((("navy", 0.035), ("cream", 0.022), ("terracotta", 0.030), ("sage", 0.018))):
        size = (0.17 - 0.008 * k, 0.24 - 0.012 * k, thick)
        model.box(paint, size, (0, 0, z + thick / 2), (0, 0, 0.22 * k - 0.3), bevel=0.002)
        model.trim("white", (size[0] - 0.012, size[1] + 0.001, thick - 0.008), (0.004, 0, z + thick / 2),
                   (0, 0, 0.22 * k - 0.3))
        z += thick
    return model


def cushion(name, about, fabric):
    """A sofa cushion, 0.42 x 0.42, that leans back: the sofa's back is towards -x."""
    model = Model(name, about)
    model.cushion(fabric, (0.13, 0.42, 0.42), (0, 0, 0.205), (0, -0.30, 0), roundness=0.5)
    return model


def storage_box(name, about, paint):
    """A lidded box, 0.28 x 0.36, 0.18 high, with a label."""
    model = Model(name, about)
    model.box(paint, (0.27, 0.35, 0.15), (0, 0, 0.075), bevel=0.006)
    model.box(paint, (0.285, 0.365, 0.035), (0, 0, 0.165), bevel=0.006)
    model.trim("white", (0.003, 0.10, 0.05), (0.136, 0, 0.08))
    return model
