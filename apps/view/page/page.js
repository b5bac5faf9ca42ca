// The controls of the page.
const at = id => document.getElementById(id);
const state = {shown: -1, wanted: 0, ranges: model.fields.map((_, f) => usualRange(f)), playing: 0};

function cutNow() {
  const axis = at('cut').value, side = at('cut_flip').checked ? 1 : -1, place = Number(at('cut_at').value);
  at('cut_at').disabled = at('cut_flip').disabled = axis === 'none';
  at('cut_text').textContent = axis === 'none' ? '' : `${axis} = ${place.toFixed(2)} mm`;
  if (axis === 'none') return [0, 0, 0, 0];
  const normal = ['x', 'y', 'z'].map(name => name === axis ? side : 0);
  // Particles in the plane itself stay, whatever the rounding.
  return [...normal, side * place + 0.01];
}

function drawBar() {
  const f = at('field').selectedIndex, [low, high] = state.ranges[f];
  at('bar').style.background = `linear-gradient(to right, ${colours.map(colourText).join(', ')})`;
  at('ticks').replaceChildren(...[0, 1, 2, 3, 4].map(k => {
    const tick = document.createElement('span');
    tick.textContent = shortNumber(low + (high - low) * k / 4);
    return tick;
  }));
  for (const [id, value] of [['low', low], ['high', high]])
    if (document.activeElement !== at(id)) at(id).value = Number(value.toPrecision(5));
}

function redraw() {
  if (!stage.frame) return;
  drawBar();
  show(stage.frame, {field: at('field').selectedIndex, range: state.ranges[at('field').selectedIndex], cut: cutNow(),
    whole: at('extent').value === 'whole', edges: at('edges').checked, colourProjectile: at('colour_projectile').checked,
    hideProjectile: at('hide_projectile').checked});
}

// Shows frame k once it is unpacked, unless another one is wanted by then.
async function goTo(k) {
  state.wanted = Math.min(Math.max(k, 0), model.frames.length - 1);
  const wanted = state.wanted, frame = await frameOf(wanted);
  if (wanted !== state.wanted || wanted === state.shown) return;
  stage.frame = frame;
  state.shown = wanted;
  at('time').value = wanted;
  const velocity = velocityAt(frame.time_us);
  at('when').textContent = `${frame.time_us.toFixed(1)} µs` + (velocity === undefined ? '' : `, ${velocity.toFixed(1)} m/s`);
  at('time').setAttribute('aria-valuetext', at('when').textContent);
  at('values').hidden = true;
  markCurve(frame.time_us);
  redraw();
  document.body.dataset.frame = wanted;
}

function play(on) {
  clearInterval(state.playing);
  state.playing = on ? setInterval(() => goTo((state.shown + 1) % model.frames.length), 125) : 0;
  at('play').textContent = on ? 'pause' : 'play';
  at('play').setAttribute('aria-pressed', on);
}

function chooseView(view) {
  if (view === 'section') at('cut').value = 'y', at('cut_at').value = 0, at('cut_flip').checked = false;
  if (view.startsWith('from')) at('cut').value = 'none';
  redraw();
  look(view);
}

function showValues(x, y) {
  const found = stage.frame && pick(x, y), box = at('values');
  box.hidden = !found;
  if (!found) return;
  box.textContent = valuesText(found);
  const {clientWidth: width, clientHeight: height} = canvas;
  const left = (x + 1) / 2 * width, top = (1 - y) / 2 * height;
  box.style.left = `${left + 16 + box.offsetWidth > width ? left - 12 - box.offsetWidth : left + 16}px`;
  box.style.top = `${Math.min(top + 8, height - box.offsetHeight)}px`;
}

function step(select, by) {
  select.selectedIndex = (select.selectedIndex + by + select.length) % select.length;
  select.dispatchEvent(new Event('change'));
}

