// SPDX-License-Identifier: Apache-2.0
/// The sine of an angle: a wave from -1 to 1.
/// @param angle the angle @unit radians
genType sine(genType angle) { return sin(angle); }
