"""Paints the textures, pure Python: python3 make.py writes them to ../textures as PNG. All but pictures tile."""
import math
import os
import random
import struct
import zlib


def save_png(path, width, height, pixel):
    """8-bit RGB; pixel(u, v) -> (r, g, b) in 0..1, u to the right, v UPWARDS, both in 0..1."""
    def byte(value):
        return min(255, max(0, int(value * 64 + 0.5) * 4))      # 65 steps: small files

    rows = bytearray()
    for j in range(height):
        row = bytearray()
        for i in range(width):
            row += bytes(map(byte, pixel((i + 0.5) / width, 1 - (j + 0.5) / height)))
        rows += b"\x00" + row

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
                  + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


class Noise:
    """Smooth noise in 0..1 that tiles: nu x nv cells over the unit square."""

    def __init__(self, seed, nu, nv):
        source = random.Random(seed)
        self.nu, self.nv = nu, nv
        self.cells = [[source.random() for _ in range(nv)] for _ in range(nu)]

    def __call__(self, u, v):
        x, y = u * self.nu, v * self.nv
        i, j = math.floor(x), math.floor(y)
        a, b = x - i, y - j
        a, b = a * a * (3 - 2 * a), b * b * (3 - 2 * b)
        left, right = self.cells[i % self.nu], self.cells[(i + 1) % self.nu]
        j, k = j % self.nv, (j + 1) % self.nv
        return (left[j] * (1 - b) + left[k] * b) * (1 - a) + (right[j] * (1 - b) + right[k] * b) * a


def mix(a, b, t):
    t = min(1.0, max(0.0, t))
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def shade(colour, factor):
    return tuple(c * factor for c in colour)


def wood(seed, light, dark, rings=9):
    """Grain along u."""
    wave, fibre, fine = Noise(seed, 3, 6), Noise(seed + 1, 5, 80), Noise(seed + 2, 9, 200)

    def pixel(u, v):
        ring = 0.5 + 0.5 * math.sin(2 * math.pi * (v * rings + 2.2 * wave(u, v)))
        return mix(light, dark, 0.35 * ring + 0.45 * fibre(u, v) + 0.25 * fine(u, v) - 0.1)
    return pixel


def planks(seed, light, dark, rows=10, length=2):
    """Floor boards along u, 1/rows m wide, each row shifted."""
    grain, source = wood(seed, light, dark), random.Random(seed)
    shift = [source.random() for _ in range(rows)]
    tone = [[0.90 + 0.14 * source.random() for _ in range(length)] for _ in range(rows)]

    def pixel(u, v):
        row = int(v * rows) % rows
        along = (u + shift[row]) % 1.0 * length
        board = int(along) % length
        gap = min(along % 1.0, 1 - along % 1.0) / length < 0.0022 or min(v * rows % 1.0, 1 - v * rows % 1.0) < 0.024
        colour = shade(grain(u + 0.37 * row + 0.21 * board, v + 0.13 * row), tone[row][board])
        return shade(colour, 0.62) if gap else colour
    return pixel


def tiles(seed, light, dark, count, joint, border=0.012):
    patch, source = Noise(seed, 60, 60), random.Random(seed)
    tone = [[0.96 + 0.06 * source.random() for _ in range(count)] for _ in range(count)]

    def pixel(u, v):
        a, b = u * count % 1.0, v * count % 1.0
        if min(a, 1 - a, b, 1 - b) < border * count / 2:
            return joint
        return shade(mix(light, dark, patch(u, v)), tone[int(u * count) % count][int(v * count) % count])
    return pixel


def weave(seed, light, dark, threads=64, cloud=0.35):
    patch, fuzz = Noise(seed, 8, 8), Noise(seed + 1, 97, 89)

    def pixel(u, v):
        over = math.sin(2 * math.pi * threads * u) * math.sin(2 * math.pi * threads * v)
        return mix(light, dark, 0.5 + 0.22 * over + cloud * (patch(u, v) - 0.5) + 0.35 * (fuzz(u, v) - 0.5))
    return pixel


def speckled(seed, light, dark, cells=120):
    coarse, fine = Noise(seed, 10, 10), Noise(seed + 1, cells, cells)
    return lambda u, v: mix(light, dark, 0.35 * coarse(u, v) + 0.65 * fine(u, v) ** 1.5)


def stripes(a, b, count, share=0.5, soft=0.0):
    fuzz = Noise(7, 64, 64)
    return lambda u, v: shade(a if u * count % 1.0 < share else b, 0.97 + soft * fuzz(u, v))


