// One pass that turns raw values into colours. Images are integer textures: NaN and infinity are
// read from the bits of a value, because a compiler may reduce isnan of GLSL to "false".

export const kVertexShader = `#version 300 es
void main() {
  // One triangle that covers the viewport.
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}`;

export const kFragmentShader = `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;

// The channels that are shown; a single channel is the first.
uniform usampler2D first;
uniform usampler2D second;
uniform usampler2D third;
uniform bvec3 areHalf;
uniform bool isColour;
uniform bool isLuminance;
uniform sampler2D scaleColours;
uniform ivec2 size;
uniform vec2 paneOrigin;      // top left corner of the pane on the canvas, pixels
uniform float canvasHeight;
uniform vec2 origin;          // position in the image of the pane's top left corner
uniform float zoom;           // screen pixels per pixel
uniform float gain;
uniform float offset;
uniform int curve;            // 0 sRGB, 1 gamma, 2 linear
uniform float inverseGamma;
uniform bool falseColour;
uniform bool isDiverging;
uniform bool isNoise;          // NaN has no noise
uniform float scaleRow;
uniform bool isLog;
uniform float scaleEnd;
uniform bool zebra;
uniform vec3 surround;
out vec4 seen;

const vec3 kBad = vec3(1.0, 0.0, 1.0);
const float kDecades = 4.0;   // of a logarithmic scale

// How many of the values that were read have no noise.
int withoutNoise = 0;

float numberAt(uint bits, bool isHalf, inout bool bad) {
  uint exponent = isHalf ? (bits >> 10) & 31u : (bits >> 23) & 255u;
  bool isNaN = (bits & (isHalf ? 1023u : 8388607u)) != 0u;
  if (exponent == (isHalf ? 31u : 255u)) {
    if (isNoise && isNaN) ++withoutNoise;
    else bad = true;
    return 0.0;
  }
  return isHalf ? unpackHalf2x16(bits).x : uintBitsToFloat(bits);
}

vec3 pixelAt(ivec2 at, inout bool bad) {
  float one = numberAt(texelFetch(first, at, 0).r, areHalf.x, bad);
  if (!isColour) return vec3(one);
  float two = numberAt(texelFetch(second, at, 0).r, areHalf.y, bad);
  float three = numberAt(texelFetch(third, at, 0).r, areHalf.z, bad);
  return vec3(one, two, three);
}

float scalarOf(vec3 v) {
  if (isLuminance) return dot(v, vec3(0.2126, 0.7152, 0.0722));
  float largest = v.r;
  if (abs(v.g) > abs(largest)) largest = v.g;
  if (abs(v.b) > abs(largest)) largest = v.b;
  return largest;
}

float encoded(float v) {
  if (curve == 2) return v;
  if (curve == 1) return sign(v) * pow(abs(v), inverseGamma);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

bool stripes() { return mod(gl_FragCoord.x + gl_FragCoord.y, 12.0) < 6.0; }

vec3 colouredScalar(float s) {
  float t = scaleEnd > 0.0 ? s / scaleEnd : 0.0;
  bool beyond = abs(t) > 1.0 || (!isDiverging && t < 0.0);
  if (isLog && abs(t) > 0.0)
    t = sign(t) * max(0.0, 1.0 + log(abs(t)) / (log(10.0) * kDecades));
  if (zebra && beyond && stripes()) return vec3(t > 0.0 ? 0.0 : 1.0);
  float place = isDiverging ? 0.5 + 0.5 * clamp(t, -1.0, 1.0) : clamp(t, 0.0, 1.0);
  return texture(scaleColours, vec2((place * 255.0 + 0.5) / 256.0, scaleRow)).rgb;
}

void main() {
  vec2 onPane = vec2(gl_FragCoord.x, canvasHeight - gl_FragCoord.y) - paneOrigin;
  vec2 place = origin + onPane / zoom;
  if (any(lessThan(place, vec2(0.0))) || any(greaterThanEqual(place, vec2(size)))) {
    seen = vec4(surround, 1.0);
    return;
  }
  // Below a zoom of 1 a screen pixel is the mean of the pixels that it covers, and magenta if one
  // of them is bad. 64 x 64 taps suffice for the largest textures at the smallest zoom.
  int taps = zoom < 1.0 ? int(min(64.0, ceil(1.0 / zoom))) : 1;
  bool bad = false;
  vec3 sum = vec3(0.0);
  for (int j = 0; j < taps; ++j)
    for (int i = 0; i < taps; ++i) {
      vec2 inside = taps == 1 ? vec2(0.0) : (vec2(float(i), float(j)) / float(taps)) / zoom;
      sum += pixelAt(min(ivec2(place + inside), size - 1), bad);
    }
  if (bad) { seen = vec4(kBad, 1.0); return; }
  if (withoutNoise == taps * taps * (isColour ? 3 : 1)) {
    seen = vec4(vec3(stripes() ? 0.42 : 0.3), 1.0);
    return;
  }
  vec3 v = sum / float(taps * taps);
  if (falseColour) { seen = vec4(colouredScalar(scalarOf(v)), 1.0); return; }
  if (isLuminance) v = vec3(scalarOf(v));
  v = v * gain + offset;
  if (zebra && any(greaterThan(v, vec3(1.0))) && stripes()) {
    seen = vec4(0.0, 0.0, 0.0, 1.0);
    return;
  }
  if (zebra && any(lessThan(v, vec3(0.0))) && stripes()) { seen = vec4(1.0); return; }
  seen = vec4(encoded(v.r), encoded(v.g), encoded(v.b), 1.0);
}`;
