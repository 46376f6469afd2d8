import type { Session } from "../common/session";
import type { PictureDetail } from "../data/types";

function Pairs({ title, pairs }: { title: string; pairs: [string, string][] }) {
  const known = pairs.filter(([, value]) => value !== "");
  if (known.length === 0) return null;
  return (
    <div>
      <h3>{title}</h3>
      <dl class="pairs">
        {known.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
    </div>
  );
}

/** Who made the pictures, and how. */
export function Passports({ session, detail }: { session: Session; detail: PictureDetail }) {
  const { run } = session.overview;
  return (
    <section class="passports">
      <h2>Where the pictures come from</h2>
      <div class="columns">
        {detail.jobs.map((job) => (
          <Pairs key={job.id} title={`Result: ${job.scene}`} pairs={[
            ["program", job.renderer_version],
            ["samples per pixel", String(job.spp)],
            ["seed", String(job.seed)],
            ["threads", String(job.threads)],
            ["started", job.started.replace("T", " ")],
            ["host", `${run.host.name}, ${run.host.cpu}, ${run.host.cores} cores`],
            ["system", run.host.system],
            ["job", job.id],
          ]} />
        ))}
        <Pairs title="Reference" pairs={[...Object.entries(detail.reference_passport), ["file", detail.reference]]} />
      </div>
    </section>
  );
}
