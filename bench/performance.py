#!/usr/bin/env python3
"""How fast isl is, in one table: the scenes of instructions.py that POV-Ray reads too, flakes of several sizes, many solids, a picture that needs
almost nothing; both programs in turn, medians.

    bench/performance.py [-n ROUNDS] [--only NAME …] [--json FILE] [--page]

Pictures have one ray a pixel and are made by one thread. `trace` is isl's `time.trace` and POV-Ray's Trace Time, `whole` the processor time of the
process from start to exit, with reading and the PNG, of 8 bits a channel as POV-Ray writes them; `memory` is the most that isl held at once. --json keeps every measurement; --page writes the
table into docs/performance.md. Needs povray.
"""
import argparse
import json
import os
import pathlib
import re
import statistics
import sys
import tempfile

import programs

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / 'docs/performance.md'
BEGIN, END = '<!-- table: performance -->\n', '<!-- end -->'
# name: scene, size, settings, the least ratio of trace times that is wanted
SCENES = {
    'ten lines': ('bench/scenes/ten_lines.pov', (320, 240), [], None),
    'flake of 820 balls': ('bench/scenes/flake.pov', (1024, 1024), ['Levels=3'], 5),
    'flake of 7,381': ('bench/scenes/flake.pov', (1024, 1024), ['Levels=4'], 5),
    'flake of 66,430': ('bench/scenes/flake.pov', (1024, 1024), ['Levels=5'], 5),
    '200 components that overlap': ('bench/guard/overlaps.pov', (320, 240), [], 3),
    '1,000 copies of a blob': ('bench/guard/copies.pov', (640, 480), [], 3),
    '1,000 solids': ('bench/guard/solids.pov', (640, 480), ['Count=1000'], 3),
    '100,000 solids': ('bench/guard/solids.pov', (640, 480), ['Count=100000'], 3),
    'box without 1,600 cylinders': ('bench/guard/combination.pov', (320, 240), ['Holes=40'], 5),
    'noise': ('bench/guard/noise.pov', (640, 480), [], None),
    'mirrors and glass': ('bench/guard/mirrors.pov', (640, 480), [], None),
}


def measure(options, scene, size, settings, folder):
    """One run of each program: isl's trace, whole, memory and rays; POV-Ray's trace and whole."""
    path, statistics_file = str(ROOT / scene), str(folder / 'statistics.json')
    defines = [argument for setting in settings for argument in ('-D', setting)]
    ours = programs.run_isl(options, path, str(folder / 'isl.png'), size, '--bits', '8', '--stats', statistics_file, *defines)
    if ours.code != 0:
        sys.exit(f'performance.py: {scene}: {programs.isl_message(ours)}')
    told = json.loads(pathlib.Path(statistics_file).read_text())
    theirs = programs.run_povray(options, path, str(folder / 'povray.png'), size, *(f'Declare={setting}' for setting in settings),
                                 folder=folder, timeout=600)
    trace = re.search(r'Trace Time:.*?\(([\d.]+) seconds\)', theirs.errors)
    if theirs.code != 0 or not trace:
        sys.exit(f'performance.py: {scene}: POV-Ray: {programs.povray_message(theirs)}')
    return {'trace': told['time']['trace'], 'whole': ours.seconds, 'memory': told['memory']['peak_bytes'],
            'rays': sum(told['rays'].values()), 'povray_trace': float(trace.group(1)), 'povray_whole': theirs.seconds}


def row_of(name, runs, wanted):
    middle = {key: statistics.median(run[key] for run in runs) for key in runs[0]}
    ratio = middle['povray_trace'] / middle['trace']
    return '| ' + ' | '.join([
        name, f"{middle['trace']:.3f}", f"{middle['povray_trace']:.3f}", f'{ratio:.1f}', f'{wanted}' if wanted else '',
        f"{middle['whole']:.2f}", f"{middle['povray_whole']:.2f}", f"{middle['povray_whole'] / middle['whole']:.1f}",
        f"{middle['rays'] / middle['trace'] / 1e6:.1f}", f"{middle['memory'] / 1e6:.0f}"]) + ' |'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('-n', type=int, default=5, metavar='ROUNDS', help='rounds in which the programs take turns [5]')
    parser.add_argument('--only', nargs='+', default=list(SCENES), choices=list(SCENES), metavar='NAME')
    parser.add_argument('--json', metavar='FILE', help='keep every measurement')
    parser.add_argument('--page', action='store_true', help='write the table into docs/performance.md')
    programs.add_program_options(parser)
    options = parser.parse_args()
    programs.find_programs(options)

    table = ['| scene | trace, s | POV-Ray | ratio | wanted | whole, s | POV-Ray | ratio | million rays a second | MB |',
             '|---|---|---|---|---|---|---|---|---|---|']
    print('\n'.join(table))
    kept = {}
    with tempfile.TemporaryDirectory() as folder:
        for name in options.only:
            scene, size, settings, wanted = SCENES[name]
            kept[name] = [measure(options, scene, size, settings, pathlib.Path(folder)) for _ in range(options.n)]
            table.append(row_of(name, kept[name], wanted))
            print(table[-1], flush=True)
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(kept, indent=1) + '\n')
    if options.page:
        text = PAGE.read_text()
        begin = text.index(BEGIN) + len(BEGIN)
        PAGE.write_text(text[:begin] + '\n'.join(table) + '\n' + text[text.index(END, begin):])


if __name__ == '__main__':
    main()
