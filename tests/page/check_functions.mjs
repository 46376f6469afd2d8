// Checks that no function of the page or of its tests has more than 60 lines between its braces, as
// clang-tidy does for C++:
//   node check_functions.mjs <source folder>
// TypeScript calls its programming interface unstable; web/package-lock.json pins its version.
import { existsSync } from "node:fs";
import { join, relative, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const kMostLines = 60;
const source = resolve(process.argv[2]);
const typescript = join(source, "web/node_modules/typescript/dist");
if (!existsSync(typescript)) {
  console.error(`${typescript} is missing: building the target orbs-page installs it.`);
  process.exit(1);
}
const { API } = await import(pathToFileURL(join(typescript, "api/sync/api.js")));

/** Lines on which the body of a function begins and ends, counted from 1. */
function linesOf(body, file) {
  const lineAt = (position) => file.text.slice(0, position).split("\n").length;
  return { first: lineAt(body.getStart(file)), last: lineAt(body.end) };
}

const nameOf = (node) => (node.name ?? node.parent?.name)?.getText?.() ?? "an unnamed function";

function longFunctions(node, file, found) {
  if (node.parameters && node.body) {
    const { first, last } = linesOf(node.body, file);
    const count = last - first - 1; // the lines between its braces
    if (count > kMostLines)
      found.push(
        `${relative(source, file.fileName)}:${first}: ${nameOf(node)} has ${count} lines; ` +
          `at most ${kMostLines} are allowed: split it by idea`,
      );
  }
  node.forEachChild((child) => longFunctions(child, file, found));
}

const found = [];
let files = 0;
const api = new API({ cwd: source });
for (const project of ["web/tsconfig.json", "tests/page/tsconfig.json"]) {
  const path = join(source, project);
  const { program } = api.updateSnapshot({ openProject: path }).getProject(path);
  for (const name of program.getSourceFileNames()) {
    if (name.includes("/node_modules/") || !name.startsWith(source)) continue;
    ++files;
    longFunctions(program.getSourceFile(name), program.getSourceFile(name), found);
  }
}
api.close();
if (files === 0) found.push("no source file was found: the tsconfig.json files list none");
for (const line of [...new Set(found)].sort()) console.error(line);
process.exit(found.length > 0 ? 1 : 0);
