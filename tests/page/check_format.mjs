// Checks that the sources of the page, of its tests and of the adapter of the web are formatted as web/.prettierrc.json says:
//   node check_format.mjs <source folder> [--write]
// With --write they are formatted instead. web/package-lock.json pins the version of Prettier.
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { join, resolve } from "node:path";

const [folder, ...options] = process.argv.slice(2);
const source = resolve(folder);
const prettier = join(source, "web/node_modules/prettier/bin/prettier.cjs");
if (!existsSync(prettier)) {
  console.error(`${prettier} is missing: building the target orbs-page installs it.`);
  process.exit(1);
}
const files = [
  "web/src/**/*.{ts,tsx,css}",
  "web/*.{mjs,json}",
  "!web/package-lock.json",
  "tests/page/*.{ts,mjs,json}",
  "tests/gltf/*.mjs",
  "adapters/*.mjs",
  "adapters/web/*.{mjs,html,json}",
  "!adapters/web/package-lock.json",
];
const mode = options.includes("--write") ? "--write" : "--check";
const config = join(source, "web/.prettierrc.json");
const result = spawnSync(process.execPath, [prettier, "--config", config, mode, ...files], {
  cwd: source,
  stdio: "inherit",
});
if (result.status !== 0 && mode === "--check")
  console.error("To format them: node tests/page/check_format.mjs . --write");
process.exit(result.status ?? 1);
