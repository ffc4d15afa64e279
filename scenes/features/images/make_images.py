#!/usr/bin/env python3
"""Makes the images of ../images.isl, with Python's own library alone: globe.png (colours), rosette.png (heights in 16
bits), tiles.png (numbers of a palette), leaf.png (colours with alpha)."""
import math
import random
import struct
import zlib
from pathlib import Path


def write_png(name, width, height, bits, kind, rows, palette=()):
    """`rows` are bytes of a row each; `kind` is PNG's type of colour."""
    def chunk(tag, data):
        return struct.pack(">I", len(data)) + tag + data + struct.pack(">I", zlib.crc32(tag + data))

    head = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, 0)
    data = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"sRGB", b"\0")
    if palette:
        data += chunk(b"PLTE", b"".join(bytes(colour) for colour in palette))
    data += chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows), 9)) + chunk(b"IEND", b"")
    (Path(__file__).parent / name).write_bytes(data)


def mixed(a, b, share):
    return tuple(round(x + (y - x) * min(max(share, 0), 1)) for x, y in zip(a, b))


def globe(width=256, height=128):
    """Continents: a sum of waves on the sphere, whose directions are random."""
    random.seed(11)
    waves = []
    for octave in range(1, 6):
        for _ in range(5):
            d = [random.gauss(0, 1) for _ in range(3)]
            size = math.sqrt(sum(x * x for x in d))
            waves.append(([x / size * 1.7 * 1.8**octave for x in d], random.uniform(0, 6.28), 1 / 1.6**octave))
    rows = []
    for j in range(height):
        latitude = math.pi * (0.5 - (j + 0.5) / height)
        row = b""
        for i in range(width):
            turn = 2 * math.pi * (i + 0.5) / width
            p = (math.cos(turn) * math.cos(latitude), math.sin(latitude), math.sin(turn) * math.cos(latitude))
            level = sum(a * math.sin(sum(x * y for x, y in zip(p, d)) + phase) for d, phase, a in waves)
            if abs(latitude) + 0.12 * level > 1.3:
                colour = (238, 243, 246)
            elif level < 0.15:
                colour = mixed((16, 58, 104), (66, 144, 168), 1 + (level - 0.15) / 1.4)
            else:
                colour = mixed((222, 204, 140), (70, 122, 62), (level - 0.15) / 0.3)
                colour = mixed(colour, (132, 96, 66), (level - 0.75) / 0.6)
            # Thin lines of a grid every 30 degrees.
            if min(math.degrees(turn) % 30, -math.degrees(turn) % 30) < 0.8 or j * 180 / height % 30 < 1.4:
                colour = mixed(colour, (20, 30, 40), 0.35)
            row += bytes(colour)
        rows.append(row)
    write_png("globe.png", width, height, 8, 2, rows)


def rosette(side=160):
    """A medal: twelve petals, a rim, a ring of beads."""
    rows = []
    for j in range(side):
        row = b""
        for i in range(side):
            x, y = (i + 0.5) / side * 2 - 1, 1 - (j + 0.5) / side * 2
            r, a = math.hypot(x, y), math.atan2(y, x)
            petal = max(0, math.cos(6 * a)) ** 0.7 * max(0, math.sin(math.pi * min(r / 0.62, 1))) ** 0.8
            inner = max(0, math.cos(6 * a + math.pi)) ** 0.7 * max(0, math.sin(math.pi * min(r / 0.45, 1))) ** 0.8
            heart = math.sqrt(max(0, 1 - (r / 0.14) ** 2))
            step = 2 * math.pi / 48
            bead_angle = (a % step) - step / 2
            bead = math.sqrt(max(0, 1 - ((r - 0.76) ** 2 + (0.76 * bead_angle) ** 2) / 0.045**2))
            rim = max(0, 1 - ((r - 0.93) / 0.06) ** 2)
            height = max(0.75 * petal, 0.6 * inner, heart, 0.5 * bead, 0.8 * rim)
            row += struct.pack(">H", round(65535 * min(height, 1)))
        rows.append(row)
    write_png("rosette.png", side, side, 16, 0, rows)


def tiles(side=64):
    """Numbers of four materials: joints, field, star and stone of a floor."""
    rows = []
    for j in range(side):
        row = b""
        for i in range(side):
            x, y = abs(i - side / 2 + 0.5), abs(j - side / 2 + 0.5)
            star = min(max(x, y), (x + y) / math.sqrt(2)) < side * 0.3
            number = 3 if x + y < side * 0.2 else 2 if star else 1
            if max(x, y) > side / 2 - 1.5:
                number = 0
            row += bytes([number])
        rows.append(row)
    write_png("tiles.png", side, side, 8, 3, rows, [(40, 36, 34), (214, 200, 176), (44, 84, 110), (170, 62, 40)])


def leaf(width=96, height=128):
    """A leaf with its veins; around it nothing."""
    rows = []
    for j in range(height):
        row = b""
        for i in range(width):
            x, y = (i + 0.5) / width * 2 - 1, 1 - (j + 0.5) / height * 2
            t = (y + 0.8) / 1.7  # 0 at the stalk, 1 at the tip
            half = 0.62 * math.sin(math.pi * min(max(t, 0), 1)) ** 0.8 * (1 - 0.35 * t)
            alpha = min(max((half - abs(x)) * width / 2, 0), 1) if 0 < t < 1 else 0
            stalk = -0.98 < y < -0.7 and abs(x - 0.08 * (y + 0.7)) < 0.035
            vein = abs(x) < 0.02 or abs((t * 7 - abs(x) * 3.2) % 1 - 0.5) < 0.06
            colour = mixed((96, 20, 12), (222, 150, 30), t + 0.25 * math.sin(9 * x + 3 * y))
            if vein or stalk:
                colour = mixed(colour, (60, 12, 8), 0.6)
            row += bytes(colour) + bytes([255 if stalk else round(255 * alpha)])
        rows.append(row)
    write_png("leaf.png", width, height, 8, 6, rows)


globe()
rosette()
tiles()
leaf()
