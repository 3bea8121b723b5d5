// SPDX-License-Identifier: Apache-2.0
/// The picture of an animation that runs again and again, with a rest before each run.
/// It is max(0, (time + phase) mod (frames + rest) - rest), rounded down: picture 0 while it rests,
/// then one picture for each unit of time. The pictures are 0 to frames - 1; the paper's figure 12
/// has one more.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.4, Animation
///   sequence, and figure 12
/// @param time in pictures @default time
/// @param frames how many pictures the animation has; below 1 counts as 1 @range 1 4096
/// @param phase how far it is ahead, in pictures; another one for each tile, and they do not run in
///   step @default 0
/// @param rest how long the first picture stays before each run, in pictures; a fraction is
///   allowed, below 0 counts as 0 @default 0
/// @return from 0 to frames - 1
int animation_sequence(float time, int frames, float phase, float rest) {
  float count = float(max(frames, 1));
  float still = max(rest, 0.0);
  float run = mod(time + phase, count + still) - still;
  // In integers: what becomes of a number that is none, or too large for an int, is not known.
  return clamp(int(run), 0, max(frames, 1) - 1);
}
