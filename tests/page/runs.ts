// The runs that the tests show: made by orbs-page-fixture, served or reported by orbs.
import { spawn, spawnSync, type ChildProcess } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import type { Socket } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";

const build = process.env["ORBS_BINARY_DIR"] ?? "";

/** A temporary folder for the runs of a test file. */
export class Scratch {
  readonly folder = mkdtempSync(join(tmpdir(), "orbs-page-"));
  run(kind: string): string {
    const folder = join(this.folder, kind);
    const made = spawnSync(join(build, "orbs-page-fixture"), [kind, folder]);
    if (made.status !== 0) throw new Error(`orbs-page-fixture ${kind}: ${made.stderr}`);
    return folder;
  }
  remove(): void {
    rmSync(this.folder, { recursive: true, force: true });
  }
}

// A test that fails does not stop its server, so that Node must kill it instead of waiting for it.
const children: ChildProcess[] = [];
process.on("exit", () => children.forEach((child) => child.kill("SIGKILL")));

/** Starts a program of the build and waits for the first line of its output. */
async function startChild(
  program: string,
  args: string[],
  stdin: "pipe" | "ignore",
): Promise<{ child: ChildProcess; line: string }> {
  const child = spawn(join(build, program), args, { stdio: [stdin, "pipe", "inherit"] });
  children.push(child);
  const line = await firstLine(child);
  child.unref();
  for (const pipe of [child.stdin, child.stdout]) (pipe as Socket | null)?.unref();
  return { child, line };
}

function firstLine(process: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    let text = "";
    process.stdout?.on("data", (bytes: Buffer) => {
      text += bytes.toString();
      if (text.includes("\n")) resolve(text.slice(0, text.indexOf("\n")));
    });
    process.on("exit", (code) => reject(new Error(`ended with ${code}: ${text}`)));
  });
}

export interface Served {
  url: string;
  process: ChildProcess;
}

export async function serve(...runs: string[]): Promise<Served> {
  const { child, line } = await startChild("orbs", ["serve", ...runs], "ignore");
  return { url: /http:\S+\//.exec(line)?.[0] ?? "", process: child };
}

/** A server whose page may write to this configuration; the address holds the token. */
export async function serveToEdit(configuration: string, ...runs: string[]): Promise<Served> {
  const args = ["serve", "--edit", "--configuration", configuration, ...runs];
  const { child, line } = await startChild("orbs", args, "ignore");
  return { url: /http:\S+/.exec(line)?.[0] ?? "", process: child };
}

/** A live run; each line on its stdin completes a render, or is a look at one. */
export async function playLive(
  folder: string,
  kind: "live" | "live-looks" = "live",
): Promise<ChildProcess> {
  return (await startChild("orbs-page-fixture", [kind, folder], "pipe")).child;
}

/** What the command prints. */
export function output(...command: string[]): string {
  const made = spawnSync(join(build, "orbs"), command, { encoding: "utf8" });
  if (made.status !== 0) throw new Error(`orbs ${command.join(" ")}: ${made.stderr}`);
  return made.stdout;
}

export function report(run: string, file: string): void {
  output("report", run, "-o", file, "--exact");
}
