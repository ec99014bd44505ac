# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of triangles in space: parallel projection, a depth buffer, flat shading, edges as lines; written as PNG.
Needs numpy."""

import struct
import zlib

import numpy as np

oversampling = 2


class View:
    """Where a picture is seen from, and what is in it: `direction` leads from the eye into the picture, `up` is up;
    `centre` is in its middle, and `height` of space fits into it."""

    def __init__(self, direction, up, centre, height, pixels):
        forward = np.asarray(direction, float) / np.linalg.norm(direction)
        right = np.cross(forward, up)
        right /= np.linalg.norm(right)
        self.axes = np.array([right, np.cross(right, forward), forward])
        self.centre, self.height, self.pixels = np.asarray(centre, float), height, pixels

    def project(self, points):
        """Columns, rows (downwards) and depths, in fine pixels."""
        scale = self.pixels[1] * oversampling / self.height
        local = (np.asarray(points) - self.centre) @ self.axes.T * scale
        return local * [1, -1, 1] + [self.pixels[0] * oversampling / 2, self.pixels[1] * oversampling / 2, 0]


def picture(view, triangles, colours, has_lines=None, line_width=1.0):
    """RGB bytes. `triangles`: (n, 3, 3) places; `colours`: (n, 3) in 0..1; lines are drawn where `has_lines`."""
    width, height = (oversampling * n for n in view.pixels)
    image = np.ones((height, width, 3))
    depth = np.full((height, width), np.inf)
    corners = view.project(np.reshape(triangles, (-1, 3))).reshape(-1, 3, 3)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    # Light from the eye, somewhat from above and the left.
    light = np.array([-0.35, -0.5, -0.8]) / np.linalg.norm([-0.35, -0.5, -0.8])
    shade = 0.6 + 0.4 * np.abs(normals @ light) / np.maximum(lengths, 1e-300)
    low = np.maximum(np.floor(corners[:, :, :2].min(axis=1)).astype(int), 0)
    high = np.minimum(np.ceil(corners[:, :, :2].max(axis=1)).astype(int) + 1, [width, height])
    for k in np.flatnonzero((low < high).all(axis=1) & (np.abs(normals[:, 2]) > 1e-9)):
        a, b, c = corners[k]
        x, y = np.meshgrid(np.arange(low[k, 0], high[k, 0]) + 0.5, np.arange(low[k, 1], high[k, 1]) + 0.5)
        area = normals[k, 2]
        wb = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
        wc = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
        wa = 1 - wb - wc
        z = wa * a[2] + wb * b[2] + wc * c[2]
        window = np.s_[low[k, 1]:high[k, 1], low[k, 0]:high[k, 0]]
        seen = (wa >= 0) & (wb >= 0) & (wc >= 0) & (z < depth[window])
        if not seen.any():
            continue
        depth[window][seen] = z[seen]
        colour = np.broadcast_to(colours[k] * shade[k], (*seen.shape, 3))
        if has_lines is None or has_lines[k]:
            sides = [np.hypot(*(q - p)[:2]) for p, q in ((b, c), (c, a), (a, b))]
            distance = np.minimum.reduce([w * abs(area) / max(s, 1e-9) for w, s in zip((wa, wb, wc), sides)])
            on_line = np.clip(line_width * oversampling / 2 + 0.5 - distance, 0, 1)[..., None]
            colour = colour * (1 - 0.75 * on_line)
        image[window][seen] = colour[seen]
    fine = image.reshape(view.pixels[1], oversampling, view.pixels[0], oversampling, 3)
    return np.clip(np.rint(255 * fine.mean(axis=(1, 3))), 0, 255).astype(np.uint8)


def beside(pictures, gap=8):
    """Pictures of the same height in a row."""
    white = np.full((pictures[0].shape[0], gap, 3), 255, np.uint8)
    parts = [part for image in pictures for part in (image, white)]
    return np.concatenate(parts[:-1], axis=1)


def below(pictures, gap=8):
    """Pictures of the same width in a column."""
    white = np.full((gap, pictures[0].shape[1], 3), 255, np.uint8)
    parts = [part for image in pictures for part in (image, white)]
    return np.concatenate(parts[:-1], axis=0)


def write_png(path, image):
    """With 6 bits per channel, which is enough for flat shading and halves the file."""
    rows = (image >> 2 << 2 | image >> 6).astype(np.uint8)
    sub = rows.copy()
    sub[:, 1:] -= rows[:, :-1]
    data = b"".join(b"\1" + row.tobytes() for row in sub)

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    header = struct.pack(">IIBBBBB", image.shape[1], image.shape[0], 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(data, 9)) +
                     chunk(b"IEND", b""))
