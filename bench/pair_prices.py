#!/usr/bin/env python3
"""What each effect costs in isl and in POV-Ray 3.7: the processor time of a scene of pairs/ less that of the same scene without
its effect (`Without` defined; in all of them `Priced` is).

    bench/pair_prices.py [NAME…] [-n RUNS] [-s WxH] [--isl PROGRAM] [--povray PROGRAM]

NAME is a part of scenes' names, as for pairs.py. Four runs make a round: each program with and without the effect, with one thread and
one ray a pixel. The prices are the medians over the rounds (5) of the differences within a round. The size is the first of 400x300,
800x600 and 1600x1200 at which POV-Ray's effect adds half a second, if -s does not say it.

The table has both prices in seconds, the middle half of the rounds (from the lower to the upper quartile) of each, and the ratio of
ours over theirs. "yes" says that ours is at most theirs, or at most what our own runs without the effect vary by.
Scenes that isl does not render are told and left out. Run it on an idle machine.
"""
import argparse
import os
import statistics
import sys
import tempfile

import programs
from pairs import HERE, scenes

SIZES = (400, 300), (800, 600), (1600, 1200)
ENOUGH = .5  # seconds that POV-Ray's effect adds
PRICED, WITHOUT = ['Priced=1'], ['Priced=1', 'Without=1']


class Failed(Exception):
    pass


def seconds(options, program, scene, size, defines, folder):
    """Processor seconds of one run; raises Failed with the program's message."""
    if program == 'isl':
        arguments = [word for define in defines for word in ('-D', define)]
        ran = programs.run_isl(options, scene.file, os.path.join(folder, 'isl.png'), size, '--bits', '8', '-I', options.include,
                               *arguments, folder=folder, timeout=600)
        message = programs.isl_message
    else:
        ran = programs.run_povray(options, scene.file, os.path.join(folder, 'povray.png'), size, f'+L{HERE}',
                                  *[f'Declare={define}' for define in defines], folder=folder, timeout=600)
        message = programs.povray_message
    if ran.code != 0:
        raise Failed(f'{program}: {message(ran)}')
    return ran.seconds


def added(options, program, scene, size, folder):
    """The price of one round, and the time without the effect."""
    without = seconds(options, program, scene, size, WITHOUT, folder)
    return seconds(options, program, scene, size, PRICED, folder) - without, without


def size_for(options, scene, folder):
    for size in SIZES:
        if added(options, 'povray', scene, size, folder)[0] >= ENOUGH:
            break
    return size


def quartiles(values):
    return statistics.quantiles(values, n=4, method='inclusive')


def price(options, scene, folder):
    """A row of the table, and whether ours costs at most what theirs does."""
    seconds(options, 'isl', scene, (8, 6), PRICED, folder)  # a scene that is refused is not timed
    size = options.size or size_for(options, scene, folder)
    ours, theirs, plain = [], [], []
    for _ in range(options.runs):
        difference, without = added(options, 'isl', scene, size, folder)
        ours.append(difference)
        plain.append(without)
        theirs.append(added(options, 'povray', scene, size, folder)[0])
    (a, our_price, b), (c, their_price, d) = quartiles(ours), quartiles(theirs)
    low, _, high = quartiles(plain)
    is_cheap = our_price <= max(their_price, high - low)
    ratio = f'{our_price / their_price:8.2f}' if their_price > 0 else f'{"-":>8}'
    return (f'{scene.name:28} {"{}x{}".format(*size):>10} {our_price:8.2f}  {a:6.2f}..{b:<6.2f} {their_price:8.2f}  '
            f'{c:6.2f}..{d:<6.2f} {ratio}  {"yes" if is_cheap else "NO"}'), is_cheap


def size_of(text):
    width, _, height = text.partition('x')
    return int(width), int(height)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('names', nargs='*', metavar='NAME', help="a part of scenes' names [all]")
    parser.add_argument('-n', '--runs', type=int, default=5, help='rounds [5]')
    parser.add_argument('-s', '--size', type=size_of, metavar='WxH', help='size of the pictures [by what it costs]')
    programs.add_program_options(parser)
    options = parser.parse_args()
    if options.runs < 2:
        parser.error('at least 2 rounds are needed for a spread')
    chosen = scenes(options.names)
    programs.find_programs(options)
    print(f'{"scene":28} {"size":>10} {"isl, s":>8}  {"half of the runs":16} {"POV-Ray":>8}  {"half of the runs":16} {"ratio":>8}')
    cheap = []
    with tempfile.TemporaryDirectory() as folder:
        for scene in chosen:
            try:
                row, is_cheap = price(options, scene, folder)
                cheap.append(is_cheap)
            except Failed as failure:
                row = f'{scene.name:28} {failure}'
            print(row, flush=True)
    print(f'{len(cheap)} priced, {sum(cheap)} at most as dear as in POV-Ray, {len(chosen) - len(cheap)} not priced')


if __name__ == '__main__':
    main()
