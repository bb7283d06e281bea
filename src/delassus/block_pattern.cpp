#include "delassus/block_pattern.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <numeric>
#include <utility>

#include "delassus/bytes.h"

namespace delassus {
namespace {

std::vector<int> minimumDegreePlaces(int bodies, const std::vector<BlockPattern::Edge>& edges) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * edges.size() + bodies);
  for (int i = 0; i < bodies; ++i) entries.emplace_back(i, i, 1.0);
  for (const BlockPattern::Edge& e : edges) {
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

BlockPattern::BlockPattern(int bodyCount, const std::vector<Edge>& edgeList)
    : bodies(bodyCount), edges(edgeList) {
  place = bodies > 1 ? minimumDegreePlaces(bodies, edges) : std::vector<int>(bodies, 0);
  bodyAt.resize(bodies);
  for (int body = 0; body < bodies; ++body) bodyAt[place[body]] = body;

  // Pattern of L, column by column: own entries, and those that children in the elimination tree
  // pass up. The own entries of column k are high[own[k]] up to high[own[k + 1]].
  const auto placesOf = [&](const Edge& e) { return std::minmax(place[e.a], place[e.b]); };
  std::vector<int> own(bodies + 1, 0), high(edges.size());
  for (const Edge& e : edges) ++own[placesOf(e).first + 1];
  std::partial_sum(own.begin(), own.end(), own.begin());
  std::vector<int> next(own.begin(), own.end() - 1);
  for (const Edge& e : edges) high[next[placesOf(e).first]++] = placesOf(e).second;
  constexpr int none = -1;
  std::vector<int> child(bodies, none), sibling(bodies, none), rows;
  begin.assign(bodies + 1, 0);
  for (int k = 0; k < bodies; ++k) {
    rows.assign(high.begin() + own[k], high.begin() + own[k + 1]);
    for (int c = child[k]; c != none; c = sibling[c])
      rows.insert(rows.end(), row.begin() + begin[c] + 1, row.begin() + begin[c + 1]);
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    if (!rows.empty()) sibling[k] = std::exchange(child[rows.front()], k);
    row.insert(row.end(), rows.begin(), rows.end());
    begin[k + 1] = static_cast<int>(row.size());
  }

  target.reserve(edges.size());
  for (const Edge& e : edges) {
    const auto [column, below] = placesOf(e);
    const auto first = row.begin() + begin[column], last = row.begin() + begin[column + 1];
    target.push_back({static_cast<int>(std::lower_bound(first, last, below) - row.begin()),
                      place[e.a] > place[e.b]});
  }

  leader.resize(bodies);
  for (int k = 0; k < bodies; ++k) {
    const auto length = [this](int column) { return begin[column + 1] - begin[column]; };
    const bool follows = k > 0 && length(k - 1) == length(k) + 1 && row[begin[k - 1]] == k;
    leader[k] = follows ? leader[k - 1] : k;
  }

  ancestorBegin.assign(bodies + 1, 0);
  for (int r : row) ++ancestorBegin[r + 1];
  for (int k = 0; k < bodies; ++k) ancestorBegin[k + 1] += ancestorBegin[k];
  ancestors.resize(row.size());
  next.assign(ancestorBegin.begin(), ancestorBegin.end() - 1);
  for (int column = 0; column < bodies; ++column)
    for (int at = begin[column]; at < begin[column + 1]; ++at)
      ancestors[next[row[at]]++] = {column, at};
  findTasks();
}

/// A column needs only those below it in the elimination tree. In the order of minimum degree, the
/// columns of a subtree mostly follow each other; where they do not, they come one by one.
void BlockPattern::findTasks() {
  constexpr int sharesOfAll = 64;   // no subtree in a task has more than one of these
  constexpr int worthwhile = 5000;  // products of two blocks; fewer are made before others come
  constexpr int perColumn = 4;      // products that take as long as its assembly and its pivot
  struct Subtree {
    int first, size = 1;  ///< the lowest column, and the number of columns
    long long products = perColumn;
  };
  long long products = 0;  // of all columns
  for (int k = 0; k < bodies; ++k) {
    const long long rows = begin[k + 1] - begin[k];
    products += perColumn + rows * (rows + 1) / 2;
  }
  if (products < worthwhile) return;

  std::vector<Subtree> below(bodies);
  for (int k = 0; k < bodies; ++k) {
    below[k].first = k;
    for (int i = ancestorBegin[k]; i < ancestorBegin[k + 1]; ++i)
      below[k].products += begin[ancestors[i].column + 1] - ancestors[i].at;
  }
  const auto parent = [this](int k) { return begin[k] < begin[k + 1] ? row[begin[k]] : bodies; };
  for (int k = 0; k < bodies; ++k) {
    if (parent(k) == bodies) continue;
    Subtree& above = below[parent(k)];
    above.first = std::min(above.first, below[k].first);
    above.size += below[k].size;
    above.products += below[k].products;
  }
  std::vector<Task> others;
  long long last = 0;  // products of the last task
  for (int k = bodies - 1; k >= 0; --k) {
    const Subtree& own = below[k];
    if (sharesOfAll * own.products > products || k + 1 - own.first != own.size) {
      others.push_back({k, k + 1});
      continue;
    }
    const bool joins = !tasks.empty() && tasks.back().begin == k + 1 &&
                       sharesOfAll * (last + own.products) <= products;
    if (joins)
      tasks.back().begin = own.first, last += own.products;
    else
      tasks.push_back({own.first, k + 1}), last = own.products;
    k = own.first;
  }
  std::reverse(tasks.begin(), tasks.end());
  tasks.insert(tasks.end(), others.rbegin(), others.rend());
}

std::size_t BlockPattern::bytes() const {
  return bytesOf(edges, place, bodyAt, target, begin, row, leader, ancestorBegin, ancestors, tasks);
}

}  // namespace delassus
