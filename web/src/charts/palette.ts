// Okabe and Ito's colours, which people with any kind of colour vision tell apart; darkened for white paper where the
// originals are too light.
const light = [
  "#0072b2",
  "#b85600",
  "#007f5c",
  "#a3437f",
  "#7d6a00",
  "#2b88b8",
  "#5a5a5a",
  "#8c2d04",
];
const dark = [
  "#56b4e9",
  "#e69f00",
  "#3ec79b",
  "#e18dc0",
  "#f0e442",
  "#8fc9f0",
  "#c0c0c0",
  "#ff8c5a",
];

export const seriesColour = (index: number, isDark: boolean): string => {
  const palette = isDark ? dark : light;
  return palette[index % palette.length] ?? "#888888";
};
