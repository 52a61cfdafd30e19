"""flat_90: living room, kitchen, corridor, bedroom, study and bathroom. x to the east, y to the north."""
from building import DOOR, World

OUT, IN = 0.15, 0.12                                # wall thickness
WIDE, DEEP = 10.8, 8.7                              # inside of the outer walls
MID, SIDE, EAST, BACK = 4.46, 3.66, 6.26, 5.98      # middle lines of the inner walls


def hole(middle):
    return (middle - DOOR[0] / 2, middle + DOOR[0] / 2, 0.0, DOOR[1])


def window(middle, width, height=1.2, bottom=0.95):
    return (middle - width / 2, middle + width / 2, bottom, bottom + height)


def _shell(world):
    world.floor("living", -OUT, -OUT, EAST, MID, "parquet")
    world.floor("bedroom", EAST, -OUT, WIDE + OUT, MID, "parquet_dark")
    world.floor("kitchen", -OUT, MID, SIDE, DEEP + OUT, "tiles_kitchen")
    world.floor("corridor", SIDE, MID, WIDE + OUT, BACK, "parquet")
    world.floor("bathroom", SIDE, BACK, EAST, DEEP + OUT, "tiles_bath")
    world.floor("study", EAST, BACK, WIDE + OUT, DEEP + OUT, "carpet")
    world.ceiling(-OUT, -OUT, WIDE + OUT, DEEP + OUT)
    s, n, w, e = -OUT / 2, DEEP + OUT / 2, -OUT / 2, WIDE + OUT / 2
    world.wall("south_living", (0, s), (EAST, s), OUT, ("wall_sand", "facade"),
               [window(1.5, 1.2), window(4.2, 1.8, 1.3, 0.9)])
    world.wall("south_bedroom", (EAST, s), (WIDE, s), OUT, ("wall_sky", "facade"), [window(8.7, 1.8, 1.3, 0.9)])
    world.wall("north_kitchen", (0, n), (SIDE, n), OUT, ("facade", "wall_white"))
    world.wall("north_bathroom", (SIDE, n), (EAST, n), OUT, ("facade", "tiles_wall"))
    world.wall("north_study", (EAST, n), (WIDE, n), OUT, ("facade", "wall_sage"), [window(8.8, 1.8, 1.3, 0.9)])
    world.wall("west_living", (w, -OUT), (w, MID), OUT, ("wall_sand", "facade"), [window(2.2, 1.2)])
    world.wall("west_kitchen", (w, MID), (w, DEEP + OUT), OUT, ("wall_white", "facade"), [window(6.4, 1.2)])
    world.wall("east_bedroom", (e, -OUT), (e, MID), OUT, ("facade", "wallpaper"))
    world.wall("east_corridor", (e, MID), (e, BACK), OUT, ("facade", "wall_linen"), [hole(5.22)])
    world.wall("east_study", (e, BACK), (e, DEEP + OUT), OUT, ("facade", "wall_sage"))
    world.wall("living_kitchen", (0, MID), (SIDE, MID), IN, ("wall_white", "wall_teal"), [hole(1.3)])
    world.wall("living_corridor", (SIDE, MID), (EAST, MID), IN, ("wall_linen", "wall_teal"), [hole(5.0)])
    world.wall("bedroom_corridor", (EAST, MID), (WIDE, MID), IN, ("wall_linen", "wall_sky"), [hole(6.94)])
    world.wall("living_bedroom", (EAST, 0), (EAST, MID - IN / 2), IN, ("wall_sky", "wall_sand"))
    world.wall("kitchen_corridor", (SIDE, MID + IN / 2), (SIDE, BACK), IN, ("wall_linen", "wall_white"), [hole(5.22)])
    world.wall("kitchen_bathroom", (SIDE, BACK), (SIDE, DEEP), IN, ("tiles_wall", "wall_white"))
    world.wall("corridor_bathroom", (SIDE + IN / 2, BACK), (EAST, BACK), IN, ("tiles_wall", "wall_linen"), [hole(4.36)])
    world.wall("corridor_study", (EAST, BACK), (WIDE, BACK), IN, ("wall_sage", "wall_linen"), [hole(6.94)])
    world.wall("bathroom_study", (EAST, BACK + IN / 2), (EAST, DEEP), IN, ("wall_sage", "tiles_wall"))


def _openings(world):
    doors = ((1.3, MID, 90), (5.0, MID, 90), (6.94, MID, 90), (4.36, BACK, 90), (6.94, BACK, 90), (SIDE, 5.22, 0),
             (WIDE + OUT / 2, 5.22, 0))
    for x, y, turn in doors:
        world.door(x, y, turn)
    world.put("door_entrance", WIDE + 0.06, 5.22, 180)
    for x, y, turn in ((6.45, 3.90, 0), (6.45, 6.54, 180), (3.87, 6.54, 180)):     # bedroom, study, bathroom: open
        world.put("door_leaf", x, y, turn)
    world.put("window", 1.5, -OUT / 2, 90, 1.55)
    for x in (4.2, 8.7):
        world.put("window_wide", x, -OUT / 2, 90, 1.55)
        world.put("curtain_rod", x, 0, 90)
        for side in (-1.08, 1.08):
            world.put("curtain", x + side, 0, 90)
    world.put("window_wide", 8.8, DEEP + OUT / 2, -90, 1.55)
    world.put("window", -OUT / 2, 2.2, 0, 1.55)
    world.put("window", -OUT / 2, 6.4, 0, 1.55)


