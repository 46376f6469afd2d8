// The front page's report cards, what else is known of a target, and how the page compares two runs.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { open } from "./browser";
import { report } from "./runs";
import { startSession } from "./session";

const session = startSession("small", "before", "cost", "stability");

test("each renderer has a card that says first whether it is right", async () => {
  const { page, errors } = await open(session.browser, `${session.url}#/?run=small`);
  const cards = page.locator("table.cards tr.card");
  await cards.first().waitFor();
  const texts = await cards.allInnerTexts();
  assert.match(texts[0] ?? "", /^one/);
  assert.match(texts[0] ?? "", /✗ \w.* of \d+ targets/s);
  // Of what is wrong each target is a link.
  const link = page.locator(".troubles a").first();
  const target = await link.innerText();
  await link.click();
  await page.locator("article.case").waitFor();
  assert.ok(decodeURIComponent(page.url()).includes(`/${target}/`), page.url());
  assert.deepEqual(errors, []);
  await page.close();
});

test("a card takes its cost from the study beside the run, and links to it", async () => {
  const { page, errors } = await open(session.browser, "about:blank");
  await page.route("**/cost.json", async (route) => {
    const study = (await (await route.fetch()).json()) as {
      suite: string;
      renderers: { name: string }[];
    };
    study.suite = "orbs";
    study.renderers[0]!.name = "one";
    await route.fulfill({ json: study });
  });
  await page.route("**/overview.json", async (route) => {
    const overview = (await (await route.fetch()).json()) as { run: { suite: string } };
    overview.run.suite = "orbs";
    await route.fulfill({ json: overview });
  });
  await page.goto(`${session.url}#/?run=small`);
  const said = page.locator("tr.card").first().locator(".said-by a").first();
  await said.waitFor();
  assert.equal(await said.innerText(), "cost");
  await said.click();
  await page.locator(".cost-plot svg").first().waitFor();
  assert.match(page.url(), /run=cost/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a target shows its verdicts in other runs", async () => {
  const { page, errors } = await open(
    session.browser,
    `${session.url}#/case/m1_values/values/one?run=small`,
  );
  const other = page.locator(".related .earlier a");
  await other.first().waitFor();
  assert.deepEqual(await other.allInnerTexts(), ["before"]);
  await other.first().click();
  await page.waitForFunction(() => /case\/m1_values\/values\/one\?run=before/.test(location.hash));
  assert.deepEqual(errors, []);
  await page.close();
});

test("the one file has the cards, and says where the rest is", async () => {
  const file = join(session.scratch.folder, "cards.html");
  report(session.folder, file);
  const { page, errors } = await open(session.browser, `file://${file}`);
  await page.locator("tr.card .card-sentence").first().waitFor();
  await page.goto(`file://${file}#/case/m1_values/values/one`);
  await page.getByText("This page holds the run alone").waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});

test("numbers are compared by tests, and runs of other suites not at all", async () => {
  const { page, errors } = await open(session.browser, `${session.url}#/compare?run=small`);
  await page.getByRole("region", { name: "Numbers beyond chance" }).waitFor();
  assert.deepEqual(errors, []);
  await page.route("**/data/1/overview.json", async (route) => {
    const overview = (await (await route.fetch()).json()) as { run: { size: string } };
    overview.run.size = "1/8";
    await route.fulfill({ json: overview });
  });
  await page.goto("about:blank");
  await page.goto(`${session.url}#/compare?run=small&before=before&after=small`);
  await page.getByText("only runs of the same suite and size can be compared").waitFor();
  assert.equal(await page.locator("section[data-kind]").count(), 0);
  await page.close();
});

test("an address without a view says so and shows the overview", async () => {
  const { page } = await open(session.browser, `${session.url}#/nothing?run=small`);
  await page.getByText("The page has no view 'nothing'").waitFor();
  await page.locator("table.cards").waitFor();
  await page.close();
});
