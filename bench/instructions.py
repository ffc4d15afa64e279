#!/usr/bin/env python3
"""What twelve scenes execute, by callgrind, against what is stored: instructions of our own functions, which do not depend on what else the
machine does.

    bench/instructions.py [--isl PROGRAM] [--store] [--only NAME …]

bench/instructions.json has a row for each compiler, because another one makes other instructions. A scene that takes more than 1 % more
than its row says is told, and with more than 3 % the script ends with 1. After a change that is meant, --store writes the row
anew. Without a row for its compiler the script stores one, says so, and ends with 0.

Pictures are small and drawn by one thread with vectors of one width (AVX2). Ends with 77 where valgrind or AVX2 is missing.
"""
import argparse
import json
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
STORED = ROOT / 'bench/instructions.json'
TOLD, FAILS = 0.01, 0.03
WIDTH = 'AVX2'
# name: scene, size, settings
SCENES = {
    'flake of 820': ('bench/scenes/flake.pov', '96x96', ['Levels=3']),
    'flake of 7,381': ('bench/scenes/flake.pov', '96x96', ['Levels=4']),
    'Gaussian flake': ('scenes/paper/sphereflake.isl', '96x96', []),
    'coral': ('scenes/gallery/coral_tree.isl', '64x48', []),
    'crab': ('scenes/paper/hermite_crab.isl', '64x48', []),
    'overlaps': ('bench/guard/overlaps.pov', '64x48', []),
    'copies': ('bench/guard/copies.pov', '96x72', []),
    'solids': ('bench/guard/solids.pov', '128x96', ['Count=1000']),
    'many solids': ('bench/guard/solids.pov', '64x48', ['Count=10000']),
    'combination': ('bench/guard/combination.pov', '128x96', ['Holes=22']),
    'noise': ('bench/guard/noise.pov', '96x72', []),
    'mirrors': ('bench/guard/mirrors.pov', '96x72', []),
}


def own_instructions(profile):
    """The sum over functions of the program itself; what they call is counted there: the line after `calls=` has the sum of that."""
    total, is_own, skips = 0, False, False
    for line in profile.open():
        if line.startswith('ob='):
            is_own = os.path.basename(line.strip()) == 'isl'
        elif line.startswith('calls='):
            skips = True
        elif line[0].isdigit() or line[0] in '+-*':
            if is_own and not skips:
                total += int(line.split()[1])
            skips = False
    return total


def count(isl, scene, size, settings, folder):
    profile = folder / 'profile'
    command = ['valgrind', '--tool=callgrind', '--compress-strings=no', f'--callgrind-out-file={profile}',
               isl, 'render', str(ROOT / scene), '-s', size, '-t', '1', '--simd', WIDTH, '--samples', '1', '-q',
               '-o', str(folder / 'picture.exr')]
    for setting in settings:
        command += ['-D', setting]
    process = subprocess.run(command, capture_output=True, text=True)
    if process.returncode:
        sys.exit(f'instructions.py: {scene}: {process.stderr.strip()[-400:]}')
    return own_instructions(profile)


def compiler_of(isl):
    """As the compiler names itself in the program."""
    dump = subprocess.run(['readelf', '-p', '.comment', isl], capture_output=True, text=True, check=True).stdout
    return re.search(r'\]\s+(.*)', dump).group(1).strip() + ', ' + platform.machine()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--isl', default=os.environ.get('ISL', str(ROOT / 'build/release/bin/isl')))
    parser.add_argument('--store', action='store_true', help='write the row of this compiler anew')
    parser.add_argument('--only', nargs='+', default=list(SCENES), choices=list(SCENES), metavar='NAME')
    options = parser.parse_args()
    if not shutil.which('valgrind') or 'avx2' not in pathlib.Path('/proc/cpuinfo').read_text():
        print('instructions.py: needs valgrind and a processor with AVX2')
        return 77

    stored = json.loads(STORED.read_text()) if STORED.exists() else {}
    compiler = compiler_of(options.isl)
    is_new = compiler not in stored
    row = dict(stored.get(compiler, {}))
    worst = 0
    print(f'{"scene":16}{"stored":>15}{"now":>15}{"change":>10}')
    with tempfile.TemporaryDirectory() as folder:
        for name in options.only:
            now = count(options.isl, *SCENES[name], pathlib.Path(folder))
            before = row.get(name)
            change = now / before - 1 if before else 0
            worst = max(worst, change)
            note = '' if abs(change) <= TOLD else ' more' if change > 0 else ' less: --store keeps it'
            print(f'{name:16}{before or "-":>15}{now:>15}{change:>+10.2%}{note}', flush=True)
            if options.store or not before:
                row[name] = now
    if row != stored.get(compiler):
        stored[compiler] = row
        STORED.write_text(json.dumps(stored, indent=2) + '\n')
        print(f'stored in {STORED.relative_to(ROOT)}' + (f': the first row of {compiler}' if is_new else ''))
    if worst > FAILS and not options.store:
        print(f'more than {FAILS:.0%} more: bench/instructions.py --store, if that is meant')
        return 1
    return 0


if __name__ == '__main__':
    sys.exit(main())
