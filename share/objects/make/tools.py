"""Tools and what lies on a desk."""
import math

from make.mesh import Mesh, box, cylinder, extrude, lathe, loft, ring, tube
from make.model import Paint, Thing

STEEL = Paint((0.66, 0.67, 0.70), 0.6)
BLACK = Paint((0.13, 0.13, 0.14), 0.15)


def arc(cx, cy, radius, start, end, count=12, squash=1.0):
    steps = [math.radians(start + (end - start) * i / (count - 1)) for i in range(count)]
    return [(cx + radius * math.cos(t), cy + squash * radius * math.sin(t)) for t in steps]


def lying(name, mass, upright, paints, shapes, friction=0.5):
    """A thing made along z, laid along x. Shapes are given as it lies, z = 0 is its axis."""
    return Thing(name, mass, upright.turned("y", 90), paints, shapes, friction)


def scissors():
    def blade(sign):
        outline = [(-0.004, -0.006), (0.006, -0.004), (0.0025, 0.112), (0.0, 0.114), (-0.006, 0.03)]
        flat = extrude(outline, 0.006 + 0.0015 * sign, 0.0075 + 0.0015 * sign, "steel")
        return flat.turned("z", 7 * sign) if sign > 0 else flat.mapped(lambda x, y, z: (-x, y, z)).outwards().turned("z", -7)
    def grip(sign, rx, ry):
        loop = [(sign * 0.023 + rx * math.cos(t), -0.05 + ry * math.sin(t), 0.0075) for t in (2 * math.pi * i / 20 for i in range(20))]
        arm = tube([(-sign * 0.002, -0.004, 0.0075), (sign * 0.006, -0.018, 0.0075), (sign * 0.014, -0.028, 0.0075)], 0.006, "plastic", 8)
        return tube(loop, 0.0058, "plastic", 8, closed=True) + arm
    mesh = blade(1) + blade(-1) + grip(1, 0.017, 0.028) + grip(-1, 0.019, 0.03) + cylinder(0.0045, 0.003, 0.012, "steel", 12)
    shapes = [("box", (0, -0.05, 0.0075), (0.088, 0.066, 0.0135)), ("box", (0, 0.04, 0.0075), (0.03, 0.14, 0.008))]
    return Thing("scissors", 0.082, mesh, {"steel": STEEL, "plastic": Paint((0.85, 0.25, 0.10), 0.25)}, shapes, 0.4)


def marker():
    body = lathe([(0, -0.06), (0.0085, -0.06), (0.0095, -0.058), (0.0095, 0.02), (0.0085, 0.022), (0, 0.022)], "body", 18)
    cap = lathe([(0, 0.0215), (0.0102, 0.0215), (0.0102, 0.055), (0.008, 0.0605), (0, 0.0605)], "cap", 18)
    band = lathe([(0.0097, -0.045), (0.0097, 0.01)], "label", 18)
    paints = {"body": BLACK, "cap": Paint((0.08, 0.16, 0.62), 0.25), "label": Paint((0.92, 0.92, 0.9))}
    return lying("marker", 0.0158, body + cap + band, paints, [("cylinder", (0, 0, 0), 0.0102, 0.12, (0, math.pi / 2, 0))])


def screwdriver():
    grip = loft([ring(r, r, z, 18, 3) for r, z in ((0.009, 0.0), (0.0155, 0.004), (0.0165, 0.03), (0.0155, 0.075), (0.011, 0.088),
                                                   (0.0125, 0.095), (0.0105, 0.1))], "grip")
    collar = cylinder(0.0168, 0.034, 0.040, "collar", 18) + cylinder(0.0165, 0.066, 0.071, "collar", 18)
    shaft = cylinder(0.0032, 0.1, 0.2, "steel", 10) + loft([ring(0.0032, 0.0032, 0.2, 10), ring(0.0042, 0.0006, 0.214, 10)], "steel")
    shapes = [("cylinder", (0.05, 0, 0), 0.0168, 0.1, (0, math.pi / 2, 0)), ("cylinder", (0.157, 0, 0), 0.0034, 0.114, (0, math.pi / 2, 0))]
    paints = {"grip": Paint((0.85, 0.16, 0.10), 0.3), "collar": BLACK, "steel": STEEL}
    return lying("screwdriver", 0.0984, grip + collar + shaft, paints, shapes)


def hammer():
    shaft = loft([ring(rx, ry, z, 18, 2.4) for rx, ry, z in ((0.013, 0.017, 0.0), (0.0135, 0.0175, 0.01), (0.0115, 0.0145, 0.06),
                                                            (0.0135, 0.0165, 0.12))], "grip")
    shaft += loft([ring(0.0095, 0.0125, z, 14, 2.2) for z in (0.12, 0.30, 0.327)], "wood")
    head = box((0.022, 0.034, 0.026), "steel", (0, 0, 0.313))
    face = lathe([(0, 0.0), (0.0145, 0.0), (0.016, 0.003), (0.016, 0.018), (0.011, 0.024), (0.011, 0.04), (0, 0.04)], "steel", 18)
    claw = extrude([(0.0, -0.012), (0.035, -0.018), (0.062, -0.032), (0.063, -0.029), (0.038, -0.004), (0.0, 0.012)], -0.010, 0.010, "steel")
    head += face.turned("x", 90).moved(y=-0.016, z=0.313).mapped(lambda x, y, z: (x, -y - 0.073, z)).outwards()
    head += claw.turned("z", 90).turned("y", 90).moved(y=0.012, z=0.313)
    shapes = [("box", (0.06, 0, 0), (0.12, 0.034, 0.026)), ("box", (0.21, 0, 0), (0.2, 0.024, 0.018)), ("box", (0.313, 0, 0), (0.03, 0.125, 0.028))]
    return lying("hammer", 0.665, shaft + head, {"grip": BLACK, "wood": Paint((0.76, 0.55, 0.30)), "steel": STEEL}, shapes)


