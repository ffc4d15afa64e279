#!/usr/bin/env python3
"""The textures of POV-Ray's libraries (metals, golds, glass, stones, woods, skies …) in isl and in POV-Ray 3.7: are they the same?

    bench/library_textures.py [NAME…] [-o PAGE.png] [--isl PROGRAM] [--povray PROGRAM] [--include FOLDER]

NAME is a part of identifiers' names or of their files' names, as `T_Gold` or `stones1`; without one, all are rendered. What the files
of LIBRARIES declare as a texture, material, pigment, finish, interior, sky or object is found by reading them. Each is drawn by both
programs on a ball over a chequered plane, what skies.inc declares as the sky above it, and judged as the scenes of pairs/ are
(pairs.py), at 96x96; textures with `crand`, whose grain is random ("grain"), as those with noise. PAGE.png (library_textures.png)
has both pictures of each, isl's on the left; names in red are not the same.

The exit code is 1 if one differs or fails. Needs povray, python3-numpy and python3-pil.
"""
import argparse
import collections
import os
import re
import subprocess
import sys
import tempfile

import pairs
import programs
from pictures import Image, encoded, np
from PIL import ImageDraw

# glass.inc includes glass_old.inc; stones.inc consists of the two.
LIBRARIES = ['metals', 'golds', 'finish', 'glass', 'glass_old', 'textures', 'stones1', 'stones2', 'woods', 'skies']
SIZE = 96
COLUMNS, LABEL, GAP = 10, 12, 6  # of the page; pixels of a name's height and between cells

BALL = '''#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
#include "colors.inc"
#include "LIBRARY.inc"
camera { location <0, 2, -4.5> look_at <0, 0.85, 0> right x angle 38 }
light_source { <4, 7, -6> rgb 0.9 }
light_source { <-6, 3, -2> rgb 0.3 shadowless }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8, 0.85, 0.9>] [1 rgb <0.2, 0.4, 0.8>] } } }
plane { y, -0.0013 pigment { checker rgb <0.25, 0.4, 0.55> rgb <0.8, 0.85, 0.5> } finish { ambient 0.1 diffuse 0.7 } }
sphere { <0.0137, 1.0071, 0.0053>, 1 SURFACE }
'''
SKY = '''#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "LIBRARY.inc"
camera { location 2*y look_at <0, 3.2, 5> right x angle 80 }
light_source { <40, 70, -60> rgb 0.9 }
background { rgb <0.2, 0.4, 0.8> }
plane { y, -0.0013 pigment { checker rgb <0.25, 0.4, 0.55> rgb <0.8, 0.85, 0.5> } finish { ambient 0.1 diffuse 0.7 } }
SURFACE
'''
ON_BALL = {
    'texture': 'texture { NAME }', 'material': 'material { NAME }', 'pigment': 'pigment { NAME }',
    'finish': 'pigment { rgb <0.8, 0.5, 0.35> } finish { NAME }',
    'interior': 'pigment { rgbf <0.95, 0.97, 1, 0.9> } finish { ambient 0 diffuse 0.1 } interior { NAME }',
}
AS_SKY = {
    'sky_sphere': 'sky_sphere { NAME }', 'pigment': 'sky_sphere { pigment { NAME } }',
    'texture': 'sphere { 0, 10000 texture { NAME scale 1000 } hollow }',
    'sphere': 'object { NAME hollow }', 'union': 'object { NAME hollow }',
}

Declared = collections.namedtuple('Declared', 'library name kind')
Scene = collections.namedtuple('Scene', 'name file is_noise')


def declared(options, library):
    """What a file declares that can be drawn, in its order."""
    with open(os.path.join(options.include, library + '.inc'), encoding='latin1') as stream:
        text = re.sub(r'/\*.*?\*/|//[^\n]*', '', stream.read(), flags=re.DOTALL)
    kinds = AS_SKY if library == 'skies' else ON_BALL
    found = [Declared(library, *match) for match in re.findall(r'#\s*declare\s+(\w+)\s*=\s*([a-z_]+)\s*\{', text) if match[1] in kinds]
    return list({one.name: one for one in found}.values())


