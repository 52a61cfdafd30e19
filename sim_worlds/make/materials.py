"""What surfaces look like: name -> (colour, texture or None, glow or None). The colour of a textured one is white, so
that a renderer may multiply both."""

WHITE = (1.0, 1.0, 1.0)


def plain(red, green, blue, glow=None):
    return ((red, green, blue), None, glow)


def textured(name, glow=None):
    return (WHITE, name, glow)


MATERIALS = {name: textured(name) for name in (
    "oak", "walnut", "birch", "fabric_blue", "fabric_grey", "fabric_mustard", "fabric_green", "leather", "linen",
    "duvet", "stone", "books", "wicker", "rug_living", "rug_bedroom", "rug_runner", "bath_mat", "picture_hills",
    "picture_shapes", "picture_sea", "picture_leaves", "curtain", "soil", "tv_picture", "desktop", "mirror_view",
    "door_white", "tiles_splash", "parquet",
    "parquet_dark", "laminate", "carpet", "tiles_kitchen", "tiles_bath", "tiles_wall", "wallpaper")}
MATERIALS.update({
    "view": textured("view", glow=(0.35, 0.35, 0.35)),
    "white": plain(0.92, 0.92, 0.90), "cream": plain(0.90, 0.86, 0.78), "black": plain(0.06, 0.06, 0.07),
    "graphite": plain(0.18, 0.19, 0.20), "grey": plain(0.50, 0.51, 0.52), "steel": plain(0.68, 0.70, 0.72),
    "brass": plain(0.72, 0.56, 0.26), "red": plain(0.70, 0.16, 0.13), "teal": plain(0.10, 0.42, 0.44),
    "navy": plain(0.13, 0.19, 0.34), "sage": plain(0.55, 0.63, 0.53), "terracotta": plain(0.70, 0.38, 0.26),
    "leaf": plain(0.16, 0.40, 0.15), "leaf_light": plain(0.33, 0.55, 0.20), "bark": plain(0.36, 0.25, 0.16),
    "glass": plain(0.55, 0.68, 0.72), "ceramic": plain(0.95, 0.96, 0.96), "enamel": plain(0.95, 0.96, 0.96),
    "shade": plain(0.96, 0.90, 0.76, glow=(0.35, 0.30, 0.20)), "yellow": plain(0.88, 0.72, 0.22),
})
MATERIALS.update({                      # walls
    "wall_white": plain(0.95, 0.94, 0.91), "wall_linen": plain(0.93, 0.88, 0.79), "wall_sand": plain(0.94, 0.88, 0.77),
    "wall_sky": plain(0.74, 0.82, 0.86), "wall_sage": plain(0.78, 0.84, 0.75), "wall_teal": plain(0.36, 0.52, 0.54),
    "facade": plain(0.80, 0.77, 0.72), "skirting": plain(0.95, 0.95, 0.94), "ceiling": plain(0.97, 0.97, 0.96),
    "wall_top": plain(0.30, 0.31, 0.33),
})
