// Runs in the browser, in page.html: renders a .glb file with the WebGPU path tracer of three-gpu-pathtracer.
import { MathUtils, NoToneMapping, RenderTarget, Scene, WebGPURenderer } from "three/webgpu";
import { uniform, wgslFn } from "three/tsl";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { rayStruct, wgslTagFn } from "three-mesh-bvh/webgpu";
import { WebGPUPathTracer } from "three-gpu-pathtracer/src/webgpu/WebGPUPathTracer.js";
import { lightRecordStruct } from "three-gpu-pathtracer/src/webgpu/nodes/structs.wgsl.js";
import { takeLamps } from "./lamps.mjs";
import { bounce, randomNumbers } from "./random.mjs";

// Russian roulette ends paths long before.
const kUnlimitedDepth = 4096;
// The number of the first path of a seed; the others follow. Seeds that follow each other are far apart.
const kSeedStride = 0x9e3779b1;
// Rays of each path before the GPU is asked how far it is.
const kStepsAtOnce = 16;

async function loaded(url) {
  const gltf = await new GLTFLoader().loadAsync(url);
  const extras = gltf.scene.userData.orbs;
  if (!extras)
    throw new Error(
      "its scene has no extras of orbs, which hold the size of the image and the trace depth",
    );
  const camera = gltf.cameras[0];
  if (!camera) throw new Error("it has no camera");
  return { scene: new Scene().add(gltf.scene), camera, extras };
}

/** A surface whose specular factor is 0 reflects nothing at any index, but the path tracer takes what an index other than 1
 * would reflect from the light that comes from below it. */
function withoutReflection(scene) {
  scene.traverse(({ material }) => {
    if (material?.specularIntensity === 0 && material.transmission === 0) material.ior = 1;
  });
}

/** Rays from the position of the camera, or side by side where it is orthographic, to any distance. Those of the path
 * tracer go from the near plane to the far one, by a matrix of floats that yields no direction where the near plane is so
 * near and the far one so far as in our files. */
function raysWithoutPlanes(camera) {
  camera.updateWorldMatrix(true, false);
  const toWorld = uniform(camera.matrixWorld);
  const isFlat = camera.isOrthographicCamera;
  const height = uniform(isFlat ? camera.top : Math.tan(MathUtils.degToRad(camera.fov / 2)));
  const width = uniform(isFlat ? camera.right : height.value * camera.aspect);
  const spread = uniform(isFlat ? 0 : 1);
  const fn = wgslTagFn`
    fn getCameraRay( uv: vec2f, resolution: vec2f, ray: ptr<function, ${rayStruct}> ) -> bool {
      let p = ( 2.0 * uv - vec2f( 1.0 ) ) * vec2f( ${width}, ${height} );
      ray.origin = ( ${toWorld} * vec4f( p * ( 1.0 - ${spread} ), 0.0, 1.0 ) ).xyz;
      ray.direction = normalize( ( ${toWorld} * vec4f( p * ${spread}, - 1.0, 0.0 ) ).xyz );
      ray.maxDist = 0.0;
      return true;
    }
  `;
  camera.getCameraRayFn = () => ({ fn, update: () => false });
}

async function startedRenderer() {
  const renderer = new WebGPURenderer();
  renderer.toneMapping = NoToneMapping;
  renderer.setClearColor(0x000000, 1);
  await renderer.init();
  if (!renderer.backend.isWebGPUBackend) throw new Error("this browser has no WebGPU");
  // The path tracer shows each state of its image. Chromium without a window has no canvas for WebGPU, and is not asked.
  renderer.setRenderTarget(new RenderTarget(1, 1));
  return renderer;
}

// Rays begin off the surface, by up to 256 units in the last place of a coordinate, or by 2^-16 near 0.
const nearOf = wgslFn(`
  fn orbsNear( origin: vec3f, dist: f32 ) -> f32 {
    let p = abs( origin );
    return 0x1p-15f * max( max( max( p.x, p.y ), max( p.z, dist ) ), 0.5f );
  }
`);

/** Lights are met before the meshes in their place: a shadow ray of the path tracer is as long as the way from the surface,
 * from which its start is moved towards the light, so it would meet what is right behind, too. And none is sampled behind the
 * last scattering: the path tracer does so at each surface that it meets, the last of which is there for meshes that
 * shine. */
