#!/usr/bin/env python3
"""The graph of includes between the folders of a part of the tree, as its sources have it today.

  bench/include_graph.py [PART]      PART: renderer (default), cli, interpreter, …

One row a folder, in an order in which each comes after all that it includes: its files, the median and the longest of their
lengths in lines, and the folders that it includes. Below stand the cycles, if there are any; the exit code is then 1.
"""
import re
import statistics
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
SOURCES = {".h", ".cpp", ".def", ".ll", ".yy"}


def read(part):
    """Of each folder, by its path from the top: the lengths of its files by name, and the folders of the part that it includes."""
    lengths, includes = {}, {}
    for path in sorted((ROOT / part).rglob("*")):
        if path.suffix not in SOURCES or not path.is_file():
            continue
        folder = str(path.parent.relative_to(ROOT))
        text = path.read_text(encoding="utf-8")
        lengths.setdefault(folder, {})[path.name] = text.count("\n")
        for name in INCLUDE.findall(text):
            other = str(Path(name).parent)
            if other != folder and (other == part or other.startswith(part + "/")):
                includes.setdefault(folder, set()).add(other)
    return lengths, {folder: includes.get(folder, set()) for folder in lengths}


def components(graph):
    """The strongly connected components, each after all that it reaches (Tarjan 1972)."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for other in sorted(graph[node]):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            place = stack.index(node)
            found.append(sorted(stack[place:]))
            del stack[place:]

    for node in sorted(graph):
        if node not in index:
            visit(node)
    return found


def main():
    part = sys.argv[1].rstrip("/") if len(sys.argv) > 1 else "renderer"
    if not (ROOT / part).is_dir():
        sys.exit(f"there is no folder '{part}'")
    lengths, graph = read(part)
    graph = {folder: {other for other in others if other in graph} for folder, others in graph.items()}
    short = lambda folder: folder[len(part) + 1:] or part
    groups = components(graph)
    width = max(len(short(folder)) for folder in graph)
    print(f"{'folder':{width}} files median longest")
    for folder in (folder for group in groups for folder in group):
        lines = lengths[folder]
        longest = max(lines, key=lines.get)
        includes = " ".join(short(other) for group in groups for other in group if other in graph[folder])
        print(f"{short(folder):{width}} {len(lines):5} {statistics.median(lines.values()):6.0f} {lines[longest]:7}  {longest}")
        if includes:
            print(f"{'':{width}}   includes {includes}")
    cycles = [group for group in groups if len(group) > 1]
    for group in cycles:
        print("cycle: " + " ".join(short(folder) for folder in group))
    if not cycles:
        print("no cycle")
    return 1 if cycles else 0


if __name__ == "__main__":
    sys.exit(main())
