import { bytes, counted } from "../common/format";
import { PairList } from "../common/PairList";
import type { Session } from "../common/session";
import type { Host, Job, TargetDetail } from "../data/generated";

function Pairs({ title, pairs }: { title: string; pairs: [string, string][] }) {
  const known = pairs.filter(([, value]) => value !== "");
  if (known.length === 0) return null;
  return (
    <div>
      <h3>{title}</h3>
      <PairList kind="pairs" pairs={known} />
    </div>
  );
}

const samplesText = ({ identity, sampling }: Job): string =>
  sampling.looks > 0
    ? `${identity.spp}, in ${sampling.looks} of at most ${counted(sampling.most_looks, "look")}`
    : String(identity.spp);

function hostPairs(host: Host, load: number): [string, string][] {
  const limits = [
    host.cpu_limit_cores === undefined ? "" : `${host.cpu_limit_cores} cores`,
    host.memory_limit_bytes === undefined ? "" : bytes(host.memory_limit_bytes),
  ];
  return [
    ["host", `${host.name}, ${host.cpu}, ${host.cores} cores`],
    ["memory", bytes(host.memory_bytes)],
    ["container limits", limits.filter((text) => text !== "").join(", ")],
    ["governor", host.governor],
    ["load at the start", load.toFixed(2)],
    ["system", [host.distribution, host.system].filter((text) => text !== "").join(", ")],
    ["orbs compiled with", host.compiler],
  ];
}

/** The provenance of the result and of the reference. */
export function Provenance({ session, detail }: { session: Session; detail: TargetDetail }) {
  const { run } = session.overview;
  return (
    <section class="provenance">
      <h2>Provenance</h2>
      <p>
        {detail.jobs
          .map((job) => `${job.program.version}; samples per pixel: ${samplesText(job)}`)
          .join("; ")}
      </p>
      <details>
        <summary>Machine, seeds, reference</summary>
        <div class="columns">
          {detail.jobs.map((job) => (
            <Pairs
              key={job.identity.id}
              title={`Result: ${job.identity.scene}`}
              pairs={[
                ["program", job.program.version],
                ["hand-written scene", job.files.native_scene],
                ["samples per pixel", samplesText(job)],
                [
                  "seed",
                  job.identity.seeds > 1
                    ? `${job.identity.seed} to ${job.identity.seed + job.identity.seeds - 1}, averaged`
                    : String(job.identity.seed),
                ],
                ["threads", String(job.program.threads)],
                ["started", job.cost.started.replace("T", " ")],
                ...(job.cost.host ? hostPairs(job.cost.host, job.cost.load) : []),
                ["orbs", run.orbs_version],
                ["job", job.identity.id],
              ]}
            />
          ))}
          <Pairs
            title="Reference"
            pairs={[...Object.entries(detail.reference_provenance), ["file", detail.reference]]}
          />
        </div>
      </details>
    </section>
  );
}