def _living(world):
    world.put("sofa", 4.2, 0.62, 90)
    world.put("armchair", 5.55, 2.15, 165)
    world.put("table_coffee", 4.15, 1.75, 90)
    world.put("rug_living", 4.15, 1.75, 0)
    world.put("tv_board", 3.25, 4.17, -90)
    world.put("bookcase", 6.04, 3.35, 180)
    world.put("lamp_floor", 5.75, 0.42)
    world.put("plant_tall", 2.75, 0.42)
    world.put("table_dining", 1.35, 2.15)
    for x, y, turn in ((0.80, 1.75, 0), (0.80, 2.55, 0), (1.90, 1.75, 180), (1.90, 2.55, 180)):
        world.put("chair_dining", x, y, turn)
    world.put("sideboard", 1.30, 0.24, 90)
    world.put("plant_small", 0.85, 0.24, z=0.78)
    world.put("lamp_pendant", 1.35, 2.15)
    world.put("picture_hills", 6.2, 1.55, 180, 1.55)
    world.put("picture_shapes", 0, 3.55, 0, 1.55)
    world.put("picture_sea", 0, 0.8, 0, 1.6)


def _kitchen(world):
    world.put("kitchen_counter", 1.435, DEEP - 0.315, -90)
    world.put("kitchen_wall_unit", 1.435, DEEP - 0.176, -90)
    world.put("fridge", 3.24, DEEP - 0.36, -90)
    world.put("table_round", 0.62, 6.35)
    world.put("chair_dining", 0.62, 5.80, 90)
    world.put("chair_dining", 0.66, 6.90, -90)
    world.put("lamp_pendant", 0.62, 6.35)
    world.put("shelf_open", 3.40, 6.75, 180)
    world.put("bin_paper", 3.42, 7.55, name="bin")
    world.put("picture_leaves", 0, 5.2, 0, 1.55)


def _corridor(world):
    world.put("cabinet_shoes", 9.35, MID + 0.185, 90)
    world.put("mirror", 9.35, MID + 0.06, 90, 1.65)
    world.put("coat_rack", 9.6, BACK - 0.06, -90)
    world.put("rug_runner", 5.9, 5.22, 0)
    world.put("picture_sea", 5.95, MID + 0.06, 90, 1.55)
    world.put("picture_leaves", 5.6, BACK - 0.06, -90, 1.55)


def _bedroom(world):
    world.put("bed_double", WIDE - 1.08, 2.0, 180)
    for y in (0.85, 3.15):
        world.put("nightstand", WIDE - 0.22, y, 180)
        world.put("lamp_table", WIDE - 0.22, y, z=0.5)
    world.put("wardrobe", EAST + IN / 2 + 0.31, 1.65, 0)
    world.put("dresser", 9.65, 4.16, -90)
    world.put("picture_shapes", 8.75, 4.4, -90, 1.6)
    world.put("stool", 6.60, 0.28)
    world.put("plant_small", 6.60, 0.28, z=0.45)
    world.put("armchair", 7.45, 0.75, 60)
    world.put("rug_bedroom", 8.0, 2.0, 0)
    world.put("basket_laundry", 10.52, 3.85)
    world.put("picture_hills", WIDE, 2.0, 180, 1.6)


def _study(world):
    world.put("desk", 8.8, DEEP - 0.40, -90)
    world.put("chair_office", 8.75, DEEP - 0.95, 100)
    world.put("desk_small", WIDE - 0.40, 7.05, 180)
    world.put("chair_office", WIDE - 0.95, 7.0, -10)
    for y in (7.47, 8.28):
        world.put("bookcase", EAST + IN / 2 + 0.16, y, 0)
    world.put("bookcase_low", 7.3, DEEP - 0.17, -90)
    world.put("plant_small", 7.45, DEEP - 0.16, z=1.10)
    world.put("filing_cabinet", 10.45, DEEP - 0.32, -90)
    world.put("bin_paper", 9.85, 8.50, name="bin")
    world.put("plant_tall", 10.35, 6.42)
    world.put("picture_shapes", 8.6, BACK + IN / 2, 90, 1.55)


def _bathroom(world):
    world.put("bathtub", 4.60, DEEP - 0.385, -90)
    world.put("washbasin", SIDE + IN / 2 + 0.25, 7.46, 0)
    world.put("toilet", EAST - IN / 2 - 0.345, 7.45, 180)
    world.put("washing_machine", EAST - IN / 2 - 0.31, 6.37, 180)
    world.put("shelf_towels", 5.83, DEEP - 0.20, -90)
    world.put("rug_bath", 4.75, 7.62, 0)
    world.put("towel_rail", 4.6, DEEP, -90)


def build():
    about = "A flat of 91 m2: living room, kitchen, corridor, bedroom, study, bathroom"
    world = World("flat_90", about, (6.3, 5.22, 180))
    for part in (_shell, _openings, _living, _kitchen, _corridor, _bedroom, _study, _bathroom):
        part(world)
    return world
