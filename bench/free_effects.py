#!/usr/bin/env python3
"""What effects cost scenes that do not call for them, by callgrind: which of their hooks run, and the instructions of several programs.

    bench/free_effects.py build/release/bin/isl [build/plain/bin/isl …]

Hooks are the functions that work for one effect alone: the stages of its record (renderer/effects/), which are found by reading the
sources, and those of OTHER_HOOKS. The first program, which must not be stripped, draws plain scenes and others that call for
every effect with hooks, and the calls are counted. The table has for each effect the calls in the scenes that call for it, which
must not be 0, because then no call would ever be noticed, and the calls in all other scenes, which must be.

Then the first program is compared with the others, if there are any: builds without some effects
(cmake -DISL_WITHOUT_EFFECTS="surfaces;light;air;cameras"), or one from before a change. Each draws ten plain scenes on one thread, with
one ray a pixel; instructions do not depend on what else the machine does.
Ends with 1 if a hook runs where nothing calls for it, or a program needs more than 0.5 % more or less than the first for a scene.
Needs valgrind and nm (binutils).
"""
import argparse
import collections
import json
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

# Functions outside of renderer/effects/ that work for one effect alone, as regular expressions. Effects that are neither here nor have
# stages are a flag that other code tests: these have nothing that could be called.
OTHER_HOOKS = {
    "area_light": [r"AreaShadows::push\(", r"AreaShadows::ask", r"AreaShadows::finish", r"Integrator::push_area",
                   r"Integrator::throw_back_from_area"],
    "camera_normal": [r"Sampler::bend"],
    "images": [r"ImagePlacing::", r"\bdecode_texels\("],
    "normal": [r"Patterns::bent", r"PointTextures::add_normal"],
    "projected_through": [r"LightWindows::LightWindows", r"LightWindows::trim"],
    "shadows": [r"Tracer::occlusions", r"ShadowQueue::grow"],
    "transparency": [r"ShadowFilter::run", r"ShadowFilter::share_at"],
}
# The bumps of a camera are bent by the same functions, and rays for light from around wait in the same queue.
SHARED = {"normal": {"camera_normal"}, "shadows": {"ambient_occlusion", "bounce_light", "sky_light"}}
# Of bench/pairs/. With the scenes of soft light and the run below they call for every effect with hooks.
CALLING = [
    "air_fog_dims_light", "air_fog_in_mirror", "air_rainbow", "air_sky_clouds", "camera_fisheye", "clear_shadow", "finish_crand",
    "finish_emission", "finish_irid", "finish_metallic", "glass_dispersion", "image_planar", "light_area", "light_area_adaptive",
    "light_cylinder", "light_fade", "light_group", "light_parallel", "light_projected_through", "light_shadowless", "light_spot",
    "mirror_exponent", "mirror_fresnel", "normal_bump_map", "normal_bumps", "normal_camera", "object_double_illuminate",
    "object_interior_texture", "object_no_image", "object_no_reflection",
]
SOFT = ["scenes/features/occlusion.isl", "scenes/features/soft_light.isl"]
# The only effect of this run is that of plain colours.
PLAIN = "scenes/features/solids.isl", "--quality", "0"
INCLUDES = "/usr/share/povray-3.7/include"


def hooks_of_effects(program):
    """For each effect with hooks a regular expression of them; the program has them all."""
    found = dict(OTHER_HOOKS)
    for file in sorted((ROOT / "renderer/effects").glob("*.cpp")):
        text = file.read_text()
        stages = re.findall(r"class (\w+) final : public Stage<", text)
        names = re.findall(r'\.name = "(\w+)"', text)
        if stages and len(names) != 1:
            sys.exit(f"free_effects.py: {file}: stages of {len(names)} effects")
        if stages:
            found[names[0]] = [rf"\b{stage}::run\(" for stage in stages] + found.get(names[0], [])
    symbols = subprocess.run(["nm", "-C", program], capture_output=True, text=True, check=True).stdout
    for effect, hooks in found.items():
        for hook in hooks:
            if not re.search(hook, symbols):
                sys.exit(f"free_effects.py: {program} has no function {hook} of {effect}")
    return {effect: re.compile("|".join(hooks)) for effect, hooks in found.items()}


