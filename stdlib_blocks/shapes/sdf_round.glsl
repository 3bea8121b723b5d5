// SPDX-License-Identifier: Apache-2.0
/// Grows a shape all around, which rounds its corners.
/// Outside it is the distance again. A radius below 0 shrinks the shape, and rounds its notches.
/// @param shape distance from the shape, below 0 inside
/// @param radius how far the outline moves out, and the radius of corners that were sharp
///   @default 0.05
float sdf_round(float shape, float radius) { return shape - radius; }
