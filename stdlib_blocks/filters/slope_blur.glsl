// SPDX-License-Identifier: Apache-2.0
const int MODE_BLUR = 0;
const int MODE_MIN = 1;
const int MODE_MAX = 2;

float weighed(float value) { return value; }
vec2 weighed(vec2 value) { return value; }
vec3 weighed(vec3 value) { return value; }
vec4 weighed(vec4 color) { return vec4(color.rgb * color.a, color.a); }

float straight(float value) { return value; }
vec2 straight(vec2 value) { return value; }
vec3 straight(vec3 value) { return value; }
vec4 straight(vec4 color) { return vec4(color.rgb / max(color.a, 1e-20), color.a); }

/// Smears whatever is connected along the slopes of a height: chipped edges, runny paint, worn
/// stone.
/// From uv it goes up the slope in as many equal shares of `amount` as there are taps, taking the
/// slope anew at each place, and gives the mean of the image at all places, the start among them,
/// or the least or the greatest of each component. A negative amount goes down. Each place has a
/// pixel that is as large as the step to it, so that few taps leave no gaps. Colours are weighed by
/// their alpha.
/// @source Substance 3D Designer and Material Maker, "Slope Blur"
/// @param image what is smeared
/// @param height the height whose slopes it follows
/// @param uv where to look @default uv
/// @param amount how far a slope of 1 leads, in the units of uv @default 0.05
/// @param taps in how many steps; the image is computed once more, the height four times as often
///   @default 6 @range 1 32
/// @param mode what becomes of the places: blur, their mean; min, max, the least or greatest
///   @default MODE_BLUR
/// @param smallest_step the least distance over which a slope is taken, in the units of uv
///   @default 0.0005 @range 1e-5 1
genType image(vec2 uv);
float height(vec2 uv);

genType slope_blur(vec2 uv, float amount, const int taps, const int mode, float smallest_step) {
  vec2 pixel = footprint(uv);
  vec2 apart = max(pixel, max(smallest_step, 1e-5));
  vec2 across = vec2(0.5 * apart.x, 0.0);
  vec2 along = vec2(0.0, 0.5 * apart.y);
  genType sum = weighed(image(uv));
  vec2 place = uv;
  for (int i = 0; i < taps; i++) {
    vec2 rise = vec2(height(widen(place + across, pixel, uv)) -
                         height(widen(place - across, pixel, uv)),
                     height(widen(place + along, pixel, uv)) -
                         height(widen(place - along, pixel, uv)));
    vec2 way = amount / float(taps) * rise / apart;
    place += way;
    genType seen = weighed(image(widen(place, sqrt(pixel * pixel + way * way), uv)));
    sum = mode == MODE_MIN ? min(sum, seen) : mode == MODE_MAX ? max(sum, seen) : sum + seen;
  }
  return straight(mode == MODE_BLUR ? sum / float(taps + 1) : sum);
}
