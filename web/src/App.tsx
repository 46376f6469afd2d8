import type { ComponentChildren } from "preact";
import { useEffect, useState } from "preact/hooks";
import { CasePage } from "./case/CasePage";
import { ChartsPage } from "./charts/ChartsPage";
import { Help } from "./common/Help";
import { useActions, type Action } from "./common/keys";
import { NoSuchRun } from "./common/NoSuchRun";
import type { Received } from "./common/request";
import { runNamed, runQuery, type Session } from "./common/session";
import { ComparePage } from "./compare/ComparePage";
import { CostPage } from "./cost/CostPage";
import { useStudy } from "./cost/use_study";
import type { Source } from "./data/source";
import { Header } from "./Header";
import { OverviewPage } from "./overview/OverviewPage";
import { go, note, useRoute } from "./route";
import { StabilityPage } from "./stability/StabilityPage";
import { useSession } from "./use_session";

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
  const isStudy = kind === "cost" || kind === "stability";
  const session = useSession(source, isStudy ? -1 : run);
  const study = useStudy(source, kind === "cost" ? run : -1, source.study);
  const stability = useStudy(source, kind === "stability" ? run : -1, source.stability);
  const query = runQuery(source, run);
  useEffect(() => {
    if (source.runs.length > 1 && !route.query["run"]) note(query);
  }, [route]);
  useActions(pageActions(query, () => setHelp(true)));
  const [view = ""] = route.path;
  const shown = isStudy ? kind : view || "overview";
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
        study={study.value ?? stability.value}
        route={route}
        onHelp={() => setHelp(true)}
      />
      <main id="content" tabIndex={-1} class={`view-${shown}`}>
        {run < 0 ? <NoSuchRun source={source} route={route} param="run" /> : null}
        {kind === "cost" ? (
          <StudyView received={study}>
            {(value) => <CostPage source={source} run={run} study={value} route={route} />}
          </StudyView>
        ) : null}
        {kind === "stability" ? (
          <StudyView received={stability}>
            {(value) => <StabilityPage source={source} run={run} study={value} route={route} />}
          </StudyView>
        ) : null}
        {run >= 0 && !isStudy && session === undefined ? (
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

function StudyView<Study>({
  received: { value, problem },
  children,
}: {
  received: Received<Study>;
  children: (value: Study) => ComponentChildren;
}) {
  if (value) return <>{children(value)}</>;
  if (problem !== undefined) return <p role="alert">The study cannot be shown: {problem}</p>;
  return <p class="loading">Reading the study …</p>;
}

function View({ session, view }: { session: Session; view: string }) {
  const route = useRoute();
  if (view === "case") return <CasePage session={session} route={route} />;
  if (view === "charts") return <ChartsPage session={session} route={route} />;
  if (view === "compare") return <ComparePage session={session} route={route} />;
  return <OverviewPage session={session} route={route} />;
}
