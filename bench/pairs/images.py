#!/usr/bin/env python3
"""Draws the small pictures that scenes of this folder put on surfaces: colours, grey tiles, a palette of four, and one with
alpha. They lie here as files, so that each scene can be rendered by hand; needs python3-numpy and python3-pil."""
import os

import numpy as np
from PIL import Image


def draw(folder):
    def save(name, image):
        image.save(os.path.join(folder, name), optimize=True)

    rows, columns = np.mgrid[0:12, 0:16]
    colours = np.stack([columns * 17, rows * 23, 255 * ((rows // 3 + columns // 4) % 2)], 2).astype(np.uint8)
    colours[2:4, 2:5] = 255, 240, 0  # one mark, by which mirrored and turned pictures are told from others
    save('colours.png', Image.fromarray(colours))
    Image.fromarray(colours).save(os.path.join(folder, 'colours.ppm'))
    rows, columns = np.mgrid[0:16, 0:16]
    tiles = 255 * np.clip(1.2 - np.hypot(rows % 8 - 3.5, columns % 8 - 3.5) / 5, 0, 1)
    save('tiles.png', Image.fromarray(tiles.astype(np.uint8)))
    palette = Image.fromarray((((rows // 4) * 3 + columns // 4) % 4).astype(np.uint8), 'P')
    palette.putpalette([230, 60, 40, 60, 200, 90, 70, 110, 240, 250, 220, 90])
    save('palette.png', palette)
    alpha = np.stack([columns * 16, 255 - rows * 16, 0 * rows + 128, 255 * ((rows // 4 + columns // 4) % 3) // 2], 2)
    save('alpha.png', Image.fromarray(alpha.astype(np.uint8)))


if __name__ == '__main__':
    draw(os.path.dirname(os.path.abspath(__file__)))
