// Checks the types of the tests of this folder, bundles them and runs them with Node's test runner:
//   node run_tests.mjs <source folder> <build folder> [names of tests, as a pattern]
import { spawnSync } from "node:child_process";
import { existsSync, readdirSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const [source, build, pattern = ""] = process.argv.slice(2);
const modules = join(source, "web/node_modules");
const here = join(source, "tests/page");
const types = spawnSync(
  process.execPath,
  [join(modules, "typescript/bin/tsc"), "--noEmit", "--project", here],
  { stdio: "inherit" },
);
if (types.status !== 0) process.exit(1);
const esbuild = createRequire(join(source, "web/package.json"))("esbuild");
const output = join(build, "tests/page/bundle");
rmSync(output, { recursive: true, force: true });
esbuild.buildSync({
  entryPoints: readdirSync(here)
    .filter((file) => file.endsWith(".test.ts"))
    .map((file) => join(here, file)),
  outdir: output,
  bundle: true,
  platform: "node",
  format: "esm",
  target: "node18",
  outExtension: { ".js": ".mjs" },
  nodePaths: [modules],
  external: ["playwright-core"],
});
const files = readdirSync(output).map((file) => join(output, file));
const names = pattern ? [`--test-name-pattern=${pattern}`] : [];
// Not each system has a package of it. To ctest, 77 says that the test is skipped.
const chromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(
  existsSync,
);
if (!chromium) {
  console.log("Chromium is not installed, so the page was not tested in a browser.");
  process.exit(77);
}
const result = spawnSync(process.execPath, ["--test", "--test-reporter=spec", ...names, ...files], {
  stdio: "inherit",
  env: {
    ...process.env,
    ORBS_SOURCE_DIR: source,
    ORBS_BINARY_DIR: build,
    ORBS_CHROMIUM: chromium,
  },
});
process.exit(result.status ?? 1);
