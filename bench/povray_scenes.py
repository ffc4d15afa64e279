#!/usr/bin/env python3
"""Scenes written for POV-Ray, each read and rendered by isl and by POV-Ray 3.7: what is accepted, what is refused and by which word,
whether the pictures are alike, and the time to trace them.

    bench/povray_scenes.py [FOLDER] [-o WORK] [-s WxH] [--sample N] [--only PART] [--timeout S] [--again] [--no-include]
                           [--isl PROGRAM] [--povray PROGRAM] [--include FOLDER]

FOLDER holds the scenes (POV-Ray's own, /usr/share/povray-3.7/scenes). They are copied to WORK (povray_scenes_out), because some write
files beside themselves. WORK keeps every verdict and picture: a second run continues the first, or repeats isl's part for --again.
--sample takes N scenes at even distances, --only those with PART in their path.

isl checks and renders each scene strictly: what it does not have is an error. Pictures have one ray a pixel and are made by one
thread. Two are alike if the structural similarity of their encoded luma, in windows of 7x7 pixels (Wang et al. 2004), is at least
0.95 in the mean and 0.7 at the 5th percentile. Two black pictures are no evidence; they are counted apart, as is a pair of
which one is black.

Needs povray, povray-includes, povray-examples, python3-numpy and python3-pil.
"""
import argparse
import collections
import hashlib
import json
import os
import re
import shutil
import sys

import programs
from pictures import np, read_encoded, similarity

SCENES = '/usr/share/povray-3.7/scenes'
BLACK = 3  # of 255: no pixel of a black picture is brighter


def is_animation(scene):
    """True if there is a settings file of the scene's name. Then its first frame is rendered."""
    return os.path.exists(os.path.splitext(scene)[0] + '.ini')


def verdict(ran):
    """accepted, refused (by which words) or failed (with the first message). Errors after a refusal may be its consequences."""
    if ran.code == 0:
        return 'accepted', ''
    if ran.code is None:
        return 'failed', 'timed out'
    messages = re.findall(r'error: (.*)', ran.errors)
    refusals = filter(programs.is_refusal, messages)
    if messages and programs.is_refusal(messages[0]):
        return 'refused', ', '.join(sorted({re.split(r' (?:is|are) not ', m)[0] for m in refusals}))
    return 'failed', messages[0] if messages else (ran.errors.strip()[-200:] or programs.describe(ran))


