#!/usr/bin/env python3
"""Compares what `isl library --format json` lists with what bench/library_comments.py reads from the same files.

usage: library_command.py ISL

Besides, every library and the first entry of each are found by their names.
"""
import json
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../bench'))
from library_comments import STDLIB, entries, libraries  # noqa: E402


def listed(program, *name):
    ran = subprocess.run([program, 'library', *name, '--format', 'json'], capture_output=True, text=True)
    return json.loads(ran.stdout)['libraries'] if ran.returncode == 0 else []


def wanted_of(entry):
    return {'name': entry.name, 'kind': entry.kind, 'parameters': entry.parameters, 'text': entry.text,
            'example': entry.example, 'line': entry.line}


def plain(row):
    """An entry of the program's as the scripts have it: text in one line, examples without indentation."""
    example = row['example'] and '\n'.join(line.strip() for line in row['example'].split('\n'))
    return {**row, 'text': ' '.join(row['text'].split('\n')), 'example': example}


def main():
    program = sys.argv[1]
    found = {library['file']: library for library in listed(program)}
    wrong = []
    files = {file for file in os.listdir(STDLIB) if file.endswith(('.isl', '.inc'))}
    if files != set(found):
        wrong.append(f'listed are {sorted(found)}, and the folder has {sorted(files)}')
    wrong += [f'{file}: it has no sentence about itself' for file, library in found.items() if not library['purpose']]
    count = 0
    for library in libraries():
        wanted, complaints = entries(library)
        wrong += complaints
        rows = [plain(row) for row in found.get(library, {'entries': []})['entries']]
        if [row['name'] for row in rows] != [entry.name for entry in wanted]:
            wrong.append(f'{library}: other entries are listed: {[row["name"] for row in rows]}')
            continue
        for row, entry in zip(rows, wanted):
            count += 1
            if row != wanted_of(entry):
                wrong.append(f'{library}: {entry.name} is listed as {row}')
    for library in libraries():
        alone = listed(program, library)
        if [one['file'] for one in alone] != [library]:
            wrong.append(f'{library}: `isl library {library}` does not explain it')
        for entry in entries(library)[0][:1]:
            if [row['name'] for one in listed(program, entry.name) for row in one['entries']] != [entry.name]:
                wrong.append(f'{library}: `isl library {entry.name}` does not explain it')
    print('\n'.join(wrong + [f'{count} entries, {len(wrong)} complaints']))
    return 1 if wrong or not count else 0


if __name__ == '__main__':
    sys.exit(main())
