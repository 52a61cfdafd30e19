"""Tables and desks, and what stands on them."""
import math

import shapes
from model import Model
from seating import legs


def coffee_table(name, about, things=True):
    """0.60 x 1.10, 0.42 high: splayed legs, a shelf underneath; magazines and a bowl where there are `things`."""
    model = Model(name, about)
    model.box("oak", (0.60, 1.10, 0.03), (0, 0, 0.405), bevel=0.008)
    legs(model, "oak", 0.016, 0.39, 0.25, 0.49, 0.024)
    model.box("oak", (0.46, 0.94, 0.018), (0, 0, 0.175))
    if things:
        _on_coffee_table(model)
    return model


def _on_coffee_table(model):
    for k, (x, y, turn, paint) in enumerate(((0.06, -0.26, 0.2, "teal"), (0.055, -0.255, -0.1, "cream"))):
        model.box(paint, (0.21, 0.28, 0.012), (x, y, 0.426 + 0.012 * k), (0, 0, turn))
    bowl = [(0, 0.422), (0.05, 0.422), (0.11, 0.455), (0.135, 0.49), (0.125, 0.49), (0.09, 0.45), (0, 0.435)]
    model.show("ceramic", shapes.lathe(bowl, 20, True), (-0.04, 0.22, 0))
    model.solid_cylinder(0.10, 0.065, (-0.04, 0.22, 0.453))


def dining_table(name, about, things=True):
    """0.90 x 1.70, 0.75 high: slab ends and a stretcher, as of a farmhouse; a runner and flowers where there are
    `things`."""
    model = Model(name, about)
    model.box("oak", (0.90, 1.70, 0.04), (0, 0, 0.73), bevel=0.01)
    for side in (1, -1):
        y = side * 0.62
        model.box("oak", (0.66, 0.07, 0.07), (0, y, 0.035), bevel=0.01)
        model.box("oak", (0.60, 0.06, 0.06), (0, y, 0.68), bevel=0.006)
        for x in (0.20, -0.20):
            model.box("oak", (0.07, 0.06, 0.60), (x, y, 0.36), bevel=0.006)
        model.box("oak", (0.40, 0.035, 0.06), (0, y, 0.19), bevel=0.004)
    model.box("oak", (0.06, 1.26, 0.09), (0, 0, 0.19), bevel=0.006)
    if things:
        _flowers(model)
    return model


def _flowers(model):
    model.show("terracotta", shapes.box((0.42, 1.1, 0.003), skip=("-z",)), (0, 0, 0.752))
    vase = [(0, 0.753), (0.045, 0.753), (0.07, 0.81), (0.05, 0.88), (0.03, 0.93), (0.036, 0.95), (0.026, 0.95),
            (0.02, 0.92)]
    model.show("ceramic", shapes.lathe(vase, 18, True))
    model.solid_cylinder(0.055, 0.19, (0, 0, 0.85))
    for k in range(7):
        a, spread = 2.4 * k, 0.05 + 0.015 * k
        tip = (spread * math.cos(a), spread * math.sin(a), 1.10 + 0.02 * (k % 3))
        model.show("leaf", shapes.tube([(0, 0, 0.93), (tip[0] * 0.4, tip[1] * 0.4, 1.02), tip], 0.003, 4))
        model.show(("yellow", "red", "cream")[k % 3], shapes.cushion((0.05, 0.05, 0.04), 8, 4, 0.9), tip)
    model.solid_cylinder(0.10, 0.20, (0, 0, 1.05))


def round_table(name, about):
    """0.80 across, 0.74 high, on a trumpet foot."""
    model = Model(name, about)
    top = [(0, 0.71), (0.36, 0.71), (0.40, 0.725), (0.40, 0.735), (0.395, 0.74), (0, 0.74)]
    model.show("white", shapes.lathe(top, 32))
    model.solid_cylinder(0.40, 0.028, (0, 0, 0.725))
    foot = [(0.25, 0), (0.25, 0.012), (0.16, 0.035), (0.08, 0.08), (0.045, 0.18), (0.038, 0.40), (0.05, 0.62),
            (0.11, 0.71)]
    model.show("white", shapes.lathe(foot, 24, True))
    solids = ((0.25, 0.012, 0.006), (0.15, 0.04, 0.03), (0.07, 0.09, 0.09), (0.046, 0.50, 0.38), (0.07, 0.09, 0.665))
    for radius, length, z in solids:
        model.solid_cylinder(radius, length, (0, 0, z))
    return model


