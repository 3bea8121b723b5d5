// SPDX-License-Identifier: Apache-2.0
const int MODE_MIX = 0;
const int MODE_ADD = 1;
const int MODE_SUBTRACT = 2;
const int MODE_MULTIPLY = 3;
const int MODE_SCREEN = 4;
const int MODE_OVERLAY = 5;
const int MODE_DARKEN = 6;
const int MODE_LIGHTEN = 7;
const int MODE_DIFFERENCE = 8;
const int MODE_SOFT_LIGHT = 9;
const int MODE_HARD_LIGHT = 10;
const int MODE_EXCLUSION = 11;
const int MODE_COLOR_DODGE = 12;
const int MODE_COLOR_BURN = 13;
const int MODE_LINEAR_BURN = 14;
const int MODE_DIVIDE = 15;
const int MODE_HUE = 16;
const int MODE_SATURATION = 17;
const int MODE_COLOR = 18;
const int MODE_LUMINOSITY = 19;
const int MODE_LINEAR_LIGHT = 20;
const int MODE_VIVID_LIGHT = 21;
const int MODE_PIN_LIGHT = 22;
const int MODE_HARD_MIX = 23;
const int MODE_DARKER_COLOR = 24;
const int MODE_LIGHTER_COLOR = 25;

vec3 hard_light(vec3 front, vec3 back) {
  return mix(2.0 * back * front, 1.0 - 2.0 * (1.0 - back) * (1.0 - front), step(0.5, front));
}

// The standard's D(back) is the polynomial up to 0.25, and the root from there on. Both are 0.5 at
// 0.25, so the sum of both, each with its argument kept on its side, is D too.
vec3 soft_light(vec3 front, vec3 back) {
  vec3 low = min(back, 0.25);
  vec3 lighter = ((16.0 * low - 12.0) * low + 4.0) * low + (sqrt(max(back, 0.25)) - 0.5);
  return back + (2.0 * front - 1.0) * mix(back * (1.0 - back), lighter - back, step(0.5, front));
}

float least(vec3 color) { return min(min(color.r, color.g), color.b); }
float greatest(vec3 color) { return max(max(color.r, color.g), color.b); }
float luminosity(vec3 color) { return dot(color, vec3(0.3, 0.59, 0.11)); }

// The standard's SetLum and ClipColor: what leaves the range is drawn towards the grey of the same
// luminosity. The range ends at 1, or at the brightest component of the colour that gives the
// luminosity.
vec3 set_luminosity(vec3 color, vec3 giver) {
  float target = luminosity(giver);
  float white = max(greatest(giver), 1.0);
  vec3 off_grey = color - luminosity(color);
  float below = target / max(-least(off_grey), 1e-20);
  float above = (white - target) / max(greatest(off_grey), 1e-20);
  return target + off_grey * clamp(min(below, above), 0.0, 1.0);
}

// The standard's SetSat: from 0 to the giver's range, without changing the hue.
vec3 set_saturation(vec3 color, vec3 giver) {
  float low = least(color);
  float range = greatest(giver) - least(giver);
  return (color - low) * (range / max(greatest(color) - low, 1e-20));
}

// The modes that mix the three components.
vec3 hue_color(vec3 front, vec3 back, const int mode) {
  if (mode == MODE_HUE) {
    return set_luminosity(set_saturation(front, back), back);
  }
  if (mode == MODE_SATURATION) {
    return set_luminosity(set_saturation(back, front), back);
  }
  if (mode == MODE_COLOR) {
    return set_luminosity(front, back);
  }
  return set_luminosity(back, front);
}

// The modes that brighten or darken by a quotient. They end at black, and at white or at the
// background where that is brighter.
vec3 quotient_color(vec3 front, vec3 back, const int mode) {
  if (mode == MODE_COLOR_DODGE) {
    return min(back / max(1.0 - front, 1e-20), max(back, 1.0));
  }
  if (mode == MODE_COLOR_BURN) {
    return 1.0 - clamp((1.0 - back) / max(front, 1e-20), min(1.0 - back, 0.0), vec3(1.0));
  }
  return min(back / max(front, 1e-20), max(back, 1.0));
}

// The modes that darken where the foreground is below 0.5 and lighten where it is above, each by
// another mode with twice the foreground.
vec3 light_color(vec3 front, vec3 back, const int mode) {
  vec3 upper = 2.0 * front - 1.0;
  if (mode == MODE_LINEAR_LIGHT) {
    return clamp(back + upper, vec3(0.0), max(back, 1.0));
  }
  if (mode == MODE_HARD_MIX) {
    vec3 sum = front + back;
    return clamp((sum - 1.0) / max(footprint(sum), 1e-7) + 0.5, 0.0, 1.0);
  }
  vec3 darker = mode == MODE_PIN_LIGHT ? min(back, 2.0 * front)
                                       : quotient_color(2.0 * front, back, MODE_COLOR_BURN);
  vec3 lighter =
      mode == MODE_PIN_LIGHT ? max(back, upper) : quotient_color(upper, back, MODE_COLOR_DODGE);
  return mix(darker, lighter, step(0.5, front));
}

