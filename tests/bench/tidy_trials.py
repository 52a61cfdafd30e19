#!/usr/bin/env python3
"""Runs `amiss tidy` over worlds, numbers of objects and seeds, and prints what the runs are judged by.

    tests/bench/tidy_trials.py --amiss build/release/apps/amiss/amiss --out DIR [-j 2] [--seeds 101-110]
        [--worlds flat_90,lab_30] [--objects 1,3,5,7] [-- further arguments of tidy]

Each trial is a process of its own with one thread; finished ones are kept and not run again.
"""
import argparse
import concurrent.futures
import json
import pathlib
import shutil
import subprocess
import sys


def numbers(text):
    low, _, high = text.partition("-")
    return range(int(low), int(high or low) + 1)


def run(args, world, objects, seed):
    folder = args.out / f"{world}-{objects}-{seed}"
    report = folder / "report.json"
    if not report.exists():
        shutil.rmtree(folder, ignore_errors=True)
        command = [args.amiss, "tidy", "--world", world, "--objects", str(objects), "--seed", str(seed), "--quiet",
                   "--threads", "1", "--out", str(folder), *args.further]
        process = subprocess.run(command, capture_output=True, text=True, check=False)
        if not report.exists():
            return {"trial": folder.name, "failure": process.stderr.strip() or f"status {process.returncode}"}
    return {"trial": folder.name, "objects": objects, **json.loads(report.read_text())}


def summary(label, runs):
    whole = [r for r in runs if "failure" not in r]
    if not whole:
        return
    placed = sum(r["objects_placed"] for r in whole)
    detected = sum(r["regions"]["detected"] for r in whole)
    errors = [o["error_m"] for r in whole for o in r["objects"] if o["found"]]
    print(f"{label:<12} runs {len(runs):3}   all found {sum(r['objects_found'] == r['objects_placed'] for r in whole) / len(runs):6.1%}"
          f"   false regions {sum(r['regions']['false'] for r in whole) / max(1, detected):5.1%}"
          f"   segmentations/object {sum(r['segmentation_actions'] for r in whole) / placed:4.2f}"
          f"   collisions {sum(r['collisions'] for r in whole)}"
          f"   worst error {max(errors, default=0):.3f} m"
          f"   worst pose rmse {max(r['localization']['rmse_m'] for r in whole):.3f} m"
          f" {max(r['localization']['rmse_rad'] for r in whole) * 57.2958:.2f} deg"
          f"   simulated {sum(r['time']['simulated_s'] for r in whole) / len(whole):5.0f} s"
          f"   x real time {sum(r['time']['simulated_s'] for r in whole) / sum(r['time']['wall_s'] for r in whole):4.1f}"
          f"   difference {sum(r['differencing']['mean_ms'] for r in whole) / len(whole):.2f} ms")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--amiss", default="build/release/apps/amiss/amiss")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("-j", type=int, default=2)
    parser.add_argument("--seeds", type=numbers, default=range(101, 111))
    parser.add_argument("--worlds", default="flat_90,lab_30")
    parser.add_argument("--objects", default="1,3,5,7")
    parser.add_argument("further", nargs="*")
    args = parser.parse_args()
    cells = [(w, int(n)) for w in args.worlds.split(",") for n in args.objects.split(",")]
    with concurrent.futures.ThreadPoolExecutor(args.j) as pool:
        jobs = {cell: [pool.submit(run, args, *cell, seed) for seed in args.seeds] for cell in cells}
        results = {cell: [job.result() for job in cell_jobs] for cell, cell_jobs in jobs.items()}
    for (world, objects), runs in results.items():
        summary(f"{world} {objects}", runs)
    everything = [r for runs in results.values() for r in runs]
    summary("all", everything)
    for r in everything:
        if "failure" in r:
            print(f"failed: {r['trial']}: {r['failure']}")
            continue
        missed = [o["name"] for o in r["objects"] if not o["found"]]
        if missed or r["collisions"] or r["regions"]["false"]:
            print(f"{r['trial']}: {r['outcome']}, missed {missed}, {r['collisions']} collisions,"
                  f" {r['regions']['false']} false regions, {r['segmentation_actions']} segmentations")
    return 0


if __name__ == "__main__":
    sys.exit(main())
