#!/usr/bin/env python3
"""Every relative link and image of every Markdown file must lead to a file, and to a heading if it names one.

    links.py
"""
import os
import re
import subprocess
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..'))
LINK = re.compile(r'\]\(\s*<?([^)\s>]+)>?(?:\s+"[^"]*")?\s*\)')
SKIPPED = 'build', '.git'


def documents():
    """The Markdown files that git has; all files where there is no git."""
    try:
        listed = subprocess.run(['git', 'ls-files', '-co', '--exclude-standard', '*.md'], cwd=ROOT, capture_output=True, text=True)
    except FileNotFoundError:
        listed = None
    if listed and listed.returncode == 0:
        return sorted(path for path in listed.stdout.splitlines() if os.path.exists(os.path.join(ROOT, path)))
    found = []
    for folder, folders, files in os.walk(ROOT):
        folders[:] = [name for name in folders if name not in SKIPPED]
        found += [os.path.relpath(os.path.join(folder, name), ROOT) for name in files if name.endswith('.md')]
    return sorted(found)


def lines_of_prose(path):
    """The numbered lines of a document outside of its blocks of code."""
    fence = None
    with open(path, encoding='utf-8') as file:
        for number, line in enumerate(file, 1):
            found = re.match(r' {0,3}(`{3,}|~{3,})', line)
            if found and fence is None:
                fence = found.group(1)
            elif found and line.strip().strip(fence[0]) == '' and len(found.group(1)) >= len(fence):
                fence = None
            elif fence is None:
                yield number, line


def anchors_of(path, known={}):
    """The names by which links reach the headings of a document, as GitHub makes them."""
    if path not in known:
        known[path] = set()
        for _, line in lines_of_prose(path):
            heading = re.match(r'#{1,6}\s+(.*?)\s*#*\s*$', line)
            if heading:
                text = re.sub(r'\[([^]]*)\]\([^)]*\)', r'\1', heading.group(1)).lower()
                name = re.sub(r'[^\w\- ]', '', text).replace(' ', '-')
                number, unique = 0, name
                while unique in known[path]:
                    number += 1
                    unique = f'{name}-{number}'
                known[path].add(unique)
            known[path].update(re.findall(r'<a (?:id|name)="([^"]+)"', line))
    return known[path]


def complaints_of(document):
    path = os.path.join(ROOT, document)
    for number, line in lines_of_prose(path):
        for target in LINK.findall(re.sub(r'`[^`]*`', '', line)):
            if re.match(r'[a-z][a-z0-9+.-]*:', target):
                continue
            file, _, anchor = target.partition('#')
            there = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
            if not os.path.exists(there):
                yield f'{document}:{number}: {target}: there is no such file'
            elif anchor and there.endswith('.md') and anchor not in anchors_of(there):
                yield f'{document}:{number}: {target}: there is no such heading'


def main():
    found = documents()
    complaints = [text for document in found for text in complaints_of(document)]
    print('\n'.join(complaints + [f'{len(found)} documents, {len(complaints)} complaints']))
    return 1 if complaints or not found else 0


if __name__ == '__main__':
    sys.exit(main())
