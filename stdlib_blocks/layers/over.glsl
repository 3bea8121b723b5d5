// SPDX-License-Identifier: Apache-2.0
/// Lays one colour over another: the background shows where the foreground is transparent.
/// All colours are linear light with straight alpha, the result as well: half covered means half
/// the light of each. `blend` does more.
/// @source Porter and Duff, Compositing Digital Images, SIGGRAPH 1984, "over"
/// @param foreground what is laid on top
/// @param background what lies below
vec4 over(vec4 foreground, vec4 background) {
  float alpha = mix(background.a, 1.0, foreground.a);
  return vec4(mix(background.rgb, foreground.rgb, foreground.a / max(alpha, 1e-20)), alpha);
}
