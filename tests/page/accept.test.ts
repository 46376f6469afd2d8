// A failure becomes a known one with a click, if `orbs serve --edit` allows that; else the page shows the command.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { open } from "./browser";
import { serveToEdit, type Served } from "./runs";
import { startSession } from "./session";

const session = startSession("small");
const failing = "#/case/m1_values/values/one";

const configuration = `{
  "format": "orbs-configuration/1",
  "stands_alone": true,
  "suites": [{ "name": "alpha", "cases": "cases", "references": "references" }],
  "renderers": [
    { "name": "one", "executable": "one", "scene_format": "orbs-scene", "declares": "M8",
      "command": ["{executable}", "{scene}", "{output}"] }
  ]
}
`;

let editable: Served;
let file = "";
before(async () => {
  file = join(session.scratch.folder, "configuration.json");
  writeFileSync(file, configuration);
  editable = await serveToEdit(file, session.scratch.run("before"));
});
after(() => void editable?.process.kill("SIGTERM"));

const written = (): string => readFileSync(file, "utf8");

test("a click shows the change of the configuration, and another one writes it", async () => {
  const { page, errors } = await open(session.browser, editable.url);
  await page.locator(".cell a").first().waitFor();
  assert.ok(!page.url().includes("edit="), "the token is taken out of the address");
  await page.goto(new URL(editable.url).origin + "/" + failing);
  const form = page.locator(".accept form");
  await form.waitFor();
  const show = form.getByRole("button", { name: "Show the change" });
  assert.ok(await show.isDisabled(), "a reason is wanted");
  await form.getByLabel("Reason").fill("it's so");
  await form.getByLabel("Last day").fill("2999-12-31");
  await show.click();
  const difference = await page.locator(".accept .difference").innerText();
  for (const part of ["+++ ", '+  "expected": [', '"reason": "it\'s so"', '"until": "2999-12-31"'])
    assert.ok(difference.includes(part), difference);
  assert.equal(written(), configuration, "nothing is written yet");
  await page.getByRole("button", { name: "Write it" }).click();
  const status = await page.locator(".accept").getByRole("status").innerText();
  // Lines count from 1, and the entry begins in the one before that of its first member.
  const lines = written().split("\n");
  const line = lines.findIndex((text) => text.includes('"renderer": "one"'));
  assert.equal(status, `Written to ${file}, line ${line}. The verdict changes with the next run.`);
  assert.match(written(), /"reason": "it's so"/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a change of the file in between is noticed, and what the server refuses is shown", async () => {
  const { page } = await open(session.browser, editable.url);
  await page.locator(".cell a").first().waitFor();
  await page.goto(new URL(editable.url).origin + "/" + failing);
  const form = page.locator(".accept form");
  await form.getByLabel("Reason").fill("another");
  await form.getByRole("button", { name: "Show the change" }).click();
  await page.locator(".accept .difference").waitFor();
  const changed = written() + "\n";
  writeFileSync(file, changed);
  await page.getByRole("button", { name: "Write it" }).click();
  const alert = page.locator(".accept").getByRole("alert");
  await alert.getByText("has changed since its difference was shown").waitFor();
  assert.equal(written(), changed);
  await form.getByLabel("Last day").fill("2020-01-01");
  await form.getByRole("button", { name: "Show the change" }).click();
  await alert.getByText("2020-01-01, is over").waitFor();
  // Another target begins anew.
  await page.keyboard.press("]");
  await page.waitForFunction(() => !location.hash.includes("values/one"));
  assert.equal(await page.locator(".accept").getByRole("alert").count(), 0);
  await page.close();
});

test("a page of another server cannot write, nor this one without the token", async () => {
  const { page } = await open(session.browser, session.url);
  const address = `${new URL(editable.url).origin}/edit/known-failure`;
  const now = written();
  const outcome = await page.evaluate(
    async ([url, token]) =>
      fetch(url ?? "", {
        method: "POST",
        headers: { "Content-Type": "application/json", "Orbs-Token": token ?? "" },
        body: "{}",
      }).then(
        (answer) => String(answer.status),
        () => "failed",
      ),
    [address, editable.url.split("edit=")[1]],
  );
  assert.equal(outcome, "failed", "the browser asks first, and gets no leave");
  assert.equal(written(), now);
  await page.close();
  const other = await open(session.browser, new URL(editable.url).origin + "/" + failing);
  await other.page.locator(".accept").getByText("This tab may not write").waitFor();
  assert.equal(await other.page.locator(".accept form").count(), 0);
  await other.page.close();
});

test("without --edit the page shows the commands", async () => {
  const { page, errors } = await open(session.browser, session.url + failing);
  const section = page.locator(".accept");
  await section.waitFor();
  assert.equal(await section.locator("form").count(), 0);
  const accept = section.locator(".copyable code").first();
  assert.match(await accept.innerText(), / --accept-failures REASON$/);
  await section.getByLabel("Reason", { exact: true }).fill("it's so");
  assert.match(
    await accept.innerText(),
    /^orbs run --suite alpha --case m1_values .* --accept-failures 'it'\\''s so'$/,
  );
  await section.getByText("Replace the reference").click();
  await section.getByLabel("Reason for the new reference").fill("noise");
  assert.equal(
    await section.locator(".reference-command code").innerText(),
    "orbs reference --suite alpha --case m1_values --scene values --accept noise",
  );
  await page.goto(`${session.url}#/case/m1_values/values/two`);
  await page.getByRole("heading", { name: "Provenance" }).waitFor();
  assert.equal(await section.count(), 0, "a pass has nothing to accept");
  assert.deepEqual(errors, []);
  await page.close();
});
