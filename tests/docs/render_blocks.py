#!/usr/bin/env python3
"""Renders every block of scene text in the documents small, with one sample a pixel; none may complain.

    render_blocks.py PROGRAM [DOCUMENT.md ...]

The word after the fence says what a block is:

    ```isl          a whole scene, which renders as it stands
    ```isl part     a part of a scene, which renders behind HEAD
    ```isl text     the form of a construct, or a scene that needs files; it is not rendered

A block may take a picture from `paper.png`.

Without documents, those of DOCUMENTS are read. Prints the file and line of each block with an error or a warning.
"""
import concurrent.futures
import glob
import os
import re
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..'))
DOCUMENTS = 'README.md', 'docs/*.md', 'stdlib/README.md', 'scenes/gallery/README.md'
HEAD = '''#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at <0, 0.5, 0> angle 36 }
light_source { <-5, 8, -5> rgb 1 }
background { rgb <0.7, 0.8, 0.9> }
'''
# Blocks that only print something hold no object, and what shines by itself needs no light.
EXPECTED = 'holds no object', 'has no light_source'
KINDS = '', 'part', 'text'
PICTURE = 'paper.png'


def write_picture(path):
    """A PNG file of one grey pixel, which blocks may take pictures from."""
    def chunk(name, content):
        return struct.pack('>I', len(content)) + name + content + struct.pack('>I', zlib.crc32(name + content))

    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', 1, 1, 8, 0, 0, 0, 0)) +
                   chunk(b'IDAT', zlib.compress(b'\0\x80')) + chunk(b'IEND', b''))


def blocks(document):
    """The line, the kind and the text of each block of scene text."""
    fence = None
    with open(document, encoding='utf-8') as file:
        for number, line in enumerate(file, 1):
            found = re.match(r' {0,3}(`{3,})\s*(.*?)\s*$', line)
            if fence is None:
                if found:
                    fence, begin, words, text = found.group(1), number, found.group(2).split(None, 1), []
            elif found and not found.group(2) and len(found.group(1)) >= len(fence):
                if words[:1] == ['isl']:
                    yield begin, words[1] if len(words) > 1 else '', ''.join(text)
                fence = None
            else:
                text.append(line)
    if fence is not None:
        yield begin, 'without an end', ''


def complaint(program, folder, document, line, kind, text):
    place = f'{os.path.relpath(document, ROOT)}:{line}'
    if kind not in KINDS:
        return f'{place}: a block of the kind "{kind}"; there are "isl", "isl part" and "isl text"'
    name = os.path.join(folder, re.sub(r'\W', '_', place))
    with open(name + '.isl', 'w', encoding='utf-8') as file:
        file.write((HEAD if kind == 'part' else '') + text)
    ran = subprocess.run([program, 'render', name + '.isl', '-o', name + '.png', '-s', '40x30', '--samples', '1', '-t', '1',
                          '-q', '--no-system-libraries'], capture_output=True, text=True, cwd=folder)
    warnings = [line for line in ran.stderr.splitlines()
                if 'warning:' in line and not any(expected in line for expected in EXPECTED)]
    return f'{place}:\n{ran.stderr.strip()}' if ran.returncode or warnings else ''


def main():
    program = os.path.abspath(sys.argv[1])
    documents = sys.argv[2:] or sorted(path for pattern in DOCUMENTS for path in glob.glob(os.path.join(ROOT, pattern)))
    found = [(os.path.abspath(document), *block) for document in documents for block in blocks(document)]
    rendered = [block for block in found if block[2] != 'text']
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        write_picture(os.path.join(folder, PICTURE))
        complaints = [text for text in pool.map(lambda block: complaint(program, folder, *block), rendered) if text]
    print('\n'.join(complaints + [f'{len(rendered)} blocks, {len(complaints)} complaints']))
    return 1 if complaints or not rendered else 0


if __name__ == '__main__':
    sys.exit(main())
