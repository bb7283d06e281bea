#pragma once

#include <vector>

#include "delassus/body.h"
#include "delassus/contact.h"
#include "delassus/problem.h"
#include "delassus/row.h"

namespace delassus {

/// Contacts and rows that can feel each other: linked through movable bodies. Indices are in ascending order.
///
/// The unknowns of its problem are, in this order: three per frictional contact, one per frictionless contact, one per row.
struct Island {
  std::vector<int> bodies;        ///< movable bodies
  std::vector<int> frictional;    ///< contacts with friction > 0
  std::vector<int> frictionless;  ///< contacts with friction = 0: one unknown each
  std::vector<int> rows;
};

/// Splits a step into islands, ordered by their first body. Contacts and rows between immovable bodies have no
/// unknowns and appear in no island.
std::vector<Island> splitIslands(const std::vector<Body>& bodies,
                                 const std::vector<Contact>& contacts,
                                 const std::vector<Row>& rows);

/// W, q, friction and bounds of one island.
Problem assemble(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                 const std::vector<Row>& rows, const Island& island);

/// v ← v + M⁻¹ Jᵀ r for the bodies of the island.
void applyReaction(std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                   const std::vector<Row>& rows, const Island& island, const VectorXd& r);

}  // namespace delassus
