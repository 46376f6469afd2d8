import { useEffect, useMemo } from "preact/hooks";
import { useAnswer, type Answer } from "../common/answer";
import { number } from "../common/format";
import { NoSuchRun } from "../common/NoSuchRun";
import { runNamed, runQuery, type Session } from "../common/session";
import { StateMark } from "../common/StateMark";
import type { Overview } from "../data/types";
import { cellLink } from "../overview/Grid";
import { note, type Route } from "../route";
import { changesOf, stateOf, valueOf, type Change, type Kind, type Side } from "./changes";
import { timesOf, timeSummary } from "./times";

const kHeadings: Record<Kind, string> = {
  worse: "Became worse",
  better: "Became better",
  open: "Not rendered (yet) before or after",
  new: "New",
  gone: "Gone",
  same: "As before",
};
const kMostRows = 500; // of one heading

function useOverview(session: Session, run: number): Answer<Overview> {
  const own = run === session.run;
  const answer = useAnswer(
    String(run),
    own,
    own || run < 0 ? undefined : () => session.source.overview(run),
  );
  return own ? { value: session.overview } : answer;
}

function SideChoice({
  label,
  session,
  run,
  renderer,
  overview,
  runParam,
  rendererParam,
}: {
  label: string;
  session: Session;
  run: number;
  renderer: string;
  overview: Overview | undefined;
  runParam: string;
  rendererParam: string;
}) {
  return (
    <span>
      <b>{label}</b>{" "}
      {session.source.runs.length > 1 ? (
        <select
          aria-label={`${label}: run`}
          value={session.source.runs[run]}
          onChange={(e) => note({ [runParam]: e.currentTarget.value })}
        >
          {session.source.runs.map((name) => (
            <option key={name}>{name}</option>
          ))}
        </select>
      ) : null}{" "}
      <select
        aria-label={`${label}: renderer`}
        value={renderer}
        onChange={(e) => note({ [rendererParam]: e.currentTarget.value })}
      >
        <option value="">all renderers</option>
        {overview?.renderers.map(({ name }) => (
          <option key={name}>{name}</option>
        ))}
      </select>
    </span>
  );
}

function Cell({
  overview,
  cell,
  metric,
  link,
}: {
  overview: Overview;
  cell: number;
  metric: string;
  link: string;
}) {
  if (cell < 0) return <td class="quiet">–</td>;
  const value = valueOf(overview, metric, cell);
  return (
    <td>
      <a href={link}>
        <StateMark state={stateOf(overview, cell)} />
      </a>{" "}
      <span class="quiet">{value === undefined ? "" : number(value, value === Infinity)}</span>
    </td>
  );
}

const kApart = "times are of different machines";
const apartText = ([before, after]: [string, string]): string =>
  `${before || "unknown"} before, ${after || "unknown"} after`;

function TimeCell({ a, b, change }: { a: Overview; b: Overview; change: Change }) {
  const times = timesOf(a, change.before, b, change.after);
  if (!times) return <td class="quiet number">–</td>;
  if ("ratio" in times) return <td class="number">× {number(times.ratio)}</td>;
  return (
    <td class="quiet number" title={apartText(times.machines)}>
      {kApart}
    </td>
  );
}

/** What became of the time, where that can be said. */
function TimeLine({ a, b, changes }: { a: Overview; b: Overview; changes: Change[] }) {
  const { ratio, targets, apart, machines } = timeSummary(a, b, changes);
  const loads = `load at the start ${a.run.load.toFixed(2)} before, ${b.run.load.toFixed(2)} after`;
  return (
    <p class="compare-time quiet">
      {targets > 0 ? (
        <span>
          Wall clock × {number(ratio)}, the geometric mean of {targets} targets; {loads}.{" "}
        </span>
      ) : null}
      {machines ? (
        <span>
          Not compared for {apart} targets: {kApart} ({apartText(machines)}).
        </span>
      ) : null}
    </p>
  );
}

