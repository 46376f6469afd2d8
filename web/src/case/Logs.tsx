import type { Session } from "../common/session";
import type { TargetDetail } from "../data/generated";

/** The ends of the logs, always shown as plain text. */
export function Logs({ session, detail }: { session: Session; detail: TargetDetail }) {
  const jobs = detail.jobs.filter((job) => job.log !== "" || job.end.reason !== "");
  if (jobs.length === 0) return null;
  return (
    <section class="logs">
      <h2>Output of the renderer</h2>
      {jobs.map((job) => {
        const address = job.files.log
          ? session.source.fileAddress(session.run, job.files.log)
          : undefined;
        return (
          <details key={job.identity.id} open={job.end.exit_code !== 0 || job.end.signal !== ""}>
            <summary>
              {job.identity.scene}:{" "}
              {job.end.signal ? `killed by ${job.end.signal}` : `exit code ${job.end.exit_code}`}
              {job.end.reason ? ` · ${job.end.reason}` : ""}
            </summary>
            <pre tabIndex={0}>{job.log || "(no output)"}</pre>
            {address ? <a href={address}>Whole log</a> : null}
          </details>
        );
      })}
    </section>
  );
}
