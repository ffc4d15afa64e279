#!/usr/bin/env python3
"""Soft light and focal blur in isl and in POV-Ray 3.7: whether both mean the same picture, and what its noise costs in time.

    bench/soft_noise.py [NAME…] [-s WxH] [-o FOLDER] [--again] [--isl PROGRAM] [--povray PROGRAM]

For each scene of soft/ (NAME is a part of the names): both programs draw it with thousands of samples a pixel. `off` is the greatest
difference of the means of blocks of 16x16 pixels, in any channel, in units of 1/255 of encoded values; wanted: at most 1. Then each
program draws it with several settings, POV-Ray without and with antialiasing, or with more rays of a blur, isl with several --max-noise.
A setting has a noise, the root mean square of the differences from the program's own picture of thousands of samples, and a processor
time, with one thread. The ratio is the time of isl over that of POV-Ray at the same noise, between settings by straight lines in
logarithms; it is the median over the noises that both reach. Wanted: at most 0.25.

FOLDER [soft_noise] keeps the pictures of thousands of samples, which are not made again without --again, and gets table.txt and
noise.png, a picture of all curves.
"""
import argparse
import math
import os
import statistics
import sys
import tempfile

import numpy
from PIL import Image, ImageDraw

import programs

HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'soft')
NOISES = '0.08', '0.04', '0.02', '0.01', '0.005'
RUNS = 3
BLOCK = 16


def pixels(file):
    return numpy.asarray(Image.open(file).convert('RGB'), dtype=float) / 255


def draw(options, program, scene, picture, *arguments):
    """Processor seconds of one picture; ends the script if it fails."""
    file = os.path.join(HERE, scene + '.pov')
    if program == 'isl':
        ran = programs.Ran([options.isl, 'render', file, '-o', picture, '-s', options.size, '-t', '1', '-q', '--bits', '8', *arguments],
                           HERE, 3600)
        message = programs.isl_message
    else:
        width, height = options.size.split('x')
        ran = programs.Ran([options.povray, f'+I{file}', f'+O{picture}', f'+W{width}', f'+H{height}', '-D', '-P', '+WT1', f'+L{HERE}',
                            *arguments], HERE, 3600)
        message = programs.povray_message
    if ran.code != 0:
        sys.exit(f'soft_noise.py: {scene}: {program}: {message(ran)}')
    return ran.seconds


def is_blurred(scene):
    return scene.startswith('blur')


def settings(program, scene):
    if program == 'isl':
        return [('--max-noise', noise) for noise in NOISES]
    if is_blurred(scene):
        return [('-A', f'Declare=Blur={count}') for count in (7, 19, 37, 100, 300)]
    return [('-A',), ('+A0.2', '+AM2', '+R2'), ('+A0.1', '+R3'), ('+A0.03', '+R4', '-J'), ('+A0.01', '+R6', '-J')]


def converged(options, program, scene):
    """The picture of thousands of samples."""
    picture = os.path.join(options.output, f'{scene}.{program}.png')
    if options.again or not os.path.exists(picture):
        if program == 'isl':
            arguments = '--samples', '4096'
        else:
            arguments = ('-A', 'Declare=Blur=2000') if is_blurred(scene) else ('+A0.0', '+AM1', '+R5', '-J')
        draw(options, program, scene, picture, *arguments)
    return pixels(picture)


def block_difference(a, b):
    height, width = a.shape[0] // BLOCK * BLOCK, a.shape[1] // BLOCK * BLOCK
    difference = (a - b)[:height, :width].reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK, 3).mean(axis=(1, 3))
    return float(numpy.abs(difference).max()) * 255


def curve(options, program, scene, truth, folder):
    """[(noise, seconds)] of the settings."""
    points = []
    for number, arguments in enumerate(settings(program, scene)):
        picture = os.path.join(folder, f'{program}{number}.png')
        seconds = statistics.median(draw(options, program, scene, picture, *arguments) for _ in range(RUNS))
        points.append((math.sqrt(float(((pixels(picture) - truth)**2).mean())), seconds))
    return points


def seconds_at(points, noise):
    """Between two settings by a straight line in logarithms; None beyond them."""
    points = sorted(points)
    for (low, most), (high, least) in zip(points, points[1:]):
        if low <= noise <= high and low < high:
            share = math.log(noise / low) / math.log(high / low)
            return math.exp(math.log(most) + share * math.log(least / most))
    return None


def ratio(ours, theirs):
    ratios = []
    for noise, seconds in ours:
        there = seconds_at(theirs, noise)
        if there:
            ratios.append(seconds / there)
    for noise, seconds in theirs:
        here = seconds_at(ours, noise)
        if here:
            ratios.append(here / seconds)
    return statistics.median(ratios) if ratios else math.nan


def plot(curves, file):
    """Noise over time, both in logarithms: isl blue, POV-Ray orange."""
    size, margin = 900, 60
    times = [t for _, ours, theirs in curves for _, t in ours + theirs]
    noises = [n for _, ours, theirs in curves for n, _ in ours + theirs]
    low, high = min(times), max(times)
    quiet, loud = min(noises), max(noises)
    picture = Image.new('RGB', (size, size), 'white')
    pen = ImageDraw.Draw(picture)

    def place(noise, seconds):
        x = math.log(seconds / low) / math.log(high / low)
        y = math.log(noise / quiet) / math.log(loud / quiet)
        return margin + x * (size - 2 * margin), size - margin - y * (size - 2 * margin)

    for _, ours, theirs in curves:
        for points, colour in ((ours, (30, 90, 200)), (theirs, (230, 120, 20))):
            pen.line([place(*point) for point in sorted(points)], fill=colour, width=2)
    pen.text((margin, size - 40), f'{low:.2g} s .. {high:.2g} s, processor time', fill='black')
    pen.text((5, 20), f'noise {quiet:.2g} .. {loud:.2g}: blue isl, orange POV-Ray', fill='black')
    picture.save(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('names', nargs='*')
    parser.add_argument('-s', '--size', default='320x240')
    parser.add_argument('-o', '--output', default='soft_noise')
    parser.add_argument('--again', action='store_true')
    parser.add_argument('--only-means', action='store_true', help='compare the pictures of thousands of samples and no times')
    programs.add_program_options(parser)
    options = parser.parse_args()
    programs.find_programs(options)
    os.makedirs(options.output, exist_ok=True)
    options.output = os.path.abspath(options.output)
    scenes = sorted(name[:-4] for name in os.listdir(HERE) if name.endswith('.pov'))
    if options.names:
        scenes = [scene for scene in scenes if any(part in scene for part in options.names)]
    curves, lines = [], []
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            ours, theirs = (converged(options, program, scene) for program in ('isl', 'povray'))
            line = f'{scene:16} off {block_difference(ours, theirs):5.2f}'
            if not options.only_means:
                points = [curve(options, program, scene, truth, folder) for program, truth in (('isl', ours), ('povray', theirs))]
                curves.append((scene, *points))
                texts = [' '.join(f'{noise:.4f}:{seconds:.2f}s' for noise, seconds in side) for side in points]
                line += f'   time {ratio(*points):5.2f}   isl {texts[0]}   POV-Ray {texts[1]}'
            print(line, flush=True)
            lines.append(line)
    with open(os.path.join(options.output, 'table.txt'), 'w', encoding='utf8') as table:
        table.write('\n'.join(lines) + '\n')
    if curves:
        plot(curves, os.path.join(options.output, 'noise.png'))


if __name__ == '__main__':
    main()
