#!/usr/bin/env python3
"""Scripts of Lua's own kind, the same algorithm in the language of scenes and in Lua 5.4: numbers, calls, strings and arrays (scripts/).

    bench/scripts.py [-n ROUNDS] [--only NAME …] [--instructions] [--isl PROGRAM]

Whole processes, `isl check` and `lua5.4`, take turns; the table has the medians of their processor time and the ratio, where above 1 says
that isl is faster. Both must print the same. --instructions counts instructions by callgrind besides, which do not depend on what else the
machine does, and stores them in script_instructions.json. Needs lua5.4; valgrind for the counts.
"""
import argparse
import json
import os
import pathlib
import re
import resource
import shutil
import statistics
import subprocess
import sys

BENCH = pathlib.Path(__file__).resolve().parent
STORED = BENCH / 'script_instructions.json'
NAMES = ['numbers', 'calls', 'strings', 'arrays']


def commands_of(isl, name):
    """By program: the command, and the stream that the script prints to."""
    return {'isl': ([isl, 'check', str(BENCH / f'scripts/{name}.pov')], 'stderr'),
            'Lua': (['lua5.4', str(BENCH / f'scripts/{name}.lua')], 'stdout')}


def run(command, stream):
    """The processor's seconds, and the first line that the script printed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    process = subprocess.run(command, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if process.returncode:
        sys.exit(f'scripts.py: {" ".join(command)}: {process.stderr.strip()[-400:]}')
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return seconds, getattr(process, stream).split('\n')[0]


def instructions_of(command):
    process = subprocess.run(['valgrind', '--tool=callgrind', '--callgrind-out-file=/dev/null', *command], capture_output=True, text=True)
    counted = re.search(r'Collected : (\d+)', process.stderr)
    if process.returncode or not counted:
        sys.exit(f'scripts.py: {" ".join(command)}: {process.stderr.strip()[-400:]}')
    return int(counted.group(1))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('-n', type=int, default=9, metavar='ROUNDS', help='rounds in which the programs take turns [9]')
    parser.add_argument('--only', nargs='+', default=NAMES, choices=NAMES, metavar='NAME')
    parser.add_argument('--instructions', action='store_true', help='count and store instructions, too')
    parser.add_argument('--isl', default=os.environ.get('ISL', str(BENCH.parent / 'build/release/bin/isl')))
    options = parser.parse_args()
    needed = ['lua5.4'] + (['valgrind'] if options.instructions else [])
    if missing := [program for program in needed if not shutil.which(program)]:
        sys.exit(f'scripts.py: needs {" and ".join(missing)}')

    stored = json.loads(STORED.read_text()) if STORED.exists() else {}
    print(f'{"script":10}{"isl, s":>9}{"Lua, s":>9}{"ratio":>8}')
    for name in options.only:
        commands = commands_of(options.isl, name)
        seconds = {program: [] for program in commands}
        for _ in range(options.n):
            said = {}
            for program, (command, stream) in commands.items():
                taken, said[program] = run(command, stream)
                seconds[program].append(taken)
            if said['isl'] != said['Lua']:
                sys.exit(f'scripts.py: {name}: isl prints {said["isl"]!r}, Lua {said["Lua"]!r}')
        isl, lua = (statistics.median(seconds[program]) for program in ('isl', 'Lua'))
        print(f'{name:10}{isl:>9.3f}{lua:>9.3f}{lua / isl:>8.2f}', flush=True)
        if options.instructions:
            stored[name] = {program: instructions_of(command) for program, (command, _) in commands.items()}
    if options.instructions:
        STORED.write_text(json.dumps(stored, indent=2) + '\n')
        print(f'\n{"script":10}{"isl":>16}{"Lua":>16}{"ratio":>8}  instructions')
        for name, counts in stored.items():
            print(f'{name:10}{counts["isl"]:>16,}{counts["Lua"]:>16,}{counts["Lua"] / counts["isl"]:>8.2f}')


if __name__ == '__main__':
    main()
