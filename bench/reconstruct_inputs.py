# SPDX-License-Identifier: GPL-3.0-or-later
"""What bench/reconstruct_clouds feeds to `reconstruct` besides the reference clouds themselves: parts of them, points of
their truths, and copies that are turned, scaled and moved. Needs numpy."""
import math

import numpy


def subsample(points, count, folder):
    """Writes `count` of the points, chosen at random from a seed, and returns the path."""
    places = numpy.loadtxt(points)
    chosen = numpy.random.default_rng(count).choice(len(places), count, replace=False)
    path = folder / f'{points.stem}_{count}.xyz'
    numpy.savetxt(path, places[chosen], fmt='%.9g')
    return path


def read_off(path):
    words = path.read_text().split()
    vertices, triangles = int(words[1]), int(words[2])
    places = numpy.array(words[4:4 + 3 * vertices], float).reshape(-1, 3)
    rows = numpy.array(words[4 + 3 * vertices:4 + 3 * vertices + 4 * triangles], int).reshape(-1, 4)
    return places, rows[:, 1:]


def sample(truth, count, folder):
    """Writes `count` points of the truth, uniform by area from a seed, and returns the path."""
    vertices, triangles = read_off(truth)
    random = numpy.random.default_rng(count)
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    areas = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)
    chosen = random.choice(len(triangles), count, p=areas / areas.sum())
    s, t = random.random((2, count, 1))
    s, t = numpy.where(s + t > 1, 1 - s, s), numpy.where(s + t > 1, 1 - t, t)
    path = folder / f'{truth.stem}_{count}.xyz'
    numpy.savetxt(path, a[chosen] + s * (b - a)[chosen] + t * (c - a)[chosen], fmt='%.9g')
    return path


def diagonal(truth):
    numbers = [line.split() for line in truth.read_text().splitlines()]
    places = [list(map(float, words[:3])) for words in numbers if len(words) == 3][1:]
    return math.dist([min(x) for x in zip(*places)], [max(x) for x in zip(*places)])


class Copy:
    """A cloud as it is, or turned, scaled and moved, with its truth."""

    def __init__(self, name, turns=0.0, scale=1.0, diagonals=0.0):
        self.name, self.turns, self.scale, self.diagonals = name, turns, scale, diagonals

    def write(self, source, target, diagonal):
        """Transforms the points of an XYZ or the vertices of an OFF file."""
        lines = source.read_text().splitlines()
        first, last = 0, len(lines)
        if source.suffix == '.off':
            count = next(i for i, line in enumerate(lines) if len(line.split()) == 3 and line.split()[0].isdigit())
            first, last = count + 1, count + 1 + int(lines[count].split()[0])
        for i in range(first, last):
            lines[i] = ' '.join(repr(x) for x in self.moved([float(word) for word in lines[i].split()[:3]], diagonal))
        target.write_text('\n'.join(lines) + '\n')

    def of(self, points, truth, folder):
        """Writes both, and returns their paths."""
        size = diagonal(truth)
        targets = [folder / f'{points.stem}_{self.name}{path.suffix}' for path in (points, truth)]
        for path, target in zip((points, truth), targets):
            self.write(path, target, size)
        return targets

    def moved(self, place, diagonal):
        """Turned around the axis (1, 2, 3)."""
        axis = [x / math.sqrt(14) for x in (1, 2, 3)]
        cosine, sine = math.cos(2 * math.pi * self.turns), math.sin(2 * math.pi * self.turns)
        along = sum(a * x for a, x in zip(axis, place))
        across = [axis[(k + 1) % 3] * place[(k + 2) % 3] - axis[(k + 2) % 3] * place[(k + 1) % 3] for k in range(3)]
        return [self.scale * (cosine * place[k] + sine * across[k] + (1 - cosine) * along * axis[k] +
                              self.diagonals * diagonal) for k in range(3)]


COPIES = (Copy('turned', turns=0.137), Copy('shrunk', scale=1e-3), Copy('grown', scale=1e3),
          Copy('far', diagonals=1e4), Copy('all', turns=0.291, scale=1e-3, diagonals=-1e2))
