#include "bullet_ext/gather.h"

namespace delassus::bullet {

void Group::clear() {
  bodies.clear();
  bodySources.clear();
  contacts.clear();
  contactSources.clear();
  pushes.clear();
  guess.clear();
  idle.clear();
  rows.clear();
  rowGuess.clear();
  joints.clear();
  obsolete.clear();
  articulation.clear();
  indexOf.clear();
}

std::size_t Group::bytes() const {
  const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  return of(bodies) + of(bodySources) + of(contacts) + of(contactSources) + of(pushes) + of(guess) +
         of(idle) + of(rows) + of(joints) + obsolete.capacity() * sizeof(void*) + of(asked) +
         indexOf.bytes();
}

}  // namespace delassus::bullet
