// The projectile's velocity against time, with a mark at the time that is shown.
const curve = {left: 34, right: 254, top: 8, bottom: 128, ...model.velocity};

// The velocity at a time, m/s; undefined if there is no history.
function velocityAt(time) {
  const {time_us: t, velocity_mps: v} = curve;
  if (!t.length) return undefined;
  const k = Math.min(Math.max(t.findIndex(at => at >= time), 1), t.length - 1);
  if (t.length === 1 || time >= t[t.length - 1]) return v[v.length - 1];
  const share = (time - t[k - 1]) / (t[k] - t[k - 1]);
  return v[k - 1] + Math.min(Math.max(share, 0), 1) * (v[k] - v[k - 1]);
}

const svg = document.querySelector('#curve svg');

function svgElement(name, attributes, text) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  return svg.appendChild(element);
}

function drawCurve() {
  const {time_us: t, velocity_mps: v, left, right, top, bottom} = curve;
  if (!t.length) return;
  document.getElementById('curve').hidden = false;
  curve.end = Math.max(t[t.length - 1], model.frames[model.frames.length - 1].time_us, 1e-9);
  curve.high = Math.max(...v, 1e-9);
  curve.low = Math.min(...v, 0);
  curve.x = time => left + (right - left) * time / curve.end;
  curve.y = speed => bottom - (bottom - top) * (speed - curve.low) / (curve.high - curve.low);
  for (const speed of new Set([curve.low, 0, curve.high])) {
    svgElement('line', {x1: left, x2: right, y1: curve.y(speed), y2: curve.y(speed), stroke: '#d8d8d8'});
    svgElement('text', {x: left - 4, y: curve.y(speed) + 4, 'font-size': 10, 'text-anchor': 'end'}, shortNumber(speed));
  }
  for (const time of [0, curve.end])
    svgElement('text', {x: curve.x(time), y: 142, 'font-size': 10, 'text-anchor': time ? 'end' : 'start'}, shortNumber(time));
  const points = t.map((time, k) => `${curve.x(time).toFixed(1)},${curve.y(v[k]).toFixed(1)}`).join(' ');
  svgElement('polyline', {points, fill: 'none', stroke: '#0072b2', 'stroke-width': 2});
  curve.line = svgElement('line', {y1: top, y2: bottom, stroke: '#d55e00'});
  curve.dot = svgElement('circle', {r: 4, fill: '#d55e00'});
}

function markCurve(time) {
  if (!curve.line) return;
  curve.line.setAttribute('x1', curve.x(time));
  curve.line.setAttribute('x2', curve.x(time));
  curve.dot.setAttribute('cx', curve.x(time));
  curve.dot.setAttribute('cy', curve.y(velocityAt(time)));
}

// The time under a pointer on the curve, µs.
function timeUnder(event) {
  const box = svg.getBoundingClientRect();
  return curve.end * ((event.clientX - box.left) / box.width * 260 - curve.left) / (curve.right - curve.left);
}
