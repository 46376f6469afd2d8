// Renders a .glb file with three-gpu-pathtracer, a path tracer for browsers, in Chromium without a window:
//
//   npm ci --prefix adapters/web     once: fetches the packages that adapters/web/package-lock.json names
//   node adapters/web_gltf.mjs --scene scene.glb --output out.exr --spp N --seed S [--as-is] [--browser chromium]
//
// Materials, meshes, textures and camera are those of GLTFLoader of three.js, so that an image shows what a second reader of
// glTF makes of our exporter, beside Blender's importer (cycles_gltf.py). Of what the exporter puts into the extras of the
// scene it takes the size of the image and the trace depth. Without a graphics card all is computed on the processor, by
// SwiftShader. Two corrections are made unless --as-is is given: web/render.mjs and web/lamps.mjs say which.
//
// Ends with status 2 and one line on stderr when there is no image; the output appears only when complete. Prints
// `orbs: render_seconds <s>`, the time of the samples alone.
import { existsSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { extname, join, resolve, sep } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { exrBytes } from "./web/exr.mjs";

const home = fileURLToPath(new URL("web", import.meta.url));
// No request leaves the machine: all answers are files. WebGPU is there for secure addresses alone, of which this is one.
const kOrigin = "http://localhost";
const kTypes = { ".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript" };

function readArguments() {
  const { values } = parseArgs({
    options: {
      scene: { type: "string" },
      output: { type: "string" },
      spp: { type: "string" },
      seed: { type: "string", default: "0" },
      "as-is": { type: "boolean", default: false },
      browser: { type: "string" },
      version: { type: "boolean", default: false },
    },
  });
  if (values.version) return values;
  for (const name of ["scene", "output", "spp"])
    if (values[name] === undefined) throw new Error(`--${name} is missing`);
  for (const [name, least] of [
    ["spp", 1],
    ["seed", 0],
  ])
    if (!/^\d{1,9}$/.test(values[name]) || Number(values[name]) < least)
      throw new Error(`--${name} ${values[name]}: a whole number from ${least} on is needed`);
  return { ...values, spp: Number(values.spp), seed: Number(values.seed) };
}

/** The folder of a package that npm has installed. */
function folderOf(name) {
  const folder = join(home, "node_modules", name);
  if (!existsSync(folder)) throw new Error(`its packages are missing: npm ci --prefix ${home}`);
  return folder;
}

/** What makes the images, with versions. */
function versions() {
  const one = (name) =>
    `${name} ${JSON.parse(readFileSync(join(folderOf(name), "package.json"), "utf8")).version}`;
  return ["three-gpu-pathtracer", "three", "three-mesh-bvh"].map(one).join(", ");
}

function launch(chosen) {
  const usual = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
  const executablePath = chosen ?? usual.find(existsSync);
  if (!executablePath)
    throw new Error(`there is none of ${usual.join(", ")}; --browser names another`);
  // The sandbox of Chromium does not run as root in a container.
  const args = [
    "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-gpu-watchdog",
    ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
  ];
  const { chromium } = createRequire(import.meta.url)(folderOf("playwright-core"));
  // The harness has its own limit of time.
  return chromium.launch({ executablePath, args, timeout: 0 });
}

/** The file that the page asks for: the scene, or one of the folder of the page. */
function answer(path, scene) {
  if (path === "/scene.glb") return { body: scene, contentType: "model/gltf-binary" };
  const file = resolve(home, `.${path}`);
  if (!file.startsWith(home + sep) || !existsSync(file)) return { status: 404 };
  return {
    body: readFileSync(file),
    contentType: kTypes[extname(file)] ?? "application/octet-stream",
  };
}

/** A page whose `render` can be called; `failed` is rejected with the first thing that goes wrong in it. */
async function openedPage(browser, scene) {
  const page = await browser.newPage();
  page.setDefaultTimeout(0);
  let fail;
  const failed = new Promise((_, reject) => (fail = (text) => reject(new Error(text))));
  failed.catch(() => {});
  page.on("pageerror", (error) => fail(error.message));
  // The loader leaves out what it does not know, and says so as a warning: such an image would look right.
  page.on("console", (message) => {
    if (message.type() === "error" || message.text().startsWith("THREE.GLTFLoader"))
      fail(message.text());
  });
  await page.route("**/*", (route) =>
    route.fulfill(answer(decodeURI(new URL(route.request().url()).pathname), scene)),
  );
  await page.goto(`${kOrigin}/page.html`);
  await Promise.race([page.waitForFunction(() => globalThis.render), failed]);
  return { page, failed };
}

/** The pixels travel as text, as an array of numbers would take seconds. */
function renderedInPage(options) {
  return globalThis.render(options).then(({ pixels, ...rest }) => {
    const bytes = new Uint8Array(pixels.buffer);
    let text = "";
    for (let i = 0; i < bytes.length; i += 4096)
      text += String.fromCharCode(...bytes.subarray(i, i + 4096));
    return { ...rest, pixels: btoa(text) };
  });
}

async function rendered({ scene, spp, seed, browser: chosen, "as-is": asIs }) {
  const bytes = readFileSync(scene);
  const browser = await launch(chosen);
  try {
    const { page, failed } = await openedPage(browser, bytes);
    const options = { url: `${kOrigin}/scene.glb`, spp, seed, asIs };
    const result = await Promise.race([page.evaluate(renderedInPage, options), failed]);
    const pixels = Uint8Array.from(Buffer.from(result.pixels, "base64"));
    return { ...result, pixels: new Float32Array(pixels.buffer) };
  } finally {
    await browser.close();
  }
}

async function main() {
  const options = readArguments();
  if (options.version) {
    console.log(versions());
    return;
  }
  const { width, height, pixels, seconds } = await rendered(options);
  const unfinished = `${options.output}.unfinished`;
  writeFileSync(unfinished, exrBytes(width, height, pixels, { "orbs.spp": String(options.spp) }));
  renameSync(unfinished, options.output);
  console.log(`orbs: render_seconds ${seconds.toFixed(3)}`);
}

main().catch((error) => {
  console.error(`web_gltf.mjs: error: ${error.message.split("\n")[0]}`);
  process.exitCode = 2;
});
