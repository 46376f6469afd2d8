// Random numbers for the path tracer, in its shaders: see render.mjs.
//
// Each use of random numbers in a pixel has an id of its own, and with it a sequence of its own: points of Sobol' in one or two
// dimensions, whose order and digits are scrambled (B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020). So the
// samples of a pixel are even, no two uses depend on each other, and neither do the images of two seeds.
import { wgsl, wgslFn } from "three/tsl";

// The pixel, the number of the path that is the first of a seed, the bounce, and the path in the pixel.
const place = wgsl("var<private> orbsPlace: vec4u;");

// A hash of four numbers to four (M. Jarzynski and M. Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020).
const keysOf = wgslFn(
  `
  fn orbsKeysOf( id: u32 ) -> vec4u {
    var v = vec4u( orbsPlace.xyz, id ) * 1664525u + 1013904223u;
    v += v.yzxy * v.wxyz;
    v ^= v >> vec4u( 16u );
    v += v.yzxy * v.wxyz;
    return v;
  }
`,
  [place],
);

// Each bit is flipped or not by those above it: S. Laine and T. Karras' permutation, which looks at those below, of the
// reversed bits.
const scrambled = wgslFn(`
  fn orbsScrambled( bits: u32, key: u32 ) -> u32 {
    var x = reverseBits( bits ) + key;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reverseBits( x );
  }
`);

// The second coordinate of Sobol's points: each direction is the one before it, xor itself shifted by one. The first one is the
// reversed index.
const secondOfSobol = wgslFn(`
  fn orbsSecondOfSobol( index: u32 ) -> u32 {
    var sum = 0u;
    var direction = 0x80000000u;
    for ( var rest = index; rest != 0u; rest >>= 1u ) {
      sum ^= direction * ( rest & 1u );
      direction ^= direction >> 1u;
    }
    return sum;
  }
`);

// The upper 24 bits are a float below 1.
const pointOf = wgslFn(
  `
  fn orbsPointOf( id: u32 ) -> vec2f {
    let keys = orbsKeysOf( id );
    let index = orbsScrambled( orbsPlace.w, keys.x );
    let bits = vec2u(
      orbsScrambled( reverseBits( index ), keys.y ), orbsScrambled( orbsSecondOfSobol( index ), keys.z ) );
    return vec2f( bits >> vec2u( 8u ) ) * 0x1p-24f;
  }
`,
  [keysOf, scrambled, secondOfSobol, place],
);

// The path tracer has fewer ids than that; in its rand3, the first number chooses a lamp and the others a point of it.
const kFurtherId = 1024;

/** The scatterings before the surface that the path tracer looks at. */
export const bounce = wgslFn("fn orbsBounce() -> u32 { return orbsPlace.z; }", [place]);

/** What the path tracer calls: `rngInit` before it draws numbers at a bounce of a path, and the others with an id.
 * `firstPath` is the number of the first path of each pixel. */
export function randomNumbers(firstPath) {
  const rngInit = wgslFn(
    `
    fn orbsPlaceAt( pixel: vec2u, pathIndex: u32, bounceIndex: u32 ) -> void {
      orbsPlace = vec4u( pixel.x | ( pixel.y << 16u ), ${firstPath}u, bounceIndex, pathIndex - ${firstPath}u );
    }
  `,
    [place],
  );
  const draw = (count, value) =>
    wgslFn(
      `fn orbsRand${count}( id: u32 ) -> ${count > 1 ? `vec${count}f` : "f32"} { return ${value}; }`,
      [pointOf],
    );
  const further = `orbsPointOf( id + ${kFurtherId}u )`;
  return {
    rngInit,
    rngNextBounce: wgslFn("fn orbsNextBounce() -> void {}"),
    rand1: draw(1, "orbsPointOf( id ).x"),
    rand2: draw(2, "orbsPointOf( id )"),
    rand3: draw(3, `vec3f( ${further}.x, orbsPointOf( id ) )`),
    rand4: draw(4, `vec4f( ${further}, orbsPointOf( id ) )`),
  };
}
