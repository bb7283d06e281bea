#include "bullet_ext/group_islands.h"

#include "bullet_ext/group.h"

namespace delassus::bullet {

void GroupIslands::find(const Group& group, const Economies& economies) {
  assembler_.split(group.bodies, group.contacts, group.rows, !economies.tangents);
  areJoined_ = !group.articulation.trees.empty();
  if (areJoined_) joiner_.join(assembler_, group.articulation);
}

}  // namespace delassus::bullet
