/** Names with their values, one pair a line; a name stands once in the list. */
export function PairList({ pairs, kind }: { pairs: [string, string][]; kind?: string }) {
  return (
    <dl class={kind}>
      {pairs.map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}