class Comparison:
    def __init__(self, options):
        self.options = options
        self.scenes = os.path.join(options.work, 'scenes')
        self.written = os.path.join(options.work, 'written')
        os.makedirs(self.written, exist_ok=True)
        if not os.path.isdir(self.scenes):
            shutil.copytree(options.folder, self.scenes, ignore_dangling_symlinks=True)

    def names(self):
        found = sorted(os.path.relpath(os.path.join(place, name), self.scenes)
                       for place, _, names in os.walk(self.scenes) for name in names if name.lower().endswith('.pov'))
        found = [name for name in found if self.options.only in name]
        sample = self.options.sample or len(found)
        return found if sample >= len(found) else [found[i * len(found) // sample] for i in range(sample)]

    def arguments(self, scene):
        """Options of isl for a scene."""
        frame = ['--frame', '1'] if is_animation(scene) else []
        include = [] if self.options.no_include else ['-I', self.options.include]
        return ['--allow-write', self.written, *include, *frame]

    def ours(self, scene, picture):
        folder, limit, stats = os.path.dirname(scene), self.options.timeout, os.path.join(self.options.work, 'stats.json')
        arguments = self.arguments(scene)
        check = programs.Ran([self.options.isl, 'check', scene, *arguments], folder, limit)
        result = {'check': verdict(check)}
        ran = programs.run_isl(self.options, scene, picture, self.options.size, '--stats', stats, *arguments, folder=folder,
                               timeout=limit)
        result.update(render=verdict(ran), seconds=ran.seconds)
        if ran.code == 0:
            with open(stats, encoding='utf8') as stream:
                result['trace'] = json.load(stream)['time']['trace']
            result['effects'] = self.effects(scene, arguments)
        return result

    def effects(self, scene, arguments):
        """Names of the effects that the scene calls for: where a picture is not alike, one of them is the reason."""
        plan = programs.Ran([self.options.isl, 'plan', scene, '--format', 'json', *arguments], os.path.dirname(scene),
                            self.options.timeout)
        return [effect['name'] for effect in json.loads(plan.output).get('called_for', [])] if plan.code == 0 else []

    def theirs(self, scene, picture, size):
        """POV-Ray's verdict; a scene that is only parsed gets a size of a few pixels."""
        frame = ['+KFI1', '+KFF2', '+SF1', '+EF1'] if is_animation(scene) else []
        ran = programs.run_povray(self.options, scene, picture, size, *frame, folder=os.path.dirname(scene),
                                  timeout=self.options.timeout)
        if frame and ran.code == 0:  # POV-Ray puts the number of the frame behind the name
            os.replace(picture.replace('.png', '1.png'), picture)
        trace = re.search(r'Trace Time:.*?\(([\d.]+) seconds\)', ran.errors)
        rendered = ran.code == 0 and os.path.exists(picture)
        return {'parses': rendered or 'Parse Time:' in ran.errors and 'Parse Error' not in ran.errors, 'renders': rendered,
                'size': size, 'message': '' if rendered else programs.povray_message(ran), 'trace': float(trace.group(1)) if trace else None}

    def run(self, name, before):
        scene = os.path.join(self.scenes, name)
        key = hashlib.sha256(name.encode()).hexdigest()[:12]
        pictures = [os.path.join(self.options.work, f'{key}-{program}.png') for program in ('isl', 'povray')]
        result = {'key': key, 'isl': self.ours(scene, pictures[0])}
        size = self.options.size if result['isl']['render'][0] == 'accepted' else (8, 6)
        known = before.get('povray') if before else None
        result['povray'] = known if known and tuple(known['size']) == size else self.theirs(scene, pictures[1], size)
        if size == self.options.size and result['povray']['renders']:
            result['pair'] = compare(*pictures)
        return result


def compare(picture, reference_picture):
    a, b = read_encoded(picture), read_encoded(reference_picture)
    mean, low = similarity(a, b)
    return {'similarity': mean, 'low': low, 'differing': float((np.abs(a - b).max(2) > 4).mean()),
            'off': (a.mean((0, 1)) - b.mean((0, 1))).round(1).tolist(), 'black': [bool(a.max() <= BLACK), bool(b.max() <= BLACK)]}


def is_alike(pair):
    return pair['similarity'] >= .95 and pair['low'] >= .7


def row_of(result):
    """The word of the table for a scene, and the reason for it."""
    ours, theirs, pair = result['isl'], result['povray'], result.get('pair')
    for stage in ('check', 'render'):
        if ours[stage][0] != 'accepted':
            word, reason = ours[stage]
            where = '' if word == 'refused' else f'{stage}: '
            return (word if theirs['parses'] else 'both fail'), where + reason
    if not theirs['renders']:
        return 'alone', f"POV-Ray: {theirs['message']}"
    if any(pair['black']):
        return 'black', {(True, True): 'both pictures', (True, False): 'only ours', (False, True): "only POV-Ray's"}[tuple(pair['black'])]
    figures = f"similarity {pair['similarity']:.3f}, 5th percentile {pair['low']:.3f}, {100 * pair['differing']:.1f} % of pixels differ"
    if is_alike(pair):
        return 'alike', figures
    means = ' '.join(f'{value:+.1f}' for value in pair['off'])
    return 'unlike', f"{figures}, mean off by {means} of 255; effects: {', '.join(ours['effects'])}"


MEANINGS = {
    'alike': 'rendered, and alike', 'unlike': 'rendered, and not alike', 'black': 'rendered, and a picture is black',
    'alone': "rendered by isl, and not by POV-Ray", 'refused': 'refused by name', 'failed': 'failed otherwise',
    'both fail': 'accepted by neither'}


def report(results):
    rows = {name: row_of(result) for name, result in results.items()}
    for name, (word, reason) in sorted(rows.items(), key=lambda item: (list(MEANINGS).index(item[1][0]), item[0])):
        print(f'{word:10} {name:52} {reason}')
    count = collections.Counter(word for word, _ in rows.values())
    print(f'\n{len(rows)} scenes')
    for word, meaning in MEANINGS.items():
        print(f'  {count[word]:4} {meaning}')
    compared = count['alike'] + count['unlike']
    rendered = compared + count['black'] + count['alone']
    share = f" ({100 * count['alike'] / compared:.1f} %)" if compared else ''
    print(f"rendered {rendered}; alike {count['alike']} of {compared}{share}")
    words = collections.Counter(word for kind, reason in rows.values() if kind == 'refused' for word in reason.split(', '))
    if words:
        print('refused because of:', ', '.join(f'{word} {n}' for word, n in words.most_common(40)))
    disagree = [name for name, r in results.items() if r['isl']['check'] != r['isl']['render'] and r['isl']['check'][0] != 'accepted']
    if disagree:
        print('check and render disagree:', ', '.join(disagree))
    timed = sorted((r['povray']['trace'] / r['isl']['trace'], name) for name, r in results.items()
                   if 'pair' in r and (r['povray']['trace'] or 0) > .02 and r['isl'].get('trace'))
    if timed:
        print(f"time to trace, POV-Ray's over ours: median {timed[len(timed) // 2][0]:.2f}, slower on"
              f" {sum(ratio < 1 for ratio, _ in timed)} of {len(timed)}; slowest:",
              ', '.join(f'{name} {ratio:.2f}' for ratio, name in timed[:10]))


def size_of(text):
    width, _, height = text.partition('x')
    return int(width), int(height)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('folder', nargs='?', default=SCENES, help=f'the scenes [{SCENES}]')
    parser.add_argument('-o', '--work', default='povray_scenes_out', help='results, pictures, copies [povray_scenes_out]')
    parser.add_argument('-s', '--size', type=size_of, default=(320, 240), metavar='WxH', help='size of the pictures [320x240]')
    parser.add_argument('--sample', type=int, metavar='N', help='take N scenes at even distances')
    parser.add_argument('--only', default='', metavar='PART', help='take scenes with this in their path')
    parser.add_argument('--timeout', type=float, default=120, metavar='S', help='seconds for each program and scene [120]')
    parser.add_argument('--again', action='store_true', help="repeat isl's part, keep POV-Ray's")
    parser.add_argument('--no-include', action='store_true', help='isl gets no -I: it finds libraries by itself')
    programs.add_program_options(parser)
    options = parser.parse_args()
    programs.find_programs(options)
    options.folder, options.work = os.path.realpath(options.folder), os.path.abspath(options.work)
    if not os.path.isdir(options.folder):
        sys.exit(f"povray_scenes.py: no folder {options.folder} (POV-Ray's scenes are in Debian's package povray-examples)")
    comparison = Comparison(options)
    table = os.path.join(options.work, 'results.json')
    known = {}
    if os.path.exists(table):
        with open(table, encoding='utf8') as stream:
            known = json.load(stream)
    results = {}
    names = comparison.names()
    for i, name in enumerate(names):
        is_done = name in known and tuple(known[name]['size']) == options.size
        results[name] = known[name] if is_done and not options.again else comparison.run(name, known.get(name))
        results[name]['size'] = options.size
        known[name] = results[name]
        with open(table, 'w', encoding='utf8') as stream:
            json.dump(known, stream, indent=1)
        if sys.stderr.isatty():
            print(f'\r{i + 1} of {len(names)}', end='', file=sys.stderr, flush=True)
    report(results)


if __name__ == '__main__':
    main()
