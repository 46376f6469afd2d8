// Makes the images of the README from a run:
//   node screenshots.mjs <build folder> <run folder> <output folder> [<name>=<address on the page, from '#' on>...]
// Needs Debian's chromium. The case shown is the first failure with an image. With addresses only their images are made.
import { spawn } from "node:child_process";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { chromium } from "playwright-core";

const [build, run, output, ...views] = process.argv.slice(2);
mkdirSync(output, { recursive: true });
const server = spawn(join(build, "orbs"), ["serve", run]);
const url = await new Promise((resolve) =>
  server.stdout.once("data", (text) => resolve(/http:\S+\//.exec(text)[0])),
);
const args = [
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  ...(process.getuid() === 0 ? ["--no-sandbox"] : []),
];
const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args });
const page = await browser.newPage({ viewport: { width: 1200, height: 760 } });

async function take(name, height, address, ready) {
  await page.setViewportSize({ width: 1200, height });
  await page.goto("about:blank");
  await page.goto(url + address);
  await page.locator(ready).first().waitFor();
  await page.waitForLoadState("networkidle");
  await page.waitForFunction(() => !document.querySelector(".stage-note"));
  await page.waitForTimeout(300); // histograms are counted while the page is idle
  await page.screenshot({ path: join(output, `${name}.png`) });
}

async function takeUsual() {
  await take("overview", 530, "", ".cell a");
  const cell = page.locator(".cell a.tone-bad, .cell a.tone-unsure, .cell a.tone-good").first();
  const link = new URL(await cell.getAttribute("href"), page.url()).hash;
  await take(
    "case",
    960,
    `${link}?mode=side&tick=result%7Creference%7Cl1%7Csigned&img=l1`,
    ".stage canvas[data-drawn]",
  );
  await take("chart", 630, "#/charts", ".plot canvas");
}

if (views.length === 0) await takeUsual();
for (const view of views) {
  const [, name, address] = /^([^=]+)=(.+)$/s.exec(view);
  await take(name, 760, address, ".stage canvas[data-drawn]");
}
await browser.close();
server.kill("SIGTERM");
