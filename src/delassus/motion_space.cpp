#include "delassus/motion_space.h"

#include <algorithm>
#include <cmath>

namespace delassus {
namespace {

constexpr int none = -1;

/// J with J Jᵀ = W for a symmetric positive semi-definite W: Cholesky with diagonal pivoting,
/// stopped at the rank.
MatrixXd pivotedCholesky(const MatrixXd& W) {
  const int n = static_cast<int>(W.rows());
  // Below this share of its own diagonal a pivot is round-off: the contact is redundant.
  constexpr double redundant = 1e-13;
  const VectorXd original = W.diagonal();
  VectorXd pivots = original;
  MatrixXd J = MatrixXd::Zero(n, n);
  int rank = 0;
  for (; rank < n; ++rank) {
    int p = -1;
    double best = redundant;
    for (int i = 0; i < n; ++i) {
      if (!(original[i] > 0)) continue;
      const double share = pivots[i] / original[i];
      if (share > best) best = share, p = i;
    }
    if (p < 0) break;
    const VectorXd column =
        (W.col(p) - J.leftCols(rank) * J.row(p).head(rank).transpose()) / std::sqrt(pivots[p]);
    J.col(rank) = column;
    pivots -= column.cwiseAbs2();
    pivots[p] = 0;
  }
  return J.leftCols(rank);
}

/// Calls visit(at, a, Ja, b, Jb) for every pair of blocks of one contact or row if at least one of
/// the two is a part, always in the same order.
template <class Visit>
void forPairsWithParts(const BodySpace& space, const Visit& visit) {
  const auto contactsEnd = static_cast<int>(3 * space.contacts.size());
  const auto forPairsOf = [&](const BodySpace::Part* p, const BodySpace::Part* last,
                              const auto& c) {
    if (c.a >= 0) visit(p->at, c.a, BodySpace::Rows(c.Ja), p->body, p->J);
    if (c.b >= 0) visit(p->at, c.b, BodySpace::Rows(c.Jb), p->body, p->J);
    for (const BodySpace::Part* next = p + 1; next != last && next->at == p->at; ++next)
      visit(p->at, p->body, p->J, next->body, next->J);
  };
  const BodySpace::Part* last = space.parts.data() + space.parts.size();
  for (const BodySpace::Part* p = space.parts.data(); p != last; ++p) {
    if (p->at < contactsEnd)
      forPairsOf(p, last, space.contacts[p->at / 3]);
    else
      forPairsOf(p, last, space.rows[p->at - contactsEnd]);
  }
}

}  // namespace

void Stiffness::reset(const Problem& problem) {
  contacts.assign(problem.contacts(), Mat3::Zero());
  rows.setZero(problem.rows());
  disks.assign(problem.disks.size(), OfDisk());
}

bool Stiffness::isSymmetric() const {
  return std::all_of(contacts.begin(), contacts.end(),
                     [](const Mat3& G) {
                       return G(0, 1) == G(1, 0) && G(0, 2) == G(2, 0) && G(1, 2) == G(2, 1);
                     }) &&
         std::all_of(disks.begin(), disks.end(), [](const OfDisk& disk) {
           return disk.governor.isZero(0) && disk.own(0, 1) == disk.own(1, 0);
         });
}

Eigen::RowVector3d Stiffness::ofNormal(const Disk& disk) const {
  const auto contactsEnd = static_cast<int>(3 * contacts.size());
  if (disk.governor < contactsEnd) return contacts[disk.governor / 3].row(0);
  return {rows[disk.governor - contactsEnd], 0, 0};
}

void BodyMotion::setProblem(const Problem& problem) {
  space_ = &problem.W.bodySpace();
  disks_ = &problem.disks;
  plainRows_ = problem.plainRows();
  hasRoom_ = false;
}

bool BodyMotion::hasRoomFor(const Stiffness& G) {
  // Few pairs all get room at once: one order serves all regions, and no region takes memory anew.
  constexpr int fewPairs = 20;
  constexpr int perIdle = 10;  // coupled pairs
  const std::vector<Bond>& touches = touches_.all();
  const auto pairs =
      std::count_if(touches.begin(), touches.end(), [](const Bond& bond) { return bond.couples; });
  getsEdge_.assign(touches.size(), false);
  presses_.resize(space_->contacts.size());
  int coupled = 0, missing = 0, idle = 0;
  for (std::size_t k = 0; k < touches.size(); ++k) {
    const Bond& bond = touches[k];
    bool presses = false;
    for (int i = bond.begin; i < bond.end; ++i) {
      presses_[i] = G.contacts[i](0, 0) != 0;
      presses = presses || presses_[i];
    }
    if (!bond.couples) continue;
    const bool hasEdge = bond.edge >= 0;
    getsEdge_[k] = presses || pairs <= fewPairs;
    coupled += getsEdge_[k];
    missing += getsEdge_[k] && !hasEdge;
    idle += !getsEdge_[k] && hasEdge;
  }
  if (perIdle * idle > coupled) return false;
  for (std::size_t k = 0; k < touches.size(); ++k)
    if (touches[k].edge >= 0) getsEdge_[k] = true;
  return hasRoom_ && missing == 0;
}

void BodyMotion::makeRoom() {
  edges_.clear();
  edges_.reserve(touches_.all().size() + joins_.all().size());
  const auto couple = [&](int a, int b) {
    if (a >= 0 && b >= 0 && a != b) edges_.push_back({a, b});
  };
  const auto giveEdge = [&](Bond& bond, const auto& part) {
    bond.edge = static_cast<int>(edges_.size());
    edges_.push_back({part.a, part.b});
  };
  for (std::size_t k = 0; k < touches_.all().size(); ++k) {
    Bond& bond = touches_.all()[k];
    bond.edge = none;
    if (getsEdge_[k]) giveEdge(bond, space_->contacts[bond.begin]);
  }
  for (Bond& bond : joins_.all())
    if (bond.couples) giveEdge(bond, space_->rows[bond.begin]);
  endOfRows_ = static_cast<int>(edges_.size());
  forPairsWithParts(*space_, [&](int, int a, const auto&, int b, const auto&) { couple(a, b); });
  for (const Disk& disk : *disks_) {
    findShares(disk);
    for (std::size_t i = 0; i < shares_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) couple(shares_[i].body, shares_[j].body);
  }
  factor_.analyse(space_->bodies, edges_);
  hasRoom_ = true;
}

bool BodyMotion::factorise(const Stiffness& G) {
  if (!hasRoom_) {
    touches_.find(space_->bodies, space_->contacts, static_cast<int>(space_->contacts.size()));
    joins_.find(space_->bodies, space_->rows, plainRows_);
  }
  if (!hasRoomFor(G)) makeRoom();
  // Rounding alone can make a symmetric K indefinite: K ≥ 1.
  return (G.isSymmetric() && factorise(G, true)) || factorise(G, false);
}

bool BodyMotion::factorise(const Stiffness& G, bool asCholesky) {
  factor_.setIdentity(asCholesky);
  int edge = endOfRows_;
  if (!space_->parts.empty()) edge = addParts(G, edge);
  if (!disks_->empty()) addDisks(G, edge);
  return factor_.factorise([&](int body) { addTo(body, G); });
}

void BodyMotion::addTo(int body, const Stiffness& G) {
  touches_.forBondsOf(body, [&](const Bond& bond, BlockFactor::Side side) {
    BlockFactor::Responses together(side);
    for (int i = bond.begin; i < bond.end; ++i) {
      if (!presses_[i]) continue;
      if (together.isFull()) factor_.addContacts(together, bond.edge);
      together.add(space_->contacts[i], G.contacts[i]);
    }
    if (!together.isEmpty()) factor_.addContacts(together, bond.edge);
  });
  joins_.forBondsOf(body, [&](const Bond& bond, BlockFactor::Side side) {
    const int begin = bond.begin, count = bond.end - begin;
    factor_.addRows(&space_->rows[begin], &G.rows[begin], count, bond.edge, side);
  });
}

bool BodyMotion::condense(const std::vector<int>& unknowns, KeptMatrix& W) {
  if (!factor_.isCholesky()) return false;
  const auto contactsEnd = static_cast<int>(3 * space_->contacts.size());
  blocks_.clear();
  blocksBegin_.assign(1, 0);
  const auto add = [&](const auto& c, int row) {
    if (c.a >= 0) blocks_.push_back({c.a, c.Ja.row(row).transpose()});
    if (c.b >= 0) blocks_.push_back({c.b, c.Jb.row(row).transpose()});
  };
  for (const int at : unknowns) {
    const int row = at < contactsEnd ? at % 3 : 0, first = at - row;
    if (at < contactsEnd)
      add(space_->contacts[at / 3], row);
    else
      add(space_->rows[at - contactsEnd], row);
    for (const BodySpace::Part& part : space_->partsOf(first))
      blocks_.push_back({part.body, part.J.row(row).transpose()});
    blocksBegin_.push_back(static_cast<int>(blocks_.size()));
  }
  factor_.condense(blocks_, blocksBegin_, W);
  return true;
}

/// Fills shares_: the blocks that a disk or its governor moves, each once.
void BodyMotion::findShares(const Disk& disk) {
  shares_.clear();
  const auto of = [&](int body) -> DiskShare& {
    const auto known = std::find_if(shares_.begin(), shares_.end(),
                                    [&](const DiskShare& share) { return share.body == body; });
    if (known != shares_.end()) return *known;
    shares_.emplace_back().body = body;
    shares_.back().disk.setZero();
    shares_.back().governor.setZero();
    return shares_.back();
  };
  const auto contactsEnd = static_cast<int>(3 * space_->contacts.size());
  for (int i = 0; i < disk.unknowns; ++i) {
    const ScalarRow& c = space_->rows[disk.first + i - contactsEnd];
    if (c.a >= 0) of(c.a).disk.row(i) += c.Ja;
    if (c.b >= 0) of(c.b).disk.row(i) += c.Jb;
    for (const BodySpace::Part& p : space_->partsOf(disk.first + i))
      of(p.body).disk.row(i) += p.J.row(0);
  }
  const auto addGovernor = [&](const auto& c) {
    if (c.a >= 0) of(c.a).governor.topRows(c.Ja.rows()) += c.Ja;
    if (c.b >= 0) of(c.b).governor.topRows(c.Jb.rows()) += c.Jb;
  };
  if (disk.governor < contactsEnd)
    addGovernor(space_->contacts[disk.governor / 3]);
  else
    addGovernor(space_->rows[disk.governor - contactsEnd]);
  for (const BodySpace::Part& p : space_->partsOf(disk.governor))
    of(p.body).governor.topRows(p.J.rows()) += p.J;
}

void BodyMotion::addDisks(const Stiffness& G, int edge) {
  for (std::size_t k = 0; k < disks_->size(); ++k) {
    findShares((*disks_)[k]);
    Mat3 own = Mat3::Zero(), governor = Mat3::Zero();
    own.topLeftCorner<2, 2>() = G.disks[k].own;
    governor.topRows<2>() = G.disks[k].governor;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      DiskShare& a = shares_[i];
      a.answer.noalias() = own * a.disk;
      a.answer.noalias() += governor * a.governor;
      factor_.addDiagonal(a.body, a.disk, a.answer);
      for (std::size_t j = 0; j < i; ++j) {
        const DiskShare& b = shares_[j];
        factor_.addOffDiagonal(edge++, a.disk, a.answer, b.disk, b.answer);
      }
    }
  }
}

