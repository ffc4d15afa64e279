#!/usr/bin/env python3
"""The scenes of pairs/ rendered by isl and by POV-Ray 3.7: are the pictures the same?

    bench/pairs.py [NAME…] [-o FOLDER] [--isl PROGRAM] [--povray PROGRAM] [--list]

NAME is a part of scenes' names, as `normal_` or `fog`; without one, all are rendered. FOLDER (pairs_out) gets one page of pairs,
index.html, which needs no other file, and both pictures of each scene as .png.

Pictures: 320x240, one ray a pixel, one thread. A pair is the same if all three hold: at most 0.5 % of the pixels are further than
2/255 apart in linear light; at most 0.5 % further than 4/255 as encoded; and in no block of 16x16 pixels the means are further
than 6/255 apart, linear or encoded. Values above white are white. A scene whose first line says "Compared by mean and spectrum"
draws something random: there the blocks must agree likewise, the means of both pictures within 1/255, and their power in each octave
of frequencies, and in the shortest waves of each block that has noise, as well as two random pictures would.

Scenes with something that isl does not render are told and counted apart. The exit code is 1 if a pair differs or a scene fails.
Needs povray, python3-numpy and python3-pil.
"""
import argparse
import glob
import html
import os
import sys
import tempfile

import programs
from pictures import Image, data_uri, encoded, np, read_exr, read_ppm

HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'pairs')
SIZE = 320, 240
MOST_PIXELS = .005             # share of pixels that may be further apart than these
LINEAR, ENCODED = 2 / 255, 4
BLOCK, MOST_OF_BLOCK = 16, 6   # pixels; of 255
ENLARGED = 16                  # factor of the picture of differences
NOISE = 'Compared by mean and spectrum'


class Scene:
    def __init__(self, file):
        self.file = file
        self.name = os.path.splitext(os.path.basename(file))[0]
        with open(file, encoding='utf8') as stream:
            self.text = stream.read()
        self.caption = self.text.split('\n', 1)[0].lstrip('/ ')
        self.is_noise = self.caption.startswith(NOISE)


def scenes(names):
    found = [Scene(file) for file in sorted(glob.glob(os.path.join(HERE, '*.pov')))]
    if names:
        found = [scene for scene in found if any(name in scene.name for name in names)]
    if not found:
        sys.exit(f'pairs.py: no scene of {HERE} has {" or ".join(names)} in its name')
    return found


def power_by_octave(luma):
    """Mean power of the waves in octaves of their length, the shortest last, and how many waves each octave has."""
    power = np.abs(np.fft.rfft2(luma - luma.mean()))**2
    length = np.hypot(np.fft.fftfreq(luma.shape[0])[:, None], np.fft.rfftfreq(luma.shape[1]))
    octaves = [(length >= low) & (length < 2 * low) for low in (1 / 64, 1 / 32, 1 / 16, 1 / 8, 1 / 4)]
    return [(power[octave].mean(), octave.sum()) for octave in octaves]


