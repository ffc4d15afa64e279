#!/usr/bin/env python3
"""What effects cost scenes that do not call for them: instructions of several programs for ten plain scenes, by callgrind.

    bench/free_effects.py build/release/bin/isl build/plain/bin/isl …

The first program is compared with the others: builds without some effects (cmake -DISL_WITHOUT_EFFECTS="surfaces;light;air;cameras"),
or one from before a change. Each is run on one thread, with one ray a pixel; instructions do not depend on what else the machine does.
Ends with 1 if a program needs more than 0.5 % more or less than the first for a scene. Needs valgrind.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
# They call for colours, light, highlights and shadows alone.
SCENES = [
    "scenes/features/blob_kernels.isl", "scenes/features/blob_parts.isl", "scenes/features/blob_skeletons.isl",
    "scenes/features/convolution.isl", "scenes/features/csg.isl", "scenes/features/instances.isl",
    "scenes/features/patterns.isl", "scenes/features/solids.isl", "scenes/gallery/coral_tree.isl",
    "scenes/paper/sphereflake.isl",
]
BOUND = 0.005
REPEATS = 3


def instructions(program, scene, size, folder):
    result = subprocess.run(
        ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/counts", program, "render", scene, "-s", size, "--samples", "1",
         "--threads", "1", "-q", "-o", f"{folder}/picture.png"],
        capture_output=True, text=True, cwd=ROOT)
    counted = re.search(r"Collected *: *(\d+)", result.stderr)
    if result.returncode or not counted:
        sys.exit(f"free_effects.py: {program} {scene}: {result.stderr.strip()[-400:]}")
    return int(counted.group(1))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+", type=pathlib.Path)
    parser.add_argument("-s", "--size", default="100x75", help="of the pictures")
    options = parser.parse_args()
    if not shutil.which("valgrind"):
        sys.exit("free_effects.py: valgrind is missing (package valgrind)")
    programs = [str(program.resolve()) for program in options.programs]
    worst = 0.0
    with tempfile.TemporaryDirectory() as folder:
        for scene in SCENES:
            counts = [instructions(program, scene, options.size, folder) for program in programs]
            # Now and then a start takes a million more, for what the system does; the least of several runs is the program's own.
            for _ in range(REPEATS):
                if max(counts) <= (1 + BOUND) * min(counts):
                    break
                counts = [min(count, instructions(program, scene, options.size, folder)) for count, program in zip(counts, programs)]
            shares = [count / counts[0] - 1 for count in counts[1:]]
            worst = max([worst, *map(abs, shares)])
            print(f"{scene:36} {counts[0] / 1e6:10.1f} M " + " ".join(f"{100 * share:+7.2f} %" for share in shares), flush=True)
    print(f"greatest difference {100 * worst:.2f} %, wanted at most {100 * BOUND:.1f} %")
    return worst > BOUND


if __name__ == "__main__":
    sys.exit(main())
