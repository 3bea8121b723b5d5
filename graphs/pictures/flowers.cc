// SPDX-License-Identifier: Apache-2.0
// Single flowers, to be scattered. All of them lie inside of the circle in the picture, their
// shadows too, so that they may be turned.
#include "graphs/pictures/canvas.h"
#include "graphs/pictures/things.h"

namespace texgraph::pictures {

Picture MakeDaisy() {
  Canvas canvas(128, 128);
  LayDaisy(canvas, {0.5, 0.5}, 0.36, 3);
  return canvas.Finish({0.05, 0.06, 0.03});
}

}  // namespace texgraph::pictures
