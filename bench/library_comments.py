"""Reads the comments of the libraries in stdlib/: what they declare, and the examples. stdlib/README.md describes their form.
Imported by the scripts of this folder."""
import glob
import os
import re
from collections import namedtuple

HERE = os.path.dirname(os.path.abspath(__file__))
STDLIB = os.path.join(HERE, '../stdlib')

# `kind` is `macro`, or what the comment says; `example` is None of what is declared.
Entry = namedtuple('Entry', 'library name kind parameters text example line')


def libraries():
    return sorted(os.path.basename(file) for file in glob.glob(os.path.join(STDLIB, '*.isl')))


def entries(library):
    """The entries of one file, in its order, and a list of what is wrong with it."""
    found, wrong, comment = [], [], []
    prefix = library.split('.')[0].capitalize() + '_Isl_'
    with open(os.path.join(STDLIB, library), encoding='utf8') as stream:
        for number, line in enumerate(stream, 1):
            where = f'{library}:{number}'
            if len(line.rstrip('\n')) > 120:
                wrong.append(f'{where}: {len(line) - 1} characters')
            if line.startswith('//'):
                comment.append(line[2:].strip())
                continue
            macro = re.match(r'#macro (\w+)\s*\(([^)]*)\)', line)
            declared = re.match(r'#declare (\w+)\b', line)
            name = (macro or declared) and (macro or declared).group(1)
            if name and not name.startswith(prefix):
                if macro:
                    found.append(_of_macro(library, name, macro.group(2), comment, number))
                else:
                    found.append(_of_declaration(library, name, comment, number))
                if not found[-1]:
                    wrong.append(f'{where}: {name} has no comment in the form of stdlib/README.md')
                    found.pop()
            comment = []
    return found, wrong


def _of_macro(library, name, parameters, comment, line):
    wanted = f'{name}({parameters})'
    example = [i for i, text in enumerate(comment) if text.startswith('Example:')]
    if wanted not in comment or not example:
        return None
    first = comment.index(wanted)
    code = [comment[example[0]][len('Example:'):].strip()] + comment[example[0] + 1:]
    names = [part.strip() for part in parameters.split(',') if part.strip()]
    return Entry(library, name, 'macro', names, ' '.join(comment[first + 1:example[0]]), '\n'.join(code), line)


def _of_declaration(library, name, comment, line):
    for first, text in enumerate(comment):
        match = re.match(rf'{name}: (\w+)\. (.+)', text)
        if match:
            return Entry(library, name, match.group(1), [], ' '.join([match.group(2)] + comment[first + 1:]), None, line)
    return None
