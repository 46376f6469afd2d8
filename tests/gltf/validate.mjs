// Exports every scene of every suite as glTF and asks Khronos' validator of each file:
//   node validate.mjs <source folder> <build folder> [suite...]
// Prints each error and warning, and exits with 1 if there is one or if nothing is exported.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, relative, resolve } from "node:path";

const [source, build, ...chosen] = process.argv
  .slice(2)
  .map((word, i) => (i < 2 ? resolve(word) : word));
const validator = createRequire(join(source, "web/package.json"))("gltf-validator");
const shipped = join(source, "configuration.json");
const suites = JSON.parse(readFileSync(shipped, "utf8")).suites.map((suite) => suite.name);
const folder = mkdtempSync(join(tmpdir(), "orbs-gltf-"));
// A reader that lacks nothing that the exporter can write.
const configuration = join(folder, "configuration.json");
writeFileSync(
  configuration,
  JSON.stringify({
    format: "orbs-configuration/1",
    include: [shipped],
    stands_alone: true,
    renderers: [
      {
        name: "reader",
        executable: "no-program",
        scene_format: "gltf",
        declares: "G5/M8-(7)/L3/A4/B7-(1-6)/C2-(1)/D3-(2)/N6-(2,3)",
        command: ["{executable}", "{scene}", "{output}"],
      },
    ],
  }),
);

/** Exports the suite and returns the folder; the scenes that are left out are in what is printed. */
function exported(suite) {
  const output = join(folder, suite);
  const options = ["--format", "gltf", "-r", "reader", "--suite", suite, "-o", output];
  const call = spawnSync(
    join(build, "orbs"),
    ["export", "--configuration", configuration, ...options],
    {
      encoding: "utf8",
    },
  );
  if (call.status !== 0) throw new Error(`${suite}: ${call.stdout}${call.stderr}`);
  return output;
}

/** The .glb files in the folder and below. */
const filesIn = (place) =>
  readdirSync(place, { withFileTypes: true }).flatMap((entry) => {
    const path = join(place, entry.name);
    if (entry.isDirectory()) return filesIn(path);
    return path.endsWith(".glb") ? [path] : [];
  });

const kError = 0;
const kWarning = 1;
let files = 0;
let faulty = 0;
try {
  for (const suite of chosen.length > 0 ? chosen : suites) {
    const output = exported(suite);
    const scenes = filesIn(output);
    for (const path of scenes) {
      const name = relative(output, path);
      const bytes = new Uint8Array(readFileSync(path));
      const report = await validator.validateBytes(bytes, { uri: name, maxIssues: 0 });
      const issues = report.issues.messages.filter(
        ({ severity }) => severity === kError || severity === kWarning,
      );
      for (const { code, message, pointer } of issues.slice(0, 5))
        console.log(`${suite}/${name}: ${code}: ${message} (${pointer})`);
      files += 1;
      faulty += issues.length > 0 ? 1 : 0;
    }
    console.log(`${suite}: ${scenes.length} files`);
    rmSync(output, { recursive: true });
  }
} finally {
  rmSync(folder, { recursive: true, force: true });
}
console.log(`${files} files, ${faulty} with errors or warnings`);
process.exit(files === 0 || faulty > 0 ? 1 : 0);
