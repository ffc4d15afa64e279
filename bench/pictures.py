"""Pictures as arrays of rows, columns and R, G, B: reading what isl and POV-Ray write, encoding, likeness. Imported by the
scripts of this folder; knows nothing of what they measure.

Linear values come from isl's .exr and from POV-Ray's .ppm with `File_Gamma=1.0`, so that no table of one program's encoding
stands between the two. 1 is white.
"""
import base64
import io
import re
import struct
import sys
import zlib

try:
    import numpy as np
    from PIL import Image
except ImportError as missing:
    sys.exit(f'{sys.argv[0]}: {missing}: install python3-numpy and python3-pil')


def read_ppm(file):
    """Values from 0 to 1 of a binary .ppm with 8 or 16 bits."""
    with open(file, 'rb') as stream:
        data = stream.read()
    header = re.match(rb'P6(?:\s+|#[^\n]*\n)+(\d+)(?:\s+|#[^\n]*\n)+(\d+)(?:\s+|#[^\n]*\n)+(\d+)\s', data)
    if not header:
        raise ValueError(f'{file} is no binary .ppm')
    width, height, white = map(int, header.groups())
    values = np.frombuffer(data, '>u2' if white > 255 else 'u1', 3 * width * height, header.end())
    return values.reshape(height, width, 3) / white


def read_exr(file):
    """R, G, B of an .exr of scan lines as isl writes them: half or float, compressed by zip (16 lines a block)."""
    with open(file, 'rb') as stream:
        data = stream.read()
    attributes, at = {}, 8  # behind the magic number and the version
    while data[at]:
        name, kind, rest = data[at:at + 512].split(b'\0', 2)
        at += len(name) + len(kind) + 2
        size, = struct.unpack_from('<i', data, at)
        attributes[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    at += 1
    if attributes[b'compression'] != b'\3':
        raise ValueError(f'{file} is not compressed by zip')
    left, top, right, bottom = struct.unpack('<4i', attributes[b'dataWindow'])
    width, height = right - left + 1, bottom - top + 1
    channels, list_at = [], 0  # name, type (1: half, 2: float), in the order of the file
    while attributes[b'channels'][list_at]:
        end = attributes[b'channels'].index(b'\0', list_at)
        channels.append((attributes[b'channels'][list_at:end], attributes[b'channels'][end + 1]))
        list_at = end + 17
    line_size = width * sum(2 * kind for _, kind in channels)
    picture = np.zeros((height, width, 3))
    for offset in struct.unpack_from(f'<{-(-height // 16)}q', data, at):
        line, size = struct.unpack_from('<2i', data, offset)
        packed, lines = data[offset + 8:offset + 8 + size], min(16, bottom - line + 1)
        if size < lines * line_size:
            # Each byte is stored as its difference from the last plus 128, the even bytes first and then the odd ones.
            steps = np.frombuffer(zlib.decompress(packed), np.uint8).astype(int)
            steps[1:] -= 128
            halves = np.cumsum(steps).astype(np.uint8)
            raw = np.empty_like(halves)
            raw[0::2], raw[1::2] = halves[:(len(halves) + 1) // 2], halves[(len(halves) + 1) // 2:]
        else:
            raw = np.frombuffer(packed, np.uint8)
        rows, column = raw.reshape(lines, line_size), 0
        for name, kind in channels:
            values = np.ascontiguousarray(rows[:, column:column + 2 * kind * width]).view('<f2' if kind == 1 else '<f4')
            if name in (b'R', b'G', b'B'):
                picture[line - top:line - top + lines, :, b'RGB'.index(name)] = values
            column += 2 * kind * width
    return picture


def read_encoded(file):
    """0 to 255 of a picture as it is shown; of those without colour, three equal channels."""
    image = Image.open(file)
    if image.mode.startswith('I'):
        return np.repeat(np.asarray(image, float)[..., None] / 257, 3, 2)
    return np.asarray(image.convert('RGB'), float)


def encoded(linear):
    """sRGB's encoding of values from 0 to 1, in 0 to 255."""
    linear = np.clip(linear, 0, 1)
    return 255 * np.where(linear <= .0031308, 12.92 * linear, 1.055 * linear**(1 / 2.4) - .055)


def data_uri(values):
    """A PNG of values from 0 to 255, as the source of an image in a page that needs no other file."""
    stream = io.BytesIO()
    Image.fromarray(np.clip(np.rint(values), 0, 255).astype(np.uint8)).save(stream, 'PNG', optimize=True)
    return 'data:image/png;base64,' + base64.b64encode(stream.getvalue()).decode()


def window_means(values, size):
    """Means of the window of size x size (odd) about each pixel; the picture is mirrored at its borders."""
    sums = np.pad(np.pad(values, size // 2, 'symmetric'), ((1, 0), (1, 0))).cumsum(0).cumsum(1)
    return (sums[size:, size:] - sums[:-size, size:] - sums[size:, :-size] + sums[:-size, :-size]) / size**2


def similarity(a, b):
    """Mean and 5th percentile of the structural similarity of two encoded pictures' luma, in windows of 7x7 (Wang et al. 2004)."""
    weights = np.array([.299, .587, .114])
    x, y = a @ weights, b @ weights
    mean_x, mean_y = window_means(x, 7), window_means(y, 7)
    var_x, var_y = window_means(x * x, 7) - mean_x**2, window_means(y * y, 7) - mean_y**2
    covariance = window_means(x * y, 7) - mean_x * mean_y
    c1, c2 = (.01 * 255)**2, (.03 * 255)**2
    index = (2 * mean_x * mean_y + c1) * (2 * covariance + c2) / ((mean_x**2 + mean_y**2 + c1) * (var_x + var_y + c2))
    return float(index.mean()), float(np.percentile(index, 5))