def basket(light, dark):
    def pixel(u, v):
        i, j = int(u * 24), int(v * 24)
        along = (u * 24 % 1.0) if (i + j) % 2 else (v * 24 % 1.0)
        return mix(dark, light, math.sin(math.pi * along) ** 0.5)
    return pixel


def wallpaper(ground, motif):
    """Sprigs of three pairs of leaves on a plain ground, in rows shifted by half."""
    fuzz = Noise(31, 90, 90)

    def pixel(u, v):
        x, y = (u * 6 + 0.5 * (int(v * 6) % 2)) % 1.0 - 0.5, v * 6 % 1.0 - 0.5
        ink = abs(x) < 0.012 and -0.40 < y < 0.30
        for k in range(3):
            a, b = abs(x), y + 0.26 - 0.20 * k
            along, across = 0.77 * a + 0.64 * b, -0.64 * a + 0.77 * b
            size = 0.26 - 0.04 * k
            ink = ink or (0 < along < size and abs(across) < 0.9 * along * (size - along) / size)
        return shade(motif if ink else ground, 0.97 + 0.05 * fuzz(u, v))
    return pixel


TEXTURES = {
    "oak": (256, wood(1, (0.80, 0.64, 0.45), (0.67, 0.50, 0.32), 7)),
    "walnut": (256, wood(2, (0.50, 0.34, 0.23), (0.36, 0.23, 0.15), 6)),
    "birch": (256, wood(3, (0.90, 0.81, 0.66), (0.79, 0.67, 0.49), 6)),
    "door_white": (64, wood(5, (0.93, 0.93, 0.91), (0.87, 0.87, 0.85))),
    "parquet": (512, planks(11, (0.80, 0.66, 0.49), (0.66, 0.51, 0.35))),
    "parquet_dark": (512, planks(12, (0.56, 0.42, 0.31), (0.43, 0.31, 0.22), 8)),
    "laminate": (512, planks(13, (0.78, 0.72, 0.63), (0.64, 0.57, 0.48), 5, 1)),
    "tiles_kitchen": (256, tiles(21, (0.80, 0.76, 0.69), (0.74, 0.69, 0.62), 2, (0.60, 0.57, 0.53), 0.008)),
    "tiles_bath": (256, tiles(22, (0.53, 0.62, 0.66), (0.49, 0.57, 0.62), 4, (0.80, 0.82, 0.82), 0.010)),
    "tiles_wall": (256, tiles(23, (0.93, 0.95, 0.95), (0.90, 0.93, 0.94), 5, (0.78, 0.81, 0.82), 0.009)),
    "tiles_splash": (256, tiles(24, (0.62, 0.72, 0.68), (0.52, 0.63, 0.60), 10, (0.86, 0.86, 0.82), 0.008)),
    "carpet": (256, speckled(31, (0.50, 0.53, 0.57), (0.33, 0.36, 0.41))),
    "wallpaper": (384, wallpaper((0.85, 0.87, 0.82), (0.67, 0.75, 0.67))),
    "fabric_blue": (256, weave(41, (0.33, 0.44, 0.56), (0.18, 0.27, 0.38))),
    "fabric_grey": (256, weave(42, (0.62, 0.61, 0.59), (0.44, 0.43, 0.42))),
    "fabric_mustard": (256, weave(43, (0.86, 0.67, 0.28), (0.68, 0.48, 0.14), 40)),
    "fabric_green": (256, weave(44, (0.40, 0.52, 0.40), (0.25, 0.36, 0.27))),
    "leather": (256, speckled(45, (0.52, 0.31, 0.19), (0.36, 0.20, 0.12), 70)),
    "linen": (256, weave(46, (0.95, 0.93, 0.88), (0.86, 0.83, 0.77), 50)),
    "curtain": (256, stripes((0.86, 0.82, 0.72), (0.78, 0.72, 0.60), 24, 0.55, 0.05)),
    "stone": (256, speckled(47, (0.36, 0.36, 0.37), (0.15, 0.15, 0.16))),
    "soil": (64, speckled(48, (0.28, 0.20, 0.14), (0.14, 0.10, 0.07), 40)),
    "wicker": (128, basket((0.80, 0.62, 0.38), (0.48, 0.33, 0.17))),
}


def save_all(folder, pictures):
    os.makedirs(folder, exist_ok=True)
    for name, (size, pixel) in {**TEXTURES, **pictures}.items():
        width, height = size if isinstance(size, tuple) else (size, size)
        save_png(os.path.join(folder, name + ".png"), width, height, pixel)
