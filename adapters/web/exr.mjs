// Writes OpenEXR files: scan lines of 32-bit floats without compression, as "OpenEXR File Layout" describes them.

const kMagic = 20000630;
const kVersion = 2; // one part of scan lines, names of at most 31 characters
const kFloat = 2;

const int32 = (...values) => Buffer.from(new Int32Array(values).buffer);
const float32 = (...values) => Buffer.from(new Float32Array(values).buffer);
const text = (value) => Buffer.from(`${value}\0`);

function attribute(name, type, value) {
  return Buffer.concat([text(name), text(type), int32(value.length), value]);
}

/** Each channel: its name, its type, whether it is perceptually linear (of no meaning here), and a sample per pixel. */
function channelList(names) {
  const one = (name) => Buffer.concat([text(name), int32(kFloat, 0, 1, 1)]);
  return Buffer.concat([...names.map(one), Buffer.from([0])]);
}

function header(width, height, names, strings) {
  const box = int32(0, 0, width - 1, height - 1);
  return Buffer.concat([
    int32(kMagic, kVersion),
    attribute("channels", "chlist", channelList(names)),
    attribute("compression", "compression", Buffer.from([0])),
    attribute("dataWindow", "box2i", box),
    attribute("displayWindow", "box2i", box),
    attribute("lineOrder", "lineOrder", Buffer.from([0])), // from the top
    attribute("pixelAspectRatio", "float", float32(1)),
    attribute("screenWindowCenter", "v2f", float32(0, 0)),
    attribute("screenWindowWidth", "float", float32(1)),
    ...Object.entries(strings).map(([name, value]) =>
      attribute(name, "string", Buffer.from(value)),
    ),
    Buffer.from([0]),
  ]);
}

/**
 * The bytes of a file with the channels R, G and B. `pixels` holds four floats of each pixel, of which the last is not
 * written, row by row from the top; `strings` become attributes.
 */
export function exrBytes(width, height, pixels, strings = {}) {
  if (pixels.length !== 4 * width * height)
    throw new Error(`an image of ${width} x ${height} pixels has ${pixels.length} numbers`);
  const planes = { B: 2, G: 1, R: 0 }; // in the order of their names, as the format demands
  const names = Object.keys(planes);
  const head = header(width, height, names, strings);
  const rowBytes = 4 * names.length * width;
  const chunkBytes = 8 + rowBytes; // its y and its length come first
  const offsets = new BigInt64Array(height);
  const chunks = [];
  for (let y = 0; y < height; ++y) {
    offsets[y] = BigInt(head.length + 8 * height + y * chunkBytes);
    const row = names.flatMap((name) =>
      Array.from({ length: width }, (_, x) => pixels[4 * (y * width + x) + planes[name]]),
    );
    chunks.push(int32(y, rowBytes), float32(...row));
  }
  return Buffer.concat([head, Buffer.from(offsets.buffer), ...chunks]);
}
