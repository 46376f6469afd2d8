import { number, seconds } from "../common/format";
import { PairList } from "../common/PairList";
import { metricName, ratioText } from "./quantities";
import type { CostRenderer, CostStudy } from "../data/generated";

function selfText(study: CostStudy): string {
  const self = study.self_comparison;
  if (!self) return "not made";
  const single = self.scenes.length === 1 ? study.targets[self.scenes[0]?.target ?? 0]?.name : null;
  const what = `${study.renderers[self.renderer]?.name} on ${single ?? `${self.scenes.length} targets`}`;
  const ratios = `time ${ratioText(self.time_ratio)}, error ${ratioText(self.error_ratio)}`;
  const percent = (scatter: number | null): string => `${(100 * (scatter ?? 0)).toFixed(1)} %`;
  const scatter =
    single == null
      ? `; the targets scatter by ${percent(self.time_scatter)} in time and ` +
        `${percent(self.error_scatter)} in error, and ${self.differing} of them differ alone`
      : "";
  const found = self.passed
    ? "no difference shown"
    : self.known
      ? "a difference was found"
      : "too uncertain to show anything: more seeds are needed";
  return `${found}: ${what}, ${ratios}${scatter}.`;
}

function otherLoadText({ other_load: load }: CostStudy): string {
  if (load.unknown === load.renders) return "not measured";
  const left =
    `${load.left_out} of ${load.renders} renders left out, since others took more than 5 % of the ` +
    `machine; ${load.repeats} repeats`;
  const marked = load.marked > 0 ? `; ${load.marked} count although disturbed` : "";
  return left + marked + (load.unknown > 0 ? `; not known of ${load.unknown} renders` : "");
}

// Many programs begin their version with their name.
const rendererText = ({ name, version }: CostRenderer): string =>
  version.toLowerCase().startsWith(name.toLowerCase()) ? version : `${name} ${version}`;

function rows(study: CostStudy): [string, string][] {
  const { settings, host } = study;
  const load = [study.load, study.load_end].map((one) => number(one)).join(" at the start, ");
  return [
    ["Renderers", study.renderers.map(rendererText).join("; ")],
    ["Seeds per setting", String(settings.seeds)],
    ["Threads", String(settings.threads)],
    ["Order of the renders", `by the seed ${settings.order_seed}`],
    ["Budget", seconds(settings.budget_seconds)],
    [
      "Machine",
      `${host ? `${host.name}: ${host.cpu}, ${host.cores} cores; ` : ""}load ${load} at the end`,
    ],
    ["Other work on the machine", otherLoadText(study)],
    ["A renderer compared with itself", selfText(study)],
    ...study.definitions.map(({ name, text }): [string, string] => [metricName(name), text]),
  ];
}

/** How it was measured, and what each number means. */
export function About({ study }: { study: CostStudy }) {
  return (
    <section class="cost-panel about" aria-label="How it was measured">
      <h2>How it was measured</h2>
      <PairList pairs={rows(study)} />
    </section>
  );
}
