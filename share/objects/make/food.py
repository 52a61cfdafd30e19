"""Fruit and balls."""
import math

from make.mesh import Mesh, ellipsoid, lathe, tube
from make.model import Paint, Thing
from make.picture import Picture


def speckled(colour, spots, amount, seed=3):
    p = Picture(64, 32, colour)
    for i in range(amount):
        p.disc((i * 29 + seed * i * i) % 64, (i * 17 + i * i) % 32, 1, 0 or 1, spots)
    return p.grain(5)


def round_fruit(name, mass, profile, paint, stem=None, squash=1.0):
    mesh = lathe(profile, "skin", 24).scaled(1, squash, 1)
    paints = {"skin": paint}
    if stem:
        mesh += stem
        paints["stem"] = Paint((0.33, 0.22, 0.10))
    hull = lathe(profile, "hull", 12).scaled(1, squash, 1)
    return Thing(name, mass, mesh, paints, [("hull", hull)], 0.7)


def sphere_profile(radius, height, dimple=0.0, steps=14):
    """Half a circle from the bottom up, dented at the poles."""
    rows = []
    for i in range(steps + 1):
        t = math.pi * (i / steps - 0.5)
        dent = dimple * math.exp(-(radius * math.cos(t) / (0.3 * radius)) ** 2)
        rows.append((radius * math.cos(t) if 0 < i < steps else 0.0, height / 2 * math.sin(t) - math.copysign(dent, t)))
    return rows


def apple():
    stem = tube([(0, 0, 0.024), (0.002, 0, 0.034), (0.005, 0, 0.042)], 0.0015, "stem", 6)
    return round_fruit("apple", 0.16, sphere_profile(0.0375, 0.078, 0.009), Paint((1, 1, 1), 0.3, speckled((186, 28, 32), (214, 92, 50), 40)), stem)


def orange():
    return round_fruit("orange", 0.17, sphere_profile(0.0365, 0.072, 0.0015), Paint((1, 1, 1), 0.15, speckled((236, 128, 22), (214, 108, 14), 120)))


def lemon():
    rows = [(0.0, -0.034), (0.006, -0.032), (0.012, -0.027), (0.021, -0.019), (0.0262, -0.007), (0.0265, 0.004), (0.022, 0.016),
            (0.014, 0.024), (0.008, 0.0285), (0.006, 0.033), (0.0, 0.0345)]
    lying = round_fruit("lemon", 0.1, rows, Paint((1, 1, 1), 0.15, speckled((244, 214, 44), (224, 190, 30), 60)))
    return Thing(lying.name, lying.mass, lying.mesh.turned("y", 90), lying.paints, [("hull", lying.collisions[0][1].turned("y", 90))], 0.7)


def pear():
    rows = [(0.0, -0.047), (0.012, -0.048), (0.023, -0.043), (0.031, -0.031), (0.033, -0.019), (0.030, -0.005), (0.024, 0.010),
            (0.0185, 0.024), (0.016, 0.036), (0.012, 0.045), (0.005, 0.048), (0.0, 0.048)]
    stem = tube([(0, 0, 0.046), (0.002, 0, 0.056), (0.006, 0, 0.066)], 0.0016, "stem", 6)
    up = round_fruit("pear", 0.165, rows, Paint((1, 1, 1), 0.15, speckled((176, 178, 62), (140, 130, 40), 70)), stem)
    return Thing(up.name, up.mass, up.mesh.turned("y", 97), up.paints, [("hull", up.collisions[0][1].turned("y", 97))], 0.7)


def banana():
    """A bent tube that lies on its side."""
    path, radii, shapes = [], [], []
    for i in range(19):
        s = i / 18.0
        angle = math.radians(-52 + 104 * s)
        path.append((0.098 * math.cos(angle) - 0.098, 0.098 * math.sin(angle), 0.0))
        radii.append(0.0175 * min(1.0, (0.16 + 5.2 * s) ** 0.6, (0.2 + 3.2 * (1 - s)) ** 0.8))
    radii[0], radii[-1], radii[-2] = 0.004, 0.0055, 0.0055
    skin = tube(path, radii, "skin", 10)
    tips = tube([path[-1], (path[-1][0] - 0.006, path[-1][1] + 0.012, 0)], 0.005, "tip", 8) + ellipsoid(0.0045, 0.0045, 0.0045, "tip", 8).moved(*path[0])
    for i in (3, 6, 9, 12, 15):
        shapes.append(("sphere", path[i], radii[i]))
    return Thing("banana", 0.12, skin + tips, {"skin": Paint((0.93, 0.78, 0.16)), "tip": Paint((0.36, 0.28, 0.12))}, shapes, 0.7)


def ball(name, mass, radius, paint, friction):
    mesh = lathe(sphere_profile(radius, 2 * radius, 0.0, 16), "skin", 28)
    return Thing(name, mass, mesh, {"skin": paint}, [("sphere", (0, 0, 0), radius)], friction)


def tennis_ball():
    felt = Picture(128, 64, (206, 222, 50))
    for x in range(128):
        y = 32 + int(19 * math.sin(4 * math.pi * x / 128.0))
        felt.rectangle(x, y - 2, x + 1, y + 2, (240, 240, 232))
    return ball("tennis_ball", 0.058, 0.0335, Paint((1, 1, 1), 0.0, felt.grain(10)), 0.8)


def soccer_ball():
    """Black patches at the corners of an icosahedron."""
    leather = Picture(160, 80, (236, 236, 232))
    corners = [(0, 0, 1), (0, 0, -1)]
    for k in range(5):
        for sign, shift in ((1, 0.0), (-1, 36.0)):
            a = math.radians(72 * k + shift)
            corners.append((0.894 * math.cos(a), 0.894 * math.sin(a), 0.447 * sign))
    for y in range(80):
        tilt = math.pi * (0.5 - (y + 0.5) / 80)
        for x in range(160):
            a = 2 * math.pi * (x + 0.5) / 160
            d = (math.cos(tilt) * math.cos(a), math.cos(tilt) * math.sin(a), math.sin(tilt))
            if max(sum(p * q for p, q in zip(d, c)) for c in corners) > 0.94:
                leather.rows[y][x] = (28, 28, 30)
    return ball("mini_soccer_ball", 0.123, 0.063, Paint((1, 1, 1), 0.2, leather), 0.7)


def things():
    return [banana(), lemon(), apple(), orange(), pear(), tennis_ball(), soccer_ball()]
