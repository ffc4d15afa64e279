#!/usr/bin/env python3
"""Checks that every macro of stdlib/ is called: by a test, a scene, a page of the documentation, an example in a comment
of its own, or another macro. Prints those that are not; the exit code is 1 if there are any."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TEXTS = 'tests/**/*.pov', 'tests/**/*.isl', 'tests/**/*.cpp', 'scenes/**/*.isl', 'docs/*.md', 'stdlib/*.inc', 'stdlib/*.isl'
DECLARATION = re.compile(r'#macro\s+(\w+)\s*\([^)]*\)')
# A comment begins with the name of its macro and the parameters, which is no call.
HEADING = re.compile(r'^// \w+\([^)]*\)$', re.MULTILINE)
# It makes an isosurface, which is refused.
REFUSED = {'Supertorus'}


def main():
    texts = [file.read_text(encoding='utf8') for pattern in TEXTS for file in ROOT.glob(pattern)]
    called = set(re.findall(r'\b(\w+)\s*\(', '\n'.join(HEADING.sub('', DECLARATION.sub('', text)) for text in texts)))
    macros = [(file, name) for file in sorted((ROOT / 'stdlib').glob('*.i*'))
              for name in DECLARATION.findall(file.read_text(encoding='utf8'))]
    left = [(file, name) for file, name in macros if name not in called | REFUSED]
    for file, name in left:
        print(f'{file.relative_to(ROOT)}: {name} is never called')
    print(f'{len(macros)} macros, {len(left)} never called')
    return 1 if left or not macros else 0


if __name__ == '__main__':
    sys.exit(main())
