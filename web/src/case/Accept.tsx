import { useState } from "preact/hooks";
import { Copyable } from "../common/Copyable";
import { stateOf, type Session } from "../common/session";
import type { TargetDetail } from "../data/generated";
import { AcceptForm } from "./AcceptForm";
import { Reason } from "./Reason";

const isPlain = (word: string): boolean => /^[\w@%+=:,./-]+$/.test(word);

/** The text as one word of a shell's command line. */
const shellWord = (text: string): string =>
  isPlain(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;

/** The command that accepts the failure, for a page that writes nothing. */
function AcceptCommand({ session, detail }: { session: Session; detail: TargetDetail }) {
  const [reason, setReason] = useState("");
  return (
    <>
      <Reason label="Reason" value={reason} onChange={setReason} />
      <Copyable
        label="Render again, and accept the failure"
        text={`${detail.accept_command} ${shellWord(reason.trim() || "REASON")}`}
      />
      <p class="quiet">
        {session.source.edit === "locked"
          ? "This tab may not write: open the whole address that orbs serve has printed, with what follows '#'."
          : "A page that orbs serve --edit serves writes the same entry itself."}
      </p>
    </>
  );
}

/** The command that renders the reference: no click does that, as it takes too long. */
function ReferenceCommand({ detail }: { detail: TargetDetail }) {
  const [reason, setReason] = useState("");
  const isMissing = !detail.reference_command.endsWith(" --accept");
  const why =
    "The built-in tracer renders a reference with as many samples as its cases need, which takes " +
    "minutes to hours: too long for a click. The next run compares with it.";
  return (
    <details class="reference-command" open={isMissing}>
      <summary>{isMissing ? "The reference is missing" : "Replace the reference"}</summary>
      <p class="quiet">{why}</p>
      {isMissing ? null : (
        <Reason label="Reason for the new reference" value={reason} onChange={setReason} />
      )}
      <Copyable
        label={isMissing ? "Render the reference" : "Render it anew, and keep the reason"}
        text={
          isMissing
            ? detail.reference_command
            : `${detail.reference_command} ${shellWord(reason.trim() || "REASON")}`
        }
      />
    </details>
  );
}

interface Props {
  session: Session;
  /** Index of the cell that is shown. */
  index: number;
  detail: TargetDetail;
}

/** How a failure becomes a known one, and how its reference is replaced. */
export function Accept({ session, index, detail }: Props) {
  const isFailure = stateOf(session.overview, index)?.failure ?? false;
  const canAccept = detail.accept_command !== "";
  if (!isFailure && !canAccept) return null;
  const { edit } = session.source;
  return (
    <section class="accept">
      <h2>{canAccept ? "Accept this failure" : "Reference"}</h2>
      {canAccept ? (
        <p>
          A known failure is named in every report with its reason, and fails no run until it gets
          worse or passes.
        </p>
      ) : null}
      {canAccept && typeof edit === "function" ? (
        <AcceptForm edit={edit} run={session.run} detail={detail} />
      ) : null}
      {canAccept && typeof edit !== "function" ? (
        <AcceptCommand session={session} detail={detail} />
      ) : null}
      <ReferenceCommand detail={detail} />
    </section>
  );
}
