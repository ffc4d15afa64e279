#!/usr/bin/env python3
"""A page of all materials in stdlib/: each on the test body of scenes/swatches.isl, with its name and its cost beneath.

    bench/swatches.py [NAME…] [-o FILE.png] [--light N] [--isl PROGRAM]

NAME is a part of the names of materials or files, as `Gold` or `metals`; without one, all are rendered. The cost is the
processor's time for the picture with one sample a pixel and point lights over that of the same picture in a plain colour.

Needs nothing but Python: isl writes .ppm for it, and draws the letters.
"""
import argparse
import os
import resource
import struct
import subprocess
import sys
import tempfile
import zlib

from library_comments import HERE, STDLIB, entries, libraries

SCENES = os.path.join(HERE, '../scenes')
PLAIN = 'texture { pigment { rgb 0.5 } finish { SatinFinish } }'
LETTERS = 11  # height of a label in pixels
LABEL = 2 * LETTERS + 9


def render(options, text, picture, size, *arguments):
    """Renders a text; ends the script with the messages if there are errors."""
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, 'swatch.isl')
        with open(scene, 'w', encoding='utf8') as stream:
            stream.write(text)
        command = [options.isl, 'render', scene, '-o', picture, '-s', '{}x{}'.format(*size), '-q', '-I', STDLIB, '-I', SCENES,
                   *arguments]
        ran = subprocess.run(command, capture_output=True, text=True)
        if ran.returncode or ran.stderr:
            print(ran.stderr[:2000], file=sys.stderr)
        if ran.returncode:
            sys.exit(1)


def read_ppm(file):
    with open(file, 'rb') as stream:
        data = stream.read()
    width, height = map(int, data.split(None, 3)[1:3])
    pixels = data[-3 * width * height:]
    return [bytearray(pixels[3 * width * row:3 * width * (row + 1)]) for row in range(height)]


def write_png(file, rows, colours):
    """A .png of rows of bytes of R, G, B, with so many colours, or all of them if the number is 0."""
    if colours:
        palette = reduced_colours(rows, colours)
        _write_chunks(file, len(rows[0]) // 3, len(rows), 3, bytes(sum(palette, ())), dithered(rows, palette))
    else:
        _write_chunks(file, len(rows[0]) // 3, len(rows), 2, b'', b''.join(b'\0' + bytes(row) for row in rows))


def reduced_colours(rows, number):
    """A palette for the rows: boxes of colours are cut at their medians (P. Heckbert, 1982)."""
    counts = {}
    for row in rows:
        for at in range(0, len(row), 3):
            key = bytes(row[at:at + 3])
            counts[key] = counts.get(key, 0) + 1

    def width(box, axis):
        return max(c[axis] for c in box) - min(c[axis] for c in box)

    def urgency(box):  # wide boxes are cut first, and of these the ones with many pixels
        return max(width(box, axis) for axis in range(3)) * sum(counts[c] for c in box) ** .3 if len(box) > 1 else 0

    boxes = [(urgency(list(counts)), list(counts))]
    while len(boxes) < number and max(boxes)[0] > 0:
        boxes.sort()
        _, box = boxes.pop()
        axis = max(range(3), key=lambda axis: width(box, axis))
        box.sort(key=lambda c: c[axis])
        half, total, cut = sum(counts[c] for c in box) / 2, 0, 0
        while total < half:
            total += counts[box[cut]]
            cut += 1
        cut = min(cut, len(box) - 1)
        boxes += [(urgency(part), part) for part in (box[:cut], box[cut:])]
    return [tuple(round(sum(c[k] * counts[c] for c in box) / sum(counts[c] for c in box)) for k in range(3)) for _, box in boxes]


def dithered(rows, palette):
    """The rows as numbers of the palette: each pixel takes the nearest colour, and hands its error on to those that follow
    (R. Floyd and L. Steinberg, 1976)."""
    nearest, packed, width = {}, [], len(rows[0])
    errors = [0.0] * (width + 6)  # of the row above, one pixel to the right
    for row in rows:
        line, below, carried = bytearray(b'\0'), [0.0] * (width + 6), [0.0] * 3
        for at in range(0, width, 3):
            wanted = [min(255, max(0, row[at + k] + errors[at + 3 + k] + carried[k])) for k in range(3)]
            key = int(wanted[0]) >> 2, int(wanted[1]) >> 2, int(wanted[2]) >> 2
            if key not in nearest:
                nearest[key] = min(range(len(palette)),
                                   key=lambda i: sum((4 * key[k] + 2 - palette[i][k]) ** 2 for k in range(3)))
            line.append(nearest[key])
            for k in range(3):
                left = wanted[k] - palette[nearest[key]][k]
                carried[k] = left * 7 / 16
                below[at + k] += left * 3 / 16
                below[at + 3 + k] += left * 5 / 16
                below[at + 6 + k] += left / 16
        errors = below
        packed.append(bytes(line))
    return b''.join(packed)


def _write_chunks(file, width, height, colour_type, palette, packed):
    def chunk(kind, content):
        return struct.pack('>I', len(content)) + kind + content + struct.pack('>I', zlib.crc32(kind + content))

    with open(file, 'wb') as stream:
        stream.write(b'\x89PNG\r\n\x1a\n' +
                     chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, colour_type, 0, 0, 0)) +
                     (chunk(b'PLTE', palette) if palette else b'') + chunk(b'IDAT', zlib.compress(packed, 9)) + chunk(b'IEND', b''))


