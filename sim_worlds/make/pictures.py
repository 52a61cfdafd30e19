"""Paints what does not tile: pictures on walls, views from windows, rugs, screens, the spines of books."""
import math
import random

from textures import Noise, mix, shade, weave

BOOKS = 16      # spines side by side in books.png


def view(u, v):
    """Hills under a sky, a hedge and a meadow."""
    far, near = 0.46 + 0.10 * _RIDGE(u, 0.5), 0.30 + 0.07 * _RIDGE(u * 0.6 + 0.4, 0.5) + 0.03 * _CROWNS(u, 0.5)
    if v > far:
        sky = mix((0.86, 0.92, 0.97), (0.50, 0.70, 0.93), (v - far) * 1.7)
        return mix(sky, (0.98, 0.98, 0.98), 2.4 * (0.7 * _CLOUD(u, v) + 0.3 * _PUFFS(u, v) - 0.55))
    if v > near:
        return mix((0.60, 0.72, 0.70), (0.44, 0.60, 0.48), (far - v) * 6)
    if v > 0.17:
        return mix((0.36, 0.52, 0.26), (0.14, 0.28, 0.12), 0.6 * _CROWNS(u, v * 2) + 0.4 * _PUFFS(u * 2, v * 3))
    return mix((0.58, 0.70, 0.36), (0.44, 0.60, 0.28), _PUFFS(u, v * 4))


_RIDGE, _CLOUD, _CROWNS, _PUFFS = Noise(61, 5, 1), Noise(63, 5, 9), Noise(62, 26, 20), Noise(64, 50, 50)


def hills(u, v):
    sun = math.hypot(u - 0.68, (v - 0.70) * 0.75) < 0.11
    colour = (0.93, 0.55, 0.30) if sun else mix((0.98, 0.86, 0.68), (0.93, 0.72, 0.55), v)
    ridges = ((0, 0.55, (0.62, 0.52, 0.58)), (1, 0.40, (0.36, 0.42, 0.52)), (2, 0.24, (0.16, 0.25, 0.34)))
    for level, height, tone in ridges:
        if v < height + 0.09 * math.sin(2 * math.pi * (u * (1.1 + 0.5 * level) + 0.3 * level)):
            colour = tone
    return colour


def shapes(u, v):
    colour = (0.94, 0.91, 0.84)
    for x, y, r, tone in ((0.36, 0.62, 0.24, (0.14, 0.30, 0.42)), (0.62, 0.40, 0.20, (0.80, 0.36, 0.22)),
                          (0.56, 0.70, 0.10, (0.90, 0.70, 0.25))):
        if math.hypot(u - x, v - y) < r:
            colour = tone
    return (0.12, 0.12, 0.13) if abs(v - 0.22 - 0.12 * u) < 0.008 else colour


def sea(u, v):
    swell = Noise(71, 12, 60)
    if v > 0.52:
        return mix((0.97, 0.88, 0.72), (0.50, 0.68, 0.80), (v - 0.52) * 2)
    sail = 0.40 < v and abs(u - 0.34) < (0.52 - v) * 0.28
    return (0.97, 0.97, 0.95) if sail else mix((0.16, 0.40, 0.50), (0.40, 0.62, 0.66), swell(u, v))


def leaves(u, v):
    colour = (0.93, 0.92, 0.86)
    for k in range(9):
        y = 0.12 + 0.085 * k
        side = 1 if k % 2 else -1
        a, b = (u - 0.5) * side, v - y
        along, across = 0.82 * a + 0.57 * b, -0.57 * a + 0.82 * b
        if 0 < along < 0.36 and abs(across) < 0.20 * along * (0.36 - along) / 0.09 * 0.6:
            colour = mix((0.20, 0.40, 0.26), (0.42, 0.58, 0.36), k / 9)
    return (0.24, 0.36, 0.22) if abs(u - 0.5) < 0.008 and 0.06 < v < 0.9 else colour


def _rug(ground, ring, motif, along, across):
    """Border lines, a ground, and a field of along x across diamonds."""
    yarn = weave(81, (1.04, 1.04, 1.04), (0.84, 0.84, 0.84), 96)

    def pixel(u, v):
        edge = min(u, 1 - u, v, 1 - v)
        colour = ground
        if edge < 0.02 or 0.06 < edge < 0.075:
            colour = ring
        elif edge > 0.10:
            x, y = [abs((t - 0.1) / 0.8 * count % 1.0 - 0.5) for t, count in ((u, along), (v, across))]
            if x + y < 0.16 or 0.36 < x + y < 0.44:
                colour = motif
        return tuple(c * s for c, s in zip(colour, yarn(u, v)))
    return pixel


