import { useEffect, useState } from "preact/hooks";
import { CasePage } from "./case/CasePage";
import { ChartsPage } from "./charts/ChartsPage";
import { Help } from "./common/Help";
import { useActions, type Action } from "./common/keys";
import { NoSuchRun } from "./common/NoSuchRun";
import { runNamed, runQuery, type Session } from "./common/session";
import { ComparePage } from "./compare/ComparePage";
import type { Source } from "./data/source";
import { EffectsPage } from "./effects/EffectsPage";
import { Header } from "./Header";
import { OverviewPage } from "./overview/OverviewPage";
import { go, note, useRoute } from "./route";
import { StudyPage } from "./studies";
import { useSession } from "./use_session";
import { useStudy } from "./use_study";

function pageActions(query: Record<string, string>, onHelp: () => void): Action[] {
  return [
    { key: "?", label: "list of keys", group: "Page", run: onHelp },
    { key: "Escape", label: "overview", group: "Page", run: () => go({ path: [], query }) },
    {
      key: "t",
      label: "time and memory",
      group: "Page",
      run: () => go({ path: ["charts"], query }),
    },
    { key: "v", label: "compare", group: "Page", run: () => go({ path: ["compare"], query }) },
  ];
}

function useTitle(parts: string[]) {
  useEffect(() => {
    document.title = parts.filter(Boolean).join(" · ");
  });
}

export function App({ source }: { source: Source }) {
  const route = useRoute();
  const [help, setHelp] = useState(false);
  const run = runNamed(source, route.query["run"], 0);
  const kind = source.kinds[run];
  const studyKind = kind === "run" ? undefined : kind;
  const session = useSession(source, studyKind ? -1 : run);
  const study = useStudy(source, run);
  const query = runQuery(source, run);
  useEffect(() => {
    if (source.runs.length > 1 && !route.query["run"]) note(query);
  }, [route]);
  useActions(pageActions(query, () => setHelp(true)));
  const [view = ""] = route.path;
  const shown = studyKind ?? (view || "overview");
  useTitle([...route.path.slice(1).reverse(), shown, source.runs[run] ?? "", "orbs"]);
  return (
    <>
      <button class="skip" onClick={() => document.getElementById("content")?.focus()}>
        Skip to the content
      </button>
      <Header
        source={source}
        run={run}
        session={session}
        study={study.value}
        route={route}
        onHelp={() => setHelp(true)}
      />
      <main id="content" tabIndex={-1} class={`view-${shown}`}>
        {run < 0 ? <NoSuchRun source={source} route={route} param="run" /> : null}
        {studyKind && study.value ? (
          <StudyPage kind={studyKind} source={source} run={run} study={study.value} route={route} />
        ) : null}
        {studyKind && !study.value && study.problem === undefined ? (
          <p class="loading">Reading the study …</p>
        ) : null}
        {study.problem !== undefined && !study.value ? (
          <p role="alert">The study cannot be shown: {study.problem}</p>
        ) : null}
        {run >= 0 && !studyKind && session === undefined ? (
          <p class="loading">Reading the run …</p>
        ) : null}
        {typeof session === "string" ? (
          <p role="alert">The run cannot be shown: {session}</p>
        ) : null}
        {typeof session === "object" ? <View session={session} view={view} /> : null}
      </main>
      {help ? <Help onClose={() => setHelp(false)} /> : null}
    </>
  );
}

function View({ session, view }: { session: Session; view: string }) {
  const route = useRoute();
  if (view === "case") return <CasePage session={session} route={route} />;
  if (view === "charts") return <ChartsPage session={session} route={route} />;
  if (view === "effects") return <EffectsPage session={session} />;
  if (view === "compare") return <ComparePage session={session} route={route} />;
  return (
    <>
      {view === "" ? null : (
        <p role="alert">The page has no view '{view}'. This is the overview.</p>
      )}
      <OverviewPage session={session} route={route} />
    </>
  );
}
