// SPDX-License-Identifier: Apache-2.0
/// Keeps a value within a range, component by component.
/// @param value the value
/// @param low the least value @default 0
/// @param high the greatest value @default 1 @not_below low
genType clamp_range(genType value, genType low, genType high) { return clamp(value, low, high); }
