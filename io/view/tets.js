// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles are seen of a tetrahedral mesh of which only some cells are shown.
'use strict';
window.dscTets = (function () {
  // Face i is opposite corner i, counter-clockwise from outside.
  const faceCorners = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

  // The tetrahedron beyond each face: element 4 t + i is that beyond face i of t, -1 where there is none.
  // Faces are found by their smallest vertex, each of which has a short list of them: no strings, no hash map.
  function neighbours(tets, vertexCount) {
    const first = new Int32Array(vertexCount).fill(-1);
    const next = new Int32Array(tets.length);
    const middle = new Uint32Array(tets.length);
    const largest = new Uint32Array(tets.length);
    const beyond = new Int32Array(tets.length).fill(-1);
    for (let face = 0; face < tets.length; ++face) {
      const base = face & ~3;
      const [a, b, c] = faceCorners[face & 3].map(corner => tets[base + corner]).sort((p, q) => p - q);
      let other = first[a];
      while (other >= 0 && (middle[other] !== b || largest[other] !== c)) other = next[other];
      if (other >= 0) {
        beyond[face] = other >> 2;
        beyond[other] = face >> 2;
      } else {
        middle[face] = b;
        largest[face] = c;
        next[face] = first[a];
        first[a] = face;
      }
    }
    return beyond;
  }

  // The faces between a tetrahedron that is shown and none: { corners (three vertices per triangle), tets (one) }.
  function shell(tets, beyond, isShown) {
    const corners = [];
    const owners = [];
    for (let t = 0; 4 * t < tets.length; ++t) {
      if (!isShown[t]) continue;
      for (let i = 0; i < 4; ++i) {
        const other = beyond[4 * t + i];
        if (other >= 0 && isShown[other]) continue;
        for (const corner of faceCorners[i]) corners.push(tets[4 * t + corner]);
        owners.push(t);
      }
    }
    return { corners, tets: owners };
  }

  // The centre of each tetrahedron, three numbers for each.
  function centres(tets, vertices) {
    const result = new Float32Array(3 * tets.length / 4);
    for (let t = 0; 4 * t < tets.length; ++t) {
      for (let axis = 0; axis < 3; ++axis) {
        let sum = 0;
        for (let corner = 0; corner < 4; ++corner) sum += vertices[3 * tets[4 * t + corner] + axis];
        result[3 * t + axis] = sum / 4;
      }
    }
    return result;
  }

  return { neighbours, shell, centres };
})();