def is_random(options, file):
    """Whether a finish has `crand`, whose grains no two programs throw alike."""
    plan = subprocess.run([options.isl, 'plan', file, '-I', options.include], capture_output=True, text=True, check=False)
    return re.search(r'^  crand ', plan.stdout.split('left out')[0], re.MULTILINE) is not None


def compare(options, one, folder):
    template, kinds = (SKY, AS_SKY) if one.library == 'skies' else (BALL, ON_BALL)
    file = os.path.join(folder, 'scene.pov')
    with open(file, 'w', encoding='utf8') as stream:
        library = 'glass' if one.library == 'glass_old' else one.library
        stream.write(template.replace('SURFACE', kinds[one.kind]).replace('NAME', one.name).replace('LIBRARY', library))
    row = pairs.compare(options, Scene(one.name, file, False), folder, (SIZE, SIZE))
    if row['verdict'] == 'differs' and is_random(options, file):
        row['figures'], failures = pairs.judge(row['ours'], row['theirs'], True)
        # Blocks whose pixels are half a level apart in the mean have no grain that could be compared.
        failures = [rule for rule in failures if rule != 'grain inf']
        row['verdict'], row['message'] = ('differs', ', '.join(['grain'] + failures)) if failures else ('same', 'grain')
    return row


def page(rows):
    """Both pictures of each with its name."""
    cell = 2 * SIZE + GAP, SIZE + LABEL + GAP
    sheet = Image.new('RGB', (COLUMNS * cell[0], -(-len(rows) // COLUMNS) * cell[1]), 'white')
    drawing = ImageDraw.Draw(sheet)
    for at, (one, row) in enumerate(rows):
        x, y = at % COLUMNS * cell[0], at // COLUMNS * cell[1]
        drawing.text((x + 2, y), f'{one.library}: {one.name}', fill='black' if row['verdict'] == 'same' else 'red')
        for i, which in enumerate(('ours', 'theirs')):
            if row[which] is not None:
                sheet.paste(Image.fromarray(np.rint(encoded(row[which])).astype(np.uint8)), (x + i * SIZE, y + LABEL))
    return sheet


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('names', nargs='*', metavar='NAME', help="a part of identifiers' or files' names [all]")
    parser.add_argument('-o', '--output', default='library_textures.png', help='the page [library_textures.png]')
    programs.add_program_options(parser)
    options = parser.parse_args()
    programs.find_programs(options)
    chosen = [one for library in LIBRARIES for one in declared(options, library)
              if not options.names or any(name in one.name or name in one.library for name in options.names)]
    if not chosen:
        parser.error('no identifier has one of these in its name')
    print(f'{"file":10} {"identifier":28} {"kind":10} {"verdict":13}' + ''.join(f'{heading:>9}' for heading in pairs.HEADINGS))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for one in chosen:
            row = compare(options, one, folder)
            rows.append((one, row))
            note = f'  {row["message"]}' if row['message'] else ''
            print(f'{one.library:10} {one.name:28} {one.kind:10} {row["verdict"]:13}'
                  + ''.join(f'{figure:>9}' for figure in pairs.figures_of(row)) + note, flush=True)
    page(rows).save(options.output)
    for library in LIBRARIES:
        verdicts = [row['verdict'] for one, row in rows if one.library == library]
        if verdicts:
            print(f'{library:10} {verdicts.count("same")} of {len(verdicts)} the same')
    same = sum(row['verdict'] == 'same' for _, row in rows)
    print(f'{same} of {len(rows)} the same; the page: {options.output}')
    return 0 if same == len(rows) else 1


if __name__ == '__main__':
    sys.exit(main())
