// Links name their run, so that they show the same later; and the comparison of two runs.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { changeOverview, open } from "./browser";
import { report } from "./runs";
import { startSession } from "./session";

const session = startSession("small", "before");

const linksOf = (page: Page): Promise<string[]> =>
  page
    .locator("a[href^='#/']")
    .evaluateAll((links) => links.map((link) => link.getAttribute("href") ?? ""));

test("if there are several runs each link names its run", async () => {
  const { page, errors } = await open(session.browser, session.url);
  await page.waitForFunction(() => location.hash === "#/?run=small");
  await page.locator(".cell a").first().waitFor();
  for (const link of await linksOf(page)) assert.match(link, /[?&]run=small/);
  await page.keyboard.press("t");
  await page.waitForFunction(() => location.hash === "#/charts?run=small");
  await page.goto(`${session.url}#/compare`);
  await page.locator(".compare td a").first().waitFor();
  await page.waitForFunction(
    () => location.hash.includes("before=before") && location.hash.includes("after=small"),
  );
  const links = await linksOf(page);
  assert.ok(
    links.every((link) => /[?&]run=(small|before)/.test(link)),
    links.join(" "),
  );
  assert.ok(links.some((link) => link.includes("run=before")));
  assert.deepEqual(errors, []);
  await page.close();
});

test("naming the run adds no step to the history", async () => {
  const { page } = await open(session.browser, "about:blank");
  await page.goto(session.url);
  await page.waitForFunction(() => location.hash === "#/?run=small");
  await page.getByRole("link", { name: "Compare" }).click();
  await page.waitForFunction(() => location.hash.includes("before=before"));
  await page.goBack();
  await page.locator(".grid").waitFor();
  await page.goBack();
  assert.equal(page.url(), "about:blank");
  await page.close();
});

test("a run that does not exist is not replaced by another one", async () => {
  const { page, errors } = await open(
    session.browser,
    `${session.url}#/charts?run=yesterday&of=cpu_seconds`,
  );
  const alert = page.getByRole("alert");
  await alert.getByText("There is no run 'yesterday' here. There are:").waitFor();
  assert.deepEqual(await alert.getByRole("link").allInnerTexts(), ["small", "before"]);
  await alert.getByRole("link", { name: "before" }).click();
  await page.locator(".plot canvas").first().waitFor();
  assert.match(page.url(), /#\/charts\?run=before&of=cpu_seconds$/);
  await page.goto(`${session.url}#/compare?before=yesterday&after=before`);
  await alert.getByText("There is no run 'yesterday' here.").waitFor();
  await alert.getByRole("link", { name: "small" }).click();
  await page.locator("section[data-kind=new]").waitFor();
  assert.match(page.url(), /before=small&after=before/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a page of one run has short links and no other run", async () => {
  const file = join(session.scratch.folder, "page.html");
  report(join(session.scratch.folder, "small"), file);
  const { page } = await open(session.browser, `file://${file}`);
  await page.locator(".cell a").first().waitFor();
  for (const link of await linksOf(page)) assert.ok(!link.includes("run="), link);
  assert.ok(!page.url().includes("run="));
  await page.goto(`file://${file}#/?run=yesterday`);
  await page.getByText("There is no run 'yesterday' here. There is:").waitFor();
  await page.close();
});

test("the page says why a run cannot be compared", async () => {
  const { page } = await open(session.browser, "about:blank");
  await page.route("**/data/1/overview.json", (route) =>
    route.fulfill({ status: 500, body: "the disk is gone" }),
  );
  await page.goto(`${session.url}#/compare`);
  await page.getByText("The run before cannot be shown: the disk is gone").waitFor();
  await page.close();
});

test("targets that were not rendered are neither better nor worse", async () => {
  const { page } = await open(session.browser, "about:blank");
  await changeOverview(
    page,
    ({ cells, states }) => {
      ["waiting", "running", "skipped"].forEach(
        (name, i) => (cells["state"]![i] = states.findIndex((state) => state.name === name)),
      );
    },
    0,
  );
  await page.goto(`${session.url}#/compare`);
  const rows = page.locator("section[data-kind=open] tbody tr");
  await rows.first().waitFor();
  // One target was skipped in both runs.
  assert.deepEqual(
    (await rows.allInnerTexts()).map((text) => /waiting|running|skipped/.exec(text)?.[0]).sort(),
    ["running", "skipped", "skipped", "waiting"],
  );
  for (const text of await page
    .locator("section[data-kind=worse], section[data-kind=better]")
    .allInnerTexts())
    assert.doesNotMatch(text, /waiting|running|skipped/);
  await page.close();
});
