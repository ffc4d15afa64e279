#!/usr/bin/env python3
"""Scenes written for POV-Ray, each read and rendered by isl and by POV-Ray 3.7: what is accepted, what is refused and by
which word, whether the pictures are alike, and the time to trace them.

    bench/compare_scenes.py FOLDER [-o WORK] [--isl PROGRAM] [--include FOLDER] [--no-include] [--again]

FOLDER holds the scenes (POV-Ray's own: /usr/share/doc/povray/examples); they are read where they lie and may write only to WORK.
WORK keeps every verdict and picture; a second run repeats isl's part alone for --again and continues otherwise.

Pictures: 320x240, one ray a pixel, one thread each. Two are alike if the structural similarity of their encoded luma, in windows of
7x7 pixels (Wang et al. 2004), is at least 0.95 in the mean and 0.7 at the 5th percentile. Two black pictures are no evidence; they
are counted apart, as is a pair of which one is black.

Needs povray, povray-includes, python3-numpy, python3-pil and python3-scipy.
"""
import argparse
import collections
import hashlib
import json
import os
import re
import resource
import subprocess

import numpy as np
from PIL import Image
from scipy.ndimage import uniform_filter

INCLUDES = '/usr/share/povray-3.7/include'
TIMEOUT = 120  # seconds for each program and scene
BLACK = 3      # of 255: no pixel of a black picture is brighter


def run(command, folder):
    """Exit code (None after a timeout), standard error, and processor seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        process = subprocess.run(command, capture_output=True, timeout=TIMEOUT, stdin=subprocess.DEVNULL, cwd=folder)
        code, errors = process.returncode, process.stderr.decode('utf8', 'replace')
    except subprocess.TimeoutExpired as expired:
        code, errors = None, (expired.stderr or b'').decode('utf8', 'replace')
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return code, errors, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def load(file):
    image = Image.open(file)
    if image.mode.startswith('I'):
        return np.repeat(np.asarray(image, float)[..., None] / 257, 3, 2)
    return np.asarray(image.convert('RGB'), float)


def similarity(a, b):
    """Mean and 5th percentile of the structural similarity of two pictures' luma."""
    weights = np.array([.299, .587, .114])
    x, y = a @ weights, b @ weights
    mean_x, mean_y = uniform_filter(x, 7), uniform_filter(y, 7)
    var_x, var_y = uniform_filter(x * x, 7) - mean_x**2, uniform_filter(y * y, 7) - mean_y**2
    covariance = uniform_filter(x * y, 7) - mean_x * mean_y
    c1, c2 = (.01 * 255)**2, (.03 * 255)**2
    ssim = (2 * mean_x * mean_y + c1) * (2 * covariance + c2) / ((mean_x**2 + mean_y**2 + c1) * (var_x + var_y + c2))
    return float(ssim.mean()), float(np.percentile(ssim, 5))


def povray(scene, picture, size, includes):
    command = ['povray', f'+I{scene}', f'+O{picture}', f'+W{size[0]}', f'+H{size[1]}', '-D', '-A', '-P', '+WT1', f'+L{includes}']
    return run(command, os.path.dirname(scene))


def parsed_by_povray(scene, picture, includes):
    """Whether POV-Ray can parse the scene: it begins to trace a tiny picture."""
    code, errors, _ = povray(scene, picture, (8, 6), includes)
    message = re.search(r'(?:Parse Error|Fatal error)[^\n]*:([^\n]*(?:\n[^\n]+)?)', errors)
    return {'parses': code == 0 or 'Parse Time:' in errors and 'Parse Error' not in errors,
            'message': message.group(0).strip()[-200:] if message else ''}


def rendered_by_povray(scene, picture, includes):
    """POV-Ray's picture and the seconds that it traced."""
    code, errors, seconds = povray(scene, picture, (320, 240), includes)
    trace = re.search(r'Trace Time:.*?\(([\d.]+) seconds\)', errors)
    return {'renders': code == 0 and os.path.exists(picture), 'seconds': seconds,
            'trace': float(trace.group(1)) if trace else None}


def verdict(code, errors):
    """accepted, refused (by which words) or failed (the first message that is no refusal)."""
    if code == 0:
        return 'accepted', ''
    messages = re.findall(r'error: (.*)', errors)
    others = [m for m in messages if not re.search(r' (is|are) not (supported|rendered)', m) and 'errors found' not in m]
    if others or not messages:
        return 'failed', others[0] if others else (errors.strip()[-200:] or f'exit code {code}')
    return 'refused', ', '.join(sorted({m.split(' is not')[0].split(' are not')[0] for m in messages}))


def ours(isl, scene, picture, includes, writable, stats):
    # A scene with a settings file of its name is an animation: its first frame.
    frame = ['--frame', '1'] if os.path.exists(os.path.splitext(scene)[0] + '.ini') else []
    common = [scene, '--allow-write', writable, *(['-I', includes] if includes else []), *frame]
    folder = os.path.dirname(scene)
    code, errors, _ = run([isl, 'check', *common], folder)
    result = {'check': verdict(code, errors)}
    code, errors, seconds = run([isl, 'render', *common, '-q', '-s', '320x240', '-t', '1', '--samples', '1', '--stats', stats,
                                 '-o', picture], folder)
    result.update(render=verdict(code, errors), seconds=seconds)
    if code == 0:
        with open(stats) as file:
            result['trace'] = json.load(file)['time']['trace']
    return result


