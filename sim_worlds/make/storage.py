"""Shelves, cupboards and drawers; their backs towards -x."""
import shapes
from model import Model
from pictures import BOOKS
from seating import legs


def books(model, y0, y1, z, depth, height, back):
    """A run of books from y0 to y1 with their backs at x = back and spines to the front."""
    y, top = y0, 0.0
    while True:
        width = model.random.uniform(0.018, 0.042)
        if y + width > y1:
            break
        tall, deep = height * model.random.uniform(0.86, 1.0), depth * model.random.uniform(0.9, 1.0)
        spine = model.random.randrange(BOOKS)
        u = spine / BOOKS
        middle = (back + deep / 2, y + width / 2, z + tall / 2)
        body = shapes.box((deep, width - 0.001, tall), skip=("+x",))
        body = [[(p, n, (u + 0.06 / BOOKS, 0.05 + 0.01 * t[0])) for p, n, t in tri] for tri in body]
        model.show("books", body, middle)
        model.show("books", shapes.image(width - 0.001, tall, (u, 0, u + 1 / BOOKS, 1)),
                   (back + deep, y + width / 2, z + tall / 2))
        y, top = y + width, max(top, tall)
    model.solid_box((depth * 0.95, y - y0, height * 0.93), (back + depth * 0.475, (y0 + y) / 2, z + height * 0.465))


def bookcase(name, about, width, height, shelves, wood, empty=()):
    """0.30 deep, open: sides, boards and a back of 2 cm; books, boxes and a vase on the boards that
    are not `empty`."""
    model, depth = Model(name, about), 0.30
    for side in (1, -1):
        model.box(wood, (depth, 0.022, height), (0, side * (width / 2 - 0.011), height / 2))
    model.box(wood, (0.008, width - 0.044, height - 0.06), (-depth / 2 + 0.006, 0, height / 2 + 0.03))
    model.box(wood, (depth - 0.02, width - 0.044, 0.06), (-0.01, 0, 0.03))
    step, inner = (height - 0.022 - 0.06) / shelves, width - 0.044
    for k in range(shelves + 1):
        z = 0.071 + k * step
        model.box(wood, (depth - 0.01, inner, 0.022), (0.0, 0, z))
        if k < shelves and k not in empty:
            _fill(model, k, inner, z + 0.011, step - 0.022, depth)
    return model


def _fill(model, k, inner, z, room, depth):
    back, left = -depth / 2 + 0.02, -inner / 2 + 0.005
    tall = min(0.27, room - 0.04)
    if k % 3 == 0:
        for j in (0, 1):
            y = (j - 0.5) * inner / 2
            model.box("wicker", (0.26, inner / 2 - 0.05, tall * 0.85), (0.0, y, z + tall * 0.425), bevel=0.012)
            model.trim("bark", (0.008, 0.09, 0.02), (0.132, y, z + tall * 0.6))
    elif k % 3 == 1:
        books(model, left, left + inner * 0.68, z, 0.22, tall, back)
        vase = [(0, 0), (0.05, 0), (0.075, 0.08), (0.04, 0.17), (0.05, 0.20), (0.04, 0.20), (0.03, 0.17)]
        model.show("sage", shapes.lathe(vase, 14, True), (0, inner * 0.34, z))
        model.solid_cylinder(0.058, 0.20, (0, inner * 0.34, z + 0.10))
    else:
        books(model, left, left + inner * 0.36, z, 0.20, tall, back)
        books(model, left + inner * 0.60, inner / 2 - 0.01, z, 0.21, tall * 0.9, back)
        for j, paint in enumerate(("cream", "navy", "red")):
            model.box(paint, (0.20, 0.15, 0.035), (0.0, 0, z + 0.0175 + 0.035 * j), (0, 0, 0.08 * j))


def cabinet(name, about, size, wood, front, columns, rows, doors=False, knob="brass", leg=0.12):
    """A closed body on legs with a front of drawers, or of doors; size = depth, width, height."""
    depth, width, height = size
    model, body = Model(name, about), height - leg - 0.02
    legs(model, wood, 0.014, leg + 0.01, depth / 2 - 0.06, width / 2 - 0.07, 0.022)
    model.box(wood, (depth, width, 0.022), (0, 0, height - 0.011), bevel=0.005)
    model.box(wood, (depth - 0.03, width - 0.006, body), (-0.012, 0, leg + body / 2))
    model.solid_box((0.02, width - 0.01, body - 0.01), (depth / 2 - 0.017, 0, leg + body / 2))
    cell, tall = (width - 0.01) / columns, body / rows
    for i in range(columns):
        for j in range(rows):
            y, z = (i - (columns - 1) / 2) * cell, leg + (j + 0.5) * tall
            model.trim(front, (0.018, cell - 0.008, tall - 0.008), (depth / 2 - 0.018, y, z), bevel=0.003)
            if doors:
                side = 1 if i % 2 == 0 else -1
                at = (depth / 2 + 0.001, y + side * (cell / 2 - 0.045), z)
                model.trim(knob, (0.02, 0.012, min(0.16, tall / 2)), at)
            else:
                model.trim(knob, (0.02, min(0.16, cell / 3), 0.012), (depth / 2 + 0.001, y, z + tall * 0.22))
    return model


