#pragma once

#include <cstddef>
#include <vector>

namespace delassus {

/// Symbolic elimination of a symmetric pattern of blocks: the order of minimum degree, and the
/// places of the factor's blocks. It does not depend on their values.
struct BlockPattern {
  struct Edge {
    int a, b;  ///< a ≠ b
    bool operator==(const Edge& other) const { return a == other.a && b == other.b; }
  };
  struct Target {
    int at;         ///< position among the off-diagonal blocks
    bool reversed;  ///< a comes after b in the elimination order
  };
  struct Ancestor {
    int column;  ///< an earlier column with a block in this row
    int at;      ///< where that block is
  };
  /// Columns from `begin` up to `end`, for one hand to eliminate one after the other.
  struct Task {
    int begin, end;
  };

  int bodies = 0;
  std::vector<Edge> edges;          ///< repeated and reversed pairs are welcome
  std::vector<int> place;           ///< body -> place in the elimination order
  std::vector<int> bodyAt;          ///< and back
  std::vector<Target> target;       ///< edge -> off-diagonal block
  std::vector<int> begin;           ///< column -> its first off-diagonal block; size bodies + 1
  std::vector<int> row;             ///< off-diagonal block -> its row
  std::vector<int> leader;          ///< column -> first of its run of columns with the same rows
  std::vector<int> ancestorBegin;   ///< row -> its first ancestor; size bodies + 1
  std::vector<Ancestor> ancestors;  ///< one per off-diagonal block
  /// All columns, if there is enough work for several hands: first subtrees of the elimination
  /// tree, which need no columns but their own, then the rest one by one. Each task needs only
  /// columns of its own and of earlier tasks.
  std::vector<Task> tasks;

  BlockPattern(int bodyCount, const std::vector<Edge>& edgeList);

  bool isOf(int bodyCount, const std::vector<Edge>& edgeList) const {
    return bodies == bodyCount && edges == edgeList;
  }
  bool isLarge() const { return !tasks.empty(); }
  int offDiagonalBlocks() const { return static_cast<int>(row.size()); }
  std::size_t bytes() const;

 private:
  void findTasks();
};

}  // namespace delassus
