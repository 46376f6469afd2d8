import type { RefObject } from "preact";
import { lookOf } from "../common/states";
import type { Overview } from "../data/generated";
import { note } from "../route";
import { requirementGroups, type Filter } from "./rows";

interface Props {
  overview: Overview;
  filter: Filter;
  /** Number of rows that the filter leaves. */
  count: number;
  box: RefObject<HTMLInputElement | null>;
  /** The targets are shown as pictures. */
  isGallery: boolean;
}

const toggled = (list: string[], one: string): string =>
  (list.includes(one) ? list.filter((other) => other !== one) : [...list, one]).join("|");

interface ChipsProps {
  label: string;
  names: { name: string; count?: number }[];
  chosen: string[];
  param: string;
  symbols?: (name: string) => { symbol: string; tone: string };
}

function Chips({ label, names, chosen, param, symbols }: ChipsProps) {
  if (names.length < 2) return null;
  return (
    <div class="chips" role="group" aria-label={label}>
      <span class="label">{label}</span>
      {names.map(({ name, count }) => {
        const look = symbols?.(name);
        return (
          <button
            key={name}
            class={`chip ${look ? `tone-${look.tone}` : ""}`}
            aria-pressed={chosen.includes(name)}
            onClick={() => note({ [param]: toggled(chosen, name) })}
          >
            {look ? <span aria-hidden="true">{look.symbol} </span> : null}
            {name}
            {count === undefined ? null : <span class="count"> {count}</span>}
          </button>
        );
      })}
    </div>
  );
}

export function Filters({ overview, filter, count, box, isGallery }: Props) {
  const counts = overview.states.map(() => 0);
  for (const state of overview.cells.state) counts[state] = (counts[state] ?? 0) + 1;
  const states = overview.states
    .map((state, i) => ({ name: state.name, count: counts[i] ?? 0 }))
    .filter((s) => s.count > 0)
    .reverse();
  const suites = [...new Set(overview.cases.map((one) => one.suite))].map((name) => ({ name }));
  const groups = requirementGroups(overview).map((name) => ({ name }));
  const lookByName = (name: string) => lookOf(overview.states.find((state) => state.name === name));
  return (
    <section class="filters" aria-label="Filter">
      <label class="search">
        <span class="unseen">Filter by requirement, case, target, renderer or verdict</span>
        <input
          ref={box}
          type="search"
          placeholder="Filter  ( / )"
          value={filter.text}
          onInput={(event) => note({ q: event.currentTarget.value })}
          onKeyDown={(event) => event.key === "Escape" && event.currentTarget.blur()}
        />
      </label>
      <Chips label="Suite" names={suites} chosen={filter.suites} param="suite" />
      <Chips label="Group" names={groups} chosen={filter.groups} param="group" />
      <Chips
        label="State"
        names={states}
        chosen={filter.states}
        param="state"
        symbols={lookByName}
      />
      <Chips
        label="Renderer"
        names={overview.renderers}
        chosen={filter.renderers}
        param="renderer"
      />
      <Choices overview={overview} filter={filter} count={count} isGallery={isGallery} />
    </section>
  );
}

/** Table or pictures, the order of the rows, and the number that each cell shows. */
function Choices({ overview, filter, count, isGallery }: Omit<Props, "box">) {
  return (
    <div class="choices">
      <button
        aria-pressed={isGallery}
        title="Key g"
        onClick={() => note({ as: isGallery ? "" : "gallery" })}
      >
        Pictures
      </button>
      <button
        aria-pressed={filter.order === "failures"}
        title="Key f"
        onClick={() => note({ order: filter.order === "failures" ? "given" : "" })}
      >
        Failures first
      </button>
      <button
        aria-pressed={filter.order === "value"}
        title="the worst of the shown number first"
        onClick={() => note({ order: filter.order === "value" ? "" : "value" })}
      >
        Worst number first
      </button>
      <button
        aria-pressed={filter.byTarget}
        title="Key p"
        onClick={() => note({ by: filter.byTarget ? "requirement" : "target" })}
      >
        By target
      </button>
      <label>
        Show{" "}
        <select value={filter.show} onChange={(event) => note({ show: event.currentTarget.value })}>
          {overview.metrics.map((metric) => (
            <option key={metric.name}>{metric.name}</option>
          ))}
          <option value="wall_seconds">samples and time</option>
          <option value="spp">samples per pixel</option>
          <option value="peak_rss_bytes">peak memory</option>
        </select>
      </label>
      <span class="quiet" role="status">
        {count} {count === 1 ? "row" : "rows"}
      </span>
    </div>
  );
}
