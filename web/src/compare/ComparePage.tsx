import { useMemo } from "preact/hooks";
import { NoSuchRun } from "../common/NoSuchRun";
import { useRequest, type Received } from "../common/request";
import { namesOf, type Session } from "../common/session";
import type { Overview } from "../data/generated";
import { cellLink } from "../overview/Grid";
import { note, parseRoute, routeText, type Route } from "../route";
import { ChangeTable, kKinds, TimeLine, type SideNames } from "./ChangeTable";
import { changesOf, type Change } from "./changes";
import { Numbers } from "./Numbers";
import { settingsThatDiffer } from "./settings";
import { kindsOfNumbers, type RunComparison } from "./statistics";
import { useSides, type ChosenSide, type Sides } from "./use_sides";

interface SideChoiceProps {
  label: string;
  session: Session;
  side: ChosenSide;
  runParam: string;
  rendererParam: string;
}

function SideChoice({ label, session, side, runParam, rendererParam }: SideChoiceProps) {
  const { runs, kinds } = session.source;
  const comparable = runs.filter((_, i) => kinds[i] === "run");
  return (
    <span>
      <b>{label}</b>{" "}
      {comparable.length > 1 ? (
        <select
          aria-label={`${label}: run`}
          value={runs[side.run]}
          onChange={(e) => note({ [runParam]: e.currentTarget.value })}
        >
          {comparable.map((name) => (
            <option key={name}>{name}</option>
          ))}
        </select>
      ) : null}{" "}
      <select
        aria-label={`${label}: renderer`}
        value={side.renderer}
        onChange={(e) => note({ [rendererParam]: e.currentTarget.value })}
      >
        <option value="">all renderers</option>
        {side.received.value?.renderers.map(({ name }) => (
          <option key={name}>{name}</option>
        ))}
      </select>
    </span>
  );
}

interface ComparedProps {
  session: Session;
  sides: Sides;
  metric: string;
}

/** Two renderers of one run are no before and after. */
const sideNames = ({ before, after }: Sides): SideNames =>
  before.run === after.run ? { before: "A", after: "B" } : { before: "Before", after: "After" };

/** The viewer on the image after, with the image before beside it and their difference in front. */
function pairLink(
  session: Session,
  { before, after }: Sides,
  a: Overview,
  b: Overview,
  change: Change,
): string {
  const hasBoth = change.before >= 0 && change.after >= 0;
  if (!hasBoth || !a.cells.thumbnail[change.before] || !b.cells.thumbnail[change.after]) return "";
  const { renderer } = namesOf(a, change.before);
  const run = session.source.runs[before.run] ?? "";
  const other = before.run === after.run ? renderer : `${renderer}@${run}`;
  const { path, query } = parseRoute(
    cellLink({ ...session, run: after.run, overview: b }, change.after),
  );
  return routeText({ path, query: { ...query, more: other, b: other, img: "difference" } });
}

/** What the server says of the numbers of both sides. */
function useComparison({ source }: Session, { before, after }: Sides): Received<RunComparison> {
  const names: [string, string] = [before.renderer, after.renderer];
  return useRequest(
    `${before.run} ${after.run} ${names.join(" ")}`,
    "",
    before.run < 0 || after.run < 0
      ? undefined
      : () => source.comparison(before.run, after.run, names),
  );
}

/** A run after that is older than the run before. */
function Order({ a, b }: { a: Overview; b: Overview }) {
  if (a.run.started <= b.run.started) return null;
  return (
    <p class="tone-unsure">
      The run before was started later ({a.run.started.replace("T", " ")}) than the run after (
      {b.run.started.replace("T", " ")}).
    </p>
  );
}

