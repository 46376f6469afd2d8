import type { Session } from "../common/session";
import type { TargetDetail } from "../data/types";

/** The ends of the logs. They are text, whatever they hold. */
export function Logs({ session, detail }: { session: Session; detail: TargetDetail }) {
  const jobs = detail.jobs.filter((job) => job.log !== "" || job.reason !== "");
  if (jobs.length === 0) return null;
  return (
    <section class="logs">
      <h2>Output of the renderer</h2>
      {jobs.map((job) => {
        const address = job.log_file
          ? session.source.fileAddress(session.run, job.log_file)
          : undefined;
        return (
          <details key={job.id} open={job.exit_code !== 0 || job.signal !== ""}>
            <summary>
              {job.scene}: {job.signal ? `killed by ${job.signal}` : `exit code ${job.exit_code}`}
              {job.reason ? ` · ${job.reason}` : ""}
            </summary>
            <pre tabIndex={0}>{job.log || "(it wrote nothing)"}</pre>
            {address ? <a href={address}>the whole log</a> : null}
          </details>
        );
      })}
    </section>
  );
}
