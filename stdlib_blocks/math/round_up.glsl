// SPDX-License-Identifier: Apache-2.0
/// The smallest whole number that is not below the value, component by component.
/// @param value the value
genType round_up(genType value) { return ceil(value); }
