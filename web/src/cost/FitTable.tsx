import { Scroll } from "../common/Scroll";
import { seconds } from "../common/format";
import { TableHead, type Column } from "../common/TableHead";
import { withEnds } from "./quantities";
import type { CostCurve, CostStudy } from "../data/generated";

const kColumns: Column[] = [
  { label: "Renderer" },
  { label: "Fixed cost", title: "CPU seconds of an image of 4 x 4 px: start, reading, building" },
  {
    label: "Trials",
    title: "seconds of trial renderings at the last setting, where the renderer states them",
  },
  {
    label: "Own time",
    title: "seconds at the last setting, start and files left out, as the renderer states them",
  },
  { label: "v", title: "relMSE(t) = b² + v / tᵖ, t in CPU seconds above the fixed cost" },
  { label: "p", title: "1 for independent samples; larger is faster" },
  { label: "b²", title: "the part of the relMSE that no time removes" },
  { label: "Misfit", title: "chi² per degree of freedom: about 1 where the curve fits its points" },
  { label: "Floor" },
];

function floorText({ fit }: CostCurve): string {
  if (!fit) return "not fitted";
  if (!fit.has_floor) return "none shown";
  return fit.floor_named ? `yes: ${fit.floor_named}` : "yes";
}

/** The fitted curves of one target in numbers. */
export function FitTable({ study, curves }: { study: CostStudy; curves: CostCurve[] }) {
  return (
    <Scroll label="Fits of the curves">
      <table class="fits">
        <TableHead columns={kColumns} />
        <tbody>
          {curves.map((curve) => (
            <tr key={curve.renderer}>
              <th scope="row">{study.renderers[curve.renderer]?.name}</th>
              <td>{withEnds(curve.fixed_cpu_seconds, seconds)}</td>
              <td>{withEnds(curve.points.at(-1)?.trial_seconds ?? null, seconds)}</td>
              <td>{withEnds(curve.points.at(-1)?.render_seconds ?? null, seconds)}</td>
              <td>{withEnds(curve.fit?.variance ?? null)}</td>
              <td>{withEnds(curve.fit?.exponent ?? null)}</td>
              <td>{withEnds(curve.fit?.bias_squared ?? null)}</td>
              <td>{curve.fit ? curve.fit.misfit.toPrecision(2) : "–"}</td>
              <td>{floorText(curve)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      {curves
        .map(({ renderer, note, unmeasured }) => ({
          renderer,
          text: [note, unmeasured].filter((one) => one).join("; "),
        }))
        .filter(({ text }) => text)
        .map(({ renderer, text }) => (
          <p class="quiet" key={renderer}>
            {study.renderers[renderer]?.name}: {text}
          </p>
        ))}
    </Scroll>
  );
}
