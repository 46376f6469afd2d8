import { bytes, seconds } from "../common/format";
import { Copyable } from "../common/Copyable";
import type { TargetDetail } from "../data/types";

/** Time and memory of the renders, and the commands that repeat them. */
export function Cost({ detail }: { detail: TargetDetail }) {
  return (
    <section class="cost">
      <h2>Time, memory, command</h2>
      {detail.jobs.length > 0 ? (
        <table>
          <thead>
            <tr>
              <th scope="col">Render</th>
              <th scope="col" class="number" title="wall-clock time of the whole process">
                Wall
              </th>
              <th
                scope="col"
                class="number"
                title="user and system time of the process and its children"
              >
                CPU
              </th>
              <th scope="col" class="number" title="render time that the renderer itself reports">
                Reported
              </th>
              <th scope="col" class="number" title="largest resident set of any of its processes">
                Peak memory
              </th>
            </tr>
          </thead>
          <tbody>
            {detail.jobs.map((job) => (
              <tr key={job.identity.id}>
                <th scope="row">{job.identity.scene}</th>
                <td class="number">{seconds(job.cost.started ? job.cost.wall_seconds : null)}</td>
                <td class="number">{seconds(job.cost.started ? job.cost.cpu_seconds : null)}</td>
                <td class="number">{seconds(job.cost.render_seconds)}</td>
                <td class="number">{bytes(job.cost.peak_rss_bytes)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      ) : (
        <p class="quiet">Nothing was rendered for this target.</p>
      )}
      <Copyable label="Render and judge this target again" text={detail.command} />
      {detail.jobs.map((job) =>
        job.program.shell ? (
          <Copyable
            key={job.identity.id}
            label={`Run the renderer alone, ${job.identity.scene}`}
            text={job.program.shell}
          />
        ) : null,
      )}
    </section>
  );
}
