"""Every piece of furniture: its name, what it is, how it is made."""
import decoration
import kitchen_bath
import props
import seating
import storage
import tables


def _desk(name, about, width, wood, screens, laptop=False):
    model = tables.desk(name, about, width, wood)
    for y in screens:
        tables.on_desk(model, y, laptop)
    return model


def _cabinet(name, about, size, *look, things=True, **more):
    model = storage.cabinet(name, about, size, *look, **more)
    if things:
        storage.on_top(model, size[2], size[0])
    return model


FURNITURE = [
    (seating.sofa, "sofa", "Sofa for three with cushions", "fabric_blue", ("fabric_mustard", "linen"), 3, 2.15),
    (seating.sofa, "sofa_two", "Sofa for two with cushions", "fabric_grey", ("fabric_green",), 2, 1.60),
    (seating.sofa, "armchair", "Armchair", "fabric_mustard", (), 1, 0.92),
    (seating.dining_chair, "chair_dining", "Dining chair with a padded seat", "oak", "fabric_green"),
    (seating.office_chair, "chair_office", "Office chair on castors", "fabric_grey"),
    (seating.stool, "stool", "Three-legged stool", "birch"),
    (seating.bed_double, "bed_double", "Double bed with head board, pillows and duvet"),
    (tables.coffee_table, "table_coffee", "Coffee table with a shelf"),
    (tables.dining_table, "table_dining", "Dining table with slab ends and a stretcher"),
    (tables.round_table, "table_round", "Round table on one foot"),
    (_desk, "desk", "Desk with drawers and a screen", 1.60, "oak", (0.15,)),
    (_desk, "desk_small", "Small desk with drawers and a screen", 1.30, "birch", (0.10,)),
    (_desk, "desk_wide", "Wide desk with drawers, a screen and a laptop computer", 1.80, "birch", (0.10,), True),
    (tables.tv_board, "tv_board", "Low board with a television"),
    (storage.bookcase, "bookcase", "Open bookcase with books", 0.80, 2.02, 5, "oak"),
    (storage.bookcase, "bookcase_low", "Low open bookcase with books", 0.90, 1.10, 3, "walnut"),
    (storage.open_shelf, "shelf_open", "Open shelf on steel posts with jars and boxes", 0.90, 1.75, 5,
     storage.jars_and_boxes),
    (storage.open_shelf, "shelf_towels", "Shelf on steel posts with towels and baskets", 0.60, 1.55, 4, storage.towels),
    (_cabinet, "sideboard", "Sideboard with doors", (0.42, 1.60, 0.78), "walnut", "walnut", 4, 1),
    (_cabinet, "dresser", "Chest of six drawers", (0.45, 1.20, 0.82), "oak", "white", 2, 3),
    (_cabinet, "cabinet_shoes", "Narrow cabinet for shoes", (0.24, 0.90, 0.86), "oak", "white", 2, 2),
    (_cabinet, "cupboard", "Cupboard with doors", (0.45, 1.00, 1.45), "birch", "white", 2, 2),
    (_cabinet, "nightstand", "Nightstand with two drawers", (0.40, 0.45, 0.50), "oak", "white", 1, 2),
    (_cabinet, "filing_cabinet", "Drawers for files", (0.55, 0.42, 0.66), "white", "cream", 1, 3),
    (storage.wardrobe, "wardrobe", "Wardrobe with four doors", 2.00, 4, "white"),
    (kitchen_bath.kitchen_counter, "kitchen_counter", "Kitchen counter with sink, stove and oven"),
    (kitchen_bath.kitchen_wall_unit, "kitchen_wall_unit", "Wall cupboards with a cooker hood"),
    (kitchen_bath.fridge, "fridge", "Fridge with a freezer below"),
    (kitchen_bath.bathtub, "bathtub", "Bathtub"),
    (kitchen_bath.toilet, "toilet", "Toilet with a cistern"),
    (kitchen_bath.washbasin, "washbasin", "Washbasin on a cupboard, with a mirror"),
    (kitchen_bath.washing_machine, "washing_machine", "Washing machine"),
    (decoration.floor_lamp, "lamp_floor", "Floor lamp"),
    (decoration.table_lamp, "lamp_table", "Table lamp"),
    (decoration.pendant_lamp, "lamp_pendant", "Lamp that hangs from the ceiling"),
    (decoration.plant_tall, "plant_tall", "Rubber tree in a pot"),
    (decoration.plant_small, "plant_small", "Pot plant"),
    (decoration.rug, "rug_living", "Woven rug, flat", "rug_living", 2.40, 1.60),
    (decoration.rug, "rug_bedroom", "Square rug, flat", "rug_bedroom", 1.40, 1.40),
    (decoration.rug, "rug_runner", "Runner, flat", "rug_runner", 2.40, 0.80),
    (decoration.rug, "rug_bath", "Bath mat, flat", "bath_mat", 0.80, 0.50),
    (decoration.picture, "picture_hills", "Picture of hills", "picture_hills", 0.80, 0.60, "black"),
    (decoration.picture, "picture_shapes", "Picture of circles", "picture_shapes", 0.60, 0.80, "oak"),
    (decoration.picture, "picture_sea", "Picture of the sea", "picture_sea", 0.72, 0.54, "walnut"),
    (decoration.picture, "picture_leaves", "Picture of leaves", "picture_leaves", 0.42, 0.62, "oak"),
    (decoration.curtain, "curtain", "Gathered curtain"),
    (decoration.curtain_rod, "curtain_rod", "Curtain rod", 2.70),
    (decoration.window, "window_wide", "Window 1.80 x 1.30", 1.80, 1.30),
    (decoration.window, "window", "Window 1.20 x 1.20", 1.20, 1.20),
    (decoration.door_frame, "door_frame", "Door frame"),
    (decoration.door_leaf, "door_leaf", "Door leaf", "door_white", "white", 0.96, 2.03),
    (decoration.door_leaf, "door_entrance", "Entrance door", "oak", "walnut", 0.98, 2.045),
    (decoration.mirror, "mirror", "Mirror"),
    (decoration.coat_rack, "coat_rack", "Coat rack with coats and a bag"),
    (decoration.towel_rail, "towel_rail", "Towel rail with towels"),
    (decoration.basket, "basket_laundry", "Laundry basket", "wicker", 0.17, 0.21, 0.48, True),
    (decoration.basket, "bin_paper", "Waste paper bin", "graphite", 0.11, 0.14, 0.30, False),
    (seating.sofa, "sofa_plain", "Sofa for three", "fabric_blue", (), 3, 2.15),
    (seating.sofa, "sofa_grey", "Sofa for two", "fabric_grey", (), 2, 1.60),
    (seating.sofa, "armchair_green", "Green armchair", "fabric_green", (), 1, 0.92),
    (tables.coffee_table, "table_coffee_plain", "Coffee table with an empty shelf"),
    (tables.dining_table, "table_plain", "Table with slab ends and a stretcher"),
    (tables.desk, "desk_plain", "Desk with drawers", 1.60, "oak"),
    (tables.desk, "desk_long", "Long desk with drawers", 1.80, "birch"),
    (_cabinet, "sideboard_plain", "Sideboard, its top free", (0.42, 1.60, 0.78), "walnut", "walnut", 4, 1),
    (_cabinet, "dresser_plain", "Chest of six drawers, its top free", (0.45, 1.20, 0.82), "oak", "white", 2, 3),
    (storage.open_shelf, "shelf_free", "Open shelf on steel posts, boxes on its lowest board", 0.90, 1.45, 4,
     storage.boxes_below),
    (storage.bookcase, "bookcase_free", "Open bookcase, two boards of it free", 0.80, 1.66, 4, "birch"),
    (kitchen_bath.kitchen_counter, "counter_plain", "Kitchen counter with stove and oven, a hole for the sink"),
    (kitchen_bath.kitchen_sink, "kitchen_sink", "Sink for the kitchen counter"),
    (props.monitor, "monitor", "Computer screen", 0.56),
    (props.monitor, "monitor_wide", "Wide computer screen", 0.66),
    (props.keyboard, "keyboard", "Keyboard"),
    (props.mouse, "mouse", "Computer mouse"),
    (props.laptop, "laptop", "Open laptop computer"),
    (props.desk_lamp, "lamp_desk", "Desk lamp"),
    (props.printer, "printer", "Printer"),
    (props.telephone, "telephone", "Telephone"),
    (props.paper_tray, "paper_tray", "Trays for paper"),
    (props.pen_cup, "pen_cup", "Cup of pens"),
    (props.coffee_machine, "coffee_machine", "Espresso machine"),
    (props.kettle, "kettle", "Kettle"),
    (props.toaster, "toaster", "Toaster"),
    (props.knife_block, "knife_block", "Knife block"),
    (props.utensils, "utensils", "Jar of cooking spoons"),
    (props.dish_rack, "dish_rack", "Dish rack with plates"),
    (props.pot, "pot", "Cooking pot"),
    (props.vase, "vase", "Vase"),
    (props.book_pile, "book_pile", "Pile of books"),
    (props.cushion, "cushion_mustard", "Mustard cushion", "fabric_mustard"),
    (props.cushion, "cushion_linen", "Light cushion", "linen"),
    (props.cushion, "cushion_green", "Green cushion", "fabric_green"),
    (props.storage_box, "storage_box_sage", "Storage box", "sage"),
    (props.storage_box, "storage_box_terracotta", "Storage box", "terracotta"),
]
OPTIONS = {"cupboard": {"doors": True}, "sideboard": {"doors": True}, "nightstand": {"things": False},
           "filing_cabinet": {"things": False, "knob": "graphite", "leg": 0.05}, "cabinet_shoes": {"leg": 0.08},
           "sideboard_plain": {"doors": True, "things": False}, "dresser_plain": {"things": False},
           "table_coffee_plain": {"things": False}, "table_plain": {"things": False},
           "counter_plain": {"fitted": False}, "bookcase_free": {"empty": (1, 3)}}


def build_all():
    return [make(name, about, *rest, **OPTIONS.get(name, {})) for make, name, about, *rest in FURNITURE]
