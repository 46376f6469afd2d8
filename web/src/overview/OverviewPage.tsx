import { useMemo, useRef } from "preact/hooks";
import { useActions } from "../common/keys";
import type { Session } from "../common/session";
import { note, type Route } from "../route";
import { Filters } from "./Filters";
import { Grid } from "./Grid";
import { RendererTable } from "./RendererTable";
import { groupsOf, visibleRenderers, visibleRows, type Filter } from "./rows";

const list = (text: string | undefined): string[] => (text ? text.split("|") : []);

function filterOf({ query }: Route): Filter {
  return {
    text: query["q"] ?? "",
    suites: list(query["suite"]),
    states: list(query["state"]),
    renderers: list(query["renderer"]),
    byTarget: query["by"] === "target",
    failuresFirst: query["order"] !== "given",
    open: list(query["open"]),
  };
}

export function OverviewPage({ session, route }: { session: Session; route: Route }) {
  const { overview } = session;
  const groups = useMemo(() => groupsOf(overview), [overview]);
  const filter = filterOf(route);
  const rows = useMemo(
    () => visibleRows(overview, groups, filter),
    [overview, groups, location.hash],
  );
  const box = useRef<HTMLInputElement>(null);
  useActions([
    { key: "/", label: "filter", group: "Overview", run: () => box.current?.focus() },
    {
      key: "p",
      label: "by requirement or by image",
      group: "Overview",
      run: () => note({ by: filter.byTarget ? "" : "target" }),
    },
    {
      key: "f",
      label: "failures first or in the order of the suite",
      group: "Overview",
      run: () => note({ order: filter.failuresFirst ? "given" : "" }),
    },
  ]);
  return (
    <>
      <h1 class="unseen">Overview</h1>
      <RendererTable overview={overview} />
      <Filters
        overview={overview}
        filter={filter}
        count={rows.length}
        box={box}
        show={route.query["show"] ?? ""}
      />
      <Grid
        session={session}
        rows={rows}
        renderers={visibleRenderers(overview, filter)}
        filter={filter}
        show={route.query["show"] ?? overview.main_metric}
      />
    </>
  );
}
