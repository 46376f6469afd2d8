// Runs in the browser, in page.html: renders a .glb file with the WebGPU path tracer of three-gpu-pathtracer.
import { MathUtils, NoToneMapping, RenderTarget, Scene, WebGPURenderer } from "three/webgpu";
import { uniform } from "three/tsl";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { rayStruct, wgslTagFn } from "three-mesh-bvh/webgpu";
import { WebGPUPathTracer } from "three-gpu-pathtracer/src/webgpu/WebGPUPathTracer.js";
import * as RANDOM_PCG from "three-gpu-pathtracer/src/webgpu/nodes/rand/pcg.wgsl.js";

// Russian roulette ends paths long before.
const kUnlimitedDepth = 4096;
// The first random sequence of a seed; those of its samples follow. Seeds that follow each other are far apart.
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

/** Rays from the position of the camera to any distance. Those of the path tracer go from the near plane to the far one, by
 * a matrix of floats that yields no direction where the near plane is so near and the far one so far as in our files. */
function raysWithoutPlanes(camera) {
  camera.updateWorldMatrix(true, false);
  const toWorld = uniform(camera.matrixWorld);
  const height = uniform(Math.tan(MathUtils.degToRad(camera.fov / 2)));
  const width = uniform(height.value * camera.aspect);
  const fn = wgslTagFn`
    fn getCameraRay( uv: vec2f, resolution: vec2f, ray: ptr<function, ${rayStruct}> ) -> bool {
      let p = ( 2.0 * uv - vec2f( 1.0 ) ) * vec2f( ${width}, ${height} );
      ray.origin = ( ${toWorld} * vec4f( 0.0, 0.0, 0.0, 1.0 ) ).xyz;
      ray.direction = normalize( ( ${toWorld} * vec4f( p, - 1.0, 0.0 ) ).xyz );
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

/** Nothing changes the mean: no clamp, no blurred reflections, no light but that of the file. */
function pathTracer(renderer, { scene, camera, extras }, spp, seed) {
  const tracer = new WebGPUPathTracer(renderer);
  tracer.setRandom(RANDOM_PCG); // white noise: the sequences of two seeds have nothing in common
  tracer.clampDirect = 0;
  tracer.clampIndirect = 0;
  tracer.filterGlossyFactor = 0;
  const depth = extras.trace_depth === "unlimited" ? kUnlimitedDepth : extras.trace_depth;
  tracer.maxBounces = depth + 1; // it counts rays, the first of which comes from the camera
  tracer.maxSamples = spp;
  // No preview of fewer pixels comes first.
  tracer.dynamicLowRes = false;
  tracer.renderDelay = 0;
  tracer.minSamples = 0;
  tracer.synchronizeRenderSize = false;
  tracer.setScene(scene, camera);
  tracer.setSize(extras.width, extras.height);
  tracer.stableNoise = false; // it would begin with the seed 0
  tracer._pathTracer.seed = Math.imul(seed, kSeedStride) >>> 0; // no public member sets it
  return tracer;
}

/** Four floats of each pixel, from the top, and the seconds that rendering took. */
globalThis.render = async ({ url, spp, seed, asIs }) => {
  const file = await loaded(url);
  if (!asIs) withoutReflection(file.scene);
  raysWithoutPlanes(file.camera);
  const renderer = await startedRenderer();
  const tracer = pathTracer(renderer, file, spp, seed);
  const begin = performance.now();
  for (let finished = 0; finished < spp; finished = (await tracer.getSampleCountsAsync()).min)
    for (let step = 0; step < kStepsAtOnce; ++step) tracer.renderSample();
  const seconds = (performance.now() - begin) / 1000;
  const { width, height } = file.extras;
  const pixels = await renderer.backend.copyTextureToBuffer(tracer.target, 0, 0, width, height, 0);
  return { width, height, seconds, pixels };
};
