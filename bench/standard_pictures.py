#!/usr/bin/env python3
"""Makes the pictures of stdlib/ that scenes for POV-Ray ask for by name, each of the size, kind and subject of POV-
Ray's own.

    bench/standard_pictures.py [FOLDER]      FOLDER: where they go (../stdlib)

`test` has four quarters with letters, `povmap` four numbers of a palette for material maps; `bumpmap_`, `mtmandj` and
`fract003` are
fractals whose palettes' numbers are heights, `plasma2` and `plasma3` colourful clouds, `Mount1` and `Mount2` mountains
in grey.

Needs python3-numpy and python3-pil.
"""
import os
import sys

import numpy as np
from PIL import Image, ImageDraw, ImageFont

WIDTH, HEIGHT = 320, 200


def save(folder, name, values, palette):
    image = Image.fromarray(np.asarray(values, dtype=np.uint8), 'P')
    image.putpalette(sum(([int(round(c)) for c in colour] for colour in palette), []))
    image.save(os.path.join(folder, name + '.png'), optimize=True)


def ramp(stops, count):
    """`count` colours through the stops: pairs of a place from 0 to 1 and a colour."""
    places = np.linspace(0, 1, count)
    return np.stack([np.interp(places, [s[0] for s in stops], [s[1][c] for s in stops]) for c in range(3)], 1).tolist()