def books(u, v):
    """BOOKS spines side by side, each with a title band."""
    source = random.Random(int(u * BOOKS) + 5)
    tone = source.choice([(0.55, 0.14, 0.12), (0.12, 0.24, 0.42), (0.16, 0.36, 0.26), (0.84, 0.76, 0.58),
                          (0.20, 0.20, 0.22), (0.76, 0.50, 0.16), (0.40, 0.22, 0.36), (0.70, 0.72, 0.74)])
    tone = shade(tone, 0.85 + 0.3 * source.random())
    band = mix(tone, (0.95, 0.90, 0.75) if sum(tone) < 1.4 else (0.15, 0.13, 0.12), 0.8)
    x, low, high = u * BOOKS % 1.0, 0.25 + 0.3 * source.random(), 0.82
    if abs(v - high) < 0.012 or abs(v - 0.1) < 0.012:
        return band
    if low < v < 0.75 and 0.32 < x < 0.68 and (v * 40 + source.random()) % 1.0 < 0.6:
        return band
    return shade(tone, 0.75 + 0.25 * math.sin(math.pi * x))


def desktop(u, v):
    """A screen with a window of text and a plot."""
    if 0.06 < u < 0.56 and 0.12 < v < 0.90:
        if v > 0.85:
            return (0.30, 0.33, 0.38)
        row = int(v * 44)
        length = 0.12 + 0.34 * random.Random(row).random()
        ink = row % 2 == 0 and 0.09 + 0.02 * (row % 3) < u < 0.09 + length
        return [(0.55, 0.75, 0.50), (0.80, 0.62, 0.40), (0.50, 0.66, 0.86)][row % 3] if ink else (0.11, 0.13, 0.16)
    if 0.60 < u < 0.95 and 0.40 < v < 0.90:
        curve = 0.58 + 0.16 * math.sin(16 * u) * math.exp(-2 * (u - 0.6))
        return (0.85, 0.35, 0.25) if abs(v - curve) < 0.012 else (0.95, 0.95, 0.94)
    return mix((0.18, 0.34, 0.46), (0.36, 0.56, 0.62), v)


def tv_picture(u, v):
    return mix((0.03, 0.03, 0.04), (0.16, 0.19, 0.23), 1.6 * max(0.0, u + v - 1.05))


def mirror_view(u, v):
    return mix((0.70, 0.76, 0.78), (0.84, 0.89, 0.90), 0.5 + 0.5 * math.sin(4 * (u + 0.6 * v)))


def duvet(u, v):
    """Broad quiet stripes."""
    yarn = weave(91, (1.03, 1.03, 1.03), (0.93, 0.93, 0.93), 60)
    band = u * 4 % 1.0
    colour = (0.90, 0.91, 0.90) if band < 0.55 else (0.42, 0.55, 0.60) if band < 0.75 else (0.70, 0.78, 0.78)
    return tuple(c * s for c, s in zip(colour, yarn(u, v)))


PICTURES = {
    "view": ((384, 288), view), "picture_hills": ((192, 144), hills), "picture_shapes": ((144, 192), shapes),
    "picture_sea": ((192, 144), sea), "picture_leaves": ((128, 192), leaves), "books": ((256, 128), books),
    "rug_living": ((384, 256), _rug((0.56, 0.20, 0.17), (0.88, 0.80, 0.64), (0.80, 0.60, 0.38), 5, 4)),
    "rug_bedroom": ((256, 256), _rug((0.80, 0.78, 0.73), (0.36, 0.46, 0.52), (0.52, 0.60, 0.64), 4, 4)),
    "rug_runner": ((384, 128), _rug((0.24, 0.32, 0.36), (0.84, 0.76, 0.60), (0.70, 0.44, 0.30), 8, 2)),
    "bath_mat": ((96, 64), weave(82, (0.94, 0.92, 0.88), (0.80, 0.77, 0.72), 16)),
    "desktop": ((256, 144), desktop), "tv_picture": ((128, 72), tv_picture), "mirror_view": ((64, 96), mirror_view),
    "duvet": ((256, 256), duvet),
}
