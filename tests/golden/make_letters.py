"""Makes eval/letters.ttf, a font of three letters for tests of `text`: A is a triangle, O a ring of two contours with curves,
and I a bar. A pair of kerning brings O nearer to A. The em is 100 units."""
import pathlib
import struct


def checked(data):
    return data + b"\0" * (-len(data) % 4)


def glyph(contours):
    """A contour is a list of (x, y, is_on_the_curve)."""
    points = [p for contour in contours for p in contour]
    if not points:
        return b""
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    data = struct.pack(">5h", len(contours), min(xs), min(ys), max(xs), max(ys))
    end = -1
    for contour in contours:
        end += len(contour)
        data += struct.pack(">H", end)
    data += struct.pack(">H", 0) + bytes(p[2] for p in points)
    for axis in (0, 1):
        last = 0
        for p in points:
            data += struct.pack(">h", p[axis] - last)
            last = p[axis]
    return checked(data)


def lines(*points):
    return [(x, y, 1) for x, y in points]


def round_contour(x, y, r, clockwise):
    corners = [(x - r, y), (x - r, y + r), (x, y + r), (x + r, y + r), (x + r, y), (x + r, y - r), (x, y - r), (x - r, y - r)]
    if not clockwise:
        corners = corners[:1] + corners[:0:-1]
    return [(px, py, 1 - i % 2) for i, (px, py) in enumerate(corners)]


GLYPHS = [
    ("", [lines((0, 0), (0, 50), (40, 50), (40, 0))], 50, 0),  # the sign for letters that are missing
    (" ", [], 30, 0),
    ("A", [lines((0, 0), (30, 70), (60, 0))], 60, 0),
    ("I", [lines((10, 0), (10, 70), (20, 70), (20, 0))], 30, 10),
    ("O", [round_contour(35, 35, 30, True), round_contour(35, 35, 20, False)], 70, 5),
]
KERNING = [(2, 4, -12)]


def table_cmap():
    segments = [(ord(g[0]), i) for i, g in enumerate(GLYPHS) if g[0]] + [(0xFFFF, 0)]
    n = len(segments)
    body = struct.pack(">3H", 2 * n, 0, 0) + struct.pack(">H", 0)
    body += b"".join(struct.pack(">H", code) for code, _ in segments) + struct.pack(">H", 0)
    body += b"".join(struct.pack(">H", code) for code, _ in segments)
    body += b"".join(struct.pack(">H", (i - code) & 0xFFFF) for code, i in segments)
    body += struct.pack(">%dH" % n, *([0] * n))
    format4 = struct.pack(">3H", 4, 6 + len(body), 0) + body
    return struct.pack(">4HI", 0, 1, 3, 1, 12) + format4


def font():
    bodies = [glyph(g[1]) for g in GLYPHS]
    offsets = [sum(len(b) for b in bodies[:i]) for i in range(len(bodies) + 1)]
    tables = {
        b"cmap": table_cmap(),
        b"glyf": b"".join(bodies),
        b"head": struct.pack(">IIIIHHqqhhhhHHhhh", 0x10000, 0x10000, 0, 0x5F0F3CF5, 0, 100, 0, 0, 0, 0, 70, 70, 0, 8, 2, 1, 0),
        b"hhea": struct.pack(">I3hH11hH", 0x10000, 80, -20, 0, 70, 0, 0, 70, 1, 0, 0, 0, 0, 0, 0, 0, len(GLYPHS)),
        b"hmtx": b"".join(struct.pack(">Hh", g[2], g[3]) for g in GLYPHS),
        b"kern": struct.pack(">2H", 0, 1) + struct.pack(">3H", 0, 14 + 6 * len(KERNING), 1)
        + struct.pack(">4H", len(KERNING), 6, 0, 0) + b"".join(struct.pack(">2Hh", *k) for k in KERNING),
        b"loca": b"".join(struct.pack(">I", o) for o in offsets),
        b"maxp": struct.pack(">I14H", 0x10000, len(GLYPHS), 32, 4, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0),
    }
    place = 12 + 16 * len(tables)
    directory, data = struct.pack(">I4H", 0x10000, len(tables), 128, 3, 0), b""
    for tag, body in sorted(tables.items()):
        padded = checked(body)
        total = sum(struct.unpack(">%dI" % (len(padded) // 4), padded)) & 0xFFFFFFFF
        directory += tag + struct.pack(">3I", total, place + len(data), len(body))
        data += padded
    return directory + data


pathlib.Path(__file__).with_name("eval").joinpath("letters.ttf").write_bytes(font())
