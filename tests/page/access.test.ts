// axe-core finds nothing serious on any view, in light and dark, on a desktop and a phone, and nothing is
// wider than the window.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { join } from "node:path";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { drawn, open } from "./browser";
import { output, report } from "./runs";
import { startSession } from "./session";

const source = process.env["ORBS_SOURCE_DIR"] ?? "";
const axe = createRequire(join(source, "web/package.json"))("axe-core") as { source: string };

const session = startSession("small", "before", "cost-later", "cost", "looks", "stability");

interface Violation {
  id: string;
  impact: string;
  nodes: { html: string; failureSummary: string }[];
}

const views: Record<string, { address: string; ready: string; image?: string }> = {
  overview: { address: "#/?by=target", ready: ".cell a" },
  gallery: { address: "#/?as=gallery&q=known", ready: ".picture img" },
  target: { address: "#/case/m1_values/values/one?mode=flip", ready: ".readout", image: "result" },
  difference: {
    address: "#/case/m1_values/values/one?mode=flip&more=two&b=two&img=difference",
    ready: ".legend",
    image: "difference",
  },
  path: { address: "#/case/m3_lamp/lamp/one?run=looks", ready: ".path-chart svg" },
  layer: {
    address: "#/case/a1_stokes/stokes/one?layer=S1",
    ready: ".pair-errors",
    image: "result",
  },
  sweep: {
    address: "#/images?run=cost&target=110&point=orbs%2F1&more=cycles+64+spp&b=cycles+64+spp",
    ready: ".pair-errors",
    image: "result",
  },
  compare: { address: "#/compare", ready: ".compare section" },
  effects: { address: "#/effects", ready: ".effect-matrix" },
  charts: { address: "#/charts", ready: ".plot canvas" },
  cost: { address: "#/?run=cost-later", ready: ".since-answer" },
  stability: { address: "#/?run=stability", ready: "table.matrix" },
};

/** Pages that are one file. */
const files: Record<string, { ready: string; write: (file: string) => void }> = {
  report: { ready: ".cell a", write: (file) => report(session.folder, file) },
  history: {
    ready: "table",
    write: (file) =>
      void output("history", join(session.scratch.folder, "before"), session.folder, "-o", file),
  },
};

const looks = [
  { colorScheme: "light", viewport: { width: 1280, height: 900 } },
  { colorScheme: "dark", viewport: { width: 390, height: 844 } },
] as const;

const isWithinWindow = (page: Page): Promise<boolean> =>
  page.evaluate(() => document.documentElement.scrollWidth <= innerWidth);

async function seriousOf(page: Page): Promise<string[]> {
  await page.evaluate(axe.source);
  const violations = await page.evaluate(async () => {
    const { axe: own } = globalThis as unknown as {
      axe: { run: (options: object) => Promise<{ violations: Violation[] }> };
    };
    return (await own.run({ resultTypes: ["violations"] })).violations;
  });
  return violations
    .filter(({ impact }) => ["serious", "critical"].includes(impact))
    .map(({ id, nodes }) => {
      const places = nodes.slice(0, 3).map((node) => node.html);
      return `${id}: ${places.join(" ")}`;
    });
}

for (const [name, { address, ready, image }] of Object.entries(views))
  for (const look of looks)
    test(`${name} is accessible, ${look.colorScheme}, ${look.viewport.width} px wide`, async () => {
      const { page } = await open(session.browser, session.url + address, look);
      await page.locator(ready).first().waitFor();
      if (image) await drawn(page, image);
      assert.deepEqual(await seriousOf(page), []);
      assert.ok(await isWithinWindow(page), "nothing is wider than the window");
      await page.close();
    });

for (const [name, { ready, write }] of Object.entries(files))
  for (const look of looks)
    test(`the file of a ${name} is accessible, ${look.colorScheme}, ${look.viewport.width} px wide`, async () => {
      const file = join(session.scratch.folder, `${name}.html`);
      write(file);
      const { page } = await open(session.browser, `file://${file}`, look);
      await page.locator(ready).first().waitFor();
      assert.deepEqual(await seriousOf(page), []);
      assert.ok(await isWithinWindow(page), "nothing is wider than the window");
      await page.close();
    });
