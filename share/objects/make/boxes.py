"""Things that are boxes: cartons with printed labels, a book, blocks, a sponge, a remote control."""
from make.mesh import Mesh, box, cylinder, extrude, loft, ring
from make.model import Paint, Thing
from make.picture import Picture

WHITE, BLACK = (245, 243, 238), (30, 30, 32)


def _cells(widths, height):
    """Side by side in one picture: front (x), side (y), top (z)."""
    total = float(sum(widths))
    edges = [sum(widths[:i]) / total for i in range(4)]
    front, side, top = ((edges[i], 0.0, edges[i + 1], 1.0) for i in range(3))
    return {"+x": front, "-x": front, "+y": side, "-y": side, "+z": top, "-z": top}


def carton(name, mass, size, ground, band, words, ink, lying=False):
    """A printed carton that stands on its edge z, or lies on its large face."""
    x, y, z = size
    scale = 150.0 / max(y, z)
    widths = [max(12, int(e * scale)) for e in (y, x, y)]
    h = int(z * scale)
    p = Picture(sum(widths), h, ground)
    w = widths[0]
    p.rectangle(0, int(h * 0.12), w, int(h * 0.42), band)
    dot = max(1, min(int(w * 0.9 / (6 * max(len(t) for t in words))), h // 16))
    for i, text in enumerate(words):
        p.text(text, w // 2, int(h * (0.2 + 0.13 * i)), dot, ink)
    p.disc(w // 2, int(h * 0.7), int(w * 0.28), int(h * 0.17), tuple(min(255, c + 60) for c in band))
    p.disc(w // 2 - w // 12, int(h * 0.68), int(w * 0.13), int(h * 0.08), (222, 170, 90))
    p.disc(w // 2 + w // 9, int(h * 0.73), int(w * 0.11), int(h * 0.07), (205, 140, 70))
    side = widths[1]
    p.rectangle(w, 0, w + side, h, tuple(int(0.9 * c) for c in ground))
    p.rectangle(w + side // 8, h // 8, w + side - side // 8, int(h * 0.75), WHITE)
    p.lines(w + side // 5, h // 6, w + side - side // 5, max(3, h // 10), max(3, h // 18), BLACK)
    p.rectangle(w + side, 0, p.width, h, band)
    p.text(words[0], w + side + w // 2, h // 2, dot, ink)
    mesh = box(size, "label", (0, 0, z / 2), _cells(widths, h))
    shape = ("box", (0, 0, z / 2), size)
    if lying:
        mesh = mesh.moved(z=-z / 2).turned("y", 90).turned("z", 90)
        shape = ("box", (0, 0, 0), (y, z, x))
    return Thing(name, mass, mesh, {"label": Paint((1, 1, 1), 0.15, p.grain(4))}, [shape], 0.5)


def book():
    cover = Picture(110, 150, (38, 66, 110)).rectangle(8, 8, 102, 142, (46, 78, 128))
    cover.rectangle(14, 20, 96, 62, (232, 214, 160)).text("A WALK", 55, 34, 2, BLACK).text("AT NIGHT", 55, 51, 1, BLACK)
    cover.disc(55, 100, 20, 20, (240, 226, 170)).disc(63, 95, 17, 17, (46, 78, 128))
    w, d, h = 0.148, 0.21, 0.029
    mesh = (box((w, d, 0.003), "cover", (0, 0, h - 0.0015)) + box((w, d, 0.003), "cover", (0, 0, 0.0015))
            + box((w - 0.006, d - 0.008, h - 0.006), "pages", (0.001, 0, h / 2))
            + box((0.003, d, h - 0.006), "spine", (-w / 2 + 0.0015, 0, h / 2)))
    paints = {"cover": Paint((1, 1, 1), 0.2, cover.grain(3)), "pages": Paint((0.93, 0.9, 0.82)),
              "spine": Paint((0.15, 0.26, 0.43), 0.2)}
    return Thing("book", 0.38, mesh, paints, [("box", (0, 0, h / 2), (w, d, h))], 0.5)


def wood_block():
    grain = Picture(96, 96, (196, 148, 92))
    for i in range(24):
        x = (i * 41) % 96
        grain.rectangle(x, 0, x + 1 + i % 2, 96, (176 - i % 3 * 8, 128 - i % 3 * 6, 76))
    size = (0.09, 0.09, 0.205)
    mesh = box(size, "wood", (0, 0, 0)).turned("y", 90)
    return Thing("wood_block", 0.73, mesh, {"wood": Paint((1, 1, 1), 0.05, grain.grain(6))},
                 [("box", (0, 0, 0), (size[2], size[1], size[0]))], 0.6)


def sponge():
    holes = Picture(64, 64, (238, 208, 76))
    for i in range(90):
        x, y = (i * 37) % 64, (i * 59 + i * i) % 64
        holes.disc(x, y, 1 + i % 2, 1 + i % 2, (206, 170, 46))
    foam, scourer = box((0.072, 0.112, 0.022), "foam", (0, 0, 0.018)), box((0.072, 0.112, 0.007), "scourer", (0, 0, 0.0035))
    return Thing("sponge", 0.02, foam + scourer, {"foam": Paint((1, 1, 1), 0.0, holes), "scourer": Paint((0.16, 0.45, 0.22), 0.0)},
                 [("box", (0, 0, 0.0145), (0.072, 0.112, 0.029))], 0.9)


def rubiks_cube():
    colours = {"+x": (200, 30, 40), "-x": (240, 120, 20), "+y": (20, 70, 170), "-y": (20, 150, 70), "+z": WHITE, "-z": (240, 210, 40)}
    order = list(colours)
    p = Picture(48 * 6, 48, BLACK)
    cells = {}
    for i, side in enumerate(order):
        cells[side] = (i / 6.0, 0.0, (i + 1) / 6.0, 1.0)
        for k in range(9):
            hue = colours[order[(i + (k * (i + 2)) % 7 % 3 * (k % 2)) % 6]]  # a twisted cube
            p.rectangle(48 * i + 2 + 16 * (k % 3), 2 + 16 * (k // 3), 48 * i + 14 + 16 * (k % 3), 14 + 16 * (k // 3), hue)
    return Thing("rubiks_cube", 0.095, box((0.057, 0.057, 0.057), "stickers", cells=cells),
                 {"stickers": Paint((1, 1, 1), 0.3, p)}, [("box", (0, 0, 0), (0.057, 0.057, 0.057))], 0.5)


def duplo(name, studs_x, studs_y, height, colour, mass):
    pitch = 0.0159
    size = (studs_x * pitch, studs_y * pitch, height)
    mesh = box(size, "plastic", (0, 0, height / 2))
    for i in range(studs_x):
        for k in range(studs_y):
            stud = cylinder(0.0047, height, height + 0.0046, "plastic", 12)
            mesh += stud.moved((i - (studs_x - 1) / 2) * pitch, (k - (studs_y - 1) / 2) * pitch)
    return Thing(name, mass, mesh, {"plastic": Paint(colour, 0.35)},
                 [("box", (0, 0, (height + 0.0046) / 2), (size[0], size[1], height + 0.0046))], 0.4)


def remote_control():
    body = loft([ring(0.021, 0.084, 0.0, 32, 6), ring(0.024, 0.088, 0.006, 32, 6), ring(0.0235, 0.0875, 0.016, 32, 6),
                 ring(0.020, 0.084, 0.021, 32, 6)], "black")
    keys = Mesh()
    for row in range(7):
        for column in range(3):
            at = ((column - 1) * 0.0125, 0.035 - row * 0.0145, 0.0212)
            keys += box((0.008, 0.007, 0.002), "red" if row == 0 and column == 0 else "grey", at)
    keys += cylinder(0.0115, 0.0205, 0.0225, "grey", 16).moved(y=0.058)
    paints = {"black": Paint((0.17, 0.17, 0.18), 0.2), "grey": Paint((0.62, 0.62, 0.64)), "red": Paint((0.8, 0.12, 0.1))}
    return Thing("remote_control", 0.12, body + keys, paints, [("box", (0, 0, 0.011), (0.047, 0.174, 0.022))], 0.5)


def juice_carton():
    p = Picture(90, 100, (250, 170, 40)).rectangle(0, 0, 90, 26, (60, 140, 60))
    for x in (22, 67):
        p.disc(x, 66, 16, 22, (236, 120, 20)).text("ORANGE", x, 14, 1, WHITE).text("JUICE", x, 36, 1, (120, 50, 10))
    a, h = 0.07, 0.165
    walls = box((a, a, h), "label", (0, 0, h / 2))
    roof = [(-a / 2, h), (a / 2, h), (0.004, h + 0.035), (0.004, h + 0.05), (-0.004, h + 0.05), (-0.004, h + 0.035)]
    gable = extrude(roof, -a / 2, a / 2, "top").turned("x", 90)
    return Thing("juice_carton", 1.04, walls + gable + cylinder(0.013, 0, 0.012, "cap", 16).turned("y", 55).moved(0.02, 0, h + 0.014),
                 {"label": Paint((1, 1, 1), 0.2, p.grain(3)), "top": Paint((0.24, 0.55, 0.24), 0.2), "cap": Paint((0.95, 0.95, 0.95), 0.3)},
                 [("box", (0, 0, 0.1), (a, a, 0.2))], 0.5)


def things():
    red, blue, cream = (196, 34, 38), (36, 64, 150), (240, 226, 190)
    return [
        carton("cracker_box", 0.411, (0.060, 0.158, 0.213), red, (150, 16, 24), ["CRISP", "CRACKERS"], WHITE),
        carton("sugar_box", 0.514, (0.045, 0.0925, 0.176), (238, 206, 60), blue, ["SUGAR", "PURE CANE"], WHITE),
        carton("cereal_box", 0.52, (0.065, 0.19, 0.28), (52, 130, 70), (240, 196, 60), ["OATS", "AND HONEY"], BLACK),
        carton("pudding_box", 0.187, (0.038, 0.11, 0.089), (96, 52, 30), (226, 190, 140), ["PUDDING", "COCOA"], BLACK, True),
        carton("gelatin_box", 0.097, (0.030, 0.089, 0.073), cream, (210, 30, 70), ["JELLY", "BERRY"], WHITE, True),
        book(), wood_block(), sponge(), rubiks_cube(), remote_control(), juice_carton(),
        duplo("duplo_brick_red", 4, 2, 0.0192, (0.80, 0.10, 0.09), 0.014),
        duplo("duplo_brick_blue", 2, 2, 0.0384, (0.08, 0.28, 0.72), 0.013),
    ]