def on_top(model, height, depth):
    """Books, a frame and a bowl on a cabinet."""
    z = height
    for j, paint in enumerate(("navy", "terracotta", "cream")):
        model.box(paint, (0.16, 0.23, 0.028), (0.0, -0.28, z + 0.014 + 0.028 * j), (0, 0, 0.1 * j))
    model.box("oak", (0.018, 0.16, 0.21), (-depth / 2 + 0.10, 0.05, z + 0.10), (0, -0.15, 0))
    photo = shapes.moved(shapes.image(0.12, 0.17), (0.0095, 0, 0))
    model.show("picture_sea", photo, (-depth / 2 + 0.10, 0.05, z + 0.10), (0, -0.15, 0))
    bowl = [(0, 0), (0.04, 0), (0.10, 0.035), (0.12, 0.07), (0.11, 0.07), (0.08, 0.03), (0, 0.012)]
    model.show("terracotta", shapes.lathe(bowl, 18, True), (0, 0.34, z))
    model.solid_cylinder(0.085, 0.065, (0, 0.34, z + 0.033))


def wardrobe(name, about, width, doors, front):
    """0.60 deep, 2.10 high: plinth, doors with long handles, cornice."""
    model = Model(name, about)
    model.box("oak", (0.56, width - 0.04, 0.08), (-0.01, 0, 0.04))
    model.box("oak", (0.57, width, 1.98), (-0.015, 0, 1.07))
    model.box("oak", (0.61, width + 0.02, 0.04), (0.0, 0, 2.08), bevel=0.008)
    leaf = width / doors
    for k in range(doors):
        y = (k - (doors - 1) / 2) * leaf
        model.trim(front, (0.02, leaf - 0.006, 1.95), (0.28, y, 1.07), bevel=0.004)
        for z, tall in ((1.56, 0.80), (0.60, 0.86)):
            model.trim(front, (0.008, leaf - 0.16, tall), (0.292, y, z), bevel=0.003)
        side = 1 if k % 2 == 0 else -1
        model.trim("brass", (0.022, 0.014, 0.30), (0.302, y + side * (leaf / 2 - 0.045), 1.08))
    model.solid_box((0.02, width, 1.96), (0.28, 0, 1.07))
    return model


def open_shelf(name, about, width, height, shelves, fill):
    """0.38 deep, without a back: steel posts and wooden boards; fill(model, board, width, z) puts things on a board."""
    model, depth = Model(name, about), 0.38
    for x in (0.175, -0.175):
        for side in (1, -1):
            model.box("graphite", (0.03, 0.03, height), (x, side * (width / 2 - 0.015), height / 2))
    for k in range(shelves):
        z = 0.13 + k * (height - 0.16) / (shelves - 1)
        model.box("birch", (depth - 0.02, width - 0.01, 0.024), (0, 0, z), bevel=0.004)
        if k < shelves - 1:
            fill(model, k, width, z + 0.012)
    return model


def jars_and_boxes(model, k, width, z):
    for j in range(3):
        y, kind = (j - 1) * width / 3.2, (k + j) % 3
        if kind == 0:
            model.box(("cream", "sage", "navy")[j], (0.28, width / 3.8, 0.20), (0, y, z + 0.10), bevel=0.008)
            model.trim("white", (0.003, 0.08, 0.05), (0.141, y, z + 0.12))
        elif kind == 1:
            for i in range(2):
                at = (0.05 - 0.10 * i, y + 0.07 * (i - 0.5), z + 0.075)
                model.cylinder(("glass", "terracotta")[i], 0.045, 0.15, at, segments=12)
                model.show("oak", shapes.cylinder(0.047, 0.018, 12), (at[0], at[1], z + 0.159))
        else:
            model.box("graphite", (0.22, 0.17, 0.13), (0, y, z + 0.065), bevel=0.01)
            model.trim("red", (0.004, 0.03, 0.03), (0.111, y + 0.04, z + 0.09))


def boxes_below(model, k, width, z):
    """Only the lowest board is full."""
    if k == 0:
        jars_and_boxes(model, 0, width, z)


def towels(model, k, width, z):
    if k == 0:
        model.box("wicker", (0.30, width - 0.12, 0.22), (0, 0, z + 0.11), bevel=0.015)
        return
    for j in range(2):
        for i in range(4 - j - k % 2):
            paint = ("linen", "teal", "cream", "sage")[(i + j + k) % 4]
            model.cushion(paint, (0.29, 0.22, 0.058), (0, (j - 0.5) * 0.27, z + 0.028 + 0.054 * i), roundness=0.35,
                          segments=12, rings=6)
