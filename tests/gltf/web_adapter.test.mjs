// What adapters/web_gltf.mjs does before there is a browser, and the images that it writes:
//   node --test web_adapter.test.mjs
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { exrBytes } from "../../adapters/web/exr.mjs";

const adapter = fileURLToPath(new URL("../../adapters/web_gltf.mjs", import.meta.url));
const call = (...words) =>
  spawnSync(process.execPath, [adapter, ...words], { encoding: "utf8", timeout: 60000 });

test("an argument that is missing or wrong is named in one line", () => {
  for (const [words, message] of [
    [["--output", "a.exr", "--spp", "1"], "--scene is missing"],
    [["--scene", "a.glb", "--spp", "1"], "--output is missing"],
    [["--scene", "a.glb", "--output", "a.exr"], "--spp is missing"],
    [["--scene", "a.glb", "--output", "a.exr", "--spp", "0"], "--spp 0: a whole number from 1"],
    [["--scene", "a.glb", "--output", "a.exr", "--spp", "1.5"], "--spp 1.5: a whole number from 1"],
    [["--scene", "a.glb", "--output", "a.exr", "--spp", "1", "--seed", "x"], "--seed x: a whole"],
    [["--scen", "a.glb"], "'--scen'"],
  ]) {
    const { status, stderr } = call(...words);
    assert.equal(status, 2, words.join(" "));
    assert.ok(stderr.startsWith("web_gltf.mjs: error: "), stderr);
    assert.ok(stderr.includes(message), stderr);
    assert.equal(stderr.trimEnd().split("\n").length, 1, stderr);
  }
});

test("a scene that cannot be read leaves no image", () => {
  const folder = mkdtempSync(join(tmpdir(), "orbs-web-"));
  try {
    const output = join(folder, "image.exr");
    const { status, stderr } = call(
      "--scene",
      join(folder, "no.glb"),
      "--output",
      output,
      "--spp",
      "1",
    );
    assert.equal(status, 2);
    assert.match(stderr, /no such file/);
    assert.ok(!existsSync(output));
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test("an image has its channels in the order of their names, row by row from the top", () => {
  const pixels = Float32Array.from([1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 10, 11, 12, 0]);
  const bytes = exrBytes(2, 2, pixels, { "orbs.spp": "5" });
  assert.equal(bytes.readInt32LE(0), 20000630);
  assert.ok(bytes.includes("orbs.spp\0string\0\x01\0\0\x005"));
  const row = (y) => {
    const place = Number(bytes.readBigInt64LE(bytes.length - 2 * 32 - 16 + 8 * y));
    assert.deepEqual([bytes.readInt32LE(place), bytes.readInt32LE(place + 4)], [y, 24]);
    return Array.from({ length: 6 }, (_, i) => bytes.readFloatLE(place + 8 + 4 * i));
  };
  assert.deepEqual(row(0), [3, 6, 2, 5, 1, 4]);
  assert.deepEqual(row(1), [9, 12, 8, 11, 7, 10]);
});

test("an image of another size than its numbers is refused", () => {
  assert.throws(() => exrBytes(2, 2, new Float32Array(12)), /2 x 2 pixels has 12 numbers/);
});
