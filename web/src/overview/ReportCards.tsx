import { useRelated } from "../common/related";
import { runQuery, type Session } from "../common/session";
import { lookOf } from "../common/states";
import { TableHead, type Column } from "../common/TableHead";
import type { Overview, ReportCard, TroubleGroup } from "../data/generated";
import { effectsOf } from "../effects/effect_cells";
import { routeText } from "../route";
import { costSaid, stabilitySaid, type Said } from "./card_texts";
import { cellLink } from "./Grid";
import { RendererTable } from "./RendererTable";

const kColumns: Column[] = [
  { label: "Renderer" },
  { label: "Is it right?" },
  { label: "What does it cost?" },
  { label: "Does it stay right?" },
];

const kTones: Record<string, { symbol: string; tone: string }> = {
  right: { symbol: "✓", tone: "good" },
  known: { symbol: "≈", tone: "good" },
  wrong: { symbol: "✗", tone: "bad" },
  undecided: { symbol: "?", tone: "unsure" },
  open: { symbol: "·", tone: "quiet" },
};

/** So many groups stand open; the others are folded away. */
const kShown = 2;
const kLinks = 6;

const capitalised = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** The place of the first of the cells that is of the same target. */
const firstOf = ({ cells }: Overview, all: number[], cell: number): number =>
  all.findIndex((other) => cells.target[other] === cells.target[cell]);

function Group({ session, group }: { session: Session; group: TroubleGroup }) {
  const { overview } = session;
  const state = overview.states.find(({ name }) => name === group.state);
  const look = lookOf(state);
  // A target that several requirements judge is named once.
  const cells = group.targets.filter((cell, i) => firstOf(overview, group.targets, cell) === i);
  const links = cells.slice(0, kLinks);
  return (
    <li>
      <span class={`tone-${look.tone}`}>
        <span aria-hidden="true">{look.symbol}</span> {group.state}
      </span>
      {": "}
      {group.diagnosis ? <b>{group.what}</b> : group.what} <span class="quiet">in</span>{" "}
      {links.map((cell, i) => (
        <>
          {i > 0 ? ", " : ""}
          <a href={cellLink(session, cell)}>
            {overview.targets[overview.cells.target[cell] ?? -1]}
          </a>
        </>
      ))}
      {cells.length > kLinks ? ` and ${cells.length - kLinks} more` : ""}
    </li>
  );
}

function Groups({ session, groups }: { session: Session; groups: TroubleGroup[] }) {
  const item = (group: TroubleGroup) => (
    <Group key={`${group.state} ${group.what}`} session={session} group={group} />
  );
  if (groups.length === 0) return null;
  const more = groups.slice(kShown);
  return (
    <>
      <ul class="troubles">{groups.slice(0, kShown).map(item)}</ul>
      {more.length > 0 ? (
        <details class="troubles-more">
          <summary>and {more.length} more</summary>
          <ul class="troubles">{more.map(item)}</ul>
        </details>
      ) : null}
    </>
  );
}

function SaidCell({ session, label, said }: { session: Session; label: string; said: Said }) {
  const { runs } = session.source;
  return (
    <td data-label={label}>
      {capitalised(said.text)}{" "}
      <span class="quiet said-by">
        {said.run === undefined ? (
          said.source
        ) : (
          <a href={routeText({ path: [], query: { run: runs[said.run] ?? "" } })}>{said.source}</a>
        )}
      </span>
    </td>
  );
}

interface CardProps {
  session: Session;
  card: ReportCard;
  cost: Said;
  stability: Said;
}

function Card({ session, card, cost, stability }: CardProps) {
  const look = kTones[card.standing] ?? { symbol: "·", tone: "quiet" };
  const renderer = session.overview.renderers.find(({ name }) => name === card.renderer);
  return (
    <tr class="card">
      <th scope="row">
        {card.renderer} <span class="quiet">{renderer?.version}</span>
      </th>
      <td data-label="Is it right?">
        <p class={`card-sentence tone-${look.tone}`}>
          <span aria-hidden="true">{look.symbol}</span> {capitalised(card.sentence)}
        </p>
        <Groups session={session} groups={card.groups} />
      </td>
      <SaidCell session={session} label="What does it cost?" said={cost} />
      <SaidCell session={session} label="Does it stay right?" said={stability} />
    </tr>
  );
}

/** Which effects the scenes of the run call for, the most frequent first. */
function EffectsLine({ session }: { session: Session }) {
  const { scenes } = session.overview;
  const counts = effectsOf(scenes)
    .map((effect) => ({
      effect,
      count: scenes.filter((one) => one.called_for.includes(effect)).length,
    }))
    .filter(({ count }) => count > 0)
    .sort((a, b) => b.count - a.count);
  if (counts.length === 0) return null;
  const texts = counts.map(({ effect, count }) => `${effect} (${count})`);
  return (
    <p class="effects-line">
      <b>What is called for?</b> Of {scenes.length} scenes: {texts.join(", ")}. What a scene does
      not call for costs nothing:{" "}
      <a href={routeText({ path: ["effects"], query: runQuery(session.source, session.run) })}>
        effects and their costs
      </a>
      .
    </p>
  );
}

/** The answer for each renderer in one screen: is it right, what does it cost, does it stay right. */
export function ReportCards({ session }: { session: Session }) {
  const { overview, source } = session;
  const related = useRelated(source, overview.run.suite);
  const { cards } = overview;
  return (
    <section class="renderers" aria-label="Report cards" tabIndex={0}>
      <table class="cards">
        <TableHead columns={kColumns} />
        <tbody>
          {cards.map((card) => (
            <Card
              key={card.renderer}
              session={session}
              card={card}
              cost={costSaid(card, cards, related)}
              stability={stabilitySaid(card, related)}
            />
          ))}
        </tbody>
      </table>
      {overview.left_out.map(({ renderer, reason }) => (
        <p class="quiet" key={renderer}>
          {renderer} was left out: {reason}
        </p>
      ))}
      <EffectsLine session={session} />
      <details class="declared">
        <summary>What each declares, has measured and took</summary>
        <RendererTable overview={overview} />
      </details>
    </section>
  );
}