def desk(name, about, width, wood):
    """0.75 deep, 0.74 high: steel legs, modesty panel, drawers under one end; the user sits at +x."""
    model = Model(name, about)
    model.box(wood, (0.75, width, 0.028), (0, 0, 0.726), bevel=0.006)
    for sy in (1, -1):
        y = sy * (width / 2 - 0.06)
        for x in (0.32, -0.32):
            model.box("graphite", (0.045, 0.045, 0.712), (x, y, 0.356))
        model.box("graphite", (0.60, 0.045, 0.03), (0, y, 0.697))
    model.box("graphite", (0.02, width - 0.20, 0.34), (-0.31, 0, 0.54))
    y = -(width / 2 - 0.34)
    model.box(wood, (0.55, 0.42, 0.56), (-0.02, y, 0.36), bevel=0.004)
    for k, (z, height) in enumerate(((0.555, 0.13), (0.415, 0.13), (0.215, 0.25))):
        model.trim("white", (0.016, 0.40, height), (0.262, y, z), bevel=0.003)
        model.trim("graphite", (0.022, 0.13, 0.012), (0.278, y, z + height / 2 - 0.03))
    legs(model, "black", 0.02, 0.08, 0.20, 0.15, centre=(-0.02, y))
    return model


def on_desk(model, y, laptop=False):
    """A screen, a keyboard, a mouse and papers on the desk at that y."""
    z = 0.74
    model.cylinder("graphite", 0.11, 0.012, (-0.20, y, z + 0.006), segments=20)
    model.box("graphite", (0.02, 0.05, 0.20), (-0.215, y, z + 0.11))
    model.box("black", (0.025, 0.60, 0.36), (-0.19, y, z + 0.31), bevel=0.005)
    model.show("desktop", shapes.image(0.58, 0.335), (-0.1765, y, z + 0.312))
    model.box("graphite", (0.13, 0.42, 0.018), (0.10, y, z + 0.009), bevel=0.004)
    for row in range(4):
        model.trim("grey", (0.022, 0.39, 0.004), (0.055 + 0.029 * row, y, z + 0.019))
    model.cushion("graphite", (0.10, 0.06, 0.034), (0.11, y - 0.30, z + 0.014), roundness=0.6, segments=12, rings=6)
    model.box("white", (0.297, 0.21, 0.008), (0.08, y + 0.38, z + 0.004), (0, 0, 0.15))
    mug = [(0, 0), (0.038, 0), (0.041, 0.09), (0.036, 0.09), (0.034, 0.01), (0, 0.01)]
    model.show("teal", shapes.lathe(mug, 16), (-0.10, y + 0.42, z))
    model.solid_cylinder(0.039, 0.09, (-0.10, y + 0.42, z + 0.045))
    if laptop:
        model.box("steel", (0.23, 0.33, 0.016), (0.02, y - 0.55, z + 0.008), (0, 0, 0.3), bevel=0.004)


def tv_board(name, about):
    """0.42 x 1.80, 0.50 high: on legs, two drawers, an open bay with boxes; a 1.22 m television on top."""
    model = Model(name, about)
    legs(model, "walnut", 0.014, 0.14, 0.15, 0.78, 0.022)
    for z in (0.15, 0.485):
        model.box("walnut", (0.42, 1.80, 0.022), (0, 0, z), bevel=0.004)
    for y in (-0.889, -0.30, 0.30, 0.889):
        model.box("walnut", (0.40, 0.022, 0.313), (0, y, 0.3175))
    model.box("walnut", (0.012, 1.76, 0.313), (-0.20, 0, 0.3175))
    for side in (1, -1):
        model.box("walnut", (0.02, 0.56, 0.30), (0.19, side * 0.595, 0.3175), bevel=0.003)
        model.trim("brass", (0.02, 0.16, 0.014), (0.208, side * 0.595, 0.40))
    model.box("walnut", (0.36, 0.58, 0.015), (0, 0, 0.32))
    model.box("black", (0.24, 0.40, 0.055), (0.04, 0, 0.356), bevel=0.006)
    model.box("graphite", (0.22, 0.30, 0.045), (0.04, 0, 0.184), bevel=0.006)
    model.box("graphite", (0.20, 0.60, 0.014), (0, 0, 0.503), bevel=0.004)
    model.box("graphite", (0.03, 0.12, 0.10), (-0.02, 0, 0.55))
    model.box("black", (0.045, 1.22, 0.70), (0, 0, 0.93), bevel=0.008)
    model.show("tv_picture", shapes.image(1.18, 0.66), (0.0232, 0, 0.935))
    return model