def lettering(text, height):
    """The text as a mask of this height: the built-in font, enlarged."""
    font = ImageFont.load_default()
    left, top, right, bottom = font.getbbox(text)
    mask = Image.new('L', (right - left, bottom - top))
    ImageDraw.Draw(mask).text((-left, -top), text, 255, font)
    return np.asarray(mask.resize((mask.width * height // mask.height, height), Image.Resampling.BICUBIC)) > 110


def put(values, text, height, middle, number):
    mask = lettering(text, height)
    y, x = middle[1] - mask.shape[0] // 2, middle[0] - mask.shape[1] // 2
    values[y:y + mask.shape[0], x:x + mask.shape[1]][mask] = number


def test(folder):
    values = np.zeros((HEIGHT, WIDTH))
    quarters = {'TL': (0, 0, 1), 'TR': (1, 0, 3), 'BL': (0, 1, 0), 'BR': (1, 1, 2)}
    for text, (x, y, number) in quarters.items():
        values[y * 100:y * 100 + 100, x * 160:x * 160 + 160] = number
        for row in range(3):
            for column in range(3):
                put(values, text, 27, (x * 160 + 27 + 53 * column, y * 100 + 17 + 33 * row), 4)
    put(values, 'test picture', 26, (WIDTH // 2, HEIGHT // 2), 5)
    save(folder, 'test', values, [(90, 245, 250), (250, 90, 245), (250, 90, 80), (255, 250, 90), (0, 0, 0),
                                  (255, 255, 255)])


def povmap(folder):
    values = np.ones((HEIGHT, WIDTH))
    values[20:180, 13:307] = 0
    values[36:164, 29:291] = 3
    put(values, 'four numbers', 34, (WIDTH // 2, 72), 2)
    put(values, 'of a palette', 34, (WIDTH // 2, 126), 2)
    save(folder, 'povmap', values, [(0, 0, 0), (250, 90, 80), (0, 165, 10), (90, 85, 250)])


def escape(plane, constant, most):
    """Smoothed numbers of iterations of z² + c, `most` within the set."""
    place, count = plane.copy(), np.full(plane.shape, float(most))
    for turn in range(most):
        place = place * place + constant
        size = np.abs(place)
        leaving = (size > 16) & (count == most)
        count[leaving] = turn + 1 - np.log2(np.log2(size[leaving]) / 4)
        place[size > 1e6] = 1e6
    return count


def plane(width, middle):
    x = (np.arange(WIDTH) - WIDTH / 2 + .5) / WIDTH * width + middle.real
    y = (np.arange(HEIGHT) - HEIGHT / 2 + .5) / WIDTH * width + middle.imag
    return x[None] + 1j * y[:, None]


def fractals(folder):
    places = plane(4.2, -0.62 + 0j)
    count = escape(np.zeros_like(places), places, 120)
    values = np.where(count >= 120, 1, np.clip(1 + 66 * np.log(np.maximum(count, 1) / 2.6), 1, 254))
    blue = (5, 5, 160)
    save(folder, 'bumpmap_', values, [(0, 0, 0), blue] + ramp(
        [(0, blue), (.3, (130, 190, 230)), (.42, (70, 130, 40)), (.6, (150, 190, 60)), (.75, (240, 150, 30)),
         (1, (255, 255, 255))], 254))

    count = escape(plane(4.1, 0j), -0.7269 + 0.1889j, 90)
    bands = [(5, 5, 160), (5, 160, 10), (10, 165, 160), (165, 10, 5), (160, 5, 165), (165, 90, 5), (165, 165, 165),
             (90, 85, 90), (90, 90, 250),
             (85, 250, 90), (90, 250, 250), (250, 90, 85)]
    values = 1 + np.maximum(np.floor(count) - 4, 0) % 43
    save(folder, 'mtmandj', values, [(0, 0, 0)] + [bands[i % len(bands)] for i in range(255)])


def noise(shape, roughness, seed):
    """Fractal noise that repeats, from 0 to 1, by its spectrum."""
    spectrum = np.fft.fft2(np.random.default_rng(seed).standard_normal(shape))
    fy, fx = np.fft.fftfreq(shape[0]) * shape[0], np.fft.fftfreq(shape[1]) * shape[1]
    field = np.fft.ifft2(spectrum / np.maximum(1, np.hypot(fy[:, None], fx[None])) ** roughness).real
    return (field - field.min()) / np.ptp(field)


def clouds(folder):
    field = noise((HEIGHT, WIDTH), 1.5, 4)
    steps = np.round(np.clip((field - 0.5) / 0.5, 0, 1) * 16) / 16
    save(folder, 'fract003', np.where(field < .5, 1, 100 + 155 * steps), [(0, 0, 0), (5, 5, 165)] + [(0, 0, 0)] * 98
         + ramp(
        [(0, (95, 65, 20)), (.6, (140, 95, 5)), (.85, (200, 190, 170)), (1, (255, 255, 255))], 156))
    circle = ramp([(0, (250, 10, 5)), (1 / 3, (5, 250, 10)), (2 / 3, (10, 5, 250)), (1, (250, 10, 5))], 254)
    for name, roughness in ('plasma2', 1.6), ('plasma3', 2.3):
        save(folder, name, 1 + 253 * noise((100, 100), roughness, 11), [(0, 0, 0)] + circle)


def mountains(folder):
    y, x = (np.mgrid[:250, :250] - 124.5) / 125
    rim = np.clip(1.15 - np.hypot(x, y), 0, 1)
    hills = np.clip(noise((250, 250), 1.9, 8) * 2.2 - .85, 0, 1) * np.clip(rim * 2.5, 0, 1)
    ridge = np.abs(2 * noise((250, 250), 2.1, 15) - 1)
    crest = np.clip(1.1 - 1.4 * np.abs(x - y) - .45 * np.abs(x + y), 0, 1) ** .8
    massif = np.clip(crest * (1.05 - ridge * .9), 0, 1) * np.clip(rim * 4, 0, 1)
    for name, heights in ('Mount1', hills), ('Mount2', massif):
        grey = np.rint(255 * heights / heights.max()).astype(np.uint8)
        Image.fromarray(grey).save(os.path.join(folder, name + '.png'), optimize=True)


def spiral(folder):
    """A galaxy of two arms in 50x50x5 densities of a byte: three sizes in two bytes each, then x runs fastest."""
    z, y, x = (np.mgrid[:5, :50, :50] - np.array([2, 24.5, 24.5])[:, None, None,
                                                                  None]) / np.array([2.5, 25, 25])[:, None, None, None]
    radius, angle = np.hypot(x, y), np.arctan2(y, x)
    arms = np.cos(2 * (angle - 2.4 * np.log(np.maximum(radius, .05)))) * .5 + .5
    density = (arms ** 2 * np.clip(1 - radius, 0, 1) + np.exp(-(radius * 5) ** 2)) * np.clip(1 - z * z, 0, 1)
    with open(os.path.join(folder, 'spiral.df3'), 'wb') as stream:
        stream.write(np.array([50, 50, 5], '>u2').tobytes())
        stream.write(np.rint(255 * np.clip(density / density.max() * 1.3, 0, 1)).astype(np.uint8).tobytes())


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), '../stdlib')
    for make in test, povmap, fractals, clouds, mountains, spiral:
        make(folder)


if __name__ == '__main__':
    main()
