#include "delassus/split_problem.h"

#include <utility>

#include "delassus/links.h"

namespace delassus {

std::vector<ProblemPart> splitProblem(const Problem& problem) {
  const int n = problem.contacts(), size = problem.size();
  const DelassusMatrix::Sparse& W = problem.W.entries();
  const auto leader = [&](int unknown) {
    return unknown < 3 * n ? unknown - unknown % 3 : unknown;
  };

  Links links(size);
  for (int i = 0; i < size; ++i) links.join(i, leader(i));
  for (const Disk& disk : problem.disks)
    for (int i = 0; i < disk.unknowns; ++i) links.join(disk.first + i, leader(disk.governor));
  for (int i = 0; i < size; ++i)
    for (DelassusMatrix::Sparse::InnerIterator it(W, i); it; ++it)
      if (it.value() != 0) links.join(leader(i), leader(static_cast<int>(it.col())));

  std::vector<ProblemPart> parts;
  std::vector<int> partOf(size), place(size);
  for (int i = 0; i < size; ++i) {
    const int root = links.root(i);
    if (root == i) {
      partOf[i] = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    partOf[i] = partOf[root];
    place[i] = static_cast<int>(parts[partOf[i]].unknowns.size());
    parts[partOf[i]].unknowns.push_back(i);
  }
  for (const Disk& disk : problem.disks)
    parts[partOf[disk.first]].problem.disks.push_back(
        {place[disk.first], disk.unknowns, place[disk.governor], disk.radius, disk.mostLoad});

  for (ProblemPart& part : parts) {
    const int count = static_cast<int>(part.unknowns.size());
    Eigen::Index most = 0;  // of entries
    for (const int i : part.unknowns) most += W.outerIndexPtr()[i + 1] - W.outerIndexPtr()[i];
    DelassusMatrix::Sparse Wp(count, count);
    Wp.reserve(most);
    Problem& p = part.problem;
    p.name = problem.name;
    p.q.resize(count);
    std::vector<double> friction, lower, upper;
    for (int k = 0; k < count; ++k) {
      const int i = part.unknowns[k];
      p.q[k] = problem.q[i];
      if (i < 3 * n && i % 3 == 0) friction.push_back(problem.friction[i / 3]);
      if (i >= 3 * n) {
        lower.push_back(problem.lower[i - 3 * n]);
        upper.push_back(problem.upper[i - 3 * n]);
      }
      Wp.startVec(k);
      for (DelassusMatrix::Sparse::InnerIterator it(W, i); it; ++it)
        if (partOf[it.col()] == partOf[i]) Wp.insertBack(k, place[it.col()]) = it.value();
    }
    const auto vector = [](const std::vector<double>& x) {
      return VectorXd(
          Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())));
    };
    p.friction = vector(friction);
    p.lower = vector(lower);
    p.upper = vector(upper);
    Wp.finalize();
    p.W = DelassusMatrix(Wp);
  }
  return parts;
}

}  // namespace delassus
