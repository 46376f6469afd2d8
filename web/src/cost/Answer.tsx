import { seriesOf } from "../charts/series";
import { Choice } from "../common/Choice";
import { number } from "../common/format";
import {
  answerAt,
  levelsOf,
  mayRank,
  meanRatio,
  type LevelAnswer,
  type MeanRatio,
} from "./ranking";
import { RendererMark } from "./Marker";
import { lacksMeans } from "./older";
import { RendererKey } from "./Multiples";
import { fullestLevel } from "./ratio_bars";
import { RatioBars } from "./RatioBars";
import { levelText, metricName, ratioText } from "./quantities";
import { useTheme } from "./theme";
import type { CostStudy } from "../data/generated";

const excludesOne = ({ low, high }: MeanRatio): boolean => low > 1 || high < 1;
const short = (value: number): string => String(Number(value.toPrecision(2)));
const plural = (count: number, what: string): string => `${count} ${what}${count === 1 ? "" : "s"}`;

function ratioSentence(name: string, ratio: MeanRatio | undefined): string {
  if (!ratio) return `${name} cannot be compared there`;
  if (!excludesOne(ratio)) return `no difference is shown to ${name} on average`;
  return `${name} takes ${short(ratio.value)} times as long`;
}

/** Of more renderers, as of a study of algorithms, no sentence and no column can name all ratios. */
const kMostInColumns = 4;

/** The answer at one level in plain words. */
export function answerSentence(study: CostStudy, answer: LevelAnswer): string {
  const at = `At ${levelText(study, answer.metric, answer.level)}`;
  const { metric, level, leader, targets, unreached } = answer;
  const reached = targets - unreached;
  if (unreached === targets) return `${at}: no renderer reached it.`;
  if (leader === undefined)
    return `${at} no renderer is shown to be fastest more often than others.`;
  const name = study.renderers[leader]?.name ?? "";
  const others = study.renderers.flatMap((other, i) =>
    i === leader || study.renderers.length > kMostInColumns || lacksMeans(study)
      ? []
      : [ratioSentence(other.name, meanRatio(study, leader, i, metric, level))],
  );
  const all = plural(reached, "target");
  const of = unreached > 0 ? `the ${all} on which any renderer reaches it` : all;
  const wins = `${name} is fastest on ${answer.fastest[leader]} of ${of}`;
  return `${at} ${wins}${others.length > 0 ? `; ${others.join(", ")}` : ""}.`;
}

interface Part {
  key: string;
  count: number;
  text: string;
  renderer?: number;
  kind: string;
}

function partsOf(study: CostStudy, answer: LevelAnswer): Part[] {
  const each = (counts: number[], kind: string, text: (name: string) => string): Part[] =>
    study.renderers.map(({ name }, i) => ({
      key: `${kind} ${name}`,
      count: counts[i] ?? 0,
      text: text(name),
      renderer: i,
      kind,
    }));
  return [
    ...each(answer.fastest, "fastest", (name) => name),
    ...each(answer.only, "only", (name) => `only ${name}`),
    {
      key: "open",
      count: answer.open,
      text: "no difference",
      kind: "open",
    },
    {
      key: "unreached",
      count: answer.unreached,
      text: "not reached",
      kind: "unreached",
    },
  ].filter(({ count }) => count > 0);
}

const kMeanings: Record<string, string> = {
  fastest: "shown to be faster than all others that reach this quality",
  only: "no other renderer reached this quality",
  open: "no renderer is shown to be faster than all others",
  unreached: "no renderer reached this quality",
};

function Bar({ study, answer }: { study: CostStudy; answer: LevelAnswer }) {
  const theme = useTheme();
  const parts = partsOf(study, answer);
  return (
    <div class="wins">
      {parts.map(({ key, count, text, renderer, kind }) => (
        <span
          key={key}
          class={`win ${kind}`}
          title={`${kMeanings[kind]}: ${count} of ${plural(answer.targets, "target")}`}
          style={{
            flexGrow: count,
            ...(renderer === undefined
              ? {}
              : { borderColor: theme.series(seriesOf(study, renderer)) }),
            ...(kind === "fastest" && renderer !== undefined
              ? { background: `${theme.series(seriesOf(study, renderer))}33` }
              : {}),
          }}
        >
          {renderer === undefined ? null : <RendererMark study={study} renderer={renderer} />}
          <b>{count}</b> <span class="words">{text}</span>
        </span>
      ))}
    </div>
  );
}

/** What the frames of the parts of a bar mean. */
function BarKey() {
  return (
    <ul class="renderer-key">
      {[
        { kind: "fastest", text: "fastest" },
        { kind: "only", text: "the only one that reaches it" },
        { kind: "open", text: "no difference shown" },
        { kind: "unreached", text: "not reached" },
      ].map(({ kind, text }) => (
        <li key={kind} class="quiet">
          <span class={`win-sample ${kind}`} aria-hidden="true" />
          {text}
        </li>
      ))}
    </ul>
  );
}

interface RatiosProps {
  study: CostStudy;
  answer: LevelAnswer;
  /** The renderer whose time is 1. */
  base: number;
}

