# SPDX-License-Identifier: GPL-3.0-or-later
"""The tetrahedra that reconstruct writes: valid by the checker, bounded by the surface, and not too flat (numpy)."""

import numpy as np

from checkers import checked
from surface_files import read_obj, read_points, read_tets

LEAST_ANGLE = 10


def turned(numbers):
    """Triangles up to cyclic permutation, as rows with the least number first."""
    first = np.argmin(numbers, axis=1)
    return np.stack([numbers[np.arange(len(numbers)), (first + k) % 3] for k in range(3)], axis=1)


def dihedral_angles(points, tets):
    """Six of each tetrahedron, at the edges (i, j) in this order, in degrees."""
    result = []
    for i, j, k, m in ((0, 1, 2, 3), (0, 2, 1, 3), (0, 3, 1, 2), (1, 2, 0, 3), (1, 3, 0, 2), (2, 3, 0, 1)):
        axis = points[tets[:, j]] - points[tets[:, i]]
        one, other = (np.cross(axis, points[tets[:, n]] - points[tets[:, i]]) for n in (k, m))
        cosine = (one * other).sum(1) / np.linalg.norm(one, axis=1) / np.linalg.norm(other, axis=1)
        result.append(np.degrees(np.arccos(np.clip(cosine, -1, 1))))
    return np.array(result).T


def sharp_vertices(points, triangles, angle):
    """Vertices where the surface itself is sharper: triangles with such a corner, or with such an angle of the body
    between them."""
    sharp = np.zeros(len(points), bool)
    p = points[triangles]
    sides = [p[:, (k + 1) % 3] - p[:, k] for k in range(3)]
    for k in range(3):
        one, other = sides[k], -sides[(k + 2) % 3]
        cosine = (one * other).sum(1) / np.linalg.norm(one, axis=1) / np.linalg.norm(other, axis=1)
        sharp[triangles[cosine > np.cos(np.radians(angle))]] = True
    normals = np.cross(sides[0], sides[1])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    edges = {(a, b): t for t, triangle in enumerate(triangles.tolist())
             for a, b in zip(triangle, triangle[1:] + triangle[:1])}
    for (a, b), t in edges.items():
        other = edges[b, a]
        is_outward = normals[t] @ (points[triangles[other]].mean(0) - points[a]) < 0
        if is_outward and normals[t] @ normals[other] < -np.cos(np.radians(angle)):
            sharp[[a, b]] = True
    return sharp


def tet_figures(mesh, surface):
    """Figures of the MEDIT file `mesh`, the inside of the OBJ file `surface`."""
    errors = (checked("tetcheck", mesh) or {}).get("before", {}).get("errors", ["not checked"])
    points, tets = np.array(read_points(mesh)), np.array([t for t, _ in read_tets(mesh)]) - 1
    outside = read_obj(surface)
    places, triangles = np.array(outside.points), np.array(outside.triangles)
    faces = np.concatenate([tets[:, list(corners)] for corners in ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))])
    _, first, counts = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    boundary = faces[first[counts == 1]]
    number = {place: i for i, place in enumerate(map(tuple, places))}
    numbers = np.array([number.get(place, -1) for place in map(tuple, points)])
    same = {tuple(t) for t in turned(numbers[boundary]).tolist()} == {tuple(t) for t in turned(triangles).tolist()}
    angles = dihedral_angles(points, tets).min(1)
    is_sharp = np.append(sharp_vertices(places, triangles, LEAST_ANGLE), False)[numbers[tets]].any(1)
    return {"tets": len(tets), "tets_valid": not errors, "same_boundary": same,
            "least_angle": float(angles.min()), "least_angle_away": float(angles[~is_sharp].min()),
            "flat_away": int((angles[~is_sharp] < LEAST_ANGLE).sum()), "sharp_share": float(is_sharp.mean())}
