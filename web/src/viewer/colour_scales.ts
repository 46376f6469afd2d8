// The colour scales of src/image/false_colour.cpp, so that the page and the PNGs of a run agree. In
// the sequential scale lightness is linear in the value; in the diverging scale values of equal
// magnitude are equally light.

type Rgb = [number, number, number];

// OKLab to linear Rec.709: B. Ottosson, "A perceptual color space for image processing", 2020.
function linearRgb(lightness: number, chroma: number, hueDegrees: number): Rgb {
  const a = chroma * Math.cos((hueDegrees * Math.PI) / 180);
  const b = chroma * Math.sin((hueDegrees * Math.PI) / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}

export const srgbEncode = (v: number): number =>
  v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055;

function bytesOf(rgb: Rgb): number[] {
  return [...rgb.map((v) => Math.round(255 * srgbEncode(Math.min(1, Math.max(0, v))))), 255];
}

/** In the order of the rows of the painter's texture. */
export const kColourScales = ["sequential", "diverging", "noise"] as const;
export type ColourScale = (typeof kColourScales)[number];

export const scaleOf = ({
  noise,
  diverging,
}: {
  noise: boolean;
  diverging: boolean;
}): ColourScale => (noise ? "noise" : diverging ? "diverging" : "sequential");

/**
 * Of differences over their noise, from -1 to 1: grey as long as noise explains them, to the half of the scale,
 * which is 3 sigma; beyond it blue-green or red. Neither lies near the magenta of bad pixels.
 */
function noiseColour(t: number): Rgb {
  const size = Math.abs(t);
  const beyond = Math.max(0, 2 * size - 1);
  const chroma = size > 0.5 ? 0.045 + 0.065 * beyond : 0.03 * size;
  return linearRgb(0.2 + 0.2 * size + 0.3 * beyond, chroma, t < 0 ? 195 : 30);
}

/** 256 RGBA colours, from 0 to the end of the scale; a diverging scale starts at minus its end. */
export function scaleBytes(scale: ColourScale): Uint8Array {
  const out: number[] = [];
  for (let i = 0; i < 256; ++i) {
    if (scale === "noise") {
      out.push(...bytesOf(noiseColour((i / 255) * 2 - 1)));
    } else if (scale === "diverging") {
      const t = (i / 255) * 2 - 1;
      out.push(
        ...bytesOf(linearRgb(0.12 + 0.63 * Math.abs(t), 0.13 * Math.abs(t), t < 0 ? 255 : 50)),
      );
    } else {
      const t = i / 255;
      out.push(...bytesOf(linearRgb(0.15 + 0.83 * t, 0.045 + 0.52 * t * (1 - t), 290 + 175 * t)));
    }
  }
  return new Uint8Array(out);
}
