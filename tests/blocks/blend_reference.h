// SPDX-License-Identifier: Apache-2.0
// The blend modes in double precision, for colours from 0 to 1. Section numbers are those of W3C
// Compositing and Blending Level 1, whose pseudo code this follows line by line; the modes
// that it has not (mix is its "normal") are what their names say, with the quotient limited to
// white.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace texgraph::blocks::reference {

using Rgb = std::array<double, 3>;
using BlendMode = std::function<Rgb(const Rgb& back, const Rgb& front)>;

// Section 10.1.
inline double Multiply(double back, double front) { return back * front; }
inline double Screen(double back, double front) { return back + front - back * front; }

inline double HardLight(double back, double front) {
  return front <= 0.5 ? Multiply(back, 2 * front) : Screen(back, 2 * front - 1);
}

inline double ColorDodge(double back, double front) {
  if (back == 0) return 0;
  if (front == 1) return 1;
  return std::min(1.0, back / (1 - front));
}

inline double ColorBurn(double back, double front) {
  if (back == 1) return 1;
  if (front == 0) return 0;
  return 1 - std::min(1.0, (1 - back) / front);
}

inline double SoftLight(double back, double front) {
  if (front <= 0.5) return back - (1 - 2 * front) * back * (1 - back);
  double d = back <= 0.25 ? ((16 * back - 12) * back + 4) * back : std::sqrt(back);
  return back + (2 * front - 1) * (d - back);
}

// As Photoshop's manual has them: with twice the foreground, or twice what is above its middle.
inline double LinearLight(double back, double front) {
  return std::clamp(back + 2 * front - 1, 0.0, 1.0);
}

inline double VividLight(double back, double front) {
  return front < 0.5 ? ColorBurn(back, 2 * front) : ColorDodge(back, 2 * front - 1);
}

inline double PinLight(double back, double front) {
  return front < 0.5 ? std::min(back, 2 * front) : std::max(back, 2 * front - 1);
}

inline double Divide(double back, double front) {
  if (back == 0) return 0;
  return front == 0 ? 1 : std::min(1.0, back / front);
}

// Section 10.2.
inline double Min(const Rgb& c) { return std::min({c[0], c[1], c[2]}); }
inline double Max(const Rgb& c) { return std::max({c[0], c[1], c[2]}); }
inline double Lum(const Rgb& c) { return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2]; }
inline double Sat(const Rgb& c) { return Max(c) - Min(c); }

inline Rgb ClipColor(Rgb c) {
  double l = Lum(c), n = Min(c), x = Max(c);
  for (double& v : c) {
    if (n < 0) v = l + (v - l) * l / (l - n);
    if (x > 1) v = l + (v - l) * (1 - l) / (x - l);
  }
  return c;
}

inline Rgb SetLum(Rgb c, double l) {
  double d = l - Lum(c);
  for (double& v : c) v += d;
  return ClipColor(c);
}

inline Rgb SetSat(Rgb c, double s) {
  std::array<double*, 3> sorted = {&c[0], &c[1], &c[2]};
  std::sort(sorted.begin(), sorted.end(), [](double* a, double* b) { return *a < *b; });
  auto [min, mid, max] = sorted;
  if (*max > *min) {
    *mid = (*mid - *min) * s / (*max - *min);
    *max = s;
  } else {
    *mid = *max = 0;
  }
  *min = 0;
  return c;
}

inline BlendMode Separable(double (*mode)(double back, double front)) {
  return [mode](const Rgb& back, const Rgb& front) {
    return Rgb{mode(back[0], front[0]), mode(back[1], front[1]), mode(back[2], front[2])};
  };
}

// By the words of blend's port `mode`.
inline const std::pair<const char*, BlendMode> kBlendModes[] = {
    {"mix", Separable([](double, double front) { return front; })},
    {"add", Separable([](double back, double front) { return back + front; })},
    {"subtract", Separable([](double back, double front) { return std::max(0.0, back - front); })},
    {"multiply", Separable(Multiply)},
    {"screen", Separable(Screen)},
    {"overlay", Separable([](double back, double front) { return HardLight(front, back); })},
    {"darken", Separable([](double back, double front) { return std::min(back, front); })},
    {"lighten", Separable([](double back, double front) { return std::max(back, front); })},
    {"difference", Separable([](double back, double front) { return std::fabs(back - front); })},
    {"exclusion",
     Separable([](double back, double front) { return back + front - 2 * back * front; })},
    {"soft_light", Separable(SoftLight)},
    {"hard_light", Separable(HardLight)},
    {"color_dodge", Separable(ColorDodge)},
    {"color_burn", Separable(ColorBurn)},
    {"linear_burn",
     Separable([](double back, double front) { return std::max(0.0, back + front - 1); })},
    {"divide", Separable(Divide)},
    {"hue",
     [](const Rgb& back, const Rgb& front) { return SetLum(SetSat(front, Sat(back)), Lum(back)); }},
    {"saturation",
     [](const Rgb& back, const Rgb& front) { return SetLum(SetSat(back, Sat(front)), Lum(back)); }},
    {"color", [](const Rgb& back, const Rgb& front) { return SetLum(front, Lum(back)); }},
    {"linear_light", Separable(LinearLight)},
    {"vivid_light", Separable(VividLight)},
    {"pin_light", Separable(PinLight)},
    {"darker_color",
     [](const Rgb& back, const Rgb& front) { return Lum(front) < Lum(back) ? front : back; }},
    {"lighter_color",
     [](const Rgb& back, const Rgb& front) { return Lum(front) > Lum(back) ? front : back; }},
    {"luminosity", [](const Rgb& back, const Rgb& front) { return SetLum(back, Lum(front)); }},
};

inline const BlendMode& FindBlendMode(const std::string& word) {
  return std::find_if(std::begin(kBlendModes), std::end(kBlendModes),
                      [&](const auto& entry) { return entry.first == word; })
      ->second;
}

}  // namespace texgraph::blocks::reference
