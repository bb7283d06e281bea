#pragma once

#include <cstddef>
#include <vector>

namespace delassus {

/// What elimination does to a symmetric pattern of blocks, whatever their values: the order of
/// minimum degree, and where the factor has blocks.
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

  int bodies = 0;
  std::vector<Edge> edges;          ///< repeated and reversed pairs are welcome
  std::vector<int> place;           ///< body -> place in the elimination order
  std::vector<Target> target;       ///< edge -> off-diagonal block
  std::vector<int> begin;           ///< column -> its first off-diagonal block; size bodies + 1
  std::vector<int> row;             ///< off-diagonal block -> its row
  std::vector<int> leader;          ///< column -> the first of its run: columns of the same rows
  std::vector<int> ancestorBegin;   ///< row -> its first ancestor; size bodies + 1
  std::vector<Ancestor> ancestors;  ///< one an off-diagonal block

  BlockPattern(int bodyCount, const std::vector<Edge>& edgeList);

  bool isOf(int bodyCount, const std::vector<Edge>& edgeList) const {
    return bodies == bodyCount && edges == edgeList;
  }
  int offDiagonalBlocks() const { return static_cast<int>(row.size()); }
  std::size_t bytes() const;
};

}  // namespace delassus
