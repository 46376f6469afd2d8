// Bundles the page into one folder: node build.mjs <output folder>
//   index.html, page.js, page.css, icon.svg   the files that `orbs serve` sends
//   single.html                               the same in one file, with a placeholder for the
//                                             data that `orbs report` inserts
import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const output = process.argv[2];
if (!output) throw new Error("usage: node build.mjs <output folder>");
mkdirSync(output, { recursive: true });

const shared = {
  bundle: true,
  minify: true,
  target: ["chrome100", "firefox115", "safari16.4"],
  charset: "utf8",
  logLevel: "warning",
};
// The worker is a text in the page: a page in one file can start no other.
const worker = await build({
  ...shared,
  entryPoints: [join(here, "src/data/decode_worker.ts")],
  format: "iife",
  write: false,
});
const result = await build({
  ...shared,
  entryPoints: { page: join(here, "src/main.tsx") },
  outdir: output,
  format: "esm",
  define: { kDecodeWorker: JSON.stringify(worker.outputFiles[0].text) },
  jsx: "automatic",
  jsxImportSource: "preact",
  legalComments: "inline", // the licences of uPlot and preact require it
  metafile: true,
});

for (const file of ["index.html", "icon.svg"])
  copyFileSync(join(here, "src", file), join(output, file));

// An HTML parser ends a script at the first "</script", even within a string.
const script = readFileSync(join(output, "page.js"), "utf8")
  .replaceAll("</script", "<\\/script")
  .trim();
const style = readFileSync(join(output, "page.css"), "utf8").trim();
const icon = readFileSync(join(output, "icon.svg")).toString("base64");
const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
// Only this script, its worker and this style are allowed, and nothing can be loaded from the network.
const policy =
  `default-src 'none'; script-src ${hash(script)}; worker-src blob:; style-src ${hash(style)}; ` +
  `img-src data: blob:; base-uri 'none'; form-action 'none'`;
// Functions as replacements: in a string, "$" would have a special meaning.
const single = readFileSync(join(output, "index.html"), "utf8")
  .replace("<!--policy-->", () => `<meta http-equiv="Content-Security-Policy" content="${policy}">`)
  .replace(
    /<link rel="icon"[^>]*>/,
    () => `<link rel="icon" href="data:image/svg+xml;base64,${icon}">`,
  )
  .replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${style}</style>`)
  .replace(/<link rel="preload"[^>]*>\n/, "")
  .replace(
    /<script type="module"[^>]*><\/script>/,
    () => `<!--orbs-data-->\n<script type="module">${script}</script>`,
  );
for (const mark of ["<!--orbs-data-->", "Content-Security-Policy", "<style>"])
  if (!single.includes(mark))
    throw new Error(`single.html has no ${mark}: index.html does not look as expected`);
writeFileSync(join(output, "single.html"), single);

const bytes = Object.values(result.metafile.outputs).reduce((sum, file) => sum + file.bytes, 0);
console.log(`page: ${(bytes / 1000).toFixed(0)} kB in ${output}`);