function Changes({
  kind,
  changes,
  a,
  b,
  metric,
  links,
}: {
  kind: Kind;
  changes: Change[];
  a: Side;
  b: Side;
  metric: string;
  links: { a: (cell: number) => string; b: (cell: number) => string };
}) {
  if (changes.length === 0) return null;
  return (
    <section data-kind={kind}>
      <details open={kind !== "same"}>
        <summary>
          <h2 style={{ display: "inline" }}>
            {kHeadings[kind]} <span class="count">{changes.length}</span>
          </h2>
        </summary>
        <table>
          <thead>
            <tr>
              <th scope="col">Case</th>
              <th scope="col">Target</th>
              <th scope="col">Renderer</th>
              <th scope="col">Before</th>
              <th scope="col">After</th>
              <th scope="col" class="number" title="wall clock, after over before">
                Time
              </th>
            </tr>
          </thead>
          <tbody>
            {changes.slice(0, kMostRows).map((change) => (
              <tr key={`${change.names.case} ${change.names.target} ${change.names.renderer}`}>
                <th scope="row">{change.names.case}</th>
                <td>{change.names.target}</td>
                <td>
                  {a.renderer && b.renderer
                    ? `${a.renderer} → ${b.renderer}`
                    : change.names.renderer}
                </td>
                <Cell
                  overview={a.overview}
                  cell={change.before}
                  metric={metric}
                  link={links.a(change.before)}
                />
                <Cell
                  overview={b.overview}
                  cell={change.after}
                  metric={metric}
                  link={links.b(change.after)}
                />
                <TimeCell a={a.overview} b={b.overview} change={change} />
              </tr>
            ))}
          </tbody>
        </table>
        {changes.length > kMostRows ? (
          <p class="quiet">… and {changes.length - kMostRows} more.</p>
        ) : null}
      </details>
    </section>
  );
}

/** Two runs, or two renderers: what is better, worse, new and gone. */
export function ComparePage({ session, route }: { session: Session; route: Route }) {
  const { source } = session;
  // The newest run stands first, so the one before it is the next.
  const runA = runNamed(source, route.query["before"], Math.min(1, source.runs.length - 1));
  const runB = runNamed(source, route.query["after"], 0);
  useEffect(() => {
    if (source.runs.length > 1 && (!route.query["before"] || !route.query["after"]))
      note({ ...runQuery(source, runA, "before"), ...runQuery(source, runB, "after") });
  }, [route]);
  const [answerA, answerB] = [useOverview(session, runA), useOverview(session, runB)];
  const [overviewA, overviewB] = [answerA.value, answerB.value];
  const oneRun = source.runs.length < 2;
  const usual = (i: number): string =>
    oneRun && session.overview.renderers.length > 1
      ? (session.overview.renderers[i]?.name ?? "")
      : "";
  const rendererA = route.query["ra"] ?? usual(1);
  const rendererB = route.query["rb"] ?? usual(0);
  const metric = route.query["metric"] || session.overview.main_metric;
  const changes = useMemo(
    () =>
      overviewA &&
      overviewB &&
      changesOf(
        { overview: overviewA, renderer: rendererA },
        { overview: overviewB, renderer: rendererB },
        metric,
      ),
    [overviewA, overviewB, rendererA, rendererB, metric],
  );
  const link =
    (run: number, overview: Overview | undefined) =>
    (cell: number): string =>
      overview && cell >= 0 ? cellLink({ ...session, run, overview }, cell) : "";
  return (
    <div class="compare">
      <h1 class="unseen">Compare</h1>
      <div class="compare-choices">
        <SideChoice
          label="Before"
          session={session}
          run={runA}
          renderer={rendererA}
          overview={overviewA}
          runParam="before"
          rendererParam="ra"
        />
        <SideChoice
          label="After"
          session={session}
          run={runB}
          renderer={rendererB}
          overview={overviewB}
          runParam="after"
          rendererParam="rb"
        />
        <label>
          by{" "}
          <select value={metric} onChange={(e) => note({ metric: e.currentTarget.value })}>
            {session.overview.metrics.map(({ name }) => (
              <option key={name}>{name}</option>
            ))}
          </select>
        </label>
      </div>
      {changes && overviewA && overviewB ? (
        <TimeLine a={overviewA} b={overviewB} changes={changes} />
      ) : null}
      {runA < 0 ? <NoSuchRun source={source} route={route} param="before" /> : null}
      {runB < 0 ? <NoSuchRun source={source} route={route} param="after" /> : null}
      {[[runA, answerA.problem] as const, [runB, answerB.problem] as const].map(([run, problem]) =>
        problem === undefined ? null : (
          <p role="alert" key={run}>
            The run {source.runs[run]} cannot be shown: {problem}
          </p>
        ),
      )}
      {!changes || !overviewA || !overviewB ? (
        runA >= 0 && runB >= 0 && answerA.problem === undefined && answerB.problem === undefined ? (
          <p class="loading">Reading …</p>
        ) : null
      ) : (
        (Object.keys(kHeadings) as Kind[]).map((kind) => (
          <Changes
            key={kind}
            kind={kind}
            changes={changes.filter((one) => one.kind === kind)}
            metric={metric}
            a={{ overview: overviewA, renderer: rendererA }}
            b={{ overview: overviewB, renderer: rendererB }}
            links={{ a: link(runA, overviewA), b: link(runB, overviewB) }}
          />
        ))
      )}
    </div>
  );
}
