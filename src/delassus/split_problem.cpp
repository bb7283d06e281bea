#include "delassus/split_problem.h"

#include "delassus/disjoint_sets.h"

namespace delassus {
namespace {

using Sparse = DelassusMatrix::Sparse;

/// The first unknown of its contact or row, which stands for all of them.
int leaderOf(int unknown, int contacts) {
  return unknown < 3 * contacts ? unknown - unknown % 3 : unknown;
}

DisjointSets coupled(const Problem& problem) {
  const int n = problem.contacts();
  const Sparse& W = problem.W.entries();
  DisjointSets sets(problem.size());
  for (int i = 0; i < 3 * n; i += 3) sets.join(i, i + 1), sets.join(i, i + 2);
  for (const Disk& disk : problem.disks)
    for (int i = 0; i < disk.unknowns; ++i) sets.join(disk.first + i, leaderOf(disk.governor, n));
  for (int i = 0; i < problem.size(); ++i) {
    const int leader = leaderOf(i, n);
    int joined = leader;  // the last one joined: entries of a block follow each other
    for (Sparse::InnerIterator it(W, i); it; ++it) {
      const int other = leaderOf(static_cast<int>(it.col()), n);
      if (other == joined || it.value() == 0) continue;
      sets.join(leader, other);
      joined = other;
    }
  }
  return sets;
}

}  // namespace

ProblemParts::ProblemParts(const Problem& whole) : whole_(whole) {
  const int size = whole.size();
  DisjointSets sets = coupled(whole);
  partOf_.resize(size);
  place_.resize(size);
  std::vector<int> sizes;
  for (int i = 0; i < size; ++i) {
    const int root = sets.root(i);  // the first of its part
    if (root == i) {
      partOf_[i] = static_cast<int>(sizes.size());
      sizes.push_back(0);
    }
    partOf_[i] = partOf_[root];
    place_[i] = sizes[partOf_[i]]++;
  }
  begin_.assign(1, 0);
  for (const int count : sizes) begin_.push_back(begin_.back() + count);
  unknowns_.resize(size);
  for (int i = 0; i < size; ++i) unknowns_[begin_[partOf_[i]] + place_[i]] = i;
}

Problem ProblemParts::problemOf(int part) const {
  const Sparse& W = whole_.W.entries();
  const int size = sizeOf(part), frictional = 3 * whole_.contacts();
  int contacts = 0, rows = 0;
  Eigen::Index most = 0;  // of entries
  for (int k = 0; k < size; ++k) {
    const int i = unknown(part, k);
    i < frictional ? contacts += i % 3 == 0 : ++rows;
    most += W.outerIndexPtr()[i + 1] - W.outerIndexPtr()[i];
  }
  Problem p;
  p.name = whole_.name;
  p.roundOff = whole_.roundOff;
  p.leastDemand = whole_.leastDemand;
  p.q.resize(size);
  p.friction.resize(contacts);
  p.lower.resize(rows);
  p.upper.resize(rows);
  Sparse Wp(size, size);
  Wp.reserve(most);
  for (int k = 0; k < size; ++k) {
    const int i = unknown(part, k);
    p.q[k] = whole_.q[i];
    if (i < frictional) {
      p.friction[k / 3] = whole_.friction[i / 3];
    } else {
      p.lower[k - 3 * contacts] = whole_.lower[i - frictional];
      p.upper[k - 3 * contacts] = whole_.upper[i - frictional];
    }
    Wp.startVec(k);
    for (Sparse::InnerIterator it(W, i); it; ++it)
      if (partOf_[it.col()] == part) Wp.insertBack(k, place_[it.col()]) = it.value();
  }
  Wp.finalize();
  p.W = DelassusMatrix(Wp);
  for (const Disk& disk : whole_.disks)
    if (partOf_[disk.first] == part)
      p.disks.push_back(
          {place_[disk.first], disk.unknowns, place_[disk.governor], disk.radius, disk.mostLoad});
  return p;
}

}  // namespace delassus
