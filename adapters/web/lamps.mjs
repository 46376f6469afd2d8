// Lamps for a path tracer that samples lights of three.js, and no meshes that shine. Runs in the browser, see render.mjs.
import { Matrix4, RectAreaLight, Vector3 } from "three/webgpu";

// The exporter puts a black casing of this name behind the front of each lamp, so that it shines to one side alone.
const kCasing = "casing of ";
// Of a lamp's size: its corners are floats about its centre, so what is equal differs by a few roundings of 6e-8.
const kRounding = 1e-6;
// Fewer corners are no disk.
const kFewestSegments = 32;

function facingOf({ geometry }) {
  return new Vector3().fromBufferAttribute(geometry.attributes.normal, 0);
}

/** The corners about the centre of a flat mesh that is a fan about it, in order; none of another mesh. */
function cornersOf(mesh) {
  const { position } = mesh.geometry.attributes;
  const points = Array.from({ length: position.count }, (_, i) =>
    new Vector3().fromBufferAttribute(position, i),
  );
  const facing = facingOf(mesh);
  const size = Math.max(...points.map((point) => point.length()));
  if (points.some((point) => Math.abs(point.dot(facing)) > kRounding * size)) return [];
  const corners = points.filter((point) => point.length() > kRounding * size);
  if (corners.length !== points.length - 1) return [];
  const across = new Vector3().crossVectors(facing, corners[0]);
  const angle = (point) => Math.atan2(point.dot(across), point.dot(corners[0]));
  return corners.sort((a, b) => angle(a) - angle(b));
}

/** Two vectors that span a rectangle, or the diameters of a disk, and `isCircular`; nothing of another outline. */
function outlineOf(corners) {
  const radii = corners.map((corner) => corner.length());
  if (corners.length === 0) return null;
  if (Math.max(...radii) - Math.min(...radii) > kRounding * Math.max(...radii)) return null;
  if (corners.length === 4) {
    // Diagonals of one length that halve each other are those of a rectangle.
    if (new Vector3().addVectors(corners[0], corners[2]).length() > kRounding * radii[0])
      return null;
    const u = new Vector3().subVectors(corners[1], corners[0]);
    return { u, v: new Vector3().subVectors(corners[2], corners[1]), isCircular: false };
  }
  if (corners.length < kFewestSegments) return null;
  // The polygon has the area of the disk: n/2 r^2 sin(2 pi / n).
  const step = (2 * Math.PI) / corners.length;
  const radius = radii[0] * Math.sqrt(Math.sin(step) / step);
  const u = corners[0].clone().setLength(2 * radius);
  const facing = new Vector3().crossVectors(corners[0], corners[1]);
  const v = new Vector3().crossVectors(facing, u).setLength(2 * radius);
  return { u, v, isCircular: true };
}

/** A light in the place of the mesh, whose node moves it and no more, which shines along -z of its own axes; nothing where
 * there is none of its shape. */
function lightOf(mesh) {
  const outline = outlineOf(cornersOf(mesh));
  if (!outline) return null;
  const { material, matrixWorld } = mesh;
  const light = new RectAreaLight(
    material.emissive,
    material.emissiveIntensity,
    outline.u.length(),
    outline.v.length(),
  );
  light.isCircular = outline.isCircular;
  const z = facingOf(mesh).negate();
  const x = outline.u.normalize();
  light.quaternion.setFromRotationMatrix(
    new Matrix4().makeBasis(x, new Vector3().crossVectors(z, x), z),
  );
  light.position.setFromMatrixPosition(matrixWorld);
  return light;
}

/** Rectangles and disks that shine to one side become lights, which the path tracer samples, and of which it shows none to the
 * camera. So their meshes stay for the camera, with `castShadow` false, which the path tracer keeps and does not use, as the
 * mark of them. */
export function takeLamps(scene) {
  scene.updateMatrixWorld(true);
  const meshes = [];
  scene.traverse((object) => object.isMesh && meshes.push(object));
  const casings = new Set(meshes.map((mesh) => mesh.userData.name));
  for (const mesh of meshes) {
    if (!casings.has(kCasing + mesh.userData.name)) continue;
    const light = lightOf(mesh);
    if (!light) continue;
    scene.add(light);
    mesh.material = mesh.material.clone();
    mesh.material.castShadow = false;
  }
}
