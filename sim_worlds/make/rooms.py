"""The five rooms of the data set for change detection. x to the east, y to the north; walls 0.15 thick outside of the
room from (0, 0) to (WIDE, DEEP). Permanent small things stand as models of their own, so that they can be nudged."""
from building import World
from flat_90 import hole, window

OUT = 0.15


def _room(name, about, start, wide, deep, surface, colours, door, windows=()):
    """A floor, four walls (colours: south, north, west, east), a door in the east wall, windows in the south one."""
    world = World(name, about, start)
    world.floor(name, -OUT, -OUT, wide + OUT, deep + OUT, surface)
    world.ceiling(-OUT, -OUT, wide + OUT, deep + OUT)
    s, n, w, e = -OUT / 2, deep + OUT / 2, -OUT / 2, wide + OUT / 2
    south, north, west, east = colours
    world.wall("south", (0, s), (wide, s), OUT, (south, "facade"), [window(x, 1.8, 1.3, 0.9) for x in windows])
    world.wall("north", (0, n), (wide, n), OUT, ("facade", north))
    world.wall("west", (w, -OUT), (w, deep + OUT), OUT, (west, "facade"))
    world.wall("east", (e, -OUT), (e, deep + OUT), OUT, ("facade", east), [hole(door)])
    world.door(e, door, 0)
    world.put("door_entrance", wide + 0.06, door, 180)
    for x in windows:
        world.put("window_wide", x, s, 90, 1.55)
    return world


def _on(world, x, y, z, degrees, *things):
    """Things that stand at that place of a piece of furniture turned by `degrees` (0 or a quarter turn), top at z:
    (kind, to its front, to its left, own turn)."""
    cos, sin = {0: (1, 0), 90: (0, 1), 180: (-1, 0), -90: (0, -1)}[degrees]
    for kind, front, left, turn in things:
        world.put(kind, x + cos * front - sin * left, y + sin * front + cos * left, degrees + turn, z)


def big_room():
    wide, deep = 7.4, 5.6
    world = _room("big_room", "A big room of 41 m2: sofas, a long table, a desk, shelves, a sideboard", (4.4, 2.7, 180),
                  wide, deep, "laminate", ("wall_white", "wall_linen", "wall_teal", "wall_white"), 4.75, (1.9, 5.3))
    world.put("sofa_plain", 0.50, 2.35, 0)
    _on(world, 0.50, 2.35, 0.44, 0, ("cushion_mustard", -0.06, 0.62, -14), ("cushion_linen", -0.06, -0.64, 12))
    world.put("armchair_green", 1.55, 0.72, 75)
    world.put("table_coffee_plain", 1.75, 2.35, 0)
    world.put("rug_living", 1.60, 2.35, 90)
    _on(world, 1.75, 2.35, 0.42, 0, ("vase", -0.15, 0.38, 0), ("book_pile", 0.05, -0.36, 30))
    world.put("lamp_floor", 0.36, 0.42)
    world.put("plant_tall", 0.42, 4.00)
    world.put("sideboard_plain", 1.55, deep - 0.24, -90)
    _on(world, 1.55, deep - 0.24, 0.78, -90, ("lamp_table", -0.03, 0.62, 0), ("plant_small", -0.03, -0.60, 40))
    world.put("shelf_free", 3.05, deep - 0.20, -90)
    world.put("bookcase_free", 4.05, deep - 0.16, -90)
    world.put("table_plain", 4.35, 1.25, 90)
    for x, y, turn in ((3.90, 2.00, -90), (4.85, 1.98, -84), (3.95, 0.52, 90), (4.80, 0.50, 96)):
        world.put("chair_dining", x, y, turn)
    _on(world, 4.35, 1.25, 0.75, 90, ("vase", 0.05, 0.05, 0))
    world.put("desk_plain", wide - 0.40, 1.75, 180)
    world.put("chair_office", wide - 1.02, 1.80, 8)
    _on(world, wide - 0.40, 1.75, 0.74, 180, ("monitor", -0.20, 0.10, 6), ("keyboard", 0.11, 0.10, 0),
        ("mouse", 0.12, -0.22, 10), ("lamp_desk", -0.20, 0.62, -40), ("paper_tray", -0.15, -0.58, 0))
    world.put("filing_cabinet", wide - 0.30, 0.45, 180)
    world.put("printer", wide - 0.32, 0.45, 180, 0.66)
    world.put("bin_paper", wide - 0.25, 2.80, name="bin")
    world.put("dresser_plain", 5.60, deep - 0.24, -90)
    world.put("storage_box_sage", 5.25, deep - 0.24, -90, 0.82)
    for kind, x, y, turn in (("picture_hills", 0, 2.35, 0), ("picture_sea", 1.55, deep, -90),
                             ("picture_shapes", 5.60, deep, -90), ("picture_leaves", wide, 3.10, 180)):
        world.put(kind, x, y, turn, 1.6)
    return world


