#include "delassus/read_mode.h"

namespace delassus {

void readActiveSet(const Problem& problem, const VectorXd& diagonal, const VectorXd& r,
                   const VectorXd& u, ActiveSet& set) {
  const int n = problem.contacts();
  set.contacts.resize(n);
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    set.contacts[i] = modeOf(r.segment<3>(at), u.segment<3>(at), problem.friction[i],
                             diagonal.segment<3>(at).mean());
  }
  set.rows.resize(problem.rows());
  for (int i = 0; i < problem.rows(); ++i) {
    const int at = 3 * n + i;
    set.rows[i] = stateOf(r[at], u[at], problem.lower[i], problem.upper[i], diagonal[at]);
  }
  set.disks.clear();
  for (const Disk& disk : problem.disks)
    set.disks.push_back(diskModeOf(disk.of(r), disk.of(u), disk.radiusAt(r),
                                   diagonal.segment(disk.first, disk.unknowns).mean()));
}

}  // namespace delassus
