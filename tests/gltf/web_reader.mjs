// Renders scenes whose images follow from a formula with the path tracer of the web, as the entry web-gltf says:
//   node web_reader.mjs <source folder> <build folder>
// Exits with 77, which ctest shows as skipped, where its packages or the browser are not installed.
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const [source, build] = process.argv.slice(2).map((word) => resolve(word));
const kSkipped = 77;
const needed = {
  [join(source, "adapters/web/node_modules/three-gpu-pathtracer")]: "npm ci --prefix adapters/web",
  "/usr/bin/chromium": "apt-get install chromium",
};
for (const [path, command] of Object.entries(needed))
  if (!existsSync(path)) {
    console.log(`skipped: ${path} is missing; '${command}' installs it`);
    process.exit(kSkipped);
  }

// Emission that fills the image, and a diffuse plane in a constant environment: neither has noise but that of rounding. Of 8 x 8
// pixels, as WebGPU pads rows of fewer than 16, and with 4 samples, which show the mean to 0.002 %: of more, a path is lost now
// and then (docs/use/renderers.md says why), and where one pixel has all the noise there is, the mean stays undecided. And a
// floor below a rectangle and a disk, which 128 samples decide where lamps are sampled, and leave open where they are met by
// chance. And a floor below a point, slopes in parallel light, cards with normal maps at the first coordinates and at the second
// ones, and squares seen by an orthographic camera, whose edges need the samples.
const kRuns = [
  ["known", "flat-field,furnace-plane", "1/8", "0.0625"],
  ["known", "rect-above,disk-above", "1/4", "0.25"],
  ["everyday", "d1-floor,d3-slopes", "1/4", "0.25"],
  ["everyday", "n1-right,n6-normals", "1/4", "1"],
  ["everyday", "c2-squares", "1/4", "2"],
];

/** Whether all scenes pass. */
function passes([suite, scenes, size, share], output) {
  const options = ["--configuration", join(source, "configuration.json"), "-r", "web-gltf"];
  const images = ["--size", size, "--fixed-samples", "--spp-scale", share];
  const call = spawnSync(
    join(build, "orbs"),
    ["run", ...options, ...images, "--suite", suite, "-s", scenes, "-v", "-o", output],
    { encoding: "utf8" },
  );
  const told = call.stdout + call.stderr; // the lines of the targets are on stderr
  console.log(told);
  const passed = told.match(/^\[\d+\/\d+\] web-gltf +\S+ +pass /gm) ?? [];
  return call.status === 0 && passed.length === scenes.split(",").length;
}

const folder = mkdtempSync(join(tmpdir(), "orbs-web-"));
try {
  const failed = kRuns.filter((run, i) => !passes(run, join(folder, `run${i}`)));
  process.exitCode = failed.length === 0 ? 0 : 1;
} finally {
  rmSync(folder, { recursive: true, force: true });
}
