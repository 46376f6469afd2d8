import { TableHead } from "../common/TableHead";
import type { Session } from "../common/session";
import type { SceneEffects } from "../data/generated";
import { cellLink } from "../overview/Grid";
import {
  changeText,
  costOf,
  effectsOf,
  rangeText,
  spared,
  summaryOf,
  timesText,
} from "./effect_cells";
import { HowMeasured, Proof } from "./Proof";

const meanText = (change: number | undefined): string =>
  change === undefined ? "mean same but for noise" : `mean up to ${changeText(change)}`;

function Summary({ scenes, effects }: { scenes: SceneEffects[]; effects: string[] }) {
  return (
    <div class="effect-scroll" tabIndex={0} role="region" aria-label="Costs by effect">
      <table class="effect-summary">
        <TableHead
          columns={[
            { label: "Effect" },
            { label: "Scenes", isNumber: true },
            { label: "Time with it", isNumber: true, title: "median of the scenes; all scenes" },
            {
              label: "Image without it",
              title: "the largest change of an image's mean beyond three standard errors",
            },
          ]}
        />
        <tbody>
          {effects.map((effect) => {
            const { scenes: count, time, mostChange } = summaryOf(scenes, effect);
            return (
              <tr key={effect}>
                <th scope="row">{effect}</th>
                <td class="number">{count}</td>
                <td class="number">
                  {time ? (
                    <>
                      <b>{timesText(time)}</b> <small>{rangeText(time)}</small>
                    </>
                  ) : (
                    "not measured"
                  )}
                </td>
                <td>{time ? meanText(mostChange) : ""}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}

function Cell({ scene, effect, link }: { scene: SceneEffects; effect: string; link?: string }) {
  if (!scene.called_for.includes(effect))
    return (
      <td class="none" title={`${scene.name} does not call for ${effect}: it costs nothing`}>
        {link ? <a href={link}>0</a> : "0"}
        <span class="unseen"> not called for</span>
      </td>
    );
  const cost = costOf(scene, effect);
  const text = cost ? timesText(cost.time) : "needed";
  return (
    <td class="needs" title={cost ? `${cost.record.name}: ${cost.record.change}` : undefined}>
      {link ? <a href={link}>{text}</a> : text}
      {cost ? <small>{rangeText(cost.time)}</small> : null}
      {cost ? <small class="worth">{cost.record.change}</small> : null}
    </td>
  );
}

/** A line may end after an underscore. */
const breakable = (name: string) =>
  name.split(/(?<=_)/).flatMap((part, i) => (i ? [<wbr />, part] : [part]));

function SparedCell({ scene }: { scene: SceneEffects }) {
  const richest = spared(scene);
  if (!richest) return <td class="none">–</td>;
  const { time_ratio: value, time_low: low, time_high: high } = richest;
  return (
    <td title={`${richest.name}: ${richest.change}`}>
      {timesText({ value, low, high })}
      <small>{rangeText({ value, low, high })}</small>
    </td>
  );
}

function Matrix({ session, effects }: { session: Session; effects: string[] }) {
  const { scenes } = session.overview;
  const isMeasured = scenes.some(({ costs }) => costs.length > 0);
  return (
    <div class="effect-scroll" tabIndex={0} role="region" aria-label="Scenes and effects">
      <table class="effect-matrix">
        <TableHead
          columns={[
            { label: "Scene" },
            { label: "Light paths" },
            ...effects.map((label) => ({ label })),
            ...(isMeasured
              ? [
                  {
                    label: "If it carried more",
                    title: "time with the richer transport that costs most",
                  },
                ]
              : []),
          ]}
        />
        <tbody>
          {scenes.map((scene) => {
            const link = scene.cell === undefined ? {} : { link: cellLink(session, scene.cell) };
            return (
              <tr key={scene.name}>
                <th scope="row">
                  {link.link ? (
                    <a href={link.link}>{breakable(scene.name)}</a>
                  ) : (
                    breakable(scene.name)
                  )}
                </th>
                <td>{scene.transport}</td>
                {effects.map((effect) => (
                  <Cell key={effect} scene={scene} effect={effect} {...link} />
                ))}
                {isMeasured ? <SparedCell scene={scene} /> : null}
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}

/** The scenes of the run with the effects of light that each calls for, and what each costs. */
export function EffectsPage({ session }: { session: Session }) {
  const { scenes, effect_study: study } = session.overview;
  const effects = effectsOf(scenes);
  const plain = scenes.filter(({ transport }) => transport === "rgb").length;
  if (scenes.length === 0)
    return <p class="quiet">The run does not say what its scenes call for.</p>;
  return (
    <article class="effects-page">
      <h1>Which scenes need what, and what it costs</h1>
      <p>
        <b>
          {plain} of {scenes.length}
        </b>{" "}
        scenes need light paths of three colours only, and pay for nothing else.{" "}
        {study
          ? "× 1.20 means that the scene takes 20 % more CPU time than without the effect."
          : "The costs of the effects of this suite were not measured (orbs effect-cost)."}
      </p>
      <Summary scenes={scenes} effects={effects} />
      <h2>Scenes and effects</h2>
      <p class="quiet">
        0: the scene does not call for it, and it costs nothing. Needed: called for, cost not
        measured.
      </p>
      <Matrix session={session} effects={effects} />
      <Proof scenes={scenes} />
      {study ? <HowMeasured study={study} /> : null}
    </article>
  );
}
