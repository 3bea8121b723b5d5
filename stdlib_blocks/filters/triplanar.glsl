// SPDX-License-Identifier: Apache-2.0
/// Lays an image over a solid without texture coordinates: it is projected along the three axes of
/// space, and where the surface looks between them the three are mixed.
/// Seen from outside no projection is mirrored, and up is up: the image's y is the position's, or,
/// seen from above and below, minus and plus its z. The weights are |normal|^sharpness, divided by
/// their sum. A projection that has less than a thousandth of the greatest weight is not
/// computed.
/// @source MaterialX 1.39, Standard Nodes, triplanarprojection; Geiss, GPU Gems 3, chapter 1,
///   section 1.5
/// @param image what is laid over it. A function may take a second input, `plane`: 0 for what is
///   seen along x, 1 along y, 2 along z, for other images there
/// @param position where on the solid @default position
/// @param normal where the surface looks, of any length above 0 @default normal
/// @param scale how many times the image repeats in a unit of the position @default 1
/// @param sharpness how quickly one projection passes into the next: 1 softly, 32 with an edge
///   @default 4 @range 0.25 64
genType image(vec2 uv, int plane);

genType triplanar(vec3 position, vec3 normal, float scale, float sharpness) {
  vec3 p = scale * position;
  vec3 facing = abs(normal);
  float most = max(max(facing.x, facing.y), max(facing.z, 1e-20));
  vec3 weight = max(pow(facing / most, vec3(sharpness)) - 0.001, 0.0);
  weight /= max(weight.x + weight.y + weight.z, 1e-20);
  vec3 side = vec3(normal.x < 0.0 ? -1.0 : 1.0, normal.y < 0.0 ? -1.0 : 1.0,
                   normal.z < 0.0 ? -1.0 : 1.0);
  genType sum = genType(0.0);
  if (weight.x > 0.0) {
    sum += weight.x * image(vec2(-side.x * p.z, p.y), 0);
  }
  if (weight.y > 0.0) {
    sum += weight.y * image(vec2(p.x, -side.y * p.z), 1);
  }
  if (weight.z > 0.0) {
    sum += weight.z * image(vec2(side.z * p.x, p.y), 2);
  }
  return sum;
}
