import { useEffect, useState } from "preact/hooks";
import { CasePage } from "./case/CasePage";
import { ChartsPage } from "./charts/ChartsPage";
import { Help } from "./common/Help";
import { useActions, type Action } from "./common/keys";
import { NoSuchRun } from "./common/NoSuchRun";
import { runNamed, runQuery, type Session } from "./common/session";
import { ComparePage } from "./compare/ComparePage";
import type { Source } from "./data/source";
import { Header } from "./Header";
import { OverviewPage } from "./overview/OverviewPage";
import { go, note, useRoute } from "./route";
import { useSession } from "./use_session";

export function App({ source }: { source: Source }) {
  const route = useRoute();
  const [help, setHelp] = useState(false);
  const run = runNamed(source, route.query["run"], 0);
  const session = useSession(source, run);
  const query = runQuery(source, run);
  useEffect(() => {
    if (source.runs.length > 1 && !route.query["run"]) note(query);
  }, [route]);
  const actions: Action[] = [
    { key: "?", label: "this sheet", group: "Page", run: () => setHelp(true) },
    { key: "Escape", label: "to the overview", group: "Page", run: () => go({ path: [], query }) },
    {
      key: "t",
      label: "time and memory",
      group: "Page",
      run: () => go({ path: ["charts"], query }),
    },
    { key: "v", label: "compare", group: "Page", run: () => go({ path: ["compare"], query }) },
  ];
  useActions(actions);
  const [view = ""] = route.path;
  useEffect(() => {
    const name = typeof session === "object" ? session.overview.run.name : "";
    document.title = [...route.path.slice(1).reverse(), view || "overview", name, "orbs"]
      .filter(Boolean)
      .join(" · ");
  });
  return (
    <>
      <button class="skip" onClick={() => document.getElementById("content")?.focus()}>
        Skip to the content
      </button>
      <Header
        source={source}
        run={run}
        session={session}
        route={route}
        onHelp={() => setHelp(true)}
      />
      <main id="content" tabIndex={-1} class={`view-${view || "overview"}`}>
        {run < 0 ? <NoSuchRun source={source} route={route} param="run" /> : null}
        {run >= 0 && session === undefined ? <p class="loading">Reading the run …</p> : null}
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
  if (view === "compare") return <ComparePage session={session} route={route} />;
  return <OverviewPage session={session} route={route} />;
}