function Ratios({ study, answer: { metric, level }, base }: RatiosProps) {
  return (
    <ul class="ratios">
      {study.renderers.map(({ name }, i) => {
        const ratio = i === base ? undefined : meanRatio(study, base, i, metric, level);
        return ratio ? (
          <li key={name}>
            {name} <b>{ratioText(ratio)}</b>{" "}
            <span class="quiet">
              on {plural(ratio.count, "target")}
              {excludesOne(ratio) ? "" : ", no difference shown"}
            </span>
          </li>
        ) : null;
      })}
    </ul>
  );
}

function NotRanked({ study }: { study: CostStudy }) {
  const self = study.self_comparison;
  if (self?.passed !== false)
    return (
      <p class="quiet">
        Nobody is ranked{study.finished ? "" : " yet"}: the study has compared no two renderers.
      </p>
    );
  return (
    <div class="not-ranked" role="alert">
      <b>Nobody is ranked.</b> The same renderer was measured twice under two names, and was not
      shown to be like itself: time {ratioText(self.time_ratio)}, error{" "}
      {ratioText(self.error_ratio)}
      {self.known ? "" : "; too uncertain to show anything"}. Times of different renderers would not
      be believable either. Measure again on a quiet machine or with more seeds.
    </div>
  );
}

interface ManyProps {
  study: CostStudy;
  metric: string;
  answers: LevelAnswer[];
  base: number;
  /** The level that the address names. */
  level: string | undefined;
}

/** Many renderers at one level: how many times as long as one of them each takes. */
function ManyAnswer({ study, metric, answers, base, level: named }: ManyProps) {
  const theme = useTheme();
  const levels = answers.map(({ level }) => level);
  const level =
    levels.find((one) => String(one) === named) ?? fullestLevel(study, base, metric, levels);
  const answer = answers.find((one) => one.level === level);
  if (!answer || level === undefined) return null;
  return (
    <>
      <p class="answer">{answerSentence(study, answer)}</p>
      <p class="many-choices">
        <Choice
          label="CPU seconds to"
          param="at"
          chosen={String(level)}
          options={levels.map((one) => ({
            name: String(one),
            label: levelText(study, metric, one),
          }))}
        />{" "}
        <Choice
          label="as a multiple of those of"
          param="base"
          chosen={study.renderers[base]?.name ?? ""}
          options={study.renderers.map(({ name }) => ({ name, label: name }))}
        />
      </p>
      {lacksMeans(study) ? null : (
        <RatioBars study={study} theme={theme} base={base} metric={metric} level={level} />
      )}
    </>
  );
}

interface ColumnsProps {
  study: CostStudy;
  metric: string;
  answers: LevelAnswer[];
  wanted: LevelAnswer;
  base: number;
}

/** A few renderers at all levels: who is fastest on how many targets, and the ratios. */
function ColumnsAnswer({ study, metric, answers, wanted, base }: ColumnsProps) {
  return (
    <>
      <p class="answer">{answerSentence(study, wanted)}</p>
      <RendererKey study={study} />
      <BarKey />
      <table class="answer-table">
        <thead>
          <tr>
            <th scope="col">{metricName(metric)}</th>
            <th scope="col">Fastest in CPU seconds, number of targets</th>
            <th scope="col">
              <Choice
                label="Time, × that of"
                param="base"
                chosen={study.renderers[base]?.name ?? ""}
                options={study.renderers.map(({ name }) => ({ name, label: name }))}
              />
            </th>
          </tr>
        </thead>
        <tbody>
          {answers.map((answer) => (
            <tr key={answer.level} data-level={answer.level}>
              <th scope="row">
                {metric === "psnr_srgb8" ? `${answer.level} dB` : number(answer.level)}
              </th>
              <td>
                <Bar study={study} answer={answer} />
              </td>
              <td>
                <Ratios study={study} answer={answer} base={base} />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}

interface Props {
  study: CostStudy;
  metric: string;
  /** Name of the renderer whose time is 1; if it is none, the one that is fastest most often. */
  base: string | undefined;
  /** The level of a study with many renderers. */
  level: string | undefined;
}

/** Who is fastest at which quality. */
export function Answer({ study, metric, base: baseName, level }: Props) {
  if (study.renderers.length < 2)
    return <p class="quiet">One renderer alone has nobody to be compared with.</p>;
  if (!mayRank(study)) return <NotRanked study={study} />;
  const answers = levelsOf(study, metric).map((one) => answerAt(study, metric, one));
  const wanted =
    answers.find((one) => metric === "psnr_srgb8" && one.level === study.settings.target_db) ??
    answers[Math.floor(answers.length / 2)];
  if (!wanted) return <p class="quiet">The study has no times to error.</p>;
  const named = study.renderers.findIndex(({ name }) => name === baseName);
  const base = named >= 0 ? named : (wanted.leader ?? 0);
  return (
    <>
      {study.renderers.length > kMostInColumns ? (
        <ManyAnswer {...{ study, metric, answers, base, level }} />
      ) : (
        <ColumnsAnswer {...{ study, metric, answers, wanted, base }} />
      )}
      <p class="quiet">
        {lacksMeans(study)
          ? "An earlier orbs wrote this study, without mean ratios: `orbs cost --show` states them."
          : "Ratios are geometric means over the targets that both reach, with the 95 % interval " +
            "that follows from their scatter over the targets; of one target it is that of its seeds."}
        {study.self_comparison ? "" : " The study did not compare a renderer with itself."}
      </p>
    </>
  );
}
