#!/usr/bin/env python3
"""A page of all materials in stdlib/: each on the test body of scenes/swatches.isl, with its name and its cost beneath.

    bench/swatches.py [NAME…] [-o FILE.png] [--light N] [--isl PROGRAM]

NAME is a part of the names of materials or files, as `Gold` or `metals`; without one, all are rendered. The cost is the time of
tracing the body with one sample a pixel and point lights over that of the same body in a plain colour.

Needs nothing but Python: isl writes .ppm for it, and draws the letters.
"""
import argparse
import json
import os
import re
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
    """The statistics of rendering a text; ends the script with the messages if there are any."""
    with tempfile.TemporaryDirectory() as folder:
        scene, stats = os.path.join(folder, 'swatch.isl'), os.path.join(folder, 'stats.json')
        with open(scene, 'w', encoding='utf8') as stream:
            stream.write(text)
        command = [options.isl, 'render', scene, '-o', picture, '-s', '{}x{}'.format(*size), '-q', '-I', STDLIB, '-I', SCENES,
                   '--stats', stats, *arguments]
        ran = subprocess.run(command, capture_output=True, text=True)
        if ran.returncode or ran.stderr:
            print(ran.stderr[:2000], file=sys.stderr)
            if ran.returncode:
                sys.exit(1)
        with open(stats, encoding='utf8') as stream:
            return json.load(stream)


def read_ppm(file):
    with open(file, 'rb') as stream:
        data = stream.read()
    width, height = map(int, data.split(None, 3)[1:3])
    pixels = data[-3 * width * height:]
    return [bytearray(pixels[3 * width * row:3 * width * (row + 1)]) for row in range(height)]


def write_png(file, rows, colours=256):
    """A .png. With a number of colours those of the rows, which are bytes of R, G, B, are reduced by cutting boxes at their medians."""
    if not colours:
        _write_chunks(file, len(rows[0]) // 3, len(rows), 2, b'', b''.join(b'\0' + bytes(row) for row in rows))
        return
    counts = {}
    for row in rows:
        for at in range(0, len(row), 3):
            key = bytes(row[at:at + 3])
            counts[key] = counts.get(key, 0) + 1
    boxes = [list(counts)]
    while len(boxes) < colours:
        # The box whose colours are spread most, weighted by the root of the number of its pixels.
        def spread(box):
            if len(box) < 2:
                return 0
            return max(max(c[k] for c in box) - min(c[k] for c in box) for k in range(3)) * sum(counts[c] for c in box) ** .3
        widest = max(range(len(boxes)), key=lambda i: spreads[i]) if len(boxes) > 1 else 0
        if len(boxes) == 1:
            spreads = [spread(boxes[0])]
        if spreads[widest] == 0:
            break
        box = boxes.pop(widest)
        spreads.pop(widest)
        axis = max(range(3), key=lambda k: max(c[k] for c in box) - min(c[k] for c in box))
        box.sort(key=lambda c: c[axis])
        half, total, cut = sum(counts[c] for c in box) / 2, 0, 0
        for cut, colour in enumerate(box):
            total += counts[colour]
            if total >= half:
                break
        cut = max(1, min(len(box) - 1, cut))
        for part in (box[:cut], box[cut:]):
            boxes.append(part)
            spreads.append(spread(part))
    palette, index = b'', {}
    for number, box in enumerate(boxes):
        weight = sum(counts[c] for c in box)
        palette += bytes(round(sum(c[k] * counts[c] for c in box) / weight) for k in range(3))
        for colour in box:
            index[colour] = number

    packed = b''.join(b'\0' + bytes(index[bytes(row[at:at + 3])] for at in range(0, len(row), 3)) for row in rows)
    _write_chunks(file, len(rows[0]) // 3, len(rows), 3, palette, packed)


def _write_chunks(file, width, height, colour_type, palette, packed):
    def chunk(kind, content):
        return struct.pack('>I', len(content)) + kind + content + struct.pack('>I', zlib.crc32(kind + content))

    with open(file, 'wb') as stream:
        stream.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, colour_type, 0, 0, 0)) +
                     (chunk(b'PLTE', palette) if palette else b'') + chunk(b'IDAT', zlib.compress(packed, 9)) + chunk(b'IEND', b''))


def label_scene(width, height, labels):
    """A page of labels, (x, y, text, grey), drawn by isl in pixels from the top left corner."""
    lines = ['#version 3.7; global_settings { assumed_gamma 1 } background { rgb 1 } light_source { 0, 0 }',
             f'camera {{ orthographic location <{width / 2}, {-height / 2}, -10> look_at <{width / 2}, {-height / 2}, 0> '
             f'right {width}*x up {height}*y }}']
    for x, y, text, grey in labels:
        lines.append(f'text {{ ttf "DejaVuSans.ttf" "{text}" 0.1, 0 scale <{LETTERS * 1.05}, {LETTERS * 1.15}, 1> '
                     f'translate <{x}, {-y - LETTERS}, 0> pigment {{ rgb {grey} }} finish {{ ambient 0 diffuse 0 emission 1 }} }}')
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

        def swatch(material, library):
            text = f'#include "finishes.isl"\n#include "{library}"\n#declare Material = material {{ {material} }}\n#include "swatches.isl"\n'
            once = min(render(options, text, picture, (160, 130), '-t', '1', '-D', 'Light=0', '--samples', '1')['time']['trace']
                       for _ in range(4)) if not options.no_cost else 1
            light = ['-D', f'Light={options.light}'] + (['--max-noise', options.max_noise] if options.light else [])
            render(options, text, picture, (width, height), '-t', options.t, *light)
            return once, read_ppm(picture)

        plain, _ = swatch(PLAIN, 'finishes.isl')
        rows, labels, line = [], [], []
        for number, entry in enumerate(wanted):
            material = f'texture {{ {entry.name} }}' if entry.kind == 'texture' else entry.name
            time, pixels = swatch(material, entry.library)
            column = number % options.columns
            if column == 0:
                rows += [bytearray(b'\xff' * 3 * width * options.columns) for _ in range(height + LABEL)]
            top = len(rows) - height - LABEL
            for y in range(height):
                rows[top + y][3 * width * column:3 * width * (column + 1)] = pixels[y]
            name = entry.name
            labels.append((width * column + 4, top + height + 3, name, 0.02))
            labels.append((width * column + 4, top + height + 5 + LETTERS, f'{entry.library[:-4]}, {time / plain:.1f}', 0.25))
            print(f'{entry.library:14} {name:22} {time / plain:5.1f}', flush=True)
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
