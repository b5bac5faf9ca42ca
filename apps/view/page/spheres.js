// Particles as shaded spheres: each is one point, whose pixels find the sphere's depth and normal by themselves. The
// projection is parallel, so that a sphere is a circle on the screen.
const sphereMaterial = () => new THREE.ShaderMaterial({
  uniforms: {...colourUniforms(0.5), radius: {value: 1}, pixelsPerMm: {value: 1}, cut: {value: new THREE.Vector4(0, 0, 0, 0)}},
  extensions: {fragDepth: true},
  vertexShader: `
    attribute float value;
    uniform float radius, pixelsPerMm;
    uniform vec4 cut;
    varying float shownValue, depth, depthOfRadius, pixels;
    void main() {
      vec4 world = modelMatrix * vec4(position, 1.0);
      gl_Position = projectionMatrix * (viewMatrix * world);
      depth = 0.5 * gl_Position.z + 0.5;
      depthOfRadius = 0.5 * projectionMatrix[2][2] * radius;
      pixels = radius * pixelsPerMm;
      gl_PointSize = 2.0 * pixels + 1.0;
      shownValue = value;
      if (dot(cut.xyz, world.xyz) > cut.w) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    }`,
  fragmentShader: colourShader + `
    varying float shownValue, depth, depthOfRadius, pixels;
    void main() {
      vec2 place = (2.0 * gl_PointCoord - 1.0) * vec2(1.0, -1.0) * (1.0 + 0.5 / pixels);
      float outside = dot(place, place);
      if (outside > 1.0) discard;
      vec3 normal = vec3(place, sqrt(1.0 - outside));
      gl_FragDepthEXT = depth + depthOfRadius * normal.z;
      gl_FragColor = vec4(shaded(shownValue, normal), 1.0);
    }`
});

// The geometry of a cloud, coloured by its field number f.
function sphereGeometry(cloud, f) {
  const geometry = new THREE.BufferGeometry(), values = new Float32Array(cloud.points);
  for (let i = 0; i < cloud.points; ++i) values[i] = cloud.fields[f](i);
  geometry.setAttribute('position', new THREE.BufferAttribute(cloud.positions, 3));
  geometry.setAttribute('value', new THREE.BufferAttribute(values, 1));
  return geometry;
}
