#!/usr/bin/env python3
"""Renders every scene of scenes/ small, with one sample a pixel; none may complain.

    render_all.py PROGRAM
"""
import concurrent.futures
import glob
import os
import subprocess
import sys
import tempfile

SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'scenes')
# Scenes for square pictures, and what others include.
EXPECTED = 'the picture is stretched', 'holds no object'


def complaint(program, scene, folder):
    picture = os.path.join(folder, os.path.relpath(scene, SCENES).replace(os.sep, '_') + '.png')
    ran = subprocess.run([program, 'render', scene, '-o', picture, '-s', '40x30', '--samples', '1', '-t', '1', '-q'],
                         capture_output=True, text=True)
    warnings = [line for line in ran.stderr.splitlines()
                if 'warning:' in line and not any(expected in line for expected in EXPECTED)]
    message = ran.stderr.strip() if ran.returncode or warnings else ''
    return f'{os.path.relpath(scene, SCENES)}: {message}' if message else ''


def main():
    program = sys.argv[1]
    scenes = sorted(glob.glob(os.path.join(SCENES, '**', '*.isl'), recursive=True))
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        complaints = [line for line in pool.map(lambda scene: complaint(program, scene, folder), scenes) if line]
    print('\n'.join(complaints + [f'{len(scenes)} scenes, {len(complaints)} complaints']))
    return 1 if complaints or not scenes else 0


if __name__ == '__main__':
    sys.exit(main())