def calls(program, scene, folder, *options):
    """How often each function was called, and the effects that the scene calls for."""
    counts, stats = f"{folder}/calls", f"{folder}/stats.json"
    result = subprocess.run(
        ["valgrind", "--tool=callgrind", f"--callgrind-out-file={counts}", program, "render", scene, "-s", "40x30", "--samples", "1",
         "--threads", "1", "-q", "-o", f"{folder}/picture.png", "--stats", stats, "-I", INCLUDES, *options],
        capture_output=True, text=True, cwd=ROOT)
    if result.returncode:
        sys.exit(f"free_effects.py: {program} {scene}: {result.stderr.strip()[-400:]}")
    names, called, callee = {}, collections.Counter(), ""
    with open(counts, encoding="utf8") as stream:
        for line in stream:
            # "fn=(number) name", later "fn=(number)", and likewise the called functions; then "calls=count position".
            match = re.match(r"(c?fn)=\((\d+)\)(?: (.*))?", line)
            if match:
                if match[3]:
                    names[match[2]] = match[3]
                callee = match[2]
            elif line.startswith("calls="):
                called[callee] += int(line[6:].split()[0])
    with open(stats, encoding="utf8") as stream:
        effects = json.load(stream)["effects"]["called_for"]
    return {names[number]: count for number, count in called.items()}, set(effects)


def count_hooks(program, folder):
    """Prints the table of hooks; false if one runs where nothing calls for it, or one was never seen to run."""
    hooks = hooks_of_effects(program)
    runs = [(scene,) for scene in SCENES + [f"bench/pairs/{name}.pov" for name in CALLING] + SOFT] + [PLAIN]
    used, unused = collections.defaultdict(list), collections.defaultdict(list)
    for scene, *options in runs:
        functions, called_for = calls(program, scene, folder, *options)
        for effect, pattern in hooks.items():
            count = sum(n for function, n in functions.items() if pattern.search(function))
            asked = effect in called_for or SHARED.get(effect, set()) & called_for
            (used if asked else unused)[effect].append((count, scene))
    print(f"{'effect':20} {'called for by':>14} {'calls':>10} {'not by':>8} {'calls':>10}")
    is_free = True
    for effect in sorted(hooks):
        seen, stray = sum(count for count, _ in used[effect]), sum(count for count, _ in unused[effect])
        where = next((scene for count, scene in unused[effect] if count), "")
        note = f"  runs in {where}" if stray else ("" if seen else "  never seen to run")
        is_free &= not note
        print(f"{effect:20} {len(used[effect]):>7} scenes {seen:>10} {len(unused[effect]):>8} {stray:>10}{note}", flush=True)
    return is_free


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
        is_free = count_hooks(programs[0], folder)
        for scene in SCENES if len(programs) > 1 else []:
            counts = [instructions(program, scene, options.size, folder) for program in programs]
            # Now and then a start takes a million more, for what the system does; the least of several runs is the program's own.
            for _ in range(REPEATS):
                if max(counts) <= (1 + BOUND) * min(counts):
                    break
                counts = [min(count, instructions(program, scene, options.size, folder)) for count, program in zip(counts, programs)]
            shares = [count / counts[0] - 1 for count in counts[1:]]
            worst = max([worst, *map(abs, shares)])
            print(f"{scene:36} {counts[0] / 1e6:10.1f} M " + " ".join(f"{100 * share:+7.2f} %" for share in shares), flush=True)
    if len(programs) > 1:
        print(f"greatest difference {100 * worst:.2f} %, wanted at most {100 * BOUND:.1f} %")
    return worst > BOUND or not is_free


if __name__ == "__main__":
    sys.exit(main())
