"""Makes ../textures, ../models and the worlds again: python3 sim_worlds/make/make.py [textures]
Without an argument the textures stay as they are (painting them takes a minute)."""
import os
import sys

import catalogue
import flat_90
import lab_30
import pictures
import rooms
import textures

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def main():
    if "textures" in sys.argv[1:]:
        textures.save_all(os.path.join(ROOT, "textures"), pictures.PICTURES)
    for model in catalogue.build_all():
        model.save(os.path.join(ROOT, "models", model.name))
        extent = " x ".join("%.2f" % (high - low) for low, high in model.extent())
        print("%-18s %5d triangles, %3d solids, %s m, open: %s" % (
            model.name, model.triangles(), len(model.solids), extent, " ".join(model.open_materials()) or "-"))
    for world in [flat_90.build(), lab_30.build()] + rooms.build_all():
        world.save(os.path.join(ROOT, world.name + ".sdf"))


main()
