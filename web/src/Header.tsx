import { seconds } from "./common/format";
import { runQuery, type Session } from "./common/session";
import type { Source } from "./data/source";
import type { Host } from "./data/generated";
import { go, routeText, type Route } from "./route";

/** What the header says of a study of any kind. */
interface StudyFacts {
  finished: boolean;
  suite: string;
  started: string;
  orbs_version: string;
  host?: Host;
  size?: string;
}

interface Props {
  source: Source;
  /** Index of the run; -1 if the address names a run that does not exist. */
  run: number;
  session: Session | string | undefined;
  /** The study, if the index is that of one. */
  study: StudyFacts | undefined;
  route: Route;
  onHelp: () => void;
}

export function Header({ source, run: index, session, study, route, onHelp }: Props) {
  const kind = source.kinds[index];
  const isStudy = kind !== undefined && kind !== "run";
  const [view = ""] = isStudy ? [] : route.path;
  const query = runQuery(source, index);
  const link = (path: string[], label: string) => (
    <a
      href={routeText({ path, query })}
      aria-current={view === (path[0] ?? "") ? "page" : undefined}
    >
      {label}
    </a>
  );
  const run = typeof session === "object" ? session.overview.run : undefined;
  return (
    <header class="top">
      <nav aria-label="Views">
        <span class="brand">orbs</span>
        {isStudy ? (
          link([], `${kind.charAt(0).toUpperCase()}${kind.slice(1)}`)
        ) : (
          <>
            {link([], "Overview")}
            {link(["charts"], "Time and memory")}
            {link(["effects"], "Effects")}
            {link(["compare"], "Compare")}
          </>
        )}
      </nav>
      <div class="run">
        {source.runs.length > 1 ? (
          <label>
            <span class="unseen">Run</span>
            <select
              value={source.runs[index] ?? ""}
              onChange={(event) => go(routeTo(source, index, event.currentTarget.value, route))}
            >
              {source.runs.map((name, i) => (
                <option key={name} value={name}>
                  {source.kinds[i] === "run" ? name : `${name} (${source.kinds[i]})`}
                </option>
              ))}
            </select>
          </label>
        ) : (
          <strong>{source.runs[index]}</strong>
        )}
        {run ? <span class="quiet">{runText(session as Session)}</span> : null}
        {study ? <span class="quiet">{studyText(study)}</span> : null}
        <button onClick={onHelp} title="Keys (?)" aria-label="Keys">
          ?
        </button>
      </div>
      {study && !study.finished ? (
        <p class="live ended" role="status">
          This study is not finished. The page shows what it has measured.
        </p>
      ) : null}
      {run && (run.live || !run.finished) ? <LiveBar session={session as Session} /> : null}
    </header>
  );
}

/** The address of another run: the same view, unless it is of the other kind. */
function routeTo(source: Source, from: number, name: string, route: Route): Route {
  const isSameKind = source.kinds[source.runs.indexOf(name)] === source.kinds[from];
  return isSameKind
    ? { path: route.path, query: { ...route.query, run: name } }
    : { path: [], query: { run: name } };
}

function studyText(study: StudyFacts): string {
  const size = study.size === undefined || study.size === "1" ? [] : [`measured at ${study.size}`];
  const { host } = study;
  return [
    ...size,
    study.suite,
    study.started.replace("T", " "),
    ...(host ? [`${host.name} (${host.cores} cores)`] : []),
    `orbs ${study.orbs_version}`,
  ].join(" · ");
}

function runText({ overview: { run } }: Session): string {
  const parts = [run.suite, run.started.replace("T", " ")];
  if (run.size !== "1") parts.unshift(`measured at ${run.size}`);
  if (run.wall_seconds > 0) parts.push(seconds(run.wall_seconds));
  parts.push(`${run.host.name} (${run.host.cores} cores)`, `orbs ${run.orbs_version}`);
  if (run.interrupted) parts.push("interrupted");
  return parts.join(" · ");
}

/** Progress of a live run, or why it is unknown; a note if the run was killed. */
function LiveBar({ session }: { session: Session }) {
  const { run } = session.overview;
  const { progress, connectionProblem: problem } = session;
  if (!run.live)
    return (
      <p class="live ended" role="status">
        This run did not finish. The page shows what it had rendered.
      </p>
    );
  if (problem !== undefined)
    return (
      <p class="live ended" role="status">
        The page shows the last known state and keeps trying: {problem}.
      </p>
    );
  if (!progress)
    return (
      <p class="live" role="status">
        The run is in progress …
      </p>
    );
  const left = progress.total - progress.done - progress.running.length;
  const estimate =
    progress.seconds_left === null ? "" : `, about ${seconds(progress.seconds_left)} to go`;
  return (
    <div class="live" role="status">
      <progress max={progress.total} value={progress.done} aria-label="Renders done" />
      <span>
        <b>{progress.done}</b> of {progress.total} renders done, {progress.running.length} running,{" "}
        {Math.max(0, left)} left{estimate}
      </span>
      <span class="quiet">{progress.running.slice(0, 4).join(", ")}</span>
    </div>
  );
}
