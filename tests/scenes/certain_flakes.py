#!/usr/bin/env python3
"""Draws antialiased flakes; every pixel must be certain.

    certain_flakes.py PROGRAM

A ray that only just touches a ball is a hard case for a solver. Antialiasing sends many such rays, because it takes more samples where
neighbouring pixels differ, which is at outlines. With these depths and sizes two earlier solvers reported hits where there was no surface.
"""
import json
import os
import subprocess
import sys
import tempfile

FLAKE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'bench', 'scenes', 'flake.pov')
CASES = (2, 1300), (3, 400), (3, 900), (3, 1300), (4, 400)  # depth, pixels on a side


def complaint(program, depth, side, folder):
    ran = subprocess.run([program, 'render', FLAKE, '-D', f'Levels={depth}', '-s', f'{side}x{side}',
                          '-o', os.path.join(folder, 'flake.png'), '--format', 'json'], capture_output=True, text=True)
    if ran.returncode:
        return ran.stderr.strip()
    solver = json.loads(ran.stdout)['statistics']['solver']
    uncertain = {name: solver[name] for name in ('uncertified_steps', 'undecided_pixels', 'refuted_pixels')}
    return f'depth {depth}, {side}x{side}: {uncertain}' if any(uncertain.values()) else ''


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        complaints = [line for case in CASES if (line := complaint(program, *case, folder))]
    print('\n'.join(complaints + [f'{len(CASES)} flakes, {len(complaints)} with uncertain pixels']))
    return 1 if complaints else 0


if __name__ == '__main__':
    sys.exit(main())