vec3 mode_color(vec3 front, vec3 back, const int mode) {
  if (mode == MODE_ADD) {
    return back + front;
  }
  if (mode == MODE_SUBTRACT) {
    return max(back - front, 0.0);
  }
  if (mode == MODE_LINEAR_BURN) {
    return max(back + front - 1.0, 0.0);
  }
  if (mode == MODE_MULTIPLY) {
    return back * front;
  }
  if (mode == MODE_SCREEN) {
    return back + front - back * front;
  }
  if (mode == MODE_EXCLUSION) {
    return back + front - 2.0 * back * front;
  }
  if (mode == MODE_OVERLAY) {
    return hard_light(back, front);
  }
  if (mode == MODE_HARD_LIGHT) {
    return hard_light(front, back);
  }
  if (mode == MODE_SOFT_LIGHT) {
    return soft_light(front, back);
  }
  if (mode == MODE_DARKEN) {
    return min(back, front);
  }
  if (mode == MODE_LIGHTEN) {
    return max(back, front);
  }
  if (mode == MODE_DIFFERENCE) {
    return abs(back - front);
  }
  if (mode == MODE_DARKER_COLOR) {
    return mix(front, back, step(luminosity(back), luminosity(front)));
  }
  if (mode == MODE_LIGHTER_COLOR) {
    return mix(front, back, step(luminosity(front), luminosity(back)));
  }
  if (mode >= MODE_LINEAR_LIGHT) {
    return light_color(front, back, mode);
  }
  if (mode >= MODE_HUE) {
    return hue_color(front, back, mode);
  }
  return mode == MODE_MIX ? front : quotient_color(front, back, mode);
}

// Four modes need no straight colours. For the others an alpha below 1e-6 counts as 1e-6: that
// makes an error of at most 1e-6 in the result, and keeps light without alpha finite.
vec3 premultiplied_color(vec4 front, vec4 back, const int mode) {
  if (mode == MODE_MIX) {
    return front.rgb + back.rgb * (1.0 - front.a);
  }
  if (mode == MODE_ADD) {
    return front.rgb + back.rgb;
  }
  if (mode == MODE_SCREEN) {
    return front.rgb + back.rgb - front.rgb * back.rgb;
  }
  vec3 single = front.rgb * (1.0 - back.a) + back.rgb * (1.0 - front.a);
  if (mode == MODE_MULTIPLY) {
    return single + front.rgb * back.rgb;
  }
  vec3 blended = mode_color(front.rgb / max(front.a, 1e-6), back.rgb / max(back.a, 1e-6), mode);
  return single + front.a * back.a * blended;
}

/// Lays one colour over another.
/// Where there is a background the foreground's colour is what the mode makes of both, and the two
/// are composited with "source over". Colours are linear light, and so the modes meet there what
/// painting programs show them encoded: the 0.5 at which overlay, hard light and soft light turn
/// from darker to lighter is the light of an sRGB value of 188 of 255.
/// For values from 0 to 1 every mode is what its standard says, and the result lies there too (but
/// for add). Above 1 the formulas go on: screen, exclusion, overlay, hard light and soft light may
/// then turn negative or grow fast; the others don't.
/// @source W3C, Compositing and Blending Level 1, sections 5.8, 5.9, 9.1 and 10; Porter and Duff,
///   Compositing Digital Images, SIGGRAPH 1984
/// @param foreground what is laid on top
/// @param background what lies below
/// @param mode how colours meet: mix, which others call normal, shows the foreground; add and
///   subtract don't stop at 1 but at 0; multiply darkens, screen lightens; overlay does both, as
///   the background says, hard light as the foreground says, and soft light, in the standard's
///   form, does so gently; darken and lighten keep the smaller and the larger value; difference is
///   the distance between them, and exclusion that with less contrast; color dodge and color burn
///   raise the background's light or its darkness by a quotient, and linear burn is the sum less
///   1; divide is the background over the foreground, white where that is larger; hue, saturation,
///   color (which is both) and luminosity take this from the foreground, the rest from the
///   background, with the standard's luminosity of 0.3, 0.59 and 0.11; linear light adds twice the
///   foreground less 1, and ends at black and at white; vivid light is color burn or color dodge,
///   and pin light darken or lighten, each with twice the foreground; hard mix is 1 in each
///   component where the sum reaches 1, else 0, antialiased; darker color and lighter color are
///   the one of both with the smaller or the greater luminosity @default MODE_MIX
/// @param opacity of the foreground @default 1 @range 0 1
/// @param mask where the foreground is shown: another factor of its opacity @default 1 @range 0 1
/// @param alpha of both colours and of the result: straight, as everywhere in the library, or
///   premultiplied, where red, green and blue are already multiplied by it
///   @default ALPHA_STRAIGHT
vec4 blend(vec4 foreground, vec4 background, const int mode, float opacity, float mask,
           const int alpha) {
  if (alpha == ALPHA_PREMULTIPLIED) {
    vec4 weighed = foreground * (opacity * mask);
    return vec4(premultiplied_color(weighed, background, mode),
                mix(background.a, 1.0, weighed.a));
  }
  float front = foreground.a * opacity * mask;
  float both = mix(background.a, 1.0, front);
  vec3 blended = mode_color(foreground.rgb, background.rgb, mode);
  vec3 color = mode == MODE_MIX ? foreground.rgb : mix(foreground.rgb, blended, background.a);
  return vec4(mix(background.rgb, color, front / max(both, 1e-20)), both);
}
