# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that the program flow writes, read with the standard library: surfaces (OBJ, VTP) and tetrahedra (MEDIT)."""

import base64
import struct
import xml.etree.ElementTree as xml
from dataclasses import dataclass


@dataclass
class Surface:
    points: list
    triangles: list

    def write_obj(self, path):
        lines = ["v " + " ".join(map(repr, p)) for p in self.points]
        lines += ["f " + " ".join(str(v + 1) for v in triangle) for triangle in self.triangles]
        path.write_text("\n".join(lines) + "\n")


def read_obj(path):
    surface = Surface([], [])
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            surface.points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["f"]:
            surface.triangles.append(tuple(int(word.split("/")[0]) - 1 for word in words[1:4]))
    return surface


def read_vtp(path):
    """The triangles of a snapshot: inline base64 with 64-bit sizes."""
    piece = xml.parse(path).getroot().find("PolyData/Piece")

    def numbers(array, kind):
        content = base64.b64decode(array.text.strip())[8:]
        return struct.unpack(f"<{len(content) // 8}{kind}", content)

    x = numbers(piece.find("Points/DataArray"), "d")
    corners = numbers(next(a for a in piece.find("Polys") if a.get("Name") == "connectivity"), "q")
    return Surface(list(zip(x[::3], x[1::3], x[2::3])), list(zip(corners[::3], corners[1::3], corners[2::3])))


def read_tets(path):
    """The tetrahedra of a MEDIT file, as (four vertices, label)."""
    lines = iter(path.read_text().splitlines())
    for line in lines:
        if line.strip() == "Tetrahedra":
            return [(words[:4], words[4]) for words in (list(map(int, next(lines).split())) for _ in range(int(next(lines))))]
    return []


def read_points(path):
    """The vertices of a MEDIT file."""
    lines = iter(path.read_text().splitlines())
    for line in lines:
        if line.strip() == "Vertices":
            return [tuple(map(float, next(lines).split()[:3])) for _ in range(int(next(lines)))]
    return []


def volume_within(points, tets):
    """Enclosed by the faces that only one tetrahedron has."""
    sides = {}
    for (a, b, c, d), _ in tets:
        for side in ((b, c, d), (a, d, c), (a, b, d), (a, c, b)):
            sides.setdefault(tuple(sorted(side)), []).append(side)
    total = 0
    for [side, *others] in sides.values():
        if not others:
            p, q, r = (points[v - 1] for v in side)
            total += (p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
                      + p[2] * (q[0] * r[1] - q[1] * r[0])) / 6
    return total


def share_at_interface(tets):
    """Of tetrahedra with a vertex in an interface."""
    labels = {}
    for vertices, label in tets:
        for v in vertices:
            labels.setdefault(v, set()).add(label)
    return sum(any(len(labels[v]) > 1 for v in vertices) for vertices, _ in tets) / max(1, len(tets))
