// SPDX-License-Identifier: Apache-2.0
/// The cosine of an angle: a wave from -1 to 1 that starts at its top.
/// @param angle the angle @unit radians
genType cosine(genType angle) { return cos(angle); }
