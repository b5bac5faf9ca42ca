// The frames, unpacked from 16-bit words when they are needed. See view/pack.hpp for what the words mean.
const model = JSON.parse(document.getElementById('model').textContent);
const lastStep = 65535;

async function wordsOf(k) {
  const text = atob(document.getElementById(`frame${k}`).textContent);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const count = model.frames[k].words, words = new Uint16Array(count);
  for (let i = 0; i < count; ++i) words[i] = bytes[i] | bytes[count + i] << 8;
  return words;
}

function partOf(description, take) {
  const {name, points, position_mm: ranges} = description;
  const part = {name, points, hexes: description.hexes, radius: 0.7 * description.diameter_mm,
    positions: new Float32Array(3 * points)};
  ranges.forEach(([low, size], k) => {
    const words = take(points);
    for (let i = 0; i < points; ++i) part.positions[3 * i + k] = low + size * words[i] / lastStep;
  });
  const count = part.hexes ?? points;
  if (part.hexes !== undefined) {
    part.corners = new Uint32Array(8 * count);
    for (let shift = 0; shift < (points > 65536 ? 32 : 16); shift += 16)
      for (let c = 0; c < 8; ++c) {
        const words = take(count);
        for (let e = 0; e < count; ++e) part.corners[8 * e + c] |= words[e] << shift;
      }
  }
  part.fields = description.fields.map(([low, size]) => {
    const words = take(count);
    return i => low + size * words[i] / lastStep;
  });
  part.ranges = description.fields;
  return part;
}

const unpacked = [];

// Frame number k: its time and parts, positions in mm.
function frameOf(k) {
  unpacked[k] ??= wordsOf(k).then(words => {
    let at = 0;
    const take = count => words.subarray(at, at += count);
    return {...model.frames[k], parts: model.frames[k].parts.map(part => partOf(part, take))};
  });
  return unpacked[k];
}

const isProjectile = part => part.name.startsWith('projectile');

// The range of a field at first: that of ogive's pictures, or of all frames of the plate.
function usualRange(f) {
  const usual = {plastic_strain: [0, 1.5], temperature_K: [300, 900], damage: [0, 1]}[model.fields[f]];
  return usual ?? rangeOf(model.frames.flatMap(frame => frame.parts), f);
}

// The smallest and the largest value of a field in the plate's parts, or in all parts if there is no plate.
function rangeOf(parts, f) {
  const plate = parts.filter(part => !isProjectile(part) && (part.hexes ?? part.points) > 0);
  const ranges = (plate.length ? plate : parts).map(part => (part.ranges ?? part.fields)[f]);
  const low = Math.min(...ranges.map(([from]) => from)), high = Math.max(...ranges.map(([from, size]) => from + size));
  return high > low ? [low, high] : [low, low + 1];
}
