#!/usr/bin/env python3
"""Makes the objects of this folder: for each a model.sdf, a mesh with its materials, labels, and where its shape asks
for it a hull for the physics. Run it without arguments after a change in make/; the outputs are kept beside it.
Needs nothing but Python 3; the same files come out on every machine."""
import pathlib
import sys

sys.dont_write_bytecode = True
from make import boxes, food, kitchen, model, tools, toys  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
MOST_TRIANGLES = 3000


def table(things):
    rows = ["| name | x, y, z [m] | mass [kg] | triangles |", "|---|---|---|---|"]
    for thing in things:
        size = ", ".join(f"{s:.3f}" for s in thing.size())
        rows.append(f"| {thing.name} | {size} | {model.number(thing.mass)} | {len(thing.mesh.faces)} |")
    return "\n".join(rows)


def main():
    things = [thing.standing() for group in (boxes, kitchen, food, tools, toys) for thing in group.things()]
    things.sort(key=lambda thing: thing.name)
    for thing in things:
        if len(thing.mesh.faces) > MOST_TRIANGLES:
            raise SystemExit(f"{thing.name}: {len(thing.mesh.faces)} triangles, {MOST_TRIANGLES} are allowed")
        missing = {material for material, _ in thing.mesh.faces} - set(thing.paints)
        if missing:
            raise SystemExit(f"{thing.name}: no paint for {sorted(missing)}")
        model.save(thing, HERE / thing.name)
    readme = HERE / "README.md"
    head = readme.read_text().split("<!-- table -->")[0]
    readme.write_text(head + "<!-- table -->\n" + table(things) + "\n")


if __name__ == "__main__":
    main()
