#pragma once

#include "demos/report/stability/sweep.h"

namespace demos::report::stability {

/// A straight chain of links of 1 kg and 0.5 m with a ball, released at 30 degrees from the
/// vertical.
struct HungChain {
  int links;
  double ballMass;    ///< kg
  double rate = 240;  ///< steps a second
  int substeps = 1;   ///< of each step
  int copies = 1;     ///< of every ball joint
  /// Geometric stiffness, lumped: h² T l/3 is added to the links' moments of inertia about the axes
  /// across them, T the largest tension. It changes the turning from ω² = 12 T/(m l) to
  /// ω² = T l/(m l²/12 + h² T l/3) < 3/h², within ω h < 2. (Implicit springs of that stiffness add
  /// it to the masses: Andrews, Teichmann, Kövecses 2017.)
  bool stiffened = false;
};

/// Its error: the gap of joints over the length of a link, or the energy gained over that of the
/// swing, whichever is larger.
Trial hungChain(const HungChain& chain, double seconds);

/// A link of mass m and length l in a chain of tension T turns to and fro with ω² = 12 T/(m l).
/// Joints that pull along the directions of the step's start can follow it only while ω h < 2.
/// Returns the heaviest ball within that bound, kg.
double heaviestBall(int links, double timeStep);
/// The least number of steps a second for that ball.
double leastRate(int links, double ballMass);

}  // namespace demos::report::stability
