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

// Emission that fills the image, and a diffuse plane in a constant environment: neither has noise.
const kScenes = "flat-field,furnace-plane";
const folder = mkdtempSync(join(tmpdir(), "orbs-web-"));
try {
  const options = ["--configuration", join(source, "configuration.json"), "-r", "web-gltf"];
  const call = spawnSync(
    join(build, "orbs"),
    ["run", ...options, "--suite", "known", "-s", kScenes, "-v", "-o", join(folder, "run")],
    { encoding: "utf8" },
  );
  console.log(call.stdout + call.stderr);
  const passed = call.stdout.match(/^\[\d+\/\d+\] web-gltf +\S+ +pass /gm) ?? [];
  process.exitCode = call.status === 0 && passed.length === 2 ? 0 : 1;
} finally {
  rmSync(folder, { recursive: true, force: true });
}