function lightsInPlaceOfMeshes(tracer, depth) {
  const lights = tracer._pathTracer.lightsInfo; // no public member sets it
  const { randomLightSample, intersectLightAtIndex } = lights;
  lights.randomLightSample = wgslTagFn`
    fn randomLightSampleWithin( index: u32, origin: vec3f, ruv: vec2f ) -> ${lightRecordStruct} {
      var light = ${randomLightSample}( index, origin, ruv );
      light.dist -= ${nearOf}( origin, light.dist );
      if ( ${bounce}() >= ${depth}u ) { light.pdf = 0.0; }
      return light;
    }
  `;
  lights.intersectLightAtIndex = wgslTagFn`
    fn intersectLightFirst(
      origin: vec3f, direction: vec3f, index: u32, light: ptr<function, ${lightRecordStruct}>,
    ) -> bool {
      if ( ! ${intersectLightAtIndex}( origin, direction, index, light ) ) { return false; }
      ( *light ).dist -= ${nearOf}( origin, ( *light ).dist );
      return true;
    }
  `;
}

/** The meshes of lamps shine for the camera alone: all other rays meet the lights in their place. */
function lampsForTheCamera(tracer) {
  const { fns } = tracer._bvhData;
  // Read as a member, it would be whatever the member is when the shader is made.
  const inner = Object.getOwnPropertyDescriptor(fns, "getSurfaceRecord").value;
  fns.getSurfaceRecord = wgslTagFn`
    fn surfaceRecordWithLamps(
      material: Material, vertex: bvh_GeometryStruct, side: f32, faceNormal: vec3f, view: vec3f, blurRoughness: f32,
    ) -> SurfaceRecord {
      var surface = ${inner}( material, vertex, side, faceNormal, view, blurRoughness );
      if ( material.castShadow == 0 && ${bounce}() > 0u ) { surface.emission = vec3f( 0.0 ); }
      return surface;
    }
  `;
}

/** Nothing changes the mean: no clamp, no blurred reflections, no light but that of the file. */
function pathTracer(renderer, { scene, camera, extras }, spp, seed) {
  const tracer = new WebGPUPathTracer(renderer);
  const firstPath = Math.imul(seed, kSeedStride) >>> 0;
  tracer.setRandom(randomNumbers(firstPath));
  const depth = extras.trace_depth === "unlimited" ? kUnlimitedDepth : extras.trace_depth;
  lightsInPlaceOfMeshes(tracer, depth);
  tracer.clampDirect = 0;
  tracer.clampIndirect = 0;
  tracer.filterGlossyFactor = 0;
  tracer.maxBounces = depth + 1; // it counts rays, the first of which comes from the camera
  tracer.maxSamples = spp;
  // No preview of fewer pixels comes first.
  tracer.dynamicLowRes = false;
  tracer.renderDelay = 0;
  tracer.minSamples = 0;
  tracer.synchronizeRenderSize = false;
  tracer.setScene(scene, camera);
  lampsForTheCamera(tracer);
  tracer.setSize(extras.width, extras.height);
  tracer.stableNoise = false; // it would begin with the seed 0
  tracer._pathTracer.seed = firstPath - 1; // no public member sets it; it is raised by 1 before the first path
  return tracer;
}

/** WebGPU copies rows of a multiple of 256 bytes, which are 16 pixels. */
function withoutPadding(rows, width, height) {
  const floats = 4 * width;
  const apart = 4 * 16 * Math.ceil(width / 16);
  const pixels = new Float32Array(floats * height);
  for (let y = 0; y < height; ++y)
    pixels.set(rows.subarray(y * apart, y * apart + floats), y * floats);
  return pixels;
}

/** Four floats of each pixel, from the top, and the seconds that rendering took. */
globalThis.render = async ({ url, spp, seed, asIs }) => {
  const file = await loaded(url);
  if (!asIs) {
    withoutReflection(file.scene);
    takeLamps(file.scene);
  }
  raysWithoutPlanes(file.camera);
  const renderer = await startedRenderer();
  const tracer = pathTracer(renderer, file, spp, seed);
  const begin = performance.now();
  for (let finished = 0; finished < spp; finished = (await tracer.getSampleCountsAsync()).min)
    for (let step = 0; step < kStepsAtOnce; ++step) tracer.renderSample();
  const seconds = (performance.now() - begin) / 1000;
  const { width, height } = file.extras;
  const rows = await renderer.backend.copyTextureToBuffer(tracer.target, 0, 0, width, height, 0);
  return { width, height, seconds, pixels: withoutPadding(rows, width, height) };
};
