import { Scroll } from "../common/Scroll";
import { TableHead, type Column } from "../common/TableHead";
import type { Job, TargetDetail } from "../data/generated";
import { recordedValues } from "./recorded";

const kColumns: Column[] = [{ label: "Name" }, { label: "Value" }, { label: "Unit" }];

function Values({ job }: { job: Job }) {
  const { log: _log, ...record } = job;
  return (
    <Scroll label="Record">
      <table>
        <TableHead columns={kColumns} />
        <tbody>
          {recordedValues(record).map(({ name, value, unit }) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>{value}</td>
              <td>{unit}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </Scroll>
  );
}

/** Every member of the renders' records, including those that no other section of the page knows. */
export function RenderRecord({ detail }: { detail: TargetDetail }) {
  if (detail.jobs.length === 0) return null;
  return (
    <section class="records">
      <h2>Record of the render</h2>
      {detail.jobs.map((job) => (
        <details key={job.identity.id}>
          <summary>{job.identity.scene}</summary>
          <Values job={job} />
        </details>
      ))}
    </section>
  );
}
