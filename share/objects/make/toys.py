"""Toys and what is worn."""
import math

from make.mesh import Mesh, box, cylinder, ellipsoid, extrude, lathe, loft, ring, tube
from make.model import Paint, Thing

BLACK = Paint((0.12, 0.12, 0.13), 0.15)


def toy_car():
    side = [(-0.062, 0.012), (0.062, 0.012), (0.066, 0.020), (0.064, 0.030), (0.034, 0.034), (0.016, 0.050), (-0.030, 0.051),
            (-0.046, 0.035), (-0.064, 0.033), (-0.066, 0.020)]
    body = extrude(side, -0.028, 0.028, "paint").turned("x", 90)
    glass = extrude([(-0.040, 0.036), (0.029, 0.036), (0.0145, 0.0475), (-0.0285, 0.0485)], -0.0284, 0.0284, "glass").turned("x", 90)
    wheels = Mesh()
    for x in (-0.040, 0.040):
        for y in (-0.027, 0.027):
            tyre = cylinder(0.0135, -0.006, 0.006, "black", 18) + cylinder(0.007, -0.0065, 0.0065, "chrome", 12)
            wheels += tyre.turned("x", 90).moved(x, y, 0.0135)
    lamps = Mesh()
    for y in (-0.02, 0.02):
        lamps += box((0.004, 0.01, 0.006), "chrome", (0.0645, y, 0.025)) + box((0.004, 0.01, 0.005), "red", (-0.0645, y, 0.027))
    paints = {"paint": Paint((0.10, 0.36, 0.76), 0.35), "glass": Paint((0.20, 0.26, 0.32), 0.4), "black": BLACK,
              "chrome": Paint((0.75, 0.75, 0.77), 0.5), "red": Paint((0.8, 0.1, 0.1))}
    shapes = [("box", (0, 0, 0.021), (0.132, 0.066, 0.030)), ("box", (-0.007, 0, 0.043), (0.06, 0.056, 0.017)),
              ("box", (0, 0, 0.005), (0.10, 0.066, 0.01))]
    return Thing("toy_car", 0.11, body + glass + wheels + lamps, paints, shapes, 0.7)


def toy_airplane():
    hull = loft([ring(r, r * h, z, 20, 2.2, y=dy) for r, h, z, dy in ((0.010, 1, -0.125, 0.012), (0.018, 1, -0.10, 0.010), (0.032, 1.05, -0.03, 0.0),
                 (0.038, 1.05, 0.04, 0.0), (0.036, 1.0, 0.085, 0.0), (0.024, 1.0, 0.105, 0.0))], "red").turned("y", 90).turned("x", 90)
    wing = extrude([(-0.028, -0.13), (0.03, -0.13), (0.036, -0.02), (0.036, 0.02), (0.03, 0.13), (-0.028, 0.13)], -0.005, 0.005, "yellow").moved(0.03, 0, 0.02)
    tail = extrude([(-0.022, -0.055), (0.012, -0.055), (0.02, 0.0), (0.012, 0.055), (-0.022, 0.055)], -0.004, 0.004, "yellow").moved(-0.105, 0, 0.012)
    fin = extrude([(-0.128, 0.01), (-0.085, 0.01), (-0.112, 0.066), (-0.128, 0.066)], -0.004, 0.004, "yellow").turned("x", 90)
    cabin = ellipsoid(0.034, 0.024, 0.030, "blue", 16).moved(0.045, 0, 0.030)
    nose = lathe([(0, 0), (0.012, 0), (0.008, 0.012), (0, 0.018)], "blue", 14).turned("y", 90).moved(0.104)
    screw = box((0.004, 0.012, 0.11), "blue", (0.112, 0, 0)).turned("x", 25)
    wheels = Mesh()
    for x, y in ((0.05, 0.035), (0.05, -0.035), (-0.09, 0.0)):
        r = 0.022 if x > 0 else 0.012
        wheels += cylinder(r, -0.008, 0.008, "black", 18).turned("x", 90).moved(x, y, -0.066 + r)
        wheels += tube([(x, y * 0.9, -0.066 + r), (x, y * 0.4, -0.02 if x > 0 else 0.0)], 0.005, "blue", 8)
    paints = {"red": Paint((0.84, 0.14, 0.12), 0.25), "yellow": Paint((0.95, 0.76, 0.12), 0.25), "blue": Paint((0.12, 0.34, 0.72), 0.3), "black": BLACK}
    shapes = [("box", (-0.005, 0, 0.0), (0.23, 0.062, 0.07)), ("box", (0.03, 0, 0.02), (0.064, 0.26, 0.01)), ("box", (-0.105, 0, 0.012), (0.04, 0.11, 0.008)),
              ("box", (0.05, 0, -0.044), (0.044, 0.086, 0.044)), ("box", (-0.09, 0, -0.054), (0.024, 0.016, 0.024)),
              ("box", (-0.108, 0, 0.038), (0.04, 0.008, 0.056))]
    return Thing("toy_airplane", 0.57, hull + wing + tail + fin + cabin + nose + screw + wheels, paints, shapes, 0.6)


