import { Scroll } from "../common/Scroll";
import { bytes, seconds } from "../common/format";
import { Copyable } from "../common/Copyable";
import { TableHead, type Column } from "../common/TableHead";
import type { TargetDetail } from "../data/generated";

const kColumns: Column[] = [
  { label: "Render" },
  { label: "Samples", isNumber: true, title: "samples per pixel, all looks together" },
  { label: "Wall", isNumber: true, title: "wall-clock time of the whole process" },
  { label: "CPU", isNumber: true, title: "user and system time of the process and its children" },
  { label: "Reported", isNumber: true, title: "render time that the renderer itself reports" },
  { label: "Peak memory", isNumber: true, title: "largest resident set of any of its processes" },
];

/** Samples, time and memory of the renders, and the commands that repeat them. */
export function Cost({ detail }: { detail: TargetDetail }) {
  return (
    <section class="cost">
      <h2>Time, memory, command</h2>
      {detail.jobs.length > 0 ? (
        <Scroll label="Cost of the renders">
          <table>
            <TableHead columns={kColumns} />
            <tbody>
              {detail.jobs.map((job) => (
                <tr key={job.identity.id}>
                  <th scope="row">{job.identity.scene}</th>
                  <td class="number">{job.cost.started ? job.identity.spp : "–"}</td>
                  <td class="number">{seconds(job.cost.started ? job.cost.wall_seconds : null)}</td>
                  <td class="number">{seconds(job.cost.started ? job.cost.cpu_seconds : null)}</td>
                  <td class="number">{seconds(job.cost.render_seconds)}</td>
                  <td class="number">{bytes(job.cost.peak_rss_bytes)}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </Scroll>
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
