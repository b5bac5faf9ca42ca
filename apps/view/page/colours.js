// The colours of a field, those of the pictures that ogive draws: from undeformed metal to almost black.
const colours = [[0.80, 0.84, 0.88], [0.98, 0.90, 0.55], [0.98, 0.65, 0.25], [0.88, 0.32, 0.16], [0.60, 0.06, 0.16],
  [0.25, 0.02, 0.15]];
const projectileGrey = [0.47, 0.50, 0.54];

const colourText = c => `rgb(${c.map(v => Math.round(255 * v)).join(', ')})`;

// GLSL: the colour of a value within the range; with `grey` 1 that of the projectile. Light comes from above on the left.
const colourShader = `
  uniform vec3 colours[${colours.length}];
  uniform vec3 plain;
  uniform vec2 range;
  uniform float grey, ambient;
  vec3 shaded(float value, vec3 normal) {
    float place = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0) * ${colours.length - 1}.0;
    vec3 colour = colours[0];
    for (int k = 1; k < ${colours.length}; ++k)
      colour = mix(colour, colours[k], clamp(place - float(k - 1), 0.0, 1.0));
    float light = max(dot(normal, normalize(vec3(-0.5, 0.7, 1.0))), 0.0);
    return mix(colour, plain, grey) * (ambient + (1.0 - ambient) * light);
  }`;

function colourUniforms(ambient) {
  return {colours: {value: colours.map(c => new THREE.Vector3(...c))}, plain: {value: new THREE.Vector3(...projectileGrey)},
    range: {value: new THREE.Vector2(0, 1)}, grey: {value: 0}, ambient: {value: ambient}};
}

// What a field's name says of its unit.
const units = {K: 'K', MPa: 'MPa', m_per_s: 'm/s', kg_per_m3: 'kg/m³', per_s: '1/s', mm: 'mm'};

// "temperature_K" as {title: "temperature", unit: "K"}.
function described(field) {
  const longest = Object.keys(units).filter(suffix => field.endsWith('_' + suffix)).sort((a, b) => b.length - a.length)[0];
  const name = longest ? field.slice(0, -longest.length - 1) : field;
  return {title: name.replaceAll('_', ' ').replace('von mises', 'von Mises'), unit: units[longest] ?? ''};
}

const withUnit = field => described(field).unit ? `${described(field).title} (${described(field).unit})` : described(field).title;

// Three or four digits, without an exponent where a reader needs none.
function shortNumber(value) {
  const size = Math.abs(value);
  if (value === 0) return '0';
  return size >= 1e5 || size < 1e-3 ? value.toExponential(2) : String(Number(value.toPrecision(4)));
}
