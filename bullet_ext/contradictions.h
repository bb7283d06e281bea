#pragma once

namespace delassus::bullet {

struct Answer;
struct Group;

/// Judges what contradicts itself by how poses are rounded; h: the step, s.
///
/// Joints that contradict each other are answered as what softness.h has them give, c |r| of a row,
/// and the law of rows that give is kept. But no motion meets what they ask: where a row gives by
/// more than a tenth of what its joint asks for, or its bodies move at, its island is incompatible,
/// with c |r| for its residual, and the row is blamed. (Not joints that bring a softness of their
/// own.)
///
/// What the rounding of poses alone has them ask for, ε |x|/h, is no contradiction, and
/// incompatible islands that miss no more are solved.
void judgeContradictions(const Group& group, double h, Answer& answer);

}  // namespace delassus::bullet
