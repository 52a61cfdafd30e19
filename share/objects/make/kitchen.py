"""Cans, bottles and dishes: surfaces of revolution and lofts."""
import math

from make.mesh import Mesh, lathe, loft, ring, tube
from make.model import Paint, Thing
from make.picture import Picture

WHITE, BLACK = (245, 243, 238), (30, 30, 32)
METAL = Paint((0.72, 0.72, 0.74), 0.55)


def wrap_label(ground, band, words, ink):
    """Goes round twice, so that the words are seen from everywhere."""
    p = Picture(240, 90, ground).rectangle(0, 18, 240, 62, band).rectangle(0, 64, 240, 67, ink)
    for x in (60, 180):
        for i, text in enumerate(words):
            p.text(text, x, 32 + 18 * i, 2, ink)
    for x in (0, 120, 239):
        p.disc(x, 40, 14, 14, tuple(min(255, c + 50) for c in ground))
    return p.lines(12, 72, 108, 3, 5, ink).grain(4)


def can(name, mass, radius, height, ground, band, words, ink, lid=None):
    """A can with a label between two rims, or with a plastic lid."""
    rim = min(0.005, height / 8)
    label = lathe([(radius * 0.985, rim), (radius * 0.985, height - rim)], "label", 32)
    foot = lathe([(0, 0.001), (radius * 0.9, 0.001), (radius * 0.9, 0), (radius, 0), (radius, rim), (radius * 0.985, rim)], "metal", 32)
    top = lathe([(radius * 0.985, height - rim), (radius, height - rim), (radius, height), (radius * 0.92, height),
                 (radius * 0.92, height - 0.003), (0, height - 0.003)], "lid" if lid else "metal", 32)
    if lid:
        top += lathe([(radius * 0.92, height - 0.003), (0, height - 0.0005)], "lid", 32)
    paints = {"label": Paint((1, 1, 1), 0.25, wrap_label(ground, band, words, ink)), "metal": METAL}
    if lid:
        paints["lid"] = Paint(lid, 0.2)
    return Thing(name, mass, label + foot + top, paints, [("cylinder", (0, 0, height / 2), radius, height)], 0.5)


def bottle(name, mass, rows, cap_rows, paint, cap, label=None):
    """rows: (half width x, half width y, z, power) from the bottom up; the label is a band (z0, z1, Paint)."""
    body = loft([ring(*r[:3], 28, r[3]) for r in rows], "plastic")
    top = loft([ring(r[0], r[0], r[1], 20) for r in cap_rows], "cap")
    mesh, paints = body + top, {"plastic": paint, "cap": cap}
    if label:
        z0, z1, skin = label
        near = [r for r in rows if z0 <= r[2] <= z1]
        mesh += loft([ring(r[0] + 0.0006, r[1] + 0.0006, z, 28, r[3]) for r, z in ((near[0], z0), (near[-1], z1))], "label")
        paints["label"] = skin
    hull = loft([ring(*r[:3], 12, r[3]) for r in rows] + [ring(cap_rows[-1][0], cap_rows[-1][0], cap_rows[-1][1], 12)], "hull")
    return Thing(name, mass, mesh, paints, [("hull", hull)], 0.5)


def mustard_bottle():
    rows = [(0.040, 0.024, 0.0, 3), (0.046, 0.029, 0.006, 2.6), (0.048, 0.031, 0.03, 2.4), (0.047, 0.030, 0.11, 2.4),
            (0.042, 0.028, 0.135, 2.2), (0.028, 0.024, 0.150, 2), (0.016, 0.016, 0.155, 2)]
    cap = [(0.017, 0.155), (0.017, 0.168), (0.010, 0.171), (0.006, 0.189), (0.003, 0.191)]
    label = wrap_label((250, 205, 30), (200, 30, 30), ["MUSTARD", "YELLOW"], WHITE)
    return bottle("mustard_bottle", 0.603, rows, cap, Paint((0.95, 0.76, 0.08), 0.2), Paint((0.78, 0.10, 0.10), 0.2),
                  (0.03, 0.11, Paint((1, 1, 1), 0.2, label)))


def bleach_bottle():
    rows = [(0.046, 0.030, 0.0, 3), (0.050, 0.033, 0.006, 3), (0.051, 0.034, 0.04, 3), (0.051, 0.034, 0.145, 3),
            (0.044, 0.031, 0.18, 2.4), (0.025, 0.022, 0.205, 2), (0.015, 0.015, 0.215, 2)]
    cap = [(0.018, 0.215), (0.018, 0.243), (0.014, 0.2475), (0.008, 0.25)]
    label = wrap_label((230, 238, 250), (30, 90, 180), ["BLEACH", "EXTRA"], WHITE)
    return bottle("bleach_bottle", 1.131, rows, cap, Paint((0.93, 0.94, 0.95), 0.2), Paint((0.10, 0.30, 0.68), 0.2),
                  (0.04, 0.145, Paint((1, 1, 1), 0.2, label)))


