#!/usr/bin/env python3
"""Installs the pages and the libraries of a configured build into a folder of its own and looks at them.

usage: installed_files.py CMAKE BUILD

- Every relative link of a page leads to an installed file: `[text](file)` and `<img src="file">`.
- All libraries are where the program looks for them, and nothing that serves the build alone is installed.
"""
import os
import re
import subprocess
import sys
import tempfile
from urllib.parse import unquote

SOURCES = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..')
LINK = re.compile(r'\]\(\s*<?([^)\s>]+)|\b(?:src|href)="([^"]+)"')


def files_below(folder):
    return [os.path.join(place, file) for place, _, files in os.walk(folder) for file in files]


def text_without_code(page):
    with open(page, encoding='utf8') as stream:
        text = stream.read()
    return re.sub(r'`[^`\n]*`', '', re.sub(r'^```.*?^```', '', text, flags=re.M | re.S))


def dangling(page, top):
    """The relative links of a page that lead to no file below `top`."""
    found = []
    for link in LINK.finditer(text_without_code(page)):
        target = unquote((link.group(1) or link.group(2)).split('#')[0])
        if not target or re.match(r'\w+:', target):
            continue
        file = os.path.normpath(os.path.join(os.path.dirname(page), target))
        if not os.path.exists(file) or not file.startswith(top + os.sep):
            found.append(target)
    return found


def main():
    cmake, build = sys.argv[1:]
    wrong, links = [], 0
    with tempfile.TemporaryDirectory() as top:
        top = os.path.realpath(top)
        for component in 'libraries', 'docs':
            subprocess.run([cmake, '--install', build, '--prefix', top, '--component', component], check=True,
                           stdout=subprocess.DEVNULL)
        installed = files_below(top)
        pages = [file for file in installed if file.endswith('.md')]
        for page in pages:
            links += len(LINK.findall(text_without_code(page)))
            wrong += [f'{os.path.relpath(page, top)}: {target} leads nowhere' for target in dangling(page, top)]
        wrong += [f'{os.path.relpath(file, top)} serves the build' for file in installed
                  if os.path.basename(file) == 'CMakeLists.txt']
        wanted, found = ({os.path.relpath(file, folder) for file in files_below(folder)}
                         for folder in (os.path.join(SOURCES, 'stdlib'), os.path.join(top, 'share/isl')))
        wrong += [f'share/isl: {file} is in only one of the folders' for file in sorted(wanted - {'README.md'} ^ found)]
        names = {os.path.basename(page) for page in pages}
        wrong += [f'{page} is not installed' for page in ('README.md', 'CHANGELOG.md', 'language.md')
                  if page not in names]
    print('\n'.join(wrong + [f'{len(installed)} files, {len(pages)} pages, {links} links, {len(wrong)} complaints']))
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
