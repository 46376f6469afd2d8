import { isPreliminary } from "../common/session";
import type { Overview } from "../data/generated";

/** A row of the grid: a requirement with the worst of its targets, or one target. */
export interface Row {
  key: string;
  kind: "requirement" | "target";
  requirement: string;
  title: string;
  /** What the target's case is about; "" of a requirement, whose title says it. */
  about: string;
  /** The requirement's letter and what all of that letter are about. */
  group: string;
  suite: string;
  /** By renderer: the index of the cell that represents the row; -1 if there is none. */
  cells: number[];
  /** Number of targets of a requirement. */
  below: number;
  /** Everything that the filter box searches, in lower case. */
  text: string;
}

export interface Filter {
  text: string;
  suites: string[];
  groups: string[];
  states: string[];
  renderers: string[];
  byTarget: boolean;
  /** "failures" first, as "given" by the suite, or by "value": the worst of the shown number first. */
  order: "failures" | "given" | "value";
  /** The metric or cost that the cells show. */
  show: string;
  open: string[];
}

const rank = (overview: Overview, cell: number): number => {
  const state = overview.cells.state[cell] ?? 0;
  const isFailure = overview.states[state]?.failure && !isPreliminary(overview, cell);
  // A failure of a declared feature ranks above all failures of features that are not declared.
  return (overview.cells.declared[cell] && isFailure ? 1000 : 0) + state;
};

/** The cell of the row with the worst state by these renderers; -1 if there is none. */
export function worstCell(overview: Overview, row: Row, renderers: number[]): number {
  let worst = -1;
  for (const renderer of renderers) {
    const cell = row.cells[renderer] ?? -1;
    if (cell >= 0 && (worst < 0 || rank(overview, cell) > rank(overview, worst))) worst = cell;
  }
  return worst;
}

/** How bad the shown number of a cell is: costs and errors by size, of others the smallest first. */
function badness(overview: Overview, show: string, cell: number): number {
  if (cell < 0) return -Infinity;
  if (show === "wall_seconds" || show === "peak_rss_bytes" || show === "spp")
    return overview.cells[show][cell] ?? -Infinity;
  const metric = overview.metrics.find((one) => one.name === show);
  const value = overview.measures[show]?.[cell] ?? null;
  if (value === null) return -Infinity;
  if (metric?.signed) return Math.abs(value);
  return metric?.lower_is_better ? value : -value;
}

/** The cell that represents the requirement: the worse state, then the worse main metric. */
function worseOf(overview: Overview, a: number, b: number): number {
  if (a < 0) return b;
  const difference = rank(overview, b) - rank(overview, a);
  if (difference !== 0) return difference > 0 ? b : a;
  const name = overview.main_metric;
  const metric = overview.metrics.find((one) => one.name === name);
  const best = metric?.lower_is_better ? -Infinity : Infinity; // if infinite or missing
  const value = (cell: number): number => overview.measures[name]?.[cell] ?? best;
  return (metric?.lower_is_better ? value(b) > value(a) : value(b) < value(a)) ? b : a;
}

interface Group {
  row: Row;
  targets: Map<string, Row>;
}

/** By code: the letter of the requirement and what its group is about, "B appearance". */
function groupNames(overview: Overview): Map<string, string> {
  return new Map(
    overview.requirements.map(({ code, group }) => [code, `${code.charAt(0)} ${group}`.trim()]),
  );
}

/** The groups of a run's requirements, in the order of the run. */
export function requirementGroups(overview: Overview): string[] {
  return [...new Set(groupNames(overview).values())];
}

