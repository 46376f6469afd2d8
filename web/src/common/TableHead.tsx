export interface Column {
  label: string;
  /** What the column shows, for the tooltip of its head. */
  title?: string;
  /** Numbers are aligned right, and their head with them. */
  isNumber?: boolean;
}

/** The head of a table of records. */
export function TableHead({ columns }: { columns: Column[] }) {
  return (
    <thead>
      <tr>
        {columns.map(({ label, title, isNumber }) => (
          <th key={label} scope="col" class={isNumber ? "number" : undefined} title={title}>
            {label}
          </th>
        ))}
      </tr>
    </thead>
  );
}
