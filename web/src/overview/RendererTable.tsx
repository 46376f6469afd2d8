import { bytes, seconds } from "../common/format";
import { lookOf } from "../common/states";
import { TableHead, type Column } from "../common/TableHead";
import type { Overview, Renderer } from "../data/generated";

const kColumns: Column[] = [
  { label: "Renderer" },
  {
    label: "Declared",
    title: "ORB.S feature number: the levels that it claims; L4-(2) means L1 to L4 without L2",
  },
  { label: "Measured", title: "The levels of which all targets pass in this run" },
  { label: "Targets" },
  { label: "Time", isNumber: true, title: "Sum of the wall-clock time of its renders" },
  { label: "CPU", isNumber: true, title: "Sum of user and system time of its renders" },
  { label: "Peak memory", isNumber: true, title: "Largest resident set of any of its renders" },
];

/** How many targets of each renderer are in each state. */
function countsOf(overview: Overview): number[][] {
  const counts = overview.renderers.map(() => overview.states.map(() => 0));
  const { cells } = overview;
  for (let i = 0; i < cells.case.length; ++i) {
    const own = counts[cells.renderer[i] ?? -1];
    const state = cells.state[i] ?? 0;
    if (own) own[state] = (own[state] ?? 0) + 1;
  }
  return counts;
}

interface RowProps {
  overview: Overview;
  renderer: Renderer;
  /** How many of its targets are in each state of the run. */
  counts: number[];
}

function RendererRow({ overview, renderer, counts }: RowProps) {
  return (
    <tr>
      <th scope="row">
        {renderer.name} <span class="quiet">{renderer.version}</span>
      </th>
      <td data-label="Declared" class="features">
        {renderer.declared || "–"}
      </td>
      <td data-label="Measured" class="features">
        {overview.run.finished ? renderer.measured || "–" : "…"}
      </td>
      <td data-label="Targets">
        <ul class="counts">
          {counts.map((count, s) => {
            const state = overview.states[s];
            if (count === 0 || !state) return null;
            const look = lookOf(state);
            return (
              <li key={state.name} class={`tone-${look.tone}`}>
                <span aria-hidden="true">{look.symbol}</span> {count} {state.name}
              </li>
            );
          })}
        </ul>
      </td>
      <td data-label="Time" class="number">
        {renderer.wall_seconds ? seconds(renderer.wall_seconds) : "–"}
      </td>
      <td data-label="CPU" class="number">
        {renderer.cpu_seconds ? seconds(renderer.cpu_seconds) : "–"}
      </td>
      <td data-label="Peak memory" class="number">
        {bytes(renderer.peak_rss_bytes)}
      </td>
    </tr>
  );
}

/** One row per renderer: its declared and measured features, and its cost. */
export function RendererTable({ overview }: { overview: Overview }) {
  const counts = countsOf(overview);
  return (
    <table>
      <TableHead columns={kColumns} />
      <tbody>
        {overview.renderers.map((renderer, r) => (
          <RendererRow
            key={renderer.name}
            overview={overview}
            renderer={renderer}
            counts={counts[r] ?? []}
          />
        ))}
      </tbody>
    </table>
  );
}