def small_room():
    wide, deep = 4.6, 4.0
    world = _room("small_room", "A small room of 18 m2: a bed, a table, a dresser, shelves", (2.45, 1.85, 0),
                  wide, deep, "parquet", ("wall_sage", "wall_white", "wall_linen", "wall_white"), 0.75, (2.1,))
    world.put("sofa_grey", 0.50, 2.75, 0)
    _on(world, 0.50, 2.75, 0.44, 0, ("cushion_green", -0.06, 0.36, -10))
    world.put("table_round", 1.75, 2.75)
    world.put("vase", 1.62, 2.80, 0, 0.74)
    world.put("stool", 2.12, 3.48, 20)
    world.put("shelf_free", 0.22, 0.95, 0)
    world.put("storage_box_terracotta", 0.20, 1.12, 0, 0.569)
    world.put("dresser_plain", 3.10, deep - 0.24, -90)
    _on(world, 3.10, deep - 0.24, 0.82, -90, ("lamp_table", -0.04, 0.44, 0), ("book_pile", 0.0, -0.42, 70))
    world.put("plant_tall", wide - 0.42, deep - 0.42, 30)
    world.put("desk_plain", 1.65, 0.40, 90)
    world.put("chair_office", 1.62, 0.98, -96)
    _on(world, 1.65, 0.40, 0.74, 90, ("laptop", -0.02, 0.05, -8), ("lamp_desk", -0.22, -0.55, 40),
        ("pen_cup", -0.20, 0.55, 0))
    world.put("cupboard", wide - 0.24, 2.35, 180)
    world.put("bin_paper", 2.75, 0.24, name="bin")
    world.put("basket_laundry", wide - 0.32, 1.55, name="basket")
    world.put("picture_sea", 0, 2.75, 0, 1.6)
    world.put("picture_leaves", 3.10, deep, -90, 1.6)
    return world


def living_area():
    wide, deep = 5.0, 4.4
    world = _room("living_area", "A living area of 22 m2: sofa, armchairs, coffee table, television, bookcase",
                  (3.55, 2.20, 180), wide, deep, "parquet_dark",
                  ("wall_sand", "wall_white", "wall_sky", "wall_sand"), 3.80, (2.0,))
    world.put("sofa_plain", 0.50, 2.20, 0)
    _on(world, 0.50, 2.20, 0.44, 0, ("cushion_mustard", -0.06, 0.64, -12), ("cushion_linen", -0.05, 0.20, -4),
        ("cushion_green", -0.06, -0.66, 14))
    world.put("table_coffee_plain", 2.05, 2.35, 0)  # the robot passes between it, the sofa and the first armchair
    world.put("rug_living", 1.90, 2.20, 90)
    _on(world, 2.05, 2.35, 0.42, 0, ("book_pile", -0.05, 0.36, 15))
    world.put("armchair_green", 2.50, 0.53, 95)
    world.put("armchair_green", 2.40, deep - 0.55, -100)
    world.put("lamp_floor", 0.38, 0.62)
    world.put("plant_tall", 0.44, deep - 0.46, 50)
    world.put("tv_board", wide - 0.24, 1.95, 180)
    world.put("bookcase_free", 3.55, deep - 0.16, -90)
    world.put("table_round", 3.55, 0.55)
    _on(world, 3.55, 0.55, 0.74, 0, ("plant_small", 0.08, -0.08, 0))
    for kind, x, y, turn in (("picture_hills", 0, 1.60, 0), ("picture_shapes", 0, 2.80, 0),
                             ("picture_leaves", 2.3, deep, -90)):
        world.put(kind, x, y, turn, 1.6)
    return world