const toggle = id => () => at(id).click();
const moveCut = by => () => {
  at('cut_at').value = Number(at('cut_at').value) + by;
  redraw();
};
const keys = {
  ArrowLeft: () => goTo(state.wanted - 1), ArrowRight: () => goTo(state.wanted + 1), Home: () => goTo(0),
  End: () => goTo(model.frames.length - 1), ' ': () => play(!state.playing), '+': () => zoom(1.2), '=': () => zoom(1.2),
  '-': () => zoom(1 / 1.2), w: () => move(0, 0.05), s: () => move(0, -0.05), a: () => move(-0.05, 0), d: () => move(0.05, 0),
  c: () => step(at('cut'), 1), '[': moveCut(-1), ']': moveCut(1), f: () => step(at('field'), 1), p: toggle('colour_projectile'),
  h: toggle('hide_projectile'), m: toggle('edges'), v: () => showValues(0, 0), Escape: () => at('values').hidden = true
};
Object.keys(views).forEach((view, k) => keys[String(k + 1)] = () => chooseView(view));
const turns = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]};

document.addEventListener('keydown', event => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const {tagName, type} = event.target;
  if (tagName === 'SELECT' || type === 'number' || (event.key === ' ' && /BUTTON|INPUT|SUMMARY/.test(tagName))) return;
  if (type === 'range' && event.target !== at('time') && /^(Arrow|Home|End)/.test(event.key)) return;
  const turned = event.shiftKey && turns[event.key];
  const act = turned ? () => turn(...turned) : keys[event.key] ?? keys[event.key.toLowerCase()];
  if (!act) return;
  event.preventDefault();
  act();
});

function wire() {
  at('title').textContent = model.title;
  at('time').max = model.frames.length - 1;
  at('field').replaceChildren(...model.fields.map(field => new Option(withUnit(field), field)));
  at('views').replaceChildren(...Object.keys(views).map(view => {
    const button = document.createElement('button');
    button.textContent = view;
    button.addEventListener('click', () => chooseView(view));
    return button;
  }));
  for (const id of ['field', 'extent', 'cut', 'cut_flip', 'colour_projectile', 'hide_projectile', 'edges'])
    at(id).addEventListener('change', redraw);
  at('cut_at').addEventListener('input', redraw);
  for (const id of ['low', 'high'])
    at(id).addEventListener('change', () => {
      const low = Number(at('low').value), high = Number(at('high').value);
      if (high > low) state.ranges[at('field').selectedIndex] = [low, high];
      redraw();
    });
  at('fit').addEventListener('click', () => {
    state.ranges[at('field').selectedIndex] = rangeOf(stage.frame.parts, at('field').selectedIndex);
    redraw();
  });
  at('time').addEventListener('input', () => goTo(Number(at('time').value)));
  at('play').addEventListener('click', () => play(!state.playing));
  svg.addEventListener('click', event => {
    const time = timeUnder(event), distances = model.frames.map(frame => Math.abs(frame.time_us - time));
    goTo(distances.indexOf(Math.min(...distances)));
  });
  let waits = false;
  canvas.addEventListener('pointermove', event => {
    if (waits || event.buttons) return;
    waits = true;
    requestAnimationFrame(() => {
      waits = false;
      const box = canvas.getBoundingClientRect();
      showValues(2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height);
    });
  });
  canvas.addEventListener('pointerleave', () => at('values').hidden = true);
}

// The size of the view follows from the projectile's radius; y is across the plane of an oblique shot.
function reachOf(frame) {
  const projectile = frame.parts.find(isProjectile);
  if (!projectile) return 10;
  let reach = 0;
  for (let i = 0; i < projectile.points; ++i) reach = Math.max(reach, Math.abs(projectile.positions[3 * i + 1]));
  return reach || 10;
}

async function start() {
  wire();
  drawCurve();
  stage.reach = reachOf(await frameOf(model.frames.length - 1));
  for (const [key, sign] of [['min', -1], ['max', 1]]) at('cut_at')[key] = sign * Math.ceil(6 * stage.reach);
  resize();
  look('oblique');
  await goTo(model.frames.length - 1);
  document.body.dataset.readyMs = Math.round(performance.now());
  // The others are unpacked while nobody waits, so that playing does not.
  for (let k = 0; k < model.frames.length; ++k) await frameOf(k);
}

start();
