// What the comparison of two runs says of a target, without a browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import { changesOf, type Kind } from "../../web/src/compare/changes";
import { kindsOfNumbers, type RunComparison } from "../../web/src/compare/statistics";
import type { Overview } from "../../web/src/data/generated";

const kStates = [
  "pass",
  "pass with remarks",
  "unsupported",
  "inconclusive",
  "fail",
  "crash",
  "known",
  "unexpected pass",
];

/** A run of one target, in this state and with this error of its mean. */
const runOf = (state: string, light: number, preliminary = [0]): Overview =>
  ({
    cases: [{ name: "m1" }],
    targets: ["101"],
    renderers: [{ name: "r" }],
    states: kStates.map((name) => ({ name, failure: false })),
    metrics: [{ name: "mean_ratio_r", lower_is_better: true, signed: true }],
    measures: { mean_ratio_r: [light] },
    infinite: {},
    cells: { case: [0], target: [0], renderer: [0], state: [kStates.indexOf(state)], preliminary },
  }) as unknown as Overview;

const kindOf = (
  before: Overview,
  after: Overview,
  kinds = kindsOfNumbers(undefined),
): Kind | undefined =>
  changesOf({ overview: before, renderer: "" }, { overview: after, renderer: "" }, kinds)[0]?.kind;

const kindOfStates = (before: string, after: string) => kindOf(runOf(before, 0), runOf(after, 0));

test("a pass that is a known failure now is worse, and so is a known failure that is none", () => {
  assert.equal(kindOfStates("pass", "known"), "worse");
  assert.equal(kindOfStates("unexpected pass", "known"), "worse");
  assert.equal(kindOfStates("known", "fail"), "worse");
  assert.equal(kindOfStates("fail", "unsupported"), "worse");
  assert.equal(kindOfStates("fail", "crash"), "worse");
  assert.equal(kindOfStates("crash", "known"), "changed");
  assert.equal(kindOfStates("pass", "inconclusive"), "changed");
  assert.equal(kindOfStates("pass", "unexpected pass"), "changed");
  assert.equal(kindOfStates("known", "unexpected pass"), "better");
  assert.equal(kindOfStates("crash", "fail"), "better");
  assert.equal(kindOfStates("pass", "pass with remarks"), "worse");
  assert.equal(kindOfStates("pass with remarks", "pass"), "better");
  assert.equal(kindOfStates("pass with remarks", "inconclusive"), "changed");
  assert.equal(kindOfStates("pass with remarks", "fail"), "worse");
});

test("where the verdict stays, a test against noise says what the numbers did", () => {
  const comparison = {
    changes: [
      { direction: "worse", quantity: "light", renderer: "r", target: "101" },
      { direction: "better", quantity: "error", renderer: "r", target: "101" },
      { direction: "better", quantity: "time", renderer: "r", target: "102" },
    ],
  } as unknown as RunComparison;
  const kinds = kindsOfNumbers(comparison);
  assert.equal(kinds("r", "101"), "worse");
  assert.equal(kinds("r", "102"), "same");
  assert.equal(kindOf(runOf("fail", 0.051), runOf("fail", 0.049), kinds), "worse");
  assert.equal(kindOf(runOf("fail", 0.051), runOf("fail", 0.9)), "same");
  assert.equal(kindOf(runOf("fail", 0.051), runOf("pass", 0.049), kinds), "better");
});

test("a preliminary verdict is compared with nothing", () => {
  assert.equal(kindOf(runOf("pass", 0), runOf("inconclusive", 0)), "changed");
  assert.equal(kindOf(runOf("pass", 0), runOf("inconclusive", 0, [1])), "open");
  assert.equal(kindOf(runOf("inconclusive", 0, [1]), runOf("pass", 0)), "open");
});