def blocks(values):
    """Means of the blocks of a picture, or of one channel of it."""
    height, width = (n // BLOCK for n in values.shape[:2])
    return values.reshape(height, BLOCK, width, BLOCK, -1).mean((1, 3))


def grain(luma):
    """The power of each block's shortest waves: of what a pixel differs from the mean of its neighbours."""
    edges = np.pad(luma, 1, 'reflect')
    return blocks((luma - (edges[1:-1, :-2] + edges[1:-1, 2:] + edges[:-2, 1:-1] + edges[2:, 1:-1]) / 4)**2)


def noise_figures(ours, theirs):
    """How far two random pictures are from each other, as a share of what two of the same kind may be; 5 standard deviations may."""
    a, b = ours.mean(2), theirs.mean(2)
    spectrum = 0
    for (power_a, count), (power_b, _) in zip(power_by_octave(a), power_by_octave(b)):
        # The power of one wave of noise is distributed exponentially, so the mean of n has a relative deviation of 1/sqrt(n) in each
        # picture. Noise on a third of the picture leaves a third of the waves independent.
        spectrum = max(spectrum, abs(power_a - power_b) / max(power_a, power_b, 1e-12) / (5 * np.sqrt(2 * 3 / count)))
    # Things that are the same in both pictures hide noise from the spectrum, so the blocks that have noise are compared one by one. The
    # power of 256 pixels, of which neighbours are correlated, has a relative deviation of about sqrt(2/150), the logarithm of
    # the ratio of two 0.16, and the median of n of these 1.25*0.16/sqrt(n).
    noisy = blocks(np.abs(a - b)) > .5 / 255
    ratios = np.log((grain(a)[noisy] + 1e-12) / (grain(b)[noisy] + 1e-12))
    grains = abs(np.median(ratios)) * np.sqrt(len(ratios)) / (5 * 1.25 * .16) if len(ratios) else np.inf
    return {'spectrum': spectrum, 'grain': grains}


def judge(ours, theirs, is_noise):
    """The figures of a pair of linear pictures, and what of them is too much."""
    ours, theirs = np.clip(ours, 0, 1), np.clip(theirs, 0, 1)
    shown = encoded(ours) - encoded(theirs)
    figures = {'linear': (np.abs(ours - theirs).max(2) > LINEAR).mean(), 'encoded': (np.abs(shown).max(2) > ENCODED).mean(),
               'block': max(np.abs(blocks(shown)).max(), 255 * np.abs(blocks(ours - theirs)).max()), 'most': np.abs(shown).max(),
               'mean': 255 * np.abs(ours.mean((0, 1)) - theirs.mean((0, 1))).max()}
    failures = [] if figures['block'] <= MOST_OF_BLOCK else ['block']
    if not is_noise:
        return figures, failures + [rule for rule in ('linear', 'encoded') if figures[rule] > MOST_PIXELS]
    noise = noise_figures(ours, theirs)
    failures += [f'{rule} {share:.1f}' for rule, share in noise.items() if share > 1]
    return figures, failures + (['mean'] if figures['mean'] > 1 else [])


def compare(options, scene, folder, size=SIZE):
    """One row: a verdict (same, differs, not rendered, failed), a message, the figures, and both pictures."""
    exr, ppm = os.path.join(folder, 'isl.exr'), os.path.join(folder, 'povray.ppm')
    for picture in exr, ppm:
        if os.path.exists(picture):
            os.remove(picture)
    row = {'scene': scene, 'verdict': 'failed', 'message': '', 'figures': None, 'ours': None, 'theirs': None}
    theirs = programs.run_povray(options, scene.file, ppm, size, f'+L{HERE}', '+FP16', 'File_Gamma=1.0', folder=folder)
    ours = programs.run_isl(options, scene.file, exr, size, '-I', options.include, folder=folder)
    if theirs.code == 0:
        row['theirs'] = read_ppm(ppm)
    if ours.code == 0:
        row['ours'] = read_exr(exr)
    if theirs.code != 0:
        row['message'] = 'POV-Ray: ' + programs.povray_message(theirs)
    elif ours.code != 0:
        row['message'] = programs.isl_message(ours)
        if programs.is_refusal(row['message']):
            row['verdict'] = 'not rendered'
    else:
        row['figures'], failures = judge(row['ours'], row['theirs'], scene.is_noise)
        row['verdict'], row['message'] = ('differs', ', '.join(failures)) if failures else ('same', '')
    return row


def figures_of(row):
    """The columns of the table."""
    if not row['figures']:
        return [''] * 4
    return ['{:.2f} %'.format(100 * row['figures']['linear']), '{:.2f} %'.format(100 * row['figures']['encoded']),
            '{:.1f}'.format(row['figures']['block']), '{:.0f}'.format(row['figures']['most'])]


HEADINGS = 'linear', 'encoded', 'block', 'most'
STYLE = '''body { font: 15px/1.4 sans-serif; margin: 2em; color: #222; background: #fafafa }
table { border-collapse: collapse } td, th { padding: .2em .8em; text-align: left } td.number { text-align: right }
figure { margin: 0 1em 0 0; display: inline-block } figcaption { color: #666 } img { image-rendering: pixelated; width: 320px }
section { margin-top: 2em } pre { background: #eee; padding: .6em; overflow-x: auto }
.differs, .failed { color: #b00020 } .same { color: #1b6e2c } .not { color: #8a6500 }
@media (prefers-color-scheme: dark) { body { color: #ddd; background: #181818 } pre { background: #262626 } figcaption { color: #999 } }'''


def page(rows, summary):
    """All pairs in one file: the table, then the scenes, those that differ first."""
    escape = html.escape
    order = ['differs', 'failed', 'not rendered', 'same']
    rows = sorted(rows, key=lambda row: (order.index(row['verdict']), row['scene'].name))
    parts = [f'<!doctype html><html lang="en"><meta charset="utf-8"><title>Pairs</title><style>{STYLE}</style>',
             f'<h1>isl and POV-Ray 3.7: the same scenes</h1><p>{escape(summary)}</p>',
             '<p>linear, encoded: the share of pixels that are further than 2/255 and 4/255 apart (at most 0.5 % is wanted); block: the'
             ' worst block of 16x16 pixels (at most 6 of 255); most: the greatest difference of a pixel, of 255.</p>',
             '<table><tr><th>scene<th>verdict<th>' + '<th>'.join(HEADINGS)]
    for row in rows:
        name, verdict = row['scene'].name, row['verdict']
        parts.append(f'<tr><td><a href="#{name}">{name}</a><td class="{verdict.split()[0]}">{verdict}'
                     + ''.join(f'<td class="number">{figure}' for figure in figures_of(row)))
    parts.append('</table>')
    for row in rows:
        scene, verdict = row['scene'], row['verdict']
        parts.append(f'<section id="{scene.name}"><h2>{scene.name} <small class="{verdict.split()[0]}">{verdict}</small></h2>'
                     f'<p>{escape(scene.caption)}</p>')
        if row['message']:
            parts.append(f'<p class="{verdict.split()[0]}">{escape(row["message"])}</p>')
        pictures = [('isl', row['ours']), ('POV-Ray', row['theirs'])]
        shown = [(title, encoded(picture)) for title, picture in pictures if picture is not None]
        if len(shown) == 2:
            shown.append((f'difference, {ENLARGED} times', ENLARGED * np.abs(shown[0][1] - shown[1][1])))
        for title, picture in shown:
            parts.append(f'<figure><img src="{data_uri(picture)}" alt="{title}"><figcaption>{title}</figcaption></figure>')
        parts.append(f'<pre>{escape(scene.text)}</pre></section>')
    return '\n'.join(parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('names', nargs='*', metavar='NAME', help="a part of scenes' names [all]")
    parser.add_argument('-o', '--output', default='pairs_out', help='folder of the page and the pictures [pairs_out]')
    parser.add_argument('--list', action='store_true', help='list the scenes and what they are about, and end')
    programs.add_program_options(parser)
    options = parser.parse_args()
    chosen = scenes(options.names)
    if options.list:
        for scene in chosen:
            print(f'{scene.name:28} {scene.caption}')
        return 0
    programs.find_programs(options)
    options.output = os.path.abspath(options.output)
    os.makedirs(options.output, exist_ok=True)
    print(f'{"scene":28} {"verdict":13}' + ''.join(f'{heading:>9}' for heading in HEADINGS))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for scene in chosen:
            row = compare(options, scene, folder)
            rows.append(row)
            note = f'  {row["message"]}' if row['message'] else ''
            print(f'{scene.name:28} {row["verdict"]:13}' + ''.join(f'{figure:>9}' for figure in figures_of(row)) + note, flush=True)
            for which in 'ours', 'theirs':
                if row[which] is not None:
                    shown = np.rint(encoded(row[which])).astype(np.uint8)
                    Image.fromarray(shown).save(os.path.join(options.output, f'{scene.name}.{which}.png'))
    count = {verdict: sum(row['verdict'] == verdict for row in rows) for verdict in ('same', 'differs', 'failed', 'not rendered')}
    summary = (f'{len(rows)} scenes: {count["same"]} the same, {count["differs"]} differ, {count["failed"]} failed,'
               f' {count["not rendered"]} not rendered')
    print(summary)
    with open(os.path.join(options.output, 'index.html'), 'w', encoding='utf8') as stream:
        stream.write(page(rows, summary))
    print(f'pairs: {os.path.join(options.output, "index.html")}')
    return 1 if count['differs'] or count['failed'] else 0


if __name__ == '__main__':
    sys.exit(main())