def teddy_bear():
    """Sits, looks along +x."""
    fur, light = "fur", "muzzle"
    parts = ellipsoid(0.058, 0.064, 0.075, fur).moved(0, 0, 0.075) + ellipsoid(0.040, 0.046, 0.054, light).moved(0.024, 0, 0.072)
    parts += ellipsoid(0.052, 0.058, 0.052, fur).moved(0.008, 0, 0.182) + ellipsoid(0.026, 0.028, 0.022, light).moved(0.050, 0, 0.170)
    parts += ellipsoid(0.009, 0.011, 0.008, "black", 10).moved(0.075, 0, 0.177)
    shapes = [("sphere", (0, 0, 0.062), 0.060), ("sphere", (0.008, 0, 0.182), 0.054)]
    for y in (-1, 1):
        parts += ellipsoid(0.012, 0.022, 0.022, fur, 12).moved(0.0, 0.046 * y, 0.226) + ellipsoid(0.008, 0.014, 0.014, light, 10).moved(0.008, 0.046 * y, 0.226)
        parts += ellipsoid(0.006, 0.007, 0.008, "black", 10).moved(0.055, 0.022 * y, 0.196)
        parts += ellipsoid(0.026, 0.026, 0.058, fur, 14).turned("y", -38).turned("x", 28 * y).moved(0.028, 0.070 * y, 0.098)
        parts += ellipsoid(0.070, 0.033, 0.033, fur, 14).turned("z", 18 * y).moved(0.068, 0.048 * y, 0.034)
        parts += ellipsoid(0.012, 0.028, 0.032, light, 12).turned("z", 18 * y).moved(0.126, 0.066 * y, 0.036)
        shapes += [("sphere", (0.10, 0.058 * y, 0.033), 0.032), ("sphere", (0.05, 0.044 * y, 0.033), 0.032), ("sphere", (0.045, 0.074 * y, 0.085), 0.024)]
    bow = ellipsoid(0.008, 0.018, 0.011, "ribbon", 10)
    parts += bow.moved(0.052, 0.017, 0.136) + bow.moved(0.052, -0.017, 0.136) + ellipsoid(0.008, 0.007, 0.007, "ribbon", 8).moved(0.055, 0, 0.136)
    paints = {"fur": Paint((0.62, 0.42, 0.22), 0.0), "muzzle": Paint((0.86, 0.72, 0.50), 0.0), "black": BLACK, "ribbon": Paint((0.78, 0.12, 0.16))}
    return Thing("teddy_bear", 0.22, parts, paints, shapes, 0.8)


SOLE = [(-0.135, 0.026), (-0.10, 0.036), (-0.04, 0.032), (0.03, 0.038), (0.09, 0.048), (0.125, 0.038), (0.142, 0.016)]


def sole_outline(grow=0.0):
    return [(x + (grow if x > 0 else -grow) * 0.5, -y - grow) for x, y in SOLE] + [(x + (grow if x > 0 else -grow) * 0.5, y + grow) for x, y in SOLE[::-1]]


def section(x, half, low, high, count=18):
    """Across the foot at x: flat below, round above."""
    return [(x, half * math.cos(t) * (1.0 if math.sin(t) < 0 else 0.96), low if math.sin(t) < -0.3 else low + (high - low) * (math.sin(t) + 0.3) / 1.3)
            for t in (2 * math.pi * i / count for i in range(count))]


def shoe():
    sole = extrude(sole_outline(), 0.0, 0.022, "sole")
    rows = [(-0.134, 0.022, 0.055), (-0.128, 0.030, 0.088), (-0.10, 0.036, 0.094), (-0.055, 0.036, 0.088), (-0.02, 0.036, 0.086), (0.03, 0.039, 0.07),
            (0.08, 0.044, 0.055), (0.115, 0.038, 0.047), (0.136, 0.02, 0.036), (0.142, 0.006, 0.026)]
    upper = loft([section(x, half, 0.018, high) for x, half, high in rows], "cloth").outwards()
    opening = ellipsoid(0.040, 0.024, 0.004, "inside", 18).turned("y", 4).moved(-0.082, 0, 0.0905)
    toe = loft([section(x, half * 1.02, 0.02, high * 1.03) for x, half, high in rows[6:]], "cap").outwards()
    laces, stripe = Mesh(), Mesh()
    for i in range(5):
        x, z = -0.022 + 0.018 * i, 0.0875 - 0.0075 * i
        laces += tube([(x, -0.020, z - 0.008), (x + 0.003, -0.008, z - 0.001), (x + 0.006, 0.008, z - 0.001), (x + 0.009, 0.020, z - 0.008)], 0.003, "sole", 6)
    paints = {"cloth": Paint((0.16, 0.28, 0.55), 0.0), "sole": Paint((0.92, 0.91, 0.88)), "cap": Paint((0.86, 0.86, 0.84)), "inside": Paint((0.07, 0.07, 0.09))}
    hulls = [("hull", sole + loft([section(x, half, 0.018, high, 8) for x, half, high in (rows[0], rows[2], rows[5], rows[7], rows[9])], "hull").outwards())]
    return Thing("shoe", 0.36, sole + upper + toe + opening + laces + stripe, paints, hulls, 0.8)


def slipper():
    sole = extrude(sole_outline(), 0.0, 0.020, "sole") + extrude(sole_outline(-0.003), 0.020, 0.024, "felt")
    rows = [(0.005, 0.040, 0.078), (0.04, 0.042, 0.074), (0.08, 0.047, 0.063), (0.112, 0.041, 0.05), (0.132, 0.024, 0.038), (0.141, 0.008, 0.028)]
    band = loft([section(x, half, 0.018, high) for x, half, high in rows], "felt").outwards()
    mouth = loft([section(0.0035, 0.035, 0.0245, 0.072), section(0.006, 0.035, 0.0245, 0.072)], "dark").outwards()
    paints = {"sole": Paint((0.30, 0.22, 0.17)), "felt": Paint((0.58, 0.20, 0.24), 0.0), "dark": Paint((0.16, 0.07, 0.08), 0.0)}
    shapes = [("hull", sole), ("box", (0.06, 0, 0.04), (0.11, 0.078, 0.045))]
    return Thing("slipper", 0.14, sole + band + mouth, paints, shapes, 0.8)


def things():
    return [toy_car(), toy_airplane(), teddy_bear(), shoe(), slipper()]
