import type { EffectStudyRecord, SceneEffects } from "../data/generated";
import unused from "./unused_costs.json";

/** Why what a scene does not call for costs nothing. */
export function Proof({ scenes }: { scenes: SceneEffects[] }) {
  const richer = scenes
    .flatMap(({ costs }) => costs)
    .filter(({ is_enough, is_comparable }) => is_enough && is_comparable);
  const differing = richer.filter(({ change }) => change.startsWith("DIFFERS")).length;
  const equal = richer.filter(({ is_equal }) => is_equal).length;
  return (
    <section class="effect-notes">
      <h2>What is not called for costs nothing</h2>
      <ul>
        <li>
          <b>{Math.abs((unused.unused_ratio - 1) * 100).toFixed(3)} % more instructions</b> for
          eight materials, a texture and two spectra that no surface shows;{" "}
          <b>{((unused.used_ratio - 1) * 100).toFixed(1)} %</b> more as soon as one of them is on a
          ball. Counted with callgrind, whose counts scatter by 0.0003 % from call to call, without
          a clock: {unused.without.toLocaleString("en")} instructions for{" "}
          {unused.samples.toLocaleString("en")} samples of {unused.scene}. The test{" "}
          <code>Structure.UnusedAssetsCostNoInstructions</code> counts them again.
        </li>
        <li>
          Each transport has its own path loop. The test{" "}
          <code>Structure.PathLoopsHoldOnlyWhatScenesCallFor</code> reads the symbols of each loop
          and finds none of the effects that it does not carry.
        </li>
        {richer.length > 0 ? (
          <li>
            <b>
              {equal} of {richer.length}
            </b>{" "}
            measurements with a richer transport than the scene calls for gave the same image to the
            bit;{" "}
            {differing > 0
              ? `${differing} differ beyond noise, which is an error; the rest are the same but for noise.`
              : "all others are the same but for noise."}
          </li>
        ) : null}
      </ul>
    </section>
  );
}

function loadText(study: EffectStudyRecord): string {
  const end = study.load_end === undefined ? "" : ` and ${study.load_end.toFixed(1)} at the end`;
  const start = `The load was ${study.load.toFixed(1)} at the start${end}, on ${study.cores} cores.`;
  if (study.renders === undefined || study.disturbed === undefined)
    return `${start} What else the machine did was not measured for each render, so it may not have been clean.`;
  const unknown = study.unknown ? ` Of ${study.unknown} renders it is not known.` : "";
  return `${start} Other work took more than 5 % of the machine in ${study.disturbed} of ${study.renders} renders, after ${study.repeats ?? 0} repeats.${unknown}`;
}

function selfText(study: EffectStudyRecord): string {
  const { self_ratio: ratio, self_low: low, self_high: high, self_scenes: count } = study;
  if (ratio === undefined || low === undefined || high === undefined || !count)
    return "No scene was compared with itself (A/A), so small ratios are not proved to be real.";
  const verdict =
    low > 1 || high < 1
      ? "which is a difference where there is none: do not trust small ratios"
      : "so no difference was found where there is none";
  return `Each scene was also rendered twice in the same way (A/A): × ${ratio.toFixed(3)} (95 %: ${low.toFixed(3)} to ${high.toFixed(3)}), ${verdict}. ${study.self_differing ?? 0} of ${count} scenes alone show a difference; chance is 1 in 20.`;
}

/** How the costs were measured, and how far they can be trusted. */
export function HowMeasured({ study }: { study: EffectStudyRecord }) {
  return (
    <section class="effect-notes">
      <h2>How the costs were measured</h2>
      <p>
        {study.started.replace("T", " ")}, {study.cpu}, {study.rounds} rounds of {study.spp} samples
        per pixel at {study.size_px} px, CPU time, always with the same random numbers. The ranges
        in the table are{" "}
        {study.has_intervals
          ? "95 % intervals over the rounds."
          : "the smallest and the largest ratio of a round, not 95 % intervals."}
      </p>
      <p>{loadText(study)}</p>
      <p>{selfText(study)}</p>
    </section>
  );
}
