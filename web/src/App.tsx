import { useEffect, useState } from "preact/hooks";
import { CasePage } from "./case/CasePage";
import { ChartsPage } from "./charts/ChartsPage";
import { Help } from "./common/Help";
import { useActions, type Action } from "./common/keys";
import type { Session } from "./common/session";
import { ComparePage } from "./compare/ComparePage";
import type { Source } from "./data/source";
import { Header } from "./Header";
import { OverviewPage } from "./overview/OverviewPage";
import { go, useRoute } from "./route";
import { useSession } from "./use_session";

export function App({ source }: { source: Source }) {
  const route = useRoute();
  const [help, setHelp] = useState(false);
  const run = Math.max(0, source.runs.indexOf(route.query["run"] ?? source.runs[0] ?? ""));
  const session = useSession(source, run);
  const query: Record<string, string> = route.query["run"] ? { run: route.query["run"] } : {};
  const actions: Action[] = [
    { key: "?", label: "this sheet", group: "Page", run: () => setHelp(true) },
    { key: "Escape", label: "to the overview", group: "Page", run: () => go({ path: [], query }) },
    { key: "t", label: "time and memory", group: "Page", run: () => go({ path: ["charts"], query }) },
    { key: "v", label: "compare", group: "Page", run: () => go({ path: ["compare"], query }) },
  ];
  useActions(actions);
  const [view = ""] = route.path;
  useEffect(() => {
    const name = typeof session === "object" ? session.overview.run.name : "";
    document.title = [...route.path.slice(1).reverse(), view || "overview", name, "orbs"].filter(Boolean).join(" · ");
  });
  return (
    <>
      <button class="skip" onClick={() => document.getElementById("content")?.focus()}>
        Skip to the content
      </button>
      <Header source={source} session={session} route={route} onHelp={() => setHelp(true)} />
      <main id="content" tabIndex={-1} class={`view-${view || "overview"}`}>
        {session === undefined ? <p class="loading">Reading the run …</p> : null}
        {typeof session === "string" ? <p role="alert">The run cannot be shown: {session}</p> : null}
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
