// SPDX-License-Identifier: Apache-2.0
/// Raises a value to a power, component by component: a gamma curve for values from 0 to 1.
/// A base below 1e-37, negative ones too, counts as 1e-37, so that the result is a number for every
/// exponent from -1 up.
/// @param base what is raised
/// @param exponent the power @default 1
genType power(genType base, genType exponent) { return pow(max(base, 1e-37), exponent); }
