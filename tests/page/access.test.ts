// axe-core finds nothing serious on any view, in light and dark, on a desktop and a phone.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { join } from "node:path";
import { test } from "node:test";
import { drawn, open } from "./browser";
import { startSession } from "./session";

const source = process.env["ORBS_SOURCE_DIR"] ?? "";
const axe = createRequire(join(source, "web/package.json"))("axe-core") as { source: string };

const session = startSession("small", "before", "cost", "looks");

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
};

for (const [name, { address, ready, image }] of Object.entries(views))
  for (const look of [
    { colorScheme: "light", viewport: { width: 1280, height: 900 } },
    { colorScheme: "dark", viewport: { width: 390, height: 844 } },
  ] as const)
    test(`${name} is accessible, ${look.colorScheme}, ${look.viewport.width} px wide`, async () => {
      const { page } = await open(session.browser, session.url + address, look);
      await page.locator(ready).first().waitFor();
      if (image) await drawn(page, image);
      await page.evaluate(axe.source);
      const violations = await page.evaluate(async () => {
        const { axe: own } = globalThis as unknown as {
          axe: { run: (options: object) => Promise<{ violations: Violation[] }> };
        };
        return (await own.run({ resultTypes: ["violations"] })).violations;
      });
      const serious = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
      assert.deepEqual(
        serious.map(
          ({ id, nodes }) =>
            `${id}: ${nodes
              .slice(0, 3)
              .map((node) => node.html)
              .join(" ")}`,
        ),
        [],
      );
      await page.close();
    });