def office_desk():
    wide, deep = 4.2, 3.6
    world = _room("office_desk", "An office of 15 m2: two desks with screens, shelves, drawers", (2.35, 1.95, 90),
                  wide, deep, "carpet", ("wall_white", "wall_sky", "wall_white", "wall_linen"), 0.85, (1.9,))
    world.put("desk_long", 1.45, deep - 0.40, -90)
    world.put("chair_office", 1.42, deep - 1.05, 84)
    _on(world, 1.45, deep - 0.40, 0.74, -90, ("monitor_wide", -0.19, 0.02, 4), ("monitor", -0.16, 0.66, -24),
        ("keyboard", 0.13, 0.02, 0), ("mouse", 0.14, -0.31, 8), ("telephone", -0.10, -0.52, 20),
        ("pen_cup", -0.24, -0.36, 0))
    world.put("desk_plain", 0.40, 1.25, 0)
    world.put("chair_office", 1.05, 1.22, 175)
    _on(world, 0.40, 1.25, 0.74, 0, ("laptop", 0.02, 0.10, 5), ("lamp_desk", -0.22, 0.62, -30),
        ("paper_tray", -0.17, -0.58, 0))
    world.put("shelf_free", 3.05, deep - 0.20, -90)
    world.put("filing_cabinet", wide - 0.29, 2.55, 180)
    world.put("printer", wide - 0.31, 2.55, 180, 0.66)
    world.put("bookcase_free", wide - 0.16, 1.90, 180)
    world.put("bin_paper", 0.26, 2.62, name="bin")
    world.put("plant_tall", wide - 0.42, deep - 0.44, 10)
    world.put("picture_shapes", 0, 1.25, 0, 1.6)
    world.put("picture_sea", 1.45, deep, -90, 1.65)
    return world


def kitchen_counter():
    wide, deep = 4.4, 3.6
    world = _room("kitchen_counter", "A kitchen of 16 m2: counter with coffee machine and sink, fridge, a small table",
                  (2.20, 1.80, 90), wide, deep, "tiles_kitchen",
                  ("wall_white", "wall_sage", "wall_white", "wall_sand"), 1.20, (2.0,))
    x, y = 1.435, deep - 0.315
    world.put("counter_plain", x, y, -90)
    world.put("kitchen_sink", x, y, -90)
    world.put("kitchen_wall_unit", x, deep - 0.176, -90)
    _on(world, x, y, 0.905, -90, ("coffee_machine", -0.08, -1.20, 6), ("toaster", -0.16, -0.18, 0),
        ("kettle", -0.14, 0.18, -60), ("dish_rack", -0.04, 1.18, 0), ("utensils", -0.22, -0.92, 0))
    world.put("pot", x - 0.66 + 0.13, y + 0.11, 30, 0.914)
    world.put("fridge", 3.24, deep - 0.36, -90)
    world.put("sideboard_plain", 0.24, 1.55, 0)
    _on(world, 0.24, 1.55, 0.78, 0, ("knife_block", -0.06, 0.62, 20), ("plant_small", -0.02, -0.58, 0))
    world.put("table_round", 2.00, 0.62)
    world.put("vase", 2.12, 0.55, 0, 0.74)
    world.put("chair_dining", 2.62, 0.66, 186)
    world.put("chair_dining", 1.36, 0.58, -6)
    world.put("lamp_pendant", 2.00, 0.62)
    world.put("shelf_free", wide - 0.20, 2.55, 180)
    world.put("bin_paper", wide - 0.25, 3.30, name="bin")
    world.put("picture_leaves", 0, 1.55, 0, 1.6)
    world.put("picture_hills", wide, 0.32, 180, 1.6)
    return world


def build_all():
    return [big_room(), small_room(), living_area(), office_desk(), kitchen_counter()]
