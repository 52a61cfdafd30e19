"""lab_30: one room of 30 m2, half office, half living room. x to the east, y to the north."""
from building import World
from flat_90 import hole, window

OUT = 0.15
WIDE, DEEP = 6.5, 4.65


def build():
    world = World("lab_30", "A living lab of 30 m2: sofa corner, two desks, cupboard, shelves", (3.2, 2.4, 0))
    world.floor("lab", -OUT, -OUT, WIDE + OUT, DEEP + OUT, "laminate")
    world.ceiling(-OUT, -OUT, WIDE + OUT, DEEP + OUT)
    s, n, w, e = -OUT / 2, DEEP + OUT / 2, -OUT / 2, WIDE + OUT / 2
    world.wall("south", (0, s), (WIDE, s), OUT, ("wall_white", "facade"),
               [window(1.6, 1.8, 1.3, 0.9), window(4.5, 1.8, 1.3, 0.9)])
    world.wall("north", (0, n), (WIDE, n), OUT, ("facade", "wall_white"))
    world.wall("west", (w, -OUT), (w, DEEP + OUT), OUT, ("wall_teal", "facade"))
    world.wall("east", (e, -OUT), (e, DEEP + OUT), OUT, ("facade", "wall_white"), [hole(3.4)])
    world.door(e, 3.4, 0)
    world.put("door_entrance", WIDE + 0.06, 3.4, 180)
    for x in (1.6, 4.5):
        world.put("window_wide", x, s, 90, 1.55)
    world.put("sofa_two", 0.50, 1.75, 0)
    world.put("armchair", 1.45, 0.62, 80)
    world.put("table_coffee", 1.60, 1.85, 0)
    world.put("rug_living", 1.45, 1.75, 90)
    world.put("lamp_floor", 0.33, 2.92)
    world.put("dresser", 0.24, 3.85, 0)
    world.put("picture_sea", 5.35, DEEP, -90, 1.6)
    world.put("picture_leaves", WIDE, 2.5, 180, 1.6)
    world.put("plant_tall", 0.45, 0.38)
    world.put("picture_shapes", 0, 1.2, 0, 1.6)
    world.put("picture_hills", 0, 2.2, 0, 1.6)
    world.put("desk_wide", 4.45, 0.40, 90)
    world.put("chair_office", 4.5, 0.95, -85)
    world.put("desk_small", 4.05, DEEP - 0.40, -90)
    world.put("chair_office", 4.0, DEEP - 0.95, 95)
    world.put("bookcase", 1.55, DEEP - 0.16, -90)
    world.put("shelf_open", 2.55, DEEP - 0.20, -90)
    world.put("cupboard", WIDE - 0.24, 1.55, 180)
    world.put("filing_cabinet", 5.65, 0.32, 90)
    world.put("bin_paper", 3.15, 0.25, name="bin")
    world.put("plant_small", WIDE - 0.24, 1.30, z=1.45)
    return world
