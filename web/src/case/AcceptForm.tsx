import { useState } from "preact/hooks";
import { Copyable } from "../common/Copyable";
import { messageOf } from "../common/message";
import type { Edit } from "../data/edit";
import type { FileChange, TargetDetail } from "../data/generated";
import { Reason } from "./Reason";

const kindOf = (line: string): string =>
  line.startsWith("+++") || line.startsWith("---") || line.startsWith("@@")
    ? "place"
    : line.startsWith("+")
      ? "added"
      : line.startsWith("-")
        ? "removed"
        : "";

/** The lines of a unified difference; their marks say what is new, and the colours repeat it. */
function Difference({ text }: { text: string }) {
  const lines = text.replace(/\n$/, "").split("\n");
  return (
    <pre class="difference" tabIndex={0} aria-label="Difference of the file">
      {lines.map((line, i) => (
        <span key={i} class={kindOf(line)}>
          {line}
          {"\n"}
        </span>
      ))}
    </pre>
  );
}

/** The change that is shown before it is written. */
function Proposal(props: {
  change: FileChange;
  isBusy: boolean;
  onWrite: () => void;
  onDrop: () => void;
}) {
  const { change, isBusy, onWrite, onDrop } = props;
  if (change.diff === "")
    return (
      <p role="status">
        {change.file} has this entry already, in line {change.line}.
      </p>
    );
  return (
    <div class="proposal">
      <p>Nothing is written yet. This is what would change:</p>
      <Difference text={change.diff} />
      <button type="button" class="write" disabled={isBusy} onClick={onWrite}>
        Write it
      </button>{" "}
      <button type="button" disabled={isBusy} onClick={onDrop}>
        Cancel
      </button>
    </div>
  );
}

function Written({ change, command }: { change: FileChange; command: string }) {
  return (
    <>
      <p role="status">
        Written to {change.file}, line {change.line}. The verdict changes with the next run.
      </p>
      <Copyable label="Render and judge this target again" text={command} />
    </>
  );
}

/** Asks for the reason, shows what it makes of the configuration, and writes that. */
function useAcceptance(edit: Edit, run: number, detail: TargetDetail) {
  const [fields, setFields] = useState({ reason: "", until: "" });
  const [change, setChange] = useState<FileChange>();
  const [problem, setProblem] = useState("");
  const [isBusy, setBusy] = useState(false);
  const { target, renderer } = detail;
  const send = async (hash?: string): Promise<void> => {
    setBusy(true);
    setProblem("");
    try {
      setChange(await edit({ run, target, renderer, ...fields, ...(hash ? { hash } : {}) }));
    } catch (error) {
      setChange(undefined); // what was shown may be no longer so
      setProblem(messageOf(error));
    }
    setBusy(false);
  };
  const set = (part: Partial<typeof fields>): void => {
    setFields({ ...fields, ...part });
    setChange(undefined);
  };
  return { fields, set, change, drop: () => setChange(undefined), problem, isBusy, send };
}

interface Props {
  edit: Edit;
  run: number;
  detail: TargetDetail;
}

export function AcceptForm({ edit, run, detail }: Props) {
  const { fields, set, change, drop, problem, isBusy, send } = useAcceptance(edit, run, detail);
  if (change?.written) return <Written change={change} command={detail.command} />;
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        void send();
      }}
    >
      <Reason label="Reason" value={fields.reason} onChange={(reason) => set({ reason })} />
      <label class="field">
        Last day on which it counts, if there is one
        <input
          type="date"
          value={fields.until}
          onInput={(event) => set({ until: event.currentTarget.value })}
        />
      </label>
      <button disabled={isBusy || fields.reason.trim() === ""}>Show the change</button>
      {problem ? <p role="alert">Nothing was written: {problem}</p> : null}
      {change ? (
        <Proposal
          change={change}
          isBusy={isBusy}
          onWrite={() => void send(change.hash)}
          onDrop={drop}
        />
      ) : null}
    </form>
  );
}