/// Adds the parts. Returns the edge after theirs.
int BodyMotion::addParts(const Stiffness& G, int edge) {
  const auto contactsEnd = static_cast<int>(3 * space_->contacts.size());
  const auto stiff = [&](int at, const BodySpace::Rows& J) -> BodySpace::Rows {
    if (at < contactsEnd) return G.contacts[at / 3] * J;
    return G.rows[at - contactsEnd] * J;
  };
  for (const BodySpace::Part& p : space_->parts)
    factor_.addDiagonal(p.body, p.J.transpose() * stiff(p.at, p.J));
  const auto add = [&](int at, int, const BodySpace::Rows& Ja, int, const BodySpace::Rows& Jb) {
    factor_.addOffDiagonal(edge++, Ja.transpose() * stiff(at, Jb), Jb.transpose() * stiff(at, Ja));
  };
  forPairsWithParts(*space_, add);
  return edge;
}

void FactoredMotion::setProblem(const Problem& problem) {
  disks_ = &problem.disks;
  const MatrixXd W = problem.W.dense();
  J_ = pivotedCholesky(0.5 * (W + W.transpose()));
}

bool FactoredMotion::factorise(const Stiffness& G) {
  const int n = static_cast<int>(G.contacts.size());
  GJ_.resize(J_.rows(), J_.cols());
  for (int i = 0; i < n; ++i)
    GJ_.middleRows<3>(3 * i).noalias() = G.contacts[i] * J_.middleRows<3>(3 * i);
  for (int i = 3 * n; i < J_.rows(); ++i) GJ_.row(i) = G.rows[i - 3 * n] * J_.row(i);
  for (std::size_t k = 0; k < disks_->size(); ++k) {
    const Disk& disk = (*disks_)[k];
    const int governing = disk.governor < 3 * n ? 3 : 1, answering = disk.unknowns;
    GJ_.middleRows(disk.first, answering) =
        G.disks[k].own.topLeftCorner(answering, answering) * J_.middleRows(disk.first, answering) +
        G.disks[k].governor.topLeftCorner(answering, governing) *
            J_.middleRows(disk.governor, governing);
  }
  symmetric_ = G.isSymmetric();
  if (symmetric_) {
    K_.resize(J_.cols(), J_.cols());
    K_.triangularView<Eigen::Lower>() = J_.transpose() * GJ_;
    K_.diagonal().array() += 1;
    cholesky_.compute(K_);
    return cholesky_.info() == Eigen::Success;
  }
  K_.noalias() = J_.transpose() * GJ_;
  K_.diagonal().array() += 1;
  lu_.compute(K_);
  return K_.allFinite();
}

}  // namespace delassus
