// SPDX-License-Identifier: Apache-2.0
/// Gives one of two values, as a condition says. Samples of textures in both are taken either way.
/// @param condition which one; see `compare` @default true
/// @param if_true the value where the condition holds
/// @param if_false the value where it does not
genType select(bool condition, genType if_true, genType if_false) {
  return condition ? if_true : if_false;
}