def water_bottle():
    rows = [(0.028, 0.028, 0.0, 2), (0.032, 0.032, 0.004, 2)]
    rows += [(0.0325 - 0.0012 * (i % 2), 0.0325 - 0.0012 * (i % 2), 0.012 + 0.011 * i, 2) for i in range(12)]
    rows += [(0.031, 0.031, 0.150, 2), (0.022, 0.022, 0.178, 2), (0.0125, 0.0125, 0.190, 2), (0.0125, 0.0125, 0.2, 2)]
    cap = [(0.0145, 0.2), (0.0145, 0.214), (0.0135, 0.216)]
    label = wrap_label((220, 236, 248), (40, 120, 190), ["SPRING", "WATER"], WHITE)
    return bottle("water_bottle", 0.52, rows, cap, Paint((0.62, 0.78, 0.88), 0.3), Paint((0.12, 0.36, 0.75), 0.2),
                  (0.06, 0.125, Paint((1, 1, 1), 0.2, label)))


def shell(outer, thickness):
    """A vessel: the outer profile from the axis up, and the same inside."""
    inner = [(max(0.0, r - thickness), z + (thickness if r < 0.6 * outer[-1][0] else 0.0)) for r, z in reversed(outer[1:])]
    floor = max(thickness + outer[0][1], 0.003)
    return outer + [(r, max(z, floor)) for r, z in inner] + [(0.0, floor)]


def vessel(name, mass, outer, thickness, paint, segments=32, friction=0.5, handle=None):
    mesh = lathe(shell(outer, thickness), "body", segments)
    if handle:
        mesh += handle
    hull = lathe([p for p in outer] + [(0.0, outer[-1][1])], "hull", 16)
    shapes = [("hull", hull)]
    if handle:
        low, high = handle.bounds()
        shapes.append(("box", tuple((a + b) / 2 for a, b in zip(low, high)), tuple(b - a for a, b in zip(low, high))))
    return Thing(name, mass, mesh, {"body": paint}, shapes, friction)


def handle_arc(at, reach, z0, z1, radius, points=11):
    path = [(at + reach * math.sin(math.pi * i / (points - 1)), 0.0, z0 + (z1 - z0) * i / (points - 1)) for i in range(points)]
    return tube(path, radius, "body", 8)


def mug():
    outer = [(0.0, 0.0), (0.036, 0.0), (0.040, 0.004), (0.0455, 0.02), (0.0465, 0.05), (0.0465, 0.08)]
    return vessel("mug", 0.118, outer, 0.004, Paint((0.72, 0.11, 0.12), 0.3), handle=handle_arc(0.044, 0.026, 0.018, 0.066, 0.0055))


def bowl():
    outer = [(0.0, 0.0), (0.034, 0.0), (0.036, 0.004), (0.055, 0.013), (0.071, 0.030), (0.0795, 0.052), (0.0805, 0.055)]
    return vessel("bowl", 0.147, outer, 0.003, Paint((0.74, 0.18, 0.14), 0.25))


def plate():
    outer = [(0.0, 0.0), (0.083, 0.0), (0.088, 0.004), (0.100, 0.016), (0.129, 0.0245), (0.1305, 0.0265)]
    return vessel("plate", 0.279, outer, 0.0035, Paint((0.80, 0.20, 0.16), 0.25), 40)


def stacking_cup():
    outer = [(0.0, 0.0), (0.030, 0.0), (0.033, 0.003), (0.037, 0.066), (0.0405, 0.067), (0.0405, 0.072)]
    return vessel("stacking_cup", 0.021, outer, 0.0025, Paint((0.16, 0.62, 0.32), 0.25), 24)


def pitcher():
    outer = [(0.0, 0.0), (0.048, 0.0), (0.052, 0.006), (0.054, 0.06), (0.062, 0.15), (0.066, 0.22), (0.068, 0.24)]
    handle = tube([(0.062, 0, 0.21), (0.085, 0, 0.215), (0.101, 0, 0.20), (0.102, 0, 0.16), (0.096, 0, 0.11), (0.08, 0, 0.075), (0.054, 0, 0.06)],
                  0.0085, "body", 8)
    return vessel("pitcher", 0.178, outer, 0.003, Paint((0.16, 0.38, 0.72), 0.3), 32, handle=handle)


def things():
    return [
        can("soup_can", 0.349, 0.033, 0.101, (200, 26, 30), WHITE, ["TOMATO", "SOUP"], (150, 20, 24)),
        can("tuna_can", 0.171, 0.0425, 0.033, (28, 70, 140), (240, 200, 60), ["TUNA"], BLACK),
        can("coffee_can", 0.414, 0.051, 0.139, (24, 44, 120), (180, 24, 30), ["COFFEE", "ROAST"], WHITE, (0.12, 0.16, 0.42)),
        mustard_bottle(), bleach_bottle(), water_bottle(), mug(), bowl(), plate(), stacking_cup(), pitcher(),
    ]
