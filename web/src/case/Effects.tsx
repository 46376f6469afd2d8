import { TableHead, type Column } from "../common/TableHead";
import type { EffectRecord, SceneRecord, TargetDetail } from "../data/generated";

const kColumns: Column[] = [
  { label: "Transport" },
  {
    label: "Time",
    isNumber: true,
    title: "CPU time per sample, relative to the transport that the scene calls for",
  },
  {
    label: "To equal noise",
    isNumber: true,
    title: "CPU time to equal noise, relative to the transport that the scene calls for",
  },
  { label: "Change of the image" },
];

/** Groups the parts of a scene by effect; the first of a group stands for all. */
function grouped(effects: EffectRecord[]): { first: EffectRecord; others: number }[] {
  const groups = new Map<string, { first: EffectRecord; others: number }>();
  for (const one of effects) {
    const group = groups.get(one.effect);
    if (group) ++group.others;
    else groups.set(one.effect, { first: one, others: 0 });
  }
  return [...groups.values()];
}

function List({ effects }: { effects: EffectRecord[] }) {
  return (
    <ul>
      {grouped(effects).map(({ first, others }) => (
        <li key={first.effect}>
          <b>{first.effect}</b>: {first.subject} {first.reason}
          {others > 0 ? <span class="quiet"> and {others} more</span> : null}
        </li>
      ))}
    </ul>
  );
}

const times = (ratio: number) => (ratio > 0 ? `× ${ratio.toFixed(2)}` : "–");

function EffectCosts({ scene }: { scene: SceneRecord }) {
  return (
    <table>
      <caption>Effect cost, relative to {scene.transport} transport</caption>
      <TableHead columns={kColumns} />
      <tbody>
        {scene.effect_costs.map((cost) => (
          <tr key={cost.name}>
            <th scope="row">{cost.name}</th>
            <td class="number">{times(cost.time_ratio)}</td>
            <td class="number">{times(cost.error_ratio)}</td>
            <td>{cost.change}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** The effects that the scene calls for, their cost, and how the image changes without them. */
export function Effects({ detail }: { detail: TargetDetail }) {
  return (
    <>
      {detail.scenes
        .filter((scene) => scene.called_for.length > 0 || scene.effect_costs.length > 0)
        .map((scene) => (
          <section key={scene.name} class="effects">
            <h2>
              {scene.name} calls for {scene.transport} light paths
              {scene.features ? `, feature number ${scene.features}` : ""}
            </h2>
            <List effects={scene.called_for} />
            {scene.not_called_for.length > 0 ? (
              <>
                <p class="quiet">Not needed, although the scene names it:</p>
                <List effects={scene.not_called_for} />
              </>
            ) : null}
            {scene.effect_costs.length > 0 ? <EffectCosts scene={scene} /> : null}
          </section>
        ))}
    </>
  );
}
