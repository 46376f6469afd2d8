import { bytes, seconds } from "../common/format";
import { lookOf } from "../common/states";
import type { Overview } from "../data/types";

/** By renderer, how many of its images are in each state. */
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

/** One line per renderer: what it claims, what was measured, what it cost. */
export function RendererTable({ overview }: { overview: Overview }) {
  const counts = countsOf(overview);
  return (
    <section class="renderers" aria-label="Renderers">
      <table>
        <thead>
          <tr>
            <th scope="col">Renderer</th>
            <th
              scope="col"
              title="Feature number of ORB.S: the levels that the renderer claims, L4-(2) is L1 to L4 without L2"
            >
              Declared
            </th>
            <th scope="col" title="The levels whose images all pass in this run">
              Measured
            </th>
            <th scope="col">Targets</th>
            <th scope="col" class="number" title="Sum of the wall-clock time of its renders">
              Time
            </th>
            <th scope="col" class="number" title="Sum of user and system time of its renders">
              CPU
            </th>
            <th scope="col" class="number" title="Largest resident set of one of its renders">
              Peak memory
            </th>
          </tr>
        </thead>
        <tbody>
          {overview.renderers.map((renderer, r) => (
            <tr key={renderer.name}>
              <th scope="row">
                {renderer.name} <span class="quiet">{renderer.version}</span>
              </th>
              <td data-label="Declared" class="features">
                {renderer.declared || "–"}
              </td>
              <td data-label="Measured" class="features">
                {overview.run.finished ? renderer.measured || "–" : "…"}
              </td>
              <td data-label="Images">
                <ul class="counts">
                  {counts[r]?.map((count, s) => {
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
          ))}
        </tbody>
      </table>
      {overview.left_out.map(({ renderer, reason }) => (
        <p class="quiet" key={renderer}>
          Left out: {renderer}: {reason}
        </p>
      ))}
    </section>
  );
}