def compare(picture, reference_picture):
    a, b = load(picture), load(reference_picture)
    mean, low = similarity(a, b)
    return {'similarity': mean, 'low': low, 'differing': float((np.abs(a - b).max(2) > 4).mean()),
            'black': [bool(a.max() <= BLACK), bool(b.max() <= BLACK)]}


def is_alike(pair):
    return pair['similarity'] >= .95 and pair['low'] >= .7


def report(results):
    parsed = {name: r for name, r in results.items() if r['povray']['parses']}
    print(f'{len(results)} scenes, of which POV-Ray parses {len(parsed)}')
    for stage in ('check', 'render'):
        count = collections.Counter(r['isl'][stage][0] for r in parsed.values())
        print(f"  {stage}: {count['accepted']} accepted, {count['refused']} refused by name, {count['failed']} failed")
    words = collections.Counter(word for r in parsed.values() if r['isl']['render'][0] == 'refused'
                                for word in r['isl']['render'][1].split(', '))
    print('  refused because of:', ', '.join(f'{word} {n}' for word, n in words.most_common(40)))
    for name, r in parsed.items():
        if r['isl']['check'] != r['isl']['render']:
            print(f"  check and render disagree: {name}: {r['isl']['check']} {r['isl']['render']}")
        for stage in ('check', 'render'):
            if r['isl'][stage][0] == 'failed':
                print(f"  {stage} fails: {name}: {r['isl'][stage][1]}")
                break
    pairs = {name: r['pair'] for name, r in parsed.items() if 'pair' in r}
    black = {name for name, pair in pairs.items() if any(pair['black'])}
    seen = {name: pair for name, pair in pairs.items() if name not in black}
    alike = sum(map(is_alike, seen.values()))
    print(f'compared {len(seen)}, alike {alike}' + (f' ({100 * alike / len(seen):.1f} %)' if seen else ''))
    for name in sorted(black):
        which = {(True, True): 'both', (True, False): 'only ours', (False, True): "only POV-Ray's"}[tuple(pairs[name]['black'])]
        print(f'  black, {which}: {name}')
    for name, pair in sorted(seen.items(), key=lambda item: item[1]['similarity']):
        if not is_alike(pair):
            print(f"  not alike: {name}: similarity {pair['similarity']:.3f}, 5th percentile {pair['low']:.3f},"
                  f" {100 * pair['differing']:.1f} % of pixels differ")
    timed = [(r['povray']['trace'] / r['isl']['trace'], name) for name, r in parsed.items()
             if name in seen and (r['povray']['trace'] or 0) > .02 and r['isl'].get('trace')]
    if timed:
        timed.sort()
        print(f"time to trace, POV-Ray's over ours: median {timed[len(timed) // 2][0]:.2f},"
              f" slower on {sum(ratio < 1 for ratio, _ in timed)} of {len(timed)}; slowest:",
              ', '.join(f'{name} {ratio:.2f}' for ratio, name in timed[:10]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('folder')
    parser.add_argument('-o', '--work', default='compared')
    parser.add_argument('--isl', default=os.path.join(os.path.dirname(__file__), '../build/release/bin/isl'))
    parser.add_argument('--include', default=INCLUDES, help='where both programs look for include files')
    parser.add_argument('--no-include', action='store_true', help='isl gets no -I: it finds libraries by itself')
    parser.add_argument('--again', action='store_true', help="repeat isl's part, keep POV-Ray's")
    options = parser.parse_args()
    isl, folder, work = map(os.path.realpath, (options.isl, options.folder, options.work))
    os.makedirs(os.path.join(work, 'written'), exist_ok=True)
    table = os.path.join(work, 'results.json')
    results = {}
    if os.path.exists(table):
        with open(table) as file:
            results = json.load(file)
    scenes = sorted(os.path.join(place, name) for place, _, names in os.walk(folder, followlinks=True) for name in names
                    if name.lower().endswith('.pov'))
    for scene in scenes:
        name = os.path.relpath(scene, folder)
        if name in results and not options.again:
            continue
        key = hashlib.sha256(name.encode()).hexdigest()[:12]
        pictures = [os.path.join(work, f'{key}-{program}.png') for program in ('isl', 'povray')]
        povray_part = results[name]['povray'] if name in results else parsed_by_povray(scene, pictures[1], options.include)
        result = {'key': key, 'povray': povray_part}
        result['isl'] = ours(isl, scene, pictures[0], None if options.no_include else options.include,
                             os.path.join(work, 'written'), os.path.join(work, 'stats.json'))
        if result['isl']['render'][0] == 'accepted' and povray_part['parses']:
            if 'renders' not in povray_part:
                povray_part.update(rendered_by_povray(scene, pictures[1], options.include))
            if povray_part['renders']:
                result['pair'] = compare(*pictures)
        results[name] = result
        with open(table, 'w') as file:
            json.dump(results, file, indent=1)
    report(results)


if __name__ == '__main__':
    main()
