// The values at a place of the picture: of the particle or hex that is nearest there.

// The nearest particle of a cloud on a ray; `best` is the nearest find so far.
function pickParticle(cloud, origin, way, best) {
  const isKept = keeps(stage.cut), r2 = cloud.radius * cloud.radius, p = cloud.positions;
  for (const [sx, sy] of stage.copies)
    for (let i = 0; i < cloud.points; ++i) {
      const x = sx * p[3 * i], y = sy * p[3 * i + 1], z = p[3 * i + 2];
      const dx = x - origin.x, dy = y - origin.y, dz = z - origin.z;
      const along = dx * way.x + dy * way.y + dz * way.z, off2 = dx * dx + dy * dy + dz * dz - along * along;
      if (off2 > r2) continue;
      const distance = along - Math.sqrt(r2 - off2);
      if (distance < best.distance && distance > 0 && isKept(x, y, z))
        best = {distance, part: cloud, index: i, kind: 'particle', place: [x, y, z]};
    }
  return best;
}

// The nearest face of hexes on a ray.
function pickHex({part, corners, hexes}, ray, best) {
  const at = k => new THREE.Vector3(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]), hit = new THREE.Vector3();
  for (let k = 0; k < hexes.length; ++k) {
    const [a, b, c, d] = [0, 1, 2, 3].map(n => at(4 * k + n));
    if (!ray.intersectTriangle(a, b, c, false, hit) && !ray.intersectTriangle(a, c, d, false, hit)) continue;
    const distance = hit.distanceTo(ray.origin);
    if (distance < best.distance) best = {distance, part, index: hexes[k], kind: 'hex', place: hit.toArray()};
  }
  return best;
}

// What is seen at a place of the picture, from -1 to 1 each way; null if nothing is.
function pick(x, y) {
  const ray = new THREE.Ray(new THREE.Vector3(x, y, -1).unproject(camera), camera.getWorldDirection(new THREE.Vector3()));
  let best = {distance: Infinity};
  for (const part of stage.parts)
    if (part.hexes === undefined) best = pickParticle(part, ray.origin, ray.direction, best);
  for (const faces of stage.faces) best = pickHex(faces, ray, best);
  return best.part ? best : null;
}

// The lines of text on what was picked.
function valuesText({part, index, kind, place}) {
  // No "-0.00".
  const shown = place.map(v => (Math.round(100 * v) / 100 + 0).toFixed(2));
  const lines = [`${part.name}, ${kind} ${index}`, `x, y, z: ${shown.join(', ')} mm`];
  model.fields.forEach((field, f) => {
    const {title, unit} = described(field);
    lines.push(`${title}: ${shortNumber(part.fields[f](index))} ${unit}`.trimEnd());
  });
  return lines.join('\n');
}
