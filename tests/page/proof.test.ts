// Which images show a diagnosis to the eye, without a browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { ImageEntry } from "../../web/src/data/source";
import { pairOf } from "../../web/src/viewer/use_front";
import { kDefaultView } from "../../web/src/viewer/view_state";

const image = (name: string, kind: string): ImageEntry => ({ name, kind, file: `${name}.exr` });
const images = [image("result", "result"), image("reference", "reference")];
const side = { ...kDefaultView, mode: "side" as const };

test("side by side, what is left once the fault is undone is the difference", () => {
  const all = [...images, image("fault undone", "proof")];
  assert.deepEqual(pairOf(all, side), { a: "fault undone", b: "reference" });
  assert.deepEqual(pairOf(all, kDefaultView), { a: "result", b: "reference" });
  assert.deepEqual(pairOf(images, side), { a: "result", b: "reference" });
});

test("a fault that cannot be undone is shown in the reference", () => {
  const all = [...images, image("reference with fault", "proof")];
  assert.deepEqual(pairOf(all, side), { a: "result", b: "reference with fault" });
});

test("images that the address names come before the proof", () => {
  const all = [...images, image("other", "other"), image("fault undone", "proof")];
  assert.deepEqual(pairOf(all, { ...side, a: "other" }), { a: "other", b: "reference" });
});
