import { Scroll } from "../common/Scroll";
import { PairList } from "../common/PairList";
import { useRequest } from "../common/request";
import type { Source } from "../data/source";
import { note, type Route } from "../route";
import { SweepChart } from "./SweepChart";
import { capitalised, cellText, hasImages, magnitudeText, percentText, stepText } from "./texts";
import type { StabilityStep, StabilityStudy } from "../data/generated";

interface Props {
  source: Source;
  run: number;
  study: StabilityStudy;
  route: Route;
}

/** The matrix of relations and renderers; each cell chooses what is shown below. */
function Matrix({ study, chosen }: { study: StabilityStudy; chosen: string }) {
  const cellOf = (relation: string, renderer: string) =>
    study.matrix.find((cell) => cell.relation === relation && cell.renderer === renderer);
  return (
    <Scroll label="Changes and renderers">
      <table class="matrix">
        <thead>
          <tr>
            <th scope="col">change</th>
            {study.renderers.map(({ name }) => (
              <th key={name} scope="col">
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {study.relations.map((relation) => (
            <tr key={relation.name}>
              <th scope="row" title={relation.name}>
                {relation.change}
              </th>
              {study.renderers.map(({ name }) => {
                const cell = cellOf(relation.name, name);
                const key = `${relation.name}/${name}`;
                return (
                  <td key={name} class={cell?.first_break ? "broken" : undefined}>
                    {!cell ? (
                      "not measured"
                    ) : cell.scenes > 0 ? (
                      <button aria-pressed={key === chosen} onClick={() => note({ cell: key })}>
                        {cellText(cell, relation)}
                      </button>
                    ) : (
                      <span class="quiet" title={cell.why_not_applicable}>
                        {cellText(cell, relation)}
                      </span>
                    )}
                  </td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
    </Scroll>
  );
}

function Picture({
  source,
  run,
  file,
  label,
}: {
  source: Source;
  run: number;
  file: string;
  label: string;
}) {
  const { value, problem } = useRequest(`${run} ${file}`, "", () => source.picture(run, file));
  return (
    <figure>
      {value ? (
        <img src={value} alt={label} />
      ) : (
        <div class="quiet">{problem ? `no image: ${problem}` : "Reading …"}</div>
      )}
      <figcaption>{label}</figcaption>
    </figure>
  );
}

/** The images of a first break, or of single against double precision. */
function Pictures({
  source,
  run,
  step,
  title,
}: {
  source: Source;
  run: number;
  step: StabilityStep;
  title: string;
}) {
  return (
    <section class="pictures" aria-label={`Images of ${title}`}>
      <h3>{title}</h3>
      <p>{step.reason}</p>
      <div class="break">
        <Picture source={source} run={run} file={`${step.images}/original.png`} label="original" />
        <Picture source={source} run={run} file={`${step.images}/changed.png`} label="changed" />
        <Picture
          source={source}
          run={run}
          file={`${step.images}/difference.png`}
          label="changed − original"
        />
      </div>
    </section>
  );
}

/** One step: what came of it, and its numbers where images were compared. */
function StepRow({ step, scene, unit }: { step: StabilityStep; scene: string; unit: string }) {
  return (
    <tr>
      <td>{scene}</td>
      <td class="number">{magnitudeText(step.magnitude, unit)}</td>
      <td>{stepText(step)}</td>
      <td class="number">{hasImages(step) ? percentText(step.mean, step.mean_error) : ""}</td>
      <td class="number">{hasImages(step) ? percentText(step.block, step.block_error) : ""}</td>
      <td class="number">{hasImages(step) ? percentText(step.pixels, 0).replace("+", "") : ""}</td>
      <td class="quiet">{step.reason}</td>
    </tr>
  );
}

/** All steps of one relation by one renderer, and the images that were kept. */
function Steps({ source, run, study, chosen }: Omit<Props, "route"> & { chosen: string }) {
  const [name, renderer] = chosen.split("/");
  const relation = study.relations.find((one) => one.name === name);
  const steps = study.steps.filter(
    (step) =>
      study.relations[step.relation]?.name === name &&
      study.renderers[step.renderer]?.name === renderer,
  );
  if (!relation || steps.length === 0) return null;
  const titleOf = (step: StabilityStep): string => {
    const at = relation.is_sweep ? ` at ${magnitudeText(step.magnitude, relation.unit)}` : "";
    return `${study.scenes[step.scene]?.name}${at}`;
  };
  return (
    <section class="cost-panel" aria-label="Steps">
      <h2>
        {capitalised(relation.change)}: {renderer}
      </h2>
      <SweepChart study={study} relation={relation} steps={steps} />
      <Scroll label="Steps of the change">
        <table class="steps">
          <thead>
            <tr>
              {[
                "scene",
                "magnitude",
                "outcome",
                "mean",
                "worst block",
                "single pixels",
                "reason",
              ].map((head) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {steps.map((step) => (
              <StepRow
                key={`${step.scene} ${step.magnitude}`}
                step={step}
                scene={study.scenes[step.scene]?.name ?? ""}
                unit={relation.unit}
              />
            ))}
          </tbody>
        </table>
      </Scroll>
      {steps
        .filter((step) => step.images)
        .map((step) => (
          <Pictures key={step.images} source={source} run={run} step={step} title={titleOf(step)} />
        ))}
    </section>
  );
}

/** Metamorphic tests: transformed scenes, and whether the images are what the transformation implies. */
export function StabilityPage({ source, run, study, route }: Props) {
  const firstBroken = study.matrix.find((cell) => cell.first_break) ?? study.matrix[0];
  const usual = firstBroken ? `${firstBroken.relation}/${firstBroken.renderer}` : "";
  const chosen = route.query["cell"] || usual;
  const { settings } = study;
  const rows: [string, string][] = [
    ["Scenes", study.scenes.map(({ name }) => name).join(", ")],
    ["Renderers", study.renderers.map(({ name, version }) => `${name}: ${version}`).join("; ")],
    [
      "Images",
      `at most ${settings.size_px} px, ${settings.spp} samples per pixel, ${settings.seeds} seeds`,
    ],
    ...study.definitions.map(({ name, text }): [string, string] => [name, text]),
  ];
  return (
    <>
      <section class="cost-panel" aria-label="How far each renderer follows">
        <h1>How far does each renderer follow?</h1>
        {study.summaries.map((text) => (
          <p key={text}>{text}</p>
        ))}
        <Matrix study={study} chosen={chosen} />
      </section>
      <Steps source={source} run={run} study={study} chosen={chosen} />
      <section class="cost-panel about" aria-label="How it was measured">
        <h2>How it was measured</h2>
        <PairList pairs={rows} />
      </section>
    </>
  );
}
