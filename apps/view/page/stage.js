// The scene, its camera and the pixels. Lengths are in mm, z points against the flight.
const canvas = document.getElementById('canvas');
const context = canvas.getContext('webgl2', {antialias: true});
if (!context || !window.DecompressionStream) {
  const problem = document.getElementById('problem');
  problem.textContent = 'This page needs a browser with WebGL 2 and DecompressionStream (Firefox 113, Chromium 80, Safari 16.4).';
  problem.hidden = false;
  throw new Error(problem.textContent);
}
const renderer = new THREE.WebGLRenderer({canvas, context, antialias: true});
renderer.setClearColor(0xffffff, 1);
renderer.setPixelRatio(window.devicePixelRatio);
const scene = new THREE.Scene();
const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 1, 6000);
camera.up.set(0, 0, 1);
const orbit = new THREE.OrbitControls(camera, canvas);
orbit.enableKeys = false;
orbit.screenSpacePanning = true;

const stage = {frame: null, parts: [], faces: [], copies: [[1, 1]], reach: 10};
const edgeMaterial = new THREE.LineBasicMaterial({color: 0x5c636e});
const materials = {};

// The material of a part; each part has its own, for its own grey.
function materialOf(part) {
  materials[part.name] ??= part.hexes === undefined ? sphereMaterial() : hexMaterial();
  return materials[part.name];
}

const pixelsPerMm = () => canvas.height * camera.zoom / (camera.top - camera.bottom);

function render() {
  for (const material of Object.values(materials))
    if (material.uniforms.pixelsPerMm) material.uniforms.pixelsPerMm.value = pixelsPerMm();
  renderer.render(scene, camera);
}

function resize() {
  const {clientWidth: width, clientHeight: height} = canvas.parentElement;
  if (!width || !height) return;
  renderer.setSize(width, height, false);
  const half = 4.5 * stage.reach;
  Object.assign(camera, {top: half, bottom: -half, right: half * width / height, left: -half * width / height});
  camera.updateProjectionMatrix();
  render();
}

// Whether the cut leaves a point.
const keeps = cut => (x, y, z) => cut[0] * x + cut[1] * y + cut[2] * z <= cut[3];

// Shows a frame: `field` its number, `range` of the colours, `cut` [x, y, z, offset]: what lies beyond is left out;
// `whole`: with its mirror images; `edges`: with mesh lines; `colourProjectile`, `hideProjectile`.
function show(frame, {field, range, cut, whole, edges, colourProjectile, hideProjectile}) {
  stage.frame = frame;
  stage.cut = cut;
  const signs = mirrored => whole && mirrored ? [1, -1] : [1];
  stage.copies = signs(frame.mirrored_x).flatMap(x => signs(frame.mirrored_y).map(y => [x, y]));
  for (const old of scene.children) old.geometry.dispose();
  scene.remove(...scene.children);
  stage.faces = [];
  stage.parts = frame.parts.filter(part => !(hideProjectile && isProjectile(part)));
  for (const part of stage.parts) {
    const material = materialOf(part), uniforms = material.uniforms;
    uniforms.range.value.set(...range);
    uniforms.grey.value = isProjectile(part) && !colourProjectile ? 1 : 0;
    if (part.hexes === undefined) {
      uniforms.radius.value = part.radius;
      uniforms.cut.value.set(...cut);
      const geometry = sphereGeometry(part, field);
      for (const [x, y] of stage.copies) add(new THREE.Points(geometry, material)).scale.set(x, y, 1);
    } else {
      const faces = hexFaces(part, stage.copies, keeps(cut));
      stage.faces.push({part, ...faces});
      add(new THREE.Mesh(hexGeometry(part, faces, field), material));
      if (edges) add(new THREE.LineSegments(edgeGeometry(faces), edgeMaterial));
    }
  }
  render();
}

function add(object) {
  object.frustumCulled = false;
  scene.add(object);
  return object;
}

// Where the camera is, seen from the middle of the view.
const views = {section: [0, -1, 0], oblique: [-0.5, -0.75, 0.42], 'from behind': [0, -1e-4, -1], 'from the front': [0, -1e-4, 1],
  'rear, oblique': [-0.45, -0.7, -0.55]};

function look(view) {
  camera.zoom = 1;
  orbit.target.set(0, 0, view.startsWith('from') ? 0 : -0.5 * stage.reach);
  camera.position.fromArray(views[view]).normalize().multiplyScalar(3000).add(orbit.target);
  camera.updateProjectionMatrix();
  orbit.update();
  render();
}

// Turns the view by angles to the right and upwards, radians.
function turn(right, up) {
  const way = camera.position.clone().sub(orbit.target), axis = new THREE.Vector3(0, 0, 1);
  const side = new THREE.Vector3().crossVectors(axis, way).normalize(), polar = way.angleTo(axis);
  way.applyAxisAngle(side, Math.min(Math.max(up, polar - Math.PI + 1e-3), polar - 1e-3) * -1);
  way.applyAxisAngle(axis, right);
  camera.position.copy(orbit.target).add(way);
  orbit.update();
  render();
}

// Moves the view by shares of its height.
function move(right, up) {
  const height = (camera.top - camera.bottom) / camera.zoom, step = new THREE.Vector3(right * height, up * height, 0);
  step.applyQuaternion(camera.quaternion);
  camera.position.add(step);
  orbit.target.add(step);
  orbit.update();
  render();
}

function zoom(factor) {
  camera.zoom *= factor;
  camera.updateProjectionMatrix();
  render();
}

orbit.addEventListener('change', render);
new ResizeObserver(resize).observe(canvas.parentElement);
