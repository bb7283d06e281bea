#include "delassus/articulation.h"

#include <algorithm>
#include <cmath>

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

void RootFinder::find(const MatrixXd& inverseMass, MatrixXd& B) {
  factor_.compute(inverseMass);
  const auto d = factor_.vectorD();
  // Directions without motion come last: their rows are zero.
  Eigen::Index rank = d.size();
  while (rank > 0 && d[rank - 1] <= 0) --rank;
  L_ = factor_.matrixL();
  for (Eigen::Index i = 0; i < rank; ++i) L_.col(i) *= std::sqrt(std::max(d[i], 0.0));
  B = factor_.transpositionsP().transpose() * L_.leftCols(rank);
}

const KeptList<Island>& IslandJoiner::join(const Assembler& assembler,
                                           const Articulation& articulation) {
  constexpr int unseen = -1;
  const int count = assembler.islands();
  sets_.reset(count);
  islandOf_.assign(articulation.trees.size(), unseen);
  for (int i = 0; i < count; ++i)
    for (int body : assembler.island(i).bodies)
      if (const Articulation::Limb* limb = articulation.limbOf(body)) {
        int& island = islandOf_[limb->tree];
        if (island == unseen) island = i;
        sets_.join(island, i);
      }

  joined_.clear();
  place_.resize(count);
  for (int i = 0; i < count; ++i) {
    const int root = sets_.root(i);
    if (root == i) {
      place_[i] = static_cast<int>(joined_.size());
      joined_.add() = assembler.island(i);
      continue;
    }
    const auto append = [](std::vector<int>& to, const std::vector<int>& from) {
      to.insert(to.end(), from.begin(), from.end());
      std::sort(to.begin(), to.end());
    };
    Island& into = joined_[place_[root]];
    append(into.bodies, assembler.island(i).bodies);
    append(into.frictional, assembler.island(i).frictional);
    append(into.frictionless, assembler.island(i).frictionless);
    append(into.rows, assembler.island(i).rows);
  }
  return joined_;
}

void TreeGains::reset(const Articulation& articulation) {
  const std::size_t count = articulation.trees.size();
  if (of.size() < count) of.resize(count);
  for (std::size_t i = 0; i < count; ++i) of[i].setZero(articulation.trees[i].root.rows());
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

/// Adds J, in the motion of the tree, to the parts of the contact or row at `at`. block(column,
/// width) gives a piece of J.
template <class Block>
void Coupling::addParts(int at, int tree, Eigen::Index columns, const Block& block) {
  using Piece =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, 3, 6>;  // on the stack
  std::vector<BodySpace::Part>& parts = space_->parts;
  for (int column = 0; column < columns; column += 6) {
    const auto width = std::min<Eigen::Index>(6, columns - column);
    const Piece J = block(column, width);
    const int index = firstBlock_[tree] + column / 6;
    // Both sides of a contact may be limbs of one tree: then the block is there already.
    auto part = std::find_if(parts.rbegin(), parts.rend(), [&](const BodySpace::Part& p) {
      return p.at < at || p.body == index;
    });
    if (part == parts.rend() || part->at < at) {
      parts.push_back({at, index, BodySpace::Rows::Zero(J.rows(), 6)});
      part = parts.rbegin();
    }
    part->J.leftCols(width) += J;
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
    const Matrix6X& motion = limb->motion;
    addParts(at, limb->tree, motion.cols(), [&](Eigen::Index column, Eigen::Index width) {
      return J.lazyProduct(motion.middleCols(column, width));
    });
    body = fixedWorld;
  };
  for (ContactRows& c : space_->contacts) {
    moveSide(c.a, c.Ja);
    moveSide(c.b, c.Jb);
    at += 3;
  }
  const int jointsBegin = apart.size() - static_cast<int>(island.rows.size());
  auto next = articulation.jointRows.begin();
  for (ScalarRow& c : space_->rows) {
    moveSide(c.a, c.Ja);
    moveSide(c.b, c.Jb);
    const int row = at < jointsBegin ? -1 : island.rows[at - jointsBegin];
    while (next != articulation.jointRows.end() && next->row < row) ++next;
    for (; next != articulation.jointRows.end() && next->row == row; ++next)
      addParts(at, next->tree, next->effect.size(), [&](Eigen::Index column, Eigen::Index width) {
        return next->effect.segment(column, width).transpose();
      });
    ++at;
  }

  problem_.q = apart.q;
  problem_.friction = apart.friction;
  problem_.lower = apart.lower;
  problem_.upper = apart.upper;
  problem_.disks = apart.disks;
  problem_.roundOff = apart.roundOff;
  problem_.leastDemand = apart.leastDemand;
  return problem_;
}

void Coupling::addGain(const Articulation& articulation, const VectorXd& r, TreeGains& gains) {
  problem_.W.bodySpace().impulse(r, impulse_);
  for (std::size_t i = 0; i < firstBlock_.size(); ++i) {
    if (firstBlock_[i] < 0) continue;
    const MatrixXd& root = articulation.trees[i].root;
    gains.of[i].noalias() += root * impulse_.segment(6 * firstBlock_[i], root.cols());
  }
}

}  // namespace delassus
