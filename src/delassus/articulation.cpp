#include "delassus/articulation.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace delassus {

void Articulation::clear() {
  trees.clear();
  limbs.clear();
  jointRows.clear();
}

const Articulation::Limb* Articulation::limbOf(int body) const {
  const auto at = std::lower_bound(limbs.begin(), limbs.end(), body,
                                   [](const Limb& limb, int b) { return limb.body < b; });
  return at != limbs.end() && at->body == body ? &*at : nullptr;
}

bool Articulation::moves(const Island& island) const {
  return std::any_of(island.bodies.begin(), island.bodies.end(),
                     [&](int body) { return limbOf(body) != nullptr; });
}

MatrixXd rootOf(const MatrixXd& inverseMass) {
  const Eigen::LDLT<MatrixXd> factor(inverseMass);
  const VectorXd d = factor.vectorD().cwiseMax(0).cwiseSqrt();
  // The largest pivots come first: what has no motion comes last.
  Eigen::Index rank = d.size();
  while (rank > 0 && d[rank - 1] == 0) --rank;
  const MatrixXd L = factor.matrixL();
  return factor.transpositionsP().transpose() * (L.leftCols(rank) * d.head(rank).asDiagonal());
}

std::vector<Island> joinIslands(const Assembler& assembler, const Articulation& articulation) {
  constexpr int unseen = -1;
  const int count = assembler.islands();
  Links links(count);
  std::vector<int> islandOf(articulation.trees.size(), unseen);
  for (int i = 0; i < count; ++i)
    for (int body : assembler.island(i).bodies)
      if (const Articulation::Limb* limb = articulation.limbOf(body)) {
        int& island = islandOf[limb->tree];
        if (island == unseen) island = i;
        links.join(island, i);
      }

  std::vector<Island> joined;
  std::vector<int> place(count);
  for (int i = 0; i < count; ++i) {
    const int root = links.root(i);
    if (root == i) {
      place[i] = static_cast<int>(joined.size());
      joined.push_back(assembler.island(i));
      continue;
    }
    const auto append = [](std::vector<int>& to, const std::vector<int>& from) {
      const auto middle = to.insert(to.end(), from.begin(), from.end());
      std::inplace_merge(to.begin(), middle, to.end());
    };
    Island& into = joined[place[root]];
    append(into.bodies, assembler.island(i).bodies);
    append(into.frictional, assembler.island(i).frictional);
    append(into.frictionless, assembler.island(i).frictionless);
    append(into.rows, assembler.island(i).rows);
  }
  return joined;
}

void Coupling::reset(const Articulation& articulation) {
  gains_.resize(articulation.trees.size());
  for (std::size_t i = 0; i < gains_.size(); ++i)
    gains_[i].setZero(articulation.trees[i].root.rows());
}

/// Gives each tree of the island its blocks, behind those of the bodies.
void Coupling::layOut(const Articulation& articulation, const Island& island) {
  firstBlock_.assign(articulation.trees.size(), -1);
  blocks_ = static_cast<int>(island.bodies.size());
  for (int body : island.bodies) {
    const Articulation::Limb* limb = articulation.limbOf(body);
    if (!limb || firstBlock_[limb->tree] >= 0) continue;
    firstBlock_[limb->tree] = blocks_;
    blocks_ += static_cast<int>(articulation.trees[limb->tree].root.cols() + 5) / 6;
  }
}

/// Adds J, in the motion of the tree, to what the contact or row at `at` moves.
void Coupling::addParts(int at, int tree, const MatrixXd& J) {
  std::vector<BodySpace::Part>& parts = space_->parts;
  for (int column = 0; column < J.cols(); column += 6) {
    const int block = firstBlock_[tree] + column / 6;
    // Both sides of a contact may be limbs of one tree.
    auto part = std::find_if(parts.rbegin(), parts.rend(), [&](const BodySpace::Part& p) {
      return p.at < at || p.body == block;
    });
    if (part == parts.rend() || part->at < at) {
      parts.push_back({at, block, BodySpace::Rows::Zero(J.rows(), 6)});
      part = parts.rbegin();
    }
    const auto width = std::min<Eigen::Index>(6, J.cols() - column);
    part->J.leftCols(width) += J.middleCols(column, width);
  }
}

const Problem& Coupling::couple(const Articulation& articulation, const Problem& apart,
                                const Island& island) {
  layOut(articulation, island);
  const BodySpace& from = apart.W.bodySpace();
  space_ = &problem_.W.refill(apart.size());
  space_->bodies = blocks_;
  space_->contacts = from.contacts;
  space_->rows = from.rows;
  space_->compliance = from.compliance;

  int at = 0;
  const auto moveSide = [&](int& body, const auto& J) {
    if (body < 0) return;
    const Articulation::Limb* limb = articulation.limbOf(island.bodies[body]);
    if (!limb) return;
    addParts(at, limb->tree, J * limb->motion);
    body = fixedWorld;
  };
  for (BodySpace::ContactRows& c : space_->contacts) {
    moveSide(c.a, c.Ja);
    moveSide(c.b, c.Jb);
    at += 3;
  }
  const int jointsBegin = apart.size() - static_cast<int>(island.rows.size());
  auto next = articulation.jointRows.begin();
  for (BodySpace::ScalarRow& c : space_->rows) {
    moveSide(c.a, c.Ja);
    moveSide(c.b, c.Jb);
    const int row = at < jointsBegin ? -1 : island.rows[at - jointsBegin];
    while (next != articulation.jointRows.end() && next->row < row) ++next;
    for (; next != articulation.jointRows.end() && next->row == row; ++next)
      addParts(at, next->tree, next->effect.transpose());
    ++at;
  }

  problem_.q = apart.q;
  problem_.friction = apart.friction;
  problem_.lower = apart.lower;
  problem_.upper = apart.upper;
  problem_.roundOff = apart.roundOff;
  return problem_;
}

void Coupling::addGain(const Articulation& articulation, const VectorXd& r) {
  problem_.W.bodySpace().impulse(r, impulse_);
  for (std::size_t i = 0; i < firstBlock_.size(); ++i) {
    if (firstBlock_[i] < 0) continue;
    const MatrixXd& root = articulation.trees[i].root;
    gains_[i].noalias() += root * impulse_.segment(6 * firstBlock_[i], root.cols());
  }
}

}  // namespace delassus
