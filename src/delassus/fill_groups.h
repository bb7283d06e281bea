#pragma once

#include <vector>

#include "delassus/problem.h"
#include "delassus/residual.h"
#include "delassus/swept_groups.h"

namespace delassus {

/// From a problem to groups for sweeps: `fill` writes what stays the same in all sweeps, once `at`
/// is known; also a and b of bodies that are not missing. `start` writes where sweeps begin,
/// u = W r + q; r and u are taken times `scale`.

/// Where the normal reaction is swept that governs a disk; null: it stays as it is.
struct SweptLoad {
  const float* dr = nullptr;
  float unit = 1;
};

void fill(const Problem& problem, const NaturalMap& map, ContactGroup& g);
void fill(const Problem& problem, const NaturalMap& map, RowGroup& g);
/// `loads`: one per disk.
void fill(const Problem& problem, const std::vector<SweptLoad>& loads, DiskGroup& g);

void start(const Problem& problem, const VectorXd& r, const VectorXd& u, double scale,
           ContactGroup& g);
void start(const Problem& problem, const VectorXd& r, const VectorXd& u, double scale, RowGroup& g);
void start(const Problem& problem, const VectorXd& r, const VectorXd& u, double scale,
           DiskGroup& g);

/// Where the normal reaction of a contact, or a row, is swept.
inline SweptLoad loadIn(const ContactGroup& g, int lane) { return {&g.dr[0][lane], g.unit[lane]}; }
inline SweptLoad loadIn(const RowGroup& g, int lane) { return {&g.dr[lane], g.unit[lane]}; }

}  // namespace delassus