def power_drill():
    """Lies on its side: motor along x, handle along -y, z is its thickness."""
    motor = loft([ring(r, r * 1.05, z, 22, 2.6) for r, z in ((0.018, 0.0), (0.026, 0.006), (0.028, 0.03), (0.028, 0.095), (0.022, 0.108), (0.019, 0.112))],
                 "shell").turned("y", 90)
    chuck = lathe([(0, 0.112), (0.019, 0.112), (0.019, 0.128), (0.017, 0.132), (0.017, 0.150), (0.008, 0.160), (0.008, 0.166), (0, 0.166)],
                  "black", 20).turned("y", 90)
    grip = loft([ring(0.021, 0.017, 0.0, 18, 2.6, x=0.036), ring(0.019, 0.0155, -0.03, 18, 2.6, x=0.03), ring(0.0195, 0.016, -0.075, 18, 2.6, x=0.02),
                 ring(0.023, 0.018, -0.105, 18, 2.6, x=0.016)][::-1], "black").turned("x", -90).mapped(lambda x, y, z: (x, -abs(y) - 0.018, z)).outwards()
    pack = box((0.085, 0.034, 0.054), "shell", (0.022, -0.138, 0)) + box((0.078, 0.01, 0.048), "black", (0.022, -0.158, 0))
    trigger = box((0.012, 0.024, 0.012), "red", (0.058, -0.044, 0))
    bit = cylinder(0.0028, 0.16, 0.185, "steel", 8).turned("y", 90)
    shapes = [("cylinder", (0.055, 0, 0), 0.028, 0.11, (0, math.pi / 2, 0)), ("cylinder", (0.138, 0, 0), 0.019, 0.054, (0, math.pi / 2, 0)),
              ("box", (0.026, -0.075, 0), (0.042, 0.10, 0.034)), ("box", (0.022, -0.142, 0), (0.085, 0.042, 0.054))]
    paints = {"shell": Paint((0.93, 0.62, 0.06), 0.2), "black": BLACK, "red": Paint((0.75, 0.1, 0.1)), "steel": STEEL}
    return Thing("power_drill", 0.895, motor + chuck + grip + pack + trigger + bit, paints, shapes, 0.5)


def clamp():
    """A spring clamp: two jaws, two handles."""
    def arm(sign):
        outline = [(-0.075, 0.020), (-0.07, 0.034), (-0.012, 0.014), (0.012, 0.012), (0.05, 0.022), (0.088, 0.010), (0.088, 0.002),
                   (0.05, 0.010), (0.012, 0.0), (-0.012, 0.002)]
        flat = extrude(outline[::-1], 0.004, 0.032, "body")
        return flat if sign > 0 else flat.mapped(lambda x, y, z: (x, -y, z)).outwards()
    spring = tube([(0.0, 0.006 * math.cos(t), 0.018 + 0.016 * t / 20 - 0.008) for t in (i * 0.8 for i in range(20))], 0.002, "steel", 6)
    tips = box((0.02, 0.012, 0.03), "orange", (0.086, 0.006, 0.018)) + box((0.02, 0.012, 0.03), "orange", (0.086, -0.006, 0.018))
    grips = box((0.055, 0.012, 0.034), "orange", (0, 0, 0.018)).turned("z", -19).moved(-0.047, 0.0275) + \
        box((0.055, 0.012, 0.034), "orange", (0, 0, 0.018)).turned("z", 19).moved(-0.047, -0.0275)
    mesh = arm(1) + arm(-1) + spring + tips + grips + cylinder(0.006, 0.0, 0.036, "steel", 12)
    shapes = [("box", (0.045, 0, 0.018), (0.1, 0.042, 0.034)), ("box", (-0.045, 0, 0.018), (0.07, 0.074, 0.034))]
    return Thing("clamp", 0.202, mesh, {"body": BLACK, "orange": Paint((0.92, 0.42, 0.06)), "steel": STEEL}, shapes, 0.6)


def padlock():
    body = loft([ring(0.024, 0.0175, z, 24, 5) for z in (0.0, 0.002, 0.023, 0.025)], "brass")
    bow = [(0.0155, 0.016)] + [(0.0155 * math.cos(t), 0.03 + 0.0155 * math.sin(t)) for t in (math.pi * i / 10 for i in range(11))] + [(-0.0155, 0.016)]
    shackle = tube([(x, y, 0.0125) for x, y in bow], 0.0042, "steel", 8)
    shapes = [("box", (0, 0, 0.0125), (0.048, 0.035, 0.025)), ("box", (0, 0.033, 0.0125), (0.04, 0.034, 0.009))]
    return Thing("padlock", 0.208, body + shackle, {"brass": Paint((0.78, 0.60, 0.22), 0.4), "steel": STEEL}, shapes, 0.5)


def things():
    return [scissors(), marker(), screwdriver(), hammer(), power_drill(), clamp(), padlock()]
