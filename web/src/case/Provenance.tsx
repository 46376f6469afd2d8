import { bytes } from "../common/format";
import type { Session } from "../common/session";
import type { Host, TargetDetail } from "../data/types";

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

function hostPairs(host: Host, load: number): [string, string][] {
  const limits = [
    host.cpu_limit === null ? "" : `${host.cpu_limit} cores`,
    host.memory_limit_bytes === null ? "" : bytes(host.memory_limit_bytes),
  ];
  return [
    ["host", `${host.name}, ${host.cpu}, ${host.cores} cores`],
    ["memory", bytes(host.memory_bytes)],
    ["limits of its container", limits.filter((text) => text !== "").join(", ")],
    ["governor", host.governor],
    ["load when it started", load.toFixed(2)],
    ["system", [host.distribution, host.system].filter((text) => text !== "").join(", ")],
    ["orbs compiled by", host.compiler],
  ];
}

/** Who made the images, and how. */
export function Provenance({ session, detail }: { session: Session; detail: TargetDetail }) {
  const { run } = session.overview;
  return (
    <section class="provenances">
      <h2>Where the targets come from</h2>
      <div class="columns">
        {detail.jobs.map((job) => (
          <Pairs
            key={job.id}
            title={`Result: ${job.scene}`}
            pairs={[
              ["program", job.renderer_version],
              ["hand-written scene", job.native_scene],
              ["samples per pixel", String(job.spp)],
              [
                "seed",
                job.seeds > 1
                  ? `${job.seed} to ${job.seed + job.seeds - 1}, together`
                  : String(job.seed),
              ],
              ["threads", String(job.threads)],
              ["started", job.started.replace("T", " ")],
              ...hostPairs(job.host, job.load),
              ["orbs", run.orbs_version],
              ["job", job.id],
            ]}
          />
        ))}
        <Pairs
          title="Reference"
          pairs={[...Object.entries(detail.reference_provenance), ["file", detail.reference]]}
        />
      </div>
    </section>
  );
}
