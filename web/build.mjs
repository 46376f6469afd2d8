// Bundles the page into one folder: node build.mjs <output folder>
//   index.html, page.js, page.css, icon.svg   what `orbs serve` answers with
//   single.html                                the same in one file, with a mark where `orbs report` puts the data
import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const output = process.argv[2];
if (!output) throw new Error("usage: node build.mjs <output folder>");
mkdirSync(output, { recursive: true });

const result = await build({
  entryPoints: { page: join(here, "src/main.tsx") },
  outdir: output,
  bundle: true,
  minify: true,
  format: "esm",
  target: ["chrome100", "firefox115", "safari16.4"],
  jsx: "automatic",
  jsxImportSource: "preact",
  charset: "utf8",
  legalComments: "inline", // of uPlot and preact: their licences ask for it
  logLevel: "warning",
  metafile: true,
});

for (const file of ["index.html", "icon.svg"])
  copyFileSync(join(here, "src", file), join(output, file));

// An HTML parser ends a script at "</script" wherever it stands.
const script = readFileSync(join(output, "page.js"), "utf8")
  .replaceAll("</script", "<\\/script")
  .trim();
const style = readFileSync(join(output, "page.css"), "utf8").trim();
const icon = readFileSync(join(output, "icon.svg")).toString("base64");
const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
// Only these two texts run, and nothing is loaded: the file cannot ask the network for anything.
const policy =
  `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)}; ` +
  `img-src data: blob:; base-uri 'none'; form-action 'none'`;
// Replacement by functions: the texts hold "$", which a string would give a meaning.
const single = readFileSync(join(output, "index.html"), "utf8")
  .replace("<!--policy-->", () => `<meta http-equiv="Content-Security-Policy" content="${policy}">`)
  .replace(
    /<link rel="icon"[^>]*>/,
    () => `<link rel="icon" href="data:image/svg+xml;base64,${icon}">`,
  )
  .replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${style}</style>`)
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
