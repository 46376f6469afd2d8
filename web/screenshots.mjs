// Takes the screenshots of the documentation from a run:
//   node screenshots.mjs <build folder> <run folder> <output folder> [<name>=<address>...]
// The case shown is the first failure, or the first pass if there is none. An address is the part
// from '#' on; if any is given, only these screenshots are taken: of a case as high as a window, of
// pictures as a whole. Needs Debian's chromium.
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
const kWidth_px = 1280;
const page = await browser.newPage({ colorScheme: "light" });

async function take(name, height, address, ready) {
  await page.setViewportSize({ width: kWidth_px, height });
  await page.goto("about:blank");
  await page.goto(url + address);
  await page.locator(ready).first().waitFor();
  await page.waitForLoadState("networkidle");
  await page.waitForFunction(() => !document.querySelector(".stage-note"));
  await page.waitForTimeout(300); // histograms are counted while the page is idle
  await page.screenshot({ path: join(output, `${name}.png`) });
}

// A window so high that all rows are in it, and then as high as they are.
async function takeWhole(name, address) {
  await page.setViewportSize({ width: kWidth_px, height: 6000 });
  await page.goto(url + address);
  await page.locator(".gallery .body .gallery-row").first().waitFor();
  await page.waitForFunction(() => {
    const count = (what) => document.querySelectorAll(`.gallery ${what}`).length;
    return count("img[alt='|result − reference|']") === count("a.pictures");
  });
  const height = await page.evaluate(() => document.querySelector(".gallery").clientHeight);
  await page.locator(".gallery").screenshot({ path: join(output, `${name}.png`) });
  console.log(`${name}: ${height} px high`);
}

async function takeUsual() {
  await take("overview", 720, "", ".cell a");
  const cells = ["bad", "unsure", "good"].map((tone) => page.locator(`.cell a.tone-${tone}`));
  for (const cell of cells) {
    if ((await cell.count()) === 0) continue;
    const link = new URL(await cell.first().getAttribute("href"), page.url()).hash;
    const view = "mode=side&tick=result%7Creference%7Cdifference&img=difference&diff=absolute";
    await take("case", 720, `${link}?${view}`, ".stage canvas[data-drawn]");
    break;
  }
  await take("gallery", 720, "#/?as=gallery", '.gallery img[alt="|result − reference|"]');
  await take("chart", 630, "#/charts", ".plot canvas");
}

if (views.length === 0) await takeUsual();
for (const view of views) {
  const [, name, address] = /^([^=]+)=(.+)$/s.exec(view);
  if (address.includes("as=gallery")) await takeWhole(name, address);
  else await take(name, 720, address, ".stage canvas[data-drawn]");
}
await browser.close();
server.kill("SIGTERM");