/** All rows of a run by requirement, in the order of the run. */
export function groupsOf(overview: Overview): Group[] {
  const { cells, cases } = overview;
  const titles = new Map(overview.requirements.map(({ code, title }) => [code, title]));
  const names = groupNames(overview);
  const groups = new Map<string, Group>();
  const emptyCells = (): number[] => overview.renderers.map(() => -1);
  for (let i = 0; i < cells.case.length; ++i) {
    const one = cases[cells.case[i] ?? -1];
    const target = overview.targets[cells.target[i] ?? -1] ?? "";
    const renderer = cells.renderer[i] ?? -1;
    if (!one || renderer < 0) continue;
    const groupKey = `${one.suite}\n${one.requirement}`;
    let group = groups.get(groupKey);
    if (!group) {
      const title = titles.get(one.requirement) ?? one.title;
      const row: Row = {
        key: groupKey,
        kind: "requirement",
        requirement: one.requirement,
        title,
        about: "",
        group: names.get(one.requirement) ?? one.requirement.charAt(0),
        suite: one.suite,
        cells: emptyCells(),
        below: 0,
        text: `${one.requirement} ${title} ${one.suite}`.toLowerCase(),
      };
      group = { row, targets: new Map() };
      groups.set(groupKey, group);
    }
    const targetKey = `${one.name}\n${target}`;
    let row = group.targets.get(targetKey);
    if (!row) {
      row = {
        key: `${groupKey}\n${targetKey}`,
        kind: "target",
        requirement: one.requirement,
        title: target,
        about: one.title,
        group: group.row.group,
        suite: one.suite,
        cells: emptyCells(),
        below: 0,
        text: `${one.requirement} ${one.title} ${one.name} ${target} ${one.suite}`.toLowerCase(),
      };
      group.targets.set(targetKey, row);
      ++group.row.below;
      group.row.text += ` ${one.name} ${target}`.toLowerCase();
    }
    row.cells[renderer] = i;
    group.row.cells[renderer] = worseOf(overview, group.row.cells[renderer] ?? -1, i);
  }
  return [...groups.values()];
}

// The difference of two infinities is no number.
const compared = (a: number, b: number): number => (a === b ? 0 : a > b ? 1 : -1);

function worstRank(overview: Overview, row: Row, renderers: number[]): number {
  return Math.max(
    -1,
    ...renderers.map((r) => ((row.cells[r] ?? -1) < 0 ? -1 : rank(overview, row.cells[r] ?? 0))),
  );
}

/** The rows that pass the filter, in the order of the grid. */
export function visibleRows(overview: Overview, groups: Group[], filter: Filter): Row[] {
  const renderers = visibleRenderers(overview, filter);
  const words = filter.text.toLowerCase().split(/\s+/).filter(Boolean);
  // A word is part of the row's text, or of the renderer or the verdict of one of its cells.
  const hasWords = (row: Row): boolean => {
    const others = words.filter((word) => !row.text.includes(word));
    if (others.length === 0) return true;
    return renderers.some((r) => {
      const cell = row.cells[r] ?? -1;
      const state = overview.states[overview.cells.state[cell] ?? -1]?.name ?? "";
      const text = `${overview.renderers[r]?.name ?? ""} ${state}`.toLowerCase();
      return cell >= 0 && others.every((word) => text.includes(word));
    });
  };
  const keeps = (row: Row): boolean =>
    hasWords(row) &&
    (filter.suites.length === 0 || filter.suites.includes(row.suite)) &&
    (filter.groups.length === 0 || filter.groups.includes(row.group)) &&
    (filter.states.length === 0 ||
      renderers.some((r) => {
        const cell = row.cells[r] ?? -1;
        return (
          cell >= 0 &&
          filter.states.includes(overview.states[overview.cells.state[cell] ?? -1]?.name ?? "")
        );
      }));
  const sorted = (rows: Row[]): Row[] => {
    if (filter.order === "given") return rows;
    const rankOf = (row: Row): number =>
      filter.order === "failures"
        ? worstRank(overview, row, renderers)
        : Math.max(...renderers.map((r) => badness(overview, filter.show, row.cells[r] ?? -1)));
    const ranks = new Map(rows.map((row) => [row, rankOf(row)]));
    return [...rows].sort((a, b) => compared(ranks.get(b) ?? 0, ranks.get(a) ?? 0));
  };
  if (filter.byTarget)
    return sorted(groups.flatMap((group) => [...group.targets.values()]).filter(keeps));
  const kept = new Map(groups.map((group) => [group.row, group]));
  return sorted([...kept.keys()].filter(keeps)).flatMap((row) => {
    if (!filter.open.includes(row.requirement)) return [row];
    return [row, ...sorted([...(kept.get(row)?.targets.values() ?? [])].filter(keeps))];
  });
}

/** Indices of the renderers whose columns are shown. */
export function visibleRenderers(overview: Overview, filter: Filter): number[] {
  const all = overview.renderers.map((_, i) => i);
  if (filter.renderers.length === 0) return all;
  return all.filter((i) => filter.renderers.includes(overview.renderers[i]?.name ?? ""));
}
