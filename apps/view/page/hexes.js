// Hexes as the surface of those that the cut leaves.
const cornersOfFace = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

// The hex behind each of the six faces of each hex; -1 where there is none. A face is known by its smallest corner and the
// one opposite.
function neighbours(part) {
  if (part.neighbours) return part.neighbours;
  const open = new Map(), found = new Int32Array(6 * part.hexes).fill(-1);
  for (let e = 0; e < part.hexes; ++e)
    cornersOfFace.forEach((corners, f) => {
      const nodes = corners.map(c => part.corners[8 * e + c]), smallest = nodes.indexOf(Math.min(...nodes));
      const key = nodes[smallest] * part.points + nodes[(smallest + 2) % 4], other = open.get(key);
      if (other === undefined) {
        open.set(key, 6 * e + f);
      } else {
        found[6 * e + f] = Math.floor(other / 6);
        found[other] = e;
        open.delete(key);
      }
    });
  return part.neighbours = found;
}

// 1 for each hex whose middle the cut leaves, in the copy with these signs of x and y.
function keptHexes(part, sign, isKept) {
  const kept = new Uint8Array(part.hexes);
  for (let e = 0; e < part.hexes; ++e) {
    const middle = [0, 0, 0];
    for (let c = 0; c < 8; ++c)
      for (let k = 0; k < 3; ++k) middle[k] += part.positions[3 * part.corners[8 * e + c] + k] / 8;
    kept[e] = isKept(sign[0] * middle[0], sign[1] * middle[1], middle[2]) ? 1 : 0;
  }
  return kept;
}

// Whether a face lies in a plane that mirrors it: 0 for x, 1 for y, -1 for none. `mirrored` says which planes do.
function mirrorOf(part, nodes, mirrored) {
  // Nodes are held in the plane; what is left is the rounding to steps.
  return [0, 1].find(k => mirrored[k] && nodes.every(n => Math.abs(part.positions[3 * n + k]) < 0.02)) ?? -1;
}

// The faces of a part: corners (mm) and the hex of each, of all copies. Faces between a hex and its mirror image are inside.
function hexFaces(part, copies, isKept) {
  const behind = neighbours(part), corners = [], hexes = [];
  const kept = copies.map(sign => keptHexes(part, sign, isKept));
  const mirrored = [0, 1].map(k => copies.some(sign => sign[k] < 0));
  const copyOf = (sign, k) => copies.findIndex(other => other[k] === -sign[k] && other[1 - k] === sign[1 - k]);
  copies.forEach((sign, copy) => {
    for (let e = 0; e < part.hexes; ++e) {
      if (!kept[copy][e]) continue;
      for (let f = 0; f < 6; ++f) {
        const other = behind[6 * e + f];
        if (other >= 0 && kept[copy][other]) continue;
        const nodes = cornersOfFace[f].map(c => part.corners[8 * e + c]), plane = other < 0 ? mirrorOf(part, nodes, mirrored) : -1;
        if (plane >= 0 && kept[copyOf(sign, plane)][e]) continue;
        for (const n of nodes)
          corners.push(sign[0] * part.positions[3 * n], sign[1] * part.positions[3 * n + 1], part.positions[3 * n + 2]);
        hexes.push(e);
      }
    }
  });
  return {corners: new Float32Array(corners), hexes};
}

const hexMaterial = () => new THREE.ShaderMaterial({
  uniforms: colourUniforms(0.6),
  side: THREE.DoubleSide,
  extensions: {derivatives: true},
  polygonOffset: true,
  polygonOffsetFactor: 1,
  polygonOffsetUnits: 1,
  vertexShader: `
    attribute float value;
    varying float shownValue;
    varying vec3 seen;
    void main() {
      vec4 place = modelViewMatrix * vec4(position, 1.0);
      seen = place.xyz;
      shownValue = value;
      gl_Position = projectionMatrix * place;
    }`,
  fragmentShader: colourShader + `
    varying float shownValue;
    varying vec3 seen;
    void main() {
      vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
      gl_FragColor = vec4(shaded(shownValue, normal), 1.0);
    }`
});

// The geometry of faces, coloured by field number f.
function hexGeometry(part, faces, f) {
  const geometry = new THREE.BufferGeometry(), values = new Float32Array(4 * faces.hexes.length);
  const triangles = new Uint32Array(6 * faces.hexes.length);
  faces.hexes.forEach((e, k) => {
    values.fill(part.fields[f](e), 4 * k, 4 * k + 4);
    triangles.set([0, 1, 2, 0, 2, 3].map(c => 4 * k + c), 6 * k);
  });
  geometry.setAttribute('position', new THREE.BufferAttribute(faces.corners, 3));
  geometry.setAttribute('value', new THREE.BufferAttribute(values, 1));
  geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  return geometry;
}

// The edges of faces as pairs of points.
function edgeGeometry(faces) {
  const geometry = new THREE.BufferGeometry(), pairs = new Uint32Array(8 * faces.hexes.length);
  for (let k = 0; k < faces.hexes.length; ++k) pairs.set([0, 1, 1, 2, 2, 3, 3, 0].map(c => 4 * k + c), 8 * k);
  geometry.setAttribute('position', new THREE.BufferAttribute(faces.corners, 3));
  geometry.setIndex(new THREE.BufferAttribute(pairs, 1));
  return geometry;
}
