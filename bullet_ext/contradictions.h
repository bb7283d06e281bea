#pragma once

namespace delassus::bullet {

struct Answer;
struct Group;

/// Joints that contradict each other are answered as what softness.h has them give, c |r| of a row,
/// and the law of rows that give is kept. But no motion meets what they ask: where a row gives by
/// more than a tenth of what its joint asks for, or its bodies move at, its island is incompatible,
/// with c |r| for its residual, and the row is blamed. Not what rounding of poses asks for (h: the
/// step, s), nor joints that bring a softness of their own.
void nameContradictions(const Group& group, double h, Answer& answer);

}  // namespace delassus::bullet