/** The changes, once both sides are loaded. */
function Compared({ session, sides: { before, after }, metric }: ComparedProps) {
  const [a, b] = [before.received.value, after.received.value];
  const { value: comparison, problem } = useComparison(session, { before, after });
  const changes = useMemo(
    () =>
      a &&
      b &&
      changesOf(
        { overview: a, renderer: before.renderer },
        { overview: b, renderer: after.renderer },
        kindsOfNumbers(comparison),
      ),
    [a, b, before.renderer, after.renderer, comparison],
  );
  if (!a || !b || !changes) return null;
  if (a.run.suite !== b.run.suite || a.run.size !== b.run.size)
    return (
      <p role="alert">
        {session.source.runs[before.run]} is of suite {a.run.suite} at size {a.run.size},{" "}
        {session.source.runs[after.run]} of suite {b.run.suite} at size {b.run.size}: only runs of
        the same suite and size can be compared.
      </p>
    );
  const link =
    (run: number, overview: Overview) =>
    (cell: number): string =>
      cell >= 0 ? cellLink({ ...session, run, overview }, cell) : "";
  const names = sideNames({ before, after });
  const settings = settingsThatDiffer(a, b, changes);
  return (
    <>
      {settings.length > 0 ? (
        <p class="compare-settings">
          <b>Settings that differ:</b> {settings.join("; ")}.
        </p>
      ) : null}
      {before.run !== after.run ? <Order a={a} b={b} /> : null}
      {comparison ? <Numbers comparison={comparison} /> : null}
      {problem === undefined ? null : (
        <p class="quiet">Verdicts alone are compared, no numbers: {problem}.</p>
      )}
      <TimeLine a={a} b={b} changes={changes} />
      {kKinds.map((kind) => (
        <ChangeTable
          key={kind}
          kind={kind}
          changes={changes.filter((one) => one.kind === kind)}
          metric={metric}
          a={{ overview: a, renderer: before.renderer }}
          b={{ overview: b, renderer: after.renderer }}
          links={{ a: link(before.run, a), b: link(after.run, b) }}
          names={names}
          pairLink={(change) => pairLink(session, { before, after }, a, b, change)}
        />
      ))}
    </>
  );
}

/** Why a side cannot be shown, or that it is being loaded. */
function Problems({ session, route, sides }: Omit<ComparedProps, "metric"> & { route: Route }) {
  const { source } = session;
  const both = [sides.before, sides.after];
  const loading = both.some(({ received }) => !received.value);
  const failed = both.some(({ run, received }) => run < 0 || received.problem !== undefined);
  return (
    <>
      {sides.before.run < 0 ? <NoSuchRun source={source} route={route} param="before" /> : null}
      {sides.after.run < 0 ? <NoSuchRun source={source} route={route} param="after" /> : null}
      {both.map(({ run, received: { problem } }) =>
        problem === undefined ? null : (
          <p role="alert" key={run}>
            The run {source.runs[run]} cannot be shown: {problem}
          </p>
        ),
      )}
      {loading && !failed ? <p class="loading">Reading …</p> : null}
    </>
  );
}

/** Two runs, or two renderers: which targets became better, worse, new or were removed. */
export function ComparePage({ session, route }: { session: Session; route: Route }) {
  const sides = useSides(session, route);
  const metric = route.query["metric"] || session.overview.main_metric;
  return (
    <div class="compare">
      <h1 class="unseen">Compare</h1>
      <div class="compare-choices">
        <SideChoice
          label={sideNames(sides).before}
          session={session}
          side={sides.before}
          runParam="before"
          rendererParam="ra"
        />
        <SideChoice
          label={sideNames(sides).after}
          session={session}
          side={sides.after}
          runParam="after"
          rendererParam="rb"
        />
        <label>
          show{" "}
          <select value={metric} onChange={(e) => note({ metric: e.currentTarget.value })}>
            {session.overview.metrics.map(({ name }) => (
              <option key={name}>{name}</option>
            ))}
          </select>
        </label>
      </div>
      <Problems session={session} route={route} sides={sides} />
      <Compared session={session} sides={sides} metric={metric} />
    </div>
  );
}
