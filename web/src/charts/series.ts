// A renderer has the same colour and marker in every study and chart, also where some of the others are missing.

/** Those that orbs comes with, each at its place in the palette. */
const kPlaces = ["orbs", "cycles", "povray", "mitsuba", "pbrt", "hydra"];

const placeOf = (name: string): number =>
  kPlaces.findIndex((known) => name === known || name.startsWith(`${known}-`));

/** The series of each name: its own place if that is free, else the next free one. */
export function seriesOfNames(names: string[]): number[] {
  const taken = new Set<number>();
  const take = (place: number): number => {
    taken.add(place);
    return place;
  };
  const own = names.map((name) => {
    const place = placeOf(name);
    return place >= 0 && !taken.has(place) ? take(place) : -1;
  });
  return own.map((place) => {
    if (place >= 0) return place;
    let free = kPlaces.length;
    while (taken.has(free)) ++free;
    return take(free);
  });
}

const known = new WeakMap<object, number[]>();

/** The series of a renderer of a study. */
export function seriesOf({ renderers }: { renderers: { name: string }[] }, index: number): number {
  const series = known.get(renderers) ?? seriesOfNames(renderers.map(({ name }) => name));
  known.set(renderers, series);
  return series[index] ?? index;
}
