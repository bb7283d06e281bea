#include "delassus/block_factor.h"

#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <utility>

namespace delassus {
namespace {

std::vector<int> minimumDegreePlaces(int bodies, const std::vector<BlockFactor::Edge>& edges) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * edges.size() + bodies);
  for (int i = 0; i < bodies; ++i) entries.emplace_back(i, i, 1.0);
  for (const BlockFactor::Edge& e : edges) {
    entries.emplace_back(e.a, e.b, 1.0);
    entries.emplace_back(e.b, e.a, 1.0);
  }
  Eigen::SparseMatrix<double> graph(bodies, bodies);
  graph.setFromTriplets(entries.begin(), entries.end());

  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
  std::vector<int> places(bodies);
  for (int k = 0; k < bodies; ++k) places[order.indices()[k]] = k;
  return places;
}

}  // namespace

void BlockFactor::analyse(int bodies, const std::vector<Edge>& edges) {
  if (bodies == bodies_ && edges == edges_) return;
  bodies_ = bodies;
  edges_ = edges;
  place_ = bodies > 1 ? minimumDegreePlaces(bodies, edges) : std::vector<int>(bodies, 0);

  // Pattern of L, column by column: own entries, and what the children in the elimination tree pass up.
  std::vector<std::vector<int>> pattern(bodies);
  for (const Edge& e : edges) {
    const auto [low, high] = std::minmax(place_[e.a], place_[e.b]);
    pattern[low].push_back(high);
  }
  std::vector<std::vector<int>> children(bodies);
  begin_.assign(bodies + 1, 0);
  row_.clear();
  for (int k = 0; k < bodies; ++k) {
    std::vector<int>& rows = pattern[k];
    for (int child : children[k])
      rows.insert(rows.end(), pattern[child].begin() + 1, pattern[child].end());
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    if (!rows.empty()) children[rows.front()].push_back(k);
    row_.insert(row_.end(), rows.begin(), rows.end());
    begin_[k + 1] = static_cast<int>(row_.size());
  }

  target_.clear();
  target_.reserve(edges.size());
  for (const Edge& e : edges) {
    const auto [low, high] = std::minmax(place_[e.a], place_[e.b]);
    const auto first = row_.begin() + begin_[low], last = row_.begin() + begin_[low + 1];
    target_.push_back({static_cast<int>(std::lower_bound(first, last, high) - row_.begin()),
                       place_[e.a] > place_[e.b]});
  }

  ancestorBegin_.assign(bodies + 1, 0);
  for (int row : row_) ++ancestorBegin_[row + 1];
  for (int k = 0; k < bodies; ++k) ancestorBegin_[k + 1] += ancestorBegin_[k];
  ancestors_.resize(row_.size());
  std::vector<int> next(ancestorBegin_.begin(), ancestorBegin_.end() - 1);
  for (int column = 0; column < bodies; ++column)
    for (int at = begin_[column]; at < begin_[column + 1]; ++at)
      ancestors_[next[row_[at]]++] = {column, at};

  slot_.assign(bodies, -1);
  diagonal_.resize(bodies);
  diagonalInverse_.resize(bodies);
  lower_.resize(row_.size());
  upper_.resize(row_.size());
}

void BlockFactor::setIdentity() {
  std::fill(diagonal_.begin(), diagonal_.end(), Mat6::Identity());
  std::fill(lower_.begin(), lower_.end(), Mat6::Zero());
  std::fill(upper_.begin(), upper_.end(), Mat6::Zero());
}

void BlockFactor::addOffDiagonal(int edge, const Mat6& ab, const Mat6& ba) {
  const Target& t = target_[edge];
  lower_[t.at] += t.reversed ? ab : ba;
  upper_[t.at] += t.reversed ? ba.transpose() : ab.transpose();
}

void BlockFactor::eliminate(int column) {
  for (int at = begin_[column]; at < begin_[column + 1]; ++at) slot_[row_[at]] = at;

  // Left-looking: subtract what earlier columns j with a block in this row contribute.
  for (int k = ancestorBegin_[column]; k < ancestorBegin_[column + 1]; ++k) {
    const auto [j, at] = ancestors_[k];
    const Mat6& L = lower_[at];  // L_{column,j}, already times the inverse pivot
    const Mat6& U = upper_[at];  // U_{j,column} transposed
    diagonal_[column].noalias() -= L * U.transpose();
    for (int i = at + 1; i < begin_[j + 1]; ++i) {
      const int to = slot_[row_[i]];
      lower_[to].noalias() -= lower_[i] * U.transpose();
      upper_[to].noalias() -= upper_[i] * L.transpose();
    }
  }
}

bool BlockFactor::factorise() {
  for (int column = 0; column < bodies_; ++column) {
    eliminate(column);
    const Mat6 inverse = diagonal_[column].partialPivLu().inverse();
    if (!inverse.allFinite()) return false;
    diagonalInverse_[column] = inverse;
    for (int at = begin_[column]; at < begin_[column + 1]; ++at)
      lower_[at] = (lower_[at] * inverse).eval();
  }
  return true;
}

void BlockFactor::solve(VectorXd& x) const {
  VectorXd& z = ordered_;
  z.resize(x.size());
  for (int body = 0; body < bodies_; ++body)
    z.segment<6>(6 * place_[body]) = x.segment<6>(6 * body);

  for (int j = 0; j < bodies_; ++j)
    for (int at = begin_[j]; at < begin_[j + 1]; ++at)
      z.segment<6>(6 * row_[at]).noalias() -= lower_[at] * z.segment<6>(6 * j);
  for (int j = bodies_ - 1; j >= 0; --j) {
    for (int at = begin_[j]; at < begin_[j + 1]; ++at)
      z.segment<6>(6 * j).noalias() -= upper_[at].transpose() * z.segment<6>(6 * row_[at]);
    z.segment<6>(6 * j) = diagonalInverse_[j] * Vec6(z.segment<6>(6 * j));
  }

  for (int body = 0; body < bodies_; ++body)
    x.segment<6>(6 * body) = z.segment<6>(6 * place_[body]);
}

std::size_t BlockFactor::bytes() const {
  return sizeof(Mat6) *
             (diagonal_.size() + diagonalInverse_.size() + lower_.size() + upper_.size()) +
         sizeof(int) *
             (place_.size() + begin_.size() + row_.size() + ancestorBegin_.size() + slot_.size()) +
         sizeof(Ancestor) * ancestors_.size() + sizeof(Edge) * edges_.size() +
         sizeof(Target) * target_.size();
}

}  // namespace delassus
