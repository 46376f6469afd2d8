import { Scroll } from "../common/Scroll";
import { useRequest } from "../common/request";
import { seconds } from "../common/format";
import type { CostChanges, CostStudy, Interval, MeanChange } from "../data/generated";
import type { Source } from "../data/source";
import { note, routeText, type Route } from "../route";
import { levelText, ratioText } from "./quantities";

interface Props {
  source: Source;
  run: number;
  study: CostStudy;
  route: Route;
  metric: string;
  level: number | undefined;
}

const kMostScenes = 12;

function tone(ratio: Interval, isChanged: boolean): string {
  if (!isChanged) return "quiet";
  return (ratio.value ?? 1) > 1 ? "tone-bad" : "tone-good";
}

/** "The tracer now takes 0.93 times the CPU time": the sentence of one renderer. */
function sentence({ renderer, time_ratio: ratio, changed }: MeanChange): string {
  if (!changed) return `no change of ${renderer} is shown`;
  const factor = Number((ratio.value ?? 1).toPrecision(3));
  return `${renderer} takes ${factor} times the time`;
}

function versionText(changes: CostChanges, name: string): string {
  const found = changes.renderers.find((one) => one.name === name);
  if (!found) return "";
  if (found.unchanged) return `${found.version_after} in both`;
  return `${found.version_before || "?"} → ${found.version_after || "?"}`;
}

/** The factor of each renderer over all targets. */
function Means({ changes, means }: { changes: CostChanges; means: MeanChange[] }) {
  return (
    <Scroll label="Factors">
      <table>
        <thead>
          <tr>
            <th scope="col">Renderer</th>
            <th scope="col">CPU time, after / before</th>
            <th scope="col">Over programs that did not change</th>
            <th scope="col" class="number">
              Targets
            </th>
            <th scope="col">Version</th>
          </tr>
        </thead>
        <tbody>
          {means.map((mean) => (
            <tr key={mean.renderer}>
              <th scope="row">{mean.renderer}</th>
              <td class={tone(mean.time_ratio, mean.changed)}>
                {ratioText(mean.time_ratio)}
                {mean.changed ? "" : ", no change shown"}
              </td>
              <td>{mean.ratio_to_unchanged ? ratioText(mean.ratio_to_unchanged) : "–"}</td>
              <td class="number">{mean.scenes}</td>
              <td>{versionText(changes, mean.renderer)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </Scroll>
  );
}

/** The targets whose times changed beyond chance, the most changed first. */
function Scenes({
  changes,
  metric,
  level,
  route,
}: Pick<Props, "route" | "metric"> & {
  changes: CostChanges;
  level: number;
}) {
  const own = changes.scenes.filter((one) => one.metric === metric && one.level === level);
  const changed = own.filter((one) => one.changed);
  return (
    <>
      {changed.length > 0 ? (
        <Scroll label="Targets that changed">
          <table>
            <thead>
              <tr>
                <th scope="col">Target that changed</th>
                <th scope="col">Renderer</th>
                <th scope="col">Before</th>
                <th scope="col">After</th>
                <th scope="col">After / before</th>
              </tr>
            </thead>
            <tbody>
              {changed
                .slice(0, kMostScenes)
                .map(({ target, renderer, before, after, time_ratio }) => (
                  <tr key={`${target} ${renderer}`}>
                    <th scope="row">
                      <a
                        href={routeText({
                          path: route.path,
                          query: { ...route.query, target, point: "" },
                        })}
                      >
                        {target}
                      </a>
                    </th>
                    <td>{renderer}</td>
                    <td class="number">{seconds(before.value ?? 0)}</td>
                    <td class="number">{seconds(after.value ?? 0)}</td>
                    <td class={tone(time_ratio, true)}>{ratioText(time_ratio)}</td>
                  </tr>
                ))}
            </tbody>
          </table>
        </Scroll>
      ) : null}
      <p class="quiet">
        {changed.length} of {own.length} times of single targets changed beyond chance
        {changed.length > kMostScenes ? `, of which the first ${kMostScenes} are shown` : ""}. Of
        equal programs on an equal machine 1 comparison in 100 calls any time changed.
      </p>
    </>
  );
}

/** The study against an earlier one of the same scenes, as `orbs compare-runs` has it. */
export function Since({ source, run, study, route, metric, level: wanted }: Props) {
  const others = source.runs.flatMap((name, i) =>
    i !== run && source.kinds[i] === "cost" ? [{ name, i }] : [],
  );
  // The newest comes first, so that what follows is older.
  const usual = others.find(({ i }) => i > run) ?? others[0];
  const chosen = others.find(({ name }) => name === route.query["since"]) ?? usual;
  const { value: changes, problem } = useRequest(
    `since ${run} ${chosen?.i}`,
    study.renders?.length ?? 0,
    chosen ? () => source.costChanges(chosen.i, run) : undefined,
  );
  if (!chosen) return null;
  const level = wanted ?? changes?.main_level ?? 0;
  const means = changes?.means.filter((one) => one.metric === metric && one.level === level) ?? [];
  return (
    <section class="cost-panel since" aria-label="Since the earlier study">
      <div class="panel-head">
        <h2>What changed since</h2>
        <select
          aria-label="Earlier study"
          value={chosen.name}
          onChange={(event) => note({ since: event.currentTarget.value })}
        >
          {others.map(({ name }) => (
            <option key={name}>{name}</option>
          ))}
        </select>
      </div>
      {problem === undefined ? null : <p class="quiet">They cannot be compared: {problem}.</p>}
      {changes && means.length > 0 ? (
        <>
          <p class="since-answer">
            At {levelText(study, metric, level)}: {means.map(sentence).join("; ")}.
          </p>
          <Means changes={changes} means={means} />
          <Scenes {...{ changes, metric, level, route }} />
        </>
      ) : null}
      {changes && means.length === 0 ? (
        <p class="quiet">No renderer reaches {levelText(study, metric, level)} in both.</p>
      ) : null}
      <ul>
        {changes?.notes.map((text) => (
          <li key={text} class="quiet">
            {text}
          </li>
        ))}
      </ul>
    </section>
  );
}
