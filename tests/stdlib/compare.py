#!/usr/bin/env python3
"""Runs the scenes beside this file through isl and POV-Ray and compares what they print, word by word.

usage: compare.py ISL [SCENE.pov ...]

Each program includes its own library of that name. Numbers may differ by 2e-5: POV-Ray keeps colours in single
precision. The exit code is 77 (skipped) if povray is not installed.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

TOLERANCE = 2e-5
SKIPPED = 77


def said_by_isl(program, scene):
    run = subprocess.run([program, "check", "--lenient", scene], capture_output=True, text=True)
    lines = run.stderr.splitlines()
    errors = [line for line in lines if "error:" in line]
    # The output of #debug comes before the messages, and these come before the summary.
    end = next((i for i, line in enumerate(lines) if "warning:" in line or "error:" in line), len(lines))
    return " ".join(lines[:end]).split(), errors


def said_by_povray(scene):
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder) / "debug.txt"
        run = subprocess.run(
            ["povray", f"+I{scene}", "-D", "+W8", "+H8", "-F", "-GA", f"+GD{log.name}"], capture_output=True,
            text=True, cwd=folder)
        words = log.read_text().split() if log.exists() else []
        return words, [] if run.returncode == 0 else run.stderr.splitlines()[-4:]


def same(ours, theirs):
    if ours == theirs:
        return True
    try:
        return abs(float(ours) - float(theirs)) <= TOLERANCE
    except ValueError:
        return False


def compare(program, scene):
    ours, our_errors = said_by_isl(program, scene)
    theirs, their_errors = said_by_povray(scene)
    problems = our_errors + their_errors
    if len(ours) != len(theirs):
        problems.append(f"found {len(ours)} words, POV-Ray prints {len(theirs)}")
    if not theirs:
        problems.append("POV-Ray printed nothing")
    label = "the start"
    for i, (our, their) in enumerate(zip(ours, theirs)):
        if not same(our, their):
            problems.append(f"after {label}: found {our}, POV-Ray prints {their}")
            break
        if their[0].isalpha():
            label = f"{their} (word {i})"
    print(f"{scene.name}: {len(theirs)} words, {'same' if not problems else 'DIFFERENT'}")
    for problem in problems:
        print("  " + problem)
    return not problems


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if shutil.which("povray") is None:
        print("povray is not installed: skipped")
        sys.exit(SKIPPED)
    here = pathlib.Path(__file__).resolve().parent
    scenes = [pathlib.Path(name).resolve() for name in sys.argv[2:]] or sorted(here.glob("*.pov"))
    sys.exit(0 if all([compare(sys.argv[1], scene) for scene in scenes]) else 1)


if __name__ == "__main__":
    main()
