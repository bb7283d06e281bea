#pragma once

#include "delassus/island.h"

namespace delassus::bullet {

struct Answer;
struct Group;

/// The velocity that the rounding of poses alone may ask of the bodies of an island: ε |x|/h, m/s.
double askedByRounding(const Group& group, const Island& island);

/// Judges contradictions against the rounding of poses.
///
/// Joints that contradict each other are solved with the softness of softness.h: each row gives by
/// c |r|, and the law of rows that give is kept. But no motion meets what the joints ask. So if a
/// row gives by more than a tenth of what its joint asks for and of the speed of its bodies, its
/// island is incompatible with the residual c |r|, and the row is blamed. (Joints with a softness
/// of their own are not judged, nor those that a motor, or another drive at its bound, may load as
/// much: a body that is welded to the world does not follow a mouse.)
///
/// Velocities that the rounding of poses alone asks for are no contradiction: incompatible islands
/// that miss no more than that count as solved.
void judgeContradictions(const Group& group, Answer& answer);

}  // namespace delassus::bullet
