import { useMemo, useRef } from "preact/hooks";
import { useActions } from "../common/keys";
import type { Session } from "../common/session";
import { note, type Route } from "../route";
import { Filters } from "./Filters";
import { Gallery } from "./Gallery";
import { Grid } from "./Grid";
import { ReportCards } from "./ReportCards";
import { groupsOf, visibleRenderers, visibleRows, type Filter } from "./rows";

const list = (text: string | undefined): string[] => (text ? text.split("|") : []);

function orderOf(order: string | undefined): Filter["order"] {
  return order === "given" || order === "value" ? order : "failures";
}

function filterOf({ query }: Route, mainMetric: string): Filter {
  return {
    text: query["q"] ?? "",
    suites: list(query["suite"]),
    groups: list(query["group"]),
    states: list(query["state"]),
    renderers: list(query["renderer"]),
    // Pictures are of targets, a table is of requirements, if the address says nothing else.
    byTarget: (query["by"] || (query["as"] === "gallery" ? "target" : "")) === "target",
    order: orderOf(query["order"]),
    show: query["show"] || mainMetric,
    open: list(query["open"]),
  };
}

function Notes({ session, show }: { session: Session; show: string }) {
  const { run, rule_beside_psnr } = session.overview;
  return (
    <>
      {show === "psnr_srgb8" && rule_beside_psnr && <p class="quiet">{rule_beside_psnr}</p>}
      {run.references_note && <p class="quiet">{run.references_note}</p>}
    </>
  );
}

export function OverviewPage({ session, route }: { session: Session; route: Route }) {
  const { overview } = session;
  const groups = useMemo(() => groupsOf(overview), [overview]);
  const filter = filterOf(route, overview.main_metric);
  const isGallery = route.query["as"] === "gallery";
  const rows = useMemo(
    () => visibleRows(overview, groups, filter),
    [overview, groups, location.hash],
  );
  const box = useRef<HTMLInputElement>(null);
  useActions([
    { key: "/", label: "filter", group: "Overview", run: () => box.current?.focus() },
    {
      key: "p",
      label: "by requirement or by target",
      group: "Overview",
      run: () => note({ by: filter.byTarget ? "requirement" : "target" }),
    },
    {
      key: "f",
      label: "failures first or in the order of the suite",
      group: "Overview",
      run: () => note({ order: filter.order === "failures" ? "given" : "" }),
    },
    {
      key: "g",
      label: "table or pictures",
      group: "Overview",
      run: () => note({ as: isGallery ? "" : "gallery" }),
    },
  ]);
  return (
    <>
      <h1 class="unseen">Overview</h1>
      <ReportCards session={session} />
      <Filters
        overview={overview}
        filter={filter}
        count={rows.length}
        box={box}
        isGallery={isGallery}
      />
      {isGallery ? (
        <Gallery
          session={session}
          rows={rows}
          renderers={visibleRenderers(overview, filter)}
          show={filter.show}
        />
      ) : (
        <Grid
          session={session}
          rows={rows}
          renderers={visibleRenderers(overview, filter)}
          filter={filter}
          show={filter.show}
        />
      )}
      <Notes session={session} show={filter.show} />
    </>
  );
}