def label_scene(width, height, labels):
    """A page of labels, (x, y, text, grey), drawn by isl in pixels from the top left corner."""
    lines = ['#version 3.7; global_settings { assumed_gamma 1 } background { rgb 1 } light_source { 0, 0 }',
             f'camera {{ orthographic location <{width / 2}, {-height / 2}, -10> look_at <{width / 2}, {-height / 2}, 0> '
             f'right {width}*x up {height}*y }}']
    for x, y, text, grey in labels:
        lines.append(f'text {{ ttf "DejaVuSans.ttf" "{text}" 0.1, 0 scale <{LETTERS * 1.05}, {LETTERS * 1.15}, 1> '
                     f'translate <{x}, {-y - LETTERS}, 0> pigment {{ rgb {grey} }} '
                     'finish { ambient 0 diffuse 0 emission 1 } }')
    return '\n'.join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('names', nargs='*', metavar='NAME')
    parser.add_argument('-o', default='swatches.png', metavar='FILE', help='[swatches.png]')
    parser.add_argument('--isl', default=os.environ.get('ISL', os.path.join(HERE, '../build/release/bin/isl')))
    parser.add_argument('--light', type=int, choices=(0, 1, 2), default=1, help='0 points, 1 soft, 2 and light from around [1]')
    parser.add_argument('--no-cost', action='store_true', help='do not measure')
    parser.add_argument('--size', default='150x124', help='of a swatch [150x124]')
    parser.add_argument('--columns', type=int, default=10, help='[10]')
    parser.add_argument('--colours', type=int, default=256, help='of the .png, up to 256; 0 for all [256]')
    parser.add_argument('--max-noise', default='0.02', help='of soft light [0.02]')
    parser.add_argument('-t', default='1', metavar='THREADS', help='[1]')
    options = parser.parse_args()
    width, height = map(int, options.size.split('x'))

    wanted = []
    for library in libraries():
        for entry in entries(library)[0]:
            if entry.kind in ('texture', 'material') and (
                    not options.names or any(name in entry.name or name in library for name in options.names)):
                wanted.append(entry)
    if not wanted:
        sys.exit('swatches.py: no such material')

    with tempfile.TemporaryDirectory() as folder:
        picture = os.path.join(folder, 'swatch.ppm')

        def scene(material, library):
            return f'#include "{library}"\n#declare Material = material {{ {material} }}\n#include "swatches.isl"\n'

        def seconds(text, width, height, runs):
            """The least of the processor's seconds that several runs take. A .png takes isl less time to write than a .ppm."""
            least = 1e9
            for _ in range(runs):
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                render(options, text, picture[:-3] + 'png', (width, height), '-t', '1', '-D', 'Light=0', '--samples', '1')
                least = min(least, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
            return least

        # What a render takes before its first ray does not count.
        start = seconds(scene(PLAIN, 'finishes.isl'), 1, 1, 8)
        plain = seconds(scene(PLAIN, 'finishes.isl'), 200, 162, 8) - start

        def swatch(material, library):
            text = scene(material, library)
            cost = 0 if options.no_cost else (seconds(text, 200, 162, 3) - start) / plain
            light = ['-D', f'Light={options.light}'] + (['--max-noise', options.max_noise] if options.light else [])
            render(options, text, picture, (width, height), '-t', options.t, *light)
            return cost, read_ppm(picture)

        rows, labels, line = [], [], []
        for number, entry in enumerate(wanted):
            material = f'texture {{ {entry.name} }}' if entry.kind == 'texture' else entry.name
            cost, pixels = swatch(material, entry.library)
            column = number % options.columns
            if column == 0:
                rows += [bytearray(b'\xff' * 3 * width * options.columns) for _ in range(height + LABEL)]
            top = len(rows) - height - LABEL
            for y in range(height):
                rows[top + y][3 * width * column:3 * width * (column + 1)] = pixels[y]
            name = entry.name
            labels.append((width * column + 4, top + height + 3, name, 0.02))
            labels.append((width * column + 4, top + height + 5 + LETTERS, entry.library[:-4] + ('' if options.no_cost else f', {cost:.1f}'), 0.25))
            print(f'{entry.library:14} {name:22} {cost:5.1f}', flush=True)
        page = len(rows[0]) // 3, len(rows)
        render(options, label_scene(*page, labels), picture, page, '--aa', '0.02')
        for row, letters in zip(rows, read_ppm(picture)):
            for at, value in enumerate(letters):
                if value < row[at]:
                    row[at] = value
        write_png(options.o, rows, options.colours)
        print(f'{options.o}: {len(wanted)} materials, {os.path.getsize(options.o) // 1000} kB')


if __name__ == '__main__':
    main()
