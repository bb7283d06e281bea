#include "bullet_ext/plan.h"

#include <algorithm>
#include <cmath>

#include "bullet_ext/group.h"
#include "bullet_ext/group_islands.h"
#include "bullet_ext/saturating_sum.h"

namespace delassus {

void Plan::add(const Plan& group) {
  for (const auto count :
       {&Plan::frictional, &Plan::frictionless, &Plan::bouncing, &Plan::soft, &Plan::deep,
        &Plan::rolling, &Plan::spinning, &Plan::joints, &Plan::rows, &Plan::boundedRows,
        &Plan::softRows, &Plan::obsolete, &Plan::islands, &Plan::unknowns, &Plan::pushContacts})
    addTo(this->*count, group.*count);
  largestIsland = std::max(largestIsland, group.largestIsland);
  heard |= group.heard;
  events |= group.events;
}

namespace bullet {

Plan makePlan(const Group& group, bool heard, const Economies& economies,
              const GroupIslands& islands) {
  Plan plan;
  plan.bouncing = group.bouncing;
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const Contact& c = group.contacts[i];
    ++(c.friction > 0 ? plan.frictional : plan.frictionless);
    plan.soft += c.compliance > 0 || c.slipCompliance > 0;
    plan.deep += group.pushes[i] > 0;
  }
  plan.joints = static_cast<int>(group.joints.size());
  plan.rows = static_cast<int>(group.rows.size()) - group.turningRows;
  for (std::size_t i = plan.rows; i < group.rows.size(); ++i) plan.rolling += group.rows[i].paired;
  plan.spinning = group.turningRows - 2 * plan.rolling;
  for (int i = 0; i < plan.rows; ++i)
    plan.boundedRows += std::isfinite(group.rows[i].lower) || std::isfinite(group.rows[i].upper);
  plan.softRows = group.softRows;
  plan.obsolete = static_cast<int>(group.obsolete.size());
  plan.heard = heard;

  plan.islands = islands.count();
  for (int i = 0; i < plan.islands; ++i) {
    const int size = islands[i].unknowns();
    plan.unknowns += size;
    plan.largestIsland = std::max(plan.largestIsland, size);
  }
  plan.pushContacts = plan.deep > 0 || economies.pushes ? plan.deep : plan.contacts();
  plan.events = heard || !economies.events;
  return plan;
}

}  // namespace bullet
}  // namespace delassus
