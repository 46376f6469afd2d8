// Many clients at once, by hand:  node load.mjs <build folder> [seconds = 30] [clients = 200]
// Each client asks for the page, the overview, an image and its pixels again and again. Ends with status 1 when an
// answer is wrong or late, or when the server holds more memory at the end than after its first seconds.
import { spawn, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { Agent, get } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [build, seconds = "30", clients = "200"] = process.argv.slice(2);
const kLate_ms = 10000;
const kGrowth_MB = 16;
const folder = mkdtempSync(join(tmpdir(), "orbs-load-"));
spawnSync(join(build, "orbs-page-fixture"), ["small", join(folder, "run")], { stdio: "inherit" });
const server = spawn(join(build, "orbs"), ["serve", join(folder, "run")]);
const url = await new Promise((resolve) =>
  server.stdout.once("data", (text) => resolve(/http:\S+\//.exec(text)[0])),
);
const memory_MB = () =>
  Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${server.pid}/status`, "utf8"))[1]) / 1024;

const paths = [
  "",
  "data/runs.json",
  "data/0/overview.json",
  "data/0/target/0.json",
  "data/0/image/one/values/result.exr",
  "data/0/file/one/values/result.png",
];
const agent = new Agent({ keepAlive: false });
const ask = (path) =>
  new Promise((resolve) => {
    const begin = performance.now();
    const request = get(url + path, { agent, timeout: kLate_ms }, (answer) => {
      let bytes = 0;
      answer.on("data", (piece) => (bytes += piece.length));
      answer.on("end", () =>
        resolve({ ok: answer.statusCode === 200 && bytes > 0, time: performance.now() - begin }),
      );
      answer.on("error", () => resolve({ ok: false }));
    });
    request.on("timeout", () => request.destroy());
    request.on("error", (error) => resolve({ ok: false, error: error.message }));
  });

const end = performance.now() + 1000 * Number(seconds);
let done = 0;
const failures = [];
let slowest = 0;
async function client(number) {
  for (let i = number; performance.now() < end; ++i) {
    const answer = await ask(paths[i % paths.length]);
    ++done;
    if (!answer.ok) failures.push(`${paths[i % paths.length]}: ${answer.error ?? "wrong answer"}`);
    else slowest = Math.max(slowest, answer.time);
  }
}
let warm_MB = 0;
setTimeout(() => (warm_MB = memory_MB()), 200 * Number(seconds));
await Promise.all(Array.from({ length: Number(clients) }, (_, number) => client(number)));
const last_MB = memory_MB();
server.kill("SIGTERM");
rmSync(folder, { recursive: true, force: true });
console.log(
  `${clients} clients, ${seconds} s: ${done} answers (${Math.round(done / Number(seconds))}/s), ${failures.length} failures, ` +
    `slowest ${Math.round(slowest)} ms, memory ${warm_MB.toFixed(1)} MB after a fifth of the time, ${last_MB.toFixed(1)} MB at the end`,
);
for (const failure of failures.slice(0, 10)) console.log(`  ${failure}`);
process.exit(failures.length > 0 || last_MB > warm_MB + kGrowth_MB ? 1 : 0);
