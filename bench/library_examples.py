#!/usr/bin/env python3
"""Checks the libraries of stdlib/*.isl: their comments, names and examples.

    bench/library_examples.py [FILE.isl…] [-o FOLDER] [--isl PROGRAM] [--list]

- Every macro and everything declared has a comment in the form of stdlib/README.md, and no line is longer than 120 characters.
- No name is declared by two libraries, or by one of POV-Ray's include files, where the system has them.
- Every library can be included alone, twice, and with all others.
- Every example renders (40x30, one sample a pixel) without errors and warnings. So does everything that is declared.
- No finish scatters and mirrors more than all light: the mean of what is scattered and the greatest mirror are together at
  most 1.

With -o the pictures are kept, 320x240, as LIBRARY_NAME.png. --list prints every entry as a line of JSON and does nothing else.
The exit code is 1 if something is wrong. Needs nothing but Python.
"""
import argparse
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

from library_comments import HERE, STDLIB, entries, libraries

POVRAY = '/usr/share/povray-3.7/include'
# What stands around an example. Examples of cameras.isl bring a camera.
HEAD = ('#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n#include "{}"\nlight_source {{ <-5, 8, -5> rgb 1 }}\n'
        'background {{ rgb <0.3, 0.34, 0.38> }}\n')
CAMERA = 'camera { location <0, 1.2, -6> look_at 0 angle 36 }\n'
# A scene that shows what is declared, by its kind.
SHOWN = {
    'texture': 'sphere {{ 0, 1 texture {{ {} }} }}',
    'material': 'sphere {{ 0, 1 material {{ {} }} }}',
    'finish': 'sphere {{ 0, 1 pigment {{ rgb 0.5 }} finish {{ {} }} interior {{ ior 1.5 }} }}',
    'number': 'sphere {{ 0, min(1, {}) }}',
    'colour': 'sphere {{ 0, 1 pigment {{ {} }} }}',
    'ramp': 'sphere {{ 0, 1 pigment {{ gradient y RampMap({}) scale 2 translate -y }} }}',
    'sky_sphere': 'sky_sphere {{ {} }} sphere {{ 0, 1 finish {{ reflection 1 diffuse 0 }} }}',
}


def povray_names():
    names = {}
    for file in glob.glob(os.path.join(POVRAY, '*.inc')):
        with open(file, encoding='latin-1') as stream:
            for name in re.findall(r'#\s*(?:declare|macro)\s+(\w+)', stream.read()):
                names[name] = os.path.basename(file)
    return names


def run(options, text, *arguments):
    """What the program says about a scene: nothing if all is well."""
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, 'example.isl')
        with open(scene, 'w', encoding='utf8') as stream:
            stream.write(text)
        picture = [] if '-o' in arguments else ['-o', os.path.join(folder, 'example.png')]
        ran = subprocess.run([options.isl, 'render', scene, *picture, '-q', '-t', '1', '-I', STDLIB, *arguments],
                             capture_output=True, text=True)
        return ran.stderr if ran.stderr or not ran.returncode else f'exit code {ran.returncode}'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('files', nargs='*', metavar='FILE.isl')
    parser.add_argument('-o', metavar='FOLDER')
    parser.add_argument('--isl', default=os.environ.get('ISL', os.path.join(HERE, '../build/release/bin/isl')))
    parser.add_argument('--list', action='store_true')
    options = parser.parse_args()

    wrong, owners, all_entries = [], {}, {}
    for library in libraries():
        all_entries[library], complaints = entries(library)
        wrong += complaints
        for entry in all_entries[library]:
            if entry.name in owners:
                wrong.append(f'{library}:{entry.line}: {entry.name} is declared in {owners[entry.name]}, too')
            owners[entry.name] = library
    if options.list:
        for library in libraries():
            for entry in all_entries[library]:
                print(json.dumps(entry._asdict(), ensure_ascii=False))
        return 0
    for name, file in povray_names().items():
        if name in owners:
            wrong.append(f"{owners[name]}: {name} is a name of POV-Ray's {file}")

    size = ['-s', '320x240'] if options.o else ['-s', '40x30', '--samples', '1']
    chosen = [library for library in libraries() if not options.files or library in options.files]
    count = 0
    for library in chosen:
        head = HEAD.format(library) + ('' if library == 'cameras.isl' else CAMERA)
        message = run(options, head.replace('#include', f'#include "{library}"\n#include', 1) + 'sphere { 3*z, 1 }', *size)
        if message:
            wrong.append(f'{library}, included twice: {message}')
        for entry in all_entries[library]:
            text = entry.example if entry.kind == 'macro' else SHOWN.get(entry.kind, '').format(entry.name)
            if not text:
                wrong.append(f'{library}:{entry.line}: {entry.name} is of an unknown kind, {entry.kind}')
                continue
            if entry.kind == 'macro' and not re.search(rf'\b{entry.name}\(', text):
                wrong.append(f'{library}:{entry.line}: the example of {entry.name} does not call it')
            picture = ['-o', os.path.join(options.o, f'{library[:-4]}_{entry.name}.png')] if options.o else []
            message = run(options, head + text + '\n', *size, *picture)
            count += 1
            if message:
                wrong.append(f'{library}:{entry.line}: {entry.name}: {message}')
    everything = ''.join(f'#include "{library}"\n' for library in libraries())
    message = run(options, everything + 'sphere { 0, 1 } light_source { 5, 1 } camera { location -5*z }', *size)
    if message:
        wrong.append(f'all together: {message}')
    wrong += too_bright(options, everything, all_entries)

    print('\n'.join(wrong + [f'{count} examples and declarations, {len(wrong)} complaints']))
    return 1 if wrong else 0


def too_bright(options, everything, all_entries):
    """Finishes that give more light than they get: read from the database of a scene that has all textures."""
    objects = ''.join(SHOWN[entry.kind].format(entry.name) + '\n' for library in all_entries for entry in all_entries[library]
                      if entry.kind in ('texture', 'material', 'finish'))
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, 'all.isl')
        with open(scene, 'w', encoding='utf8') as stream:
            stream.write(everything + objects + 'light_source { 5, 1 } camera { location -5*z }')
        ran = subprocess.run([options.isl, 'dump', '--stage', 'database', '-I', STDLIB, scene], capture_output=True, text=True)
    found = []
    for texture in json.loads(ran.stdout)['textures']:
        # The share of evenly incoming light that is scattered: the mean of cos^brilliance over the hemisphere.
        scattered = texture.get('diffuse', 0) * 2 / (1 + texture.get('brilliance', 1))
        reflection = texture.get('reflection', {})
        # Fresnel's mirror with `conserve_energy` takes its light from what goes through.
        mirrored = 0 if reflection.get('fresnel') and texture.get('conserve_energy') else max(reflection.get('maximum', [0]))
        if scattered + mirrored > 1.0001 and texture not in found:
            found.append(texture)
    return [f'too bright: {json.dumps(texture)}' for texture in found]


if __name__ == '__main__':
    sys.exit(main())
