#pragma once

#include "demos/report/stability/sweep.h"

namespace demos::report::stability {

/// A straight chain of links of 1 kg and 0.5 m and a ball of `ballMass` kg, let go from 30 degrees beside the vertical. Every
/// ball joint is there `copies` times. Its error: joints apart over the length of a link, or the energy gained over that of
/// the swing, whichever is more.
Trial hungChain(int links, double ballMass, double seconds, double rate, int copies = 1);

/// A link of mass m and length l in a chain of tension T turns to and fro with ω² = 12 T/(m l). Joints that pull along the
/// directions of the start of a step follow it only while ω h < 2. The heaviest ball within that bound, kg.
double heaviestBall(int links, double timeStep);
/// The least number of steps a second for that ball.
double leastRate(int links, double ballMass);

}  // namespace demos::report::stability
