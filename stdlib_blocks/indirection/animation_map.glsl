// SPDX-License-Identifier: Apache-2.0
// Where the animation is, from 0 to count.
float place_of(float time, float count, float still) {
  return max(mod(time, count + still) - still, 0.0);
}

/// The picture of an animation whose rests change at some moment, without a jump: a run that has
/// begun ends, and the new rhythm starts when it can.
/// The old rhythm goes on until its run is over: to change_time + frames - p', where p' > 0 is how
/// far it is at change_time; to change_time itself where it rests. If the new one is in a run then,
/// the animation rests until that is over. That takes less than two runs; the rhythms should not
/// change again before. The paper takes change_time - 1 for an old rhythm that rests, and jumps to
/// picture 1 when the new one begins just then.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.4, Animation Map
///   and Temporal Transitions, and figure 13
/// @param time in pictures @default time
/// @param frames how many pictures the animation has; below 1 counts as 1 @range 1 4096
/// @param phase how far it is ahead, in pictures @default 0
/// @param rest how long the first picture stays before each run, at the rate 1, in pictures; other
///   values from tile to tile, and the animations start here and there @default 0
/// @param rate what the rest is multiplied by, everywhere: how seldom runs are @default 1
/// @param old_rest the rest before the change @default 0
/// @param old_rate the rate before the change @default 1
/// @param change_time when the new rest and rate came into force, in pictures @default 0
/// @return from 0 to frames - 1
int animation_map(float time, int frames, float phase, float rest, float rate, float old_rest,
                  float old_rate, float change_time) {
  float count = float(max(frames, 1));
  float still = max(rest * rate, 0.0);
  float old_still = max(old_rest * old_rate, 0.0);
  float at_change = place_of(change_time + phase, count, old_still);
  float old_end = change_time + (at_change > 0.0 ? count - at_change : 0.0);
  float at_end = place_of(old_end + phase, count, still);
  float start = old_end + (at_end > 0.0 ? count - at_end : 0.0);
  float place = place_of(time + phase, count, time < old_end ? old_still : still);
  float shown = time >= old_end && time < start ? 0.0 : place;
  // In integers: what becomes of a number that is none, or too large for an int, is not known.
  return clamp(int(shown), 0, max(frames, 1) - 1);
}
