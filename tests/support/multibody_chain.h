#pragma once

#include <vector>

#include "tests/support/multibody_world.h"

namespace delassus::test {

/// A planar chain on a fixed base at the origin. Joint axes are along z; links of 1 m lie along x
/// at rest, with masses 2, 3, ... kg in their middles.
struct Chain {
  static constexpr btScalar inertia = btScalar(0.1);
  static btScalar mass(int link) { return btScalar(2 + link); }

  explicit Chain(MultiBodyWorld& world, int links) : feedback(links) {
    tree = &world.addTree(links, 0, btVector3(0, 0, 0), true);
    for (int i = 0; i < links; ++i) {
      tree->setupRevolute(i, mass(i), btVector3(inertia, inertia, inertia), i - 1,
                          btQuaternion::getIdentity(), btVector3(0, 0, 1),
                          btVector3(i == 0 ? btScalar(0) : btScalar(0.5), 0, 0),
                          btVector3(btScalar(0.5), 0, 0), true);
      tree->getLink(i).m_jointFeedback = &feedback[i];
    }
  }
  btVector3 endOf(int link) const {
    return tree->localPosToWorld(link, btVector3(btScalar(0.5), 0, 0));
  }
  btMultiBody* tree;
  std::vector<btMultiBodyJointFeedback> feedback;
};

}  // namespace delassus::test
