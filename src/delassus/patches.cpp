#include "delassus/patches.h"

#include <algorithm>

namespace delassus {
namespace {

constexpr char settled = 0, touched = 1;  // neighbours: touched + ring

/// Makes room in a problem for these parts, without bodies and disks.
BodySpace& makeRoom(int contacts, int rows, Problem& cut) {
  cut.friction.resize(contacts);
  cut.lower.resize(rows);
  cut.upper.resize(rows);
  cut.q.resize(cut.size());
  cut.disks.clear();
  BodySpace& space = cut.W.refill(cut.size());
  space.contacts.clear();
  space.rows.clear();
  space.contacts.reserve(contacts);
  space.rows.reserve(rows);
  space.bodies = 0;
  space.compliance.resize(cut.size());
  return space;
}

/// Calls `visit` with every body that contact or row k moves.
template <class Visit>
void visitBodies(const Problem& problem, int k, Visit visit) {
  const BodySpace& space = problem.W.bodySpace();
  const int n = problem.contacts();
  const int a = k < n ? space.contacts[k].a : space.rows[k - n].a;
  const int b = k < n ? space.contacts[k].b : space.rows[k - n].b;
  if (a >= 0) visit(a);
  if (b >= 0) visit(b);
  for (const BodySpace::Part& part : space.partsOf(problem.unknownOf(k))) visit(part.body);
}

}  // namespace

/// Finds the bodies that belong to patches.
void Patches::spread(const Problem& problem, const VectorXd& residuals, double unsettled,
                     int rings) {
  const int count = problem.parts();
  reach_.assign(problem.W.bodySpace().bodies, settled);
  for (int k = 0; k < count; ++k)
    if (residuals[k] > unsettled)
      visitBodies(problem, k, [&](int body) { reach_[body] = touched; });
  for (int ring = 1; ring <= rings; ++ring) {
    const auto next = static_cast<char>(touched + ring);
    for (int k = 0; k < count; ++k) {
      bool isNear = false;
      visitBodies(problem, k, [&](int body) {
        isNear = isNear || (reach_[body] != settled && reach_[body] < next);
      });
      if (!isNear) continue;
      visitBodies(problem, k, [&](int body) {
        if (reach_[body] == settled) reach_[body] = next;
      });
    }
  }
}

/// Takes the contacts and rows whose bodies all belong to patches, and joins their bodies to
/// patches.
void Patches::join(const Problem& problem) {
  const int count = problem.parts();
  sets_.reset(static_cast<int>(reach_.size()));
  owner_.assign(count, -1);
  for (int k = 0; k < count; ++k) {
    int first = -1;
    bool inside = true;
    visitBodies(problem, k, [&](int body) {
      inside = inside && reach_[body] != settled;
      if (first < 0) first = body;
    });
    if (first < 0 || !inside) continue;
    owner_[k] = first;
    visitBodies(problem, k, [&](int body) { sets_.join(body, first); });
  }
  for (int& owner : owner_)
    if (owner >= 0) owner = sets_.root(owner);
}

/// Leaves out disks whose governor, or a row of theirs, is held: they have no law of their own in a
/// patch.
void Patches::leaveOutDisks(const Problem& problem) {
  for (const Disk& disk : problem.disks) {
    const int governor = problem.partAt(disk.governor), first = problem.partAt(disk.first);
    bool held = owner_[governor] < 0;
    for (int k = first; k < first + disk.unknowns; ++k) held = held || owner_[k] < 0;
    if (held) std::fill_n(owner_.begin() + first, disk.unknowns, -1);
  }
}

/// Fills parts_ and begin_ from owner_, with patches in the order of their first parts.
void Patches::sort() {
  place_.assign(reach_.size(), -1);
  begin_.assign(1, 0);
  for (const int owner : owner_) {
    if (owner < 0) continue;
    if (place_[owner] < 0) {
      place_[owner] = count();
      begin_.push_back(0);
    }
    ++begin_[place_[owner] + 1];
  }
  for (std::size_t patch = 1; patch < begin_.size(); ++patch) begin_[patch] += begin_[patch - 1];
  parts_.resize(begin_.back());
  // Filled from the ends, so that afterwards begin_ holds the beginnings.
  for (std::size_t k = owner_.size(); k-- > 0;)
    if (owner_[k] >= 0) parts_[--begin_[place_[owner_[k]] + 1]] = static_cast<int>(k);
  begin_.erase(begin_.begin());
  begin_.push_back(static_cast<int>(parts_.size()));
  std::fill(place_.begin(), place_.end(), -1);
}

void Patches::find(const Problem& problem, const VectorXd& residuals, double unsettled, int rings) {
  spread(problem, residuals, unsettled, rings);
  join(problem);
  leaveOutDisks(problem);
  sort();
}

void Patches::cutOut(int patch, const Problem& problem, const VectorXd& r, const VectorXd& u,
                     Problem& cut, VectorXd& reactions) {
  const BodySpace& space = problem.W.bodySpace();
  const int n = problem.contacts();
  const int* first = parts_.data() + begin_[patch];
  const int* last = parts_.data() + begin_[patch + 1];
  const int contacts = static_cast<int>(std::lower_bound(first, last, n) - first);
  const int rows = static_cast<int>(last - first) - contacts;

  BodySpace& own = makeRoom(contacts, rows, cut);
  cut.roundOff = problem.roundOff;
  cut.leastDemand = problem.leastDemand;
  reactions.resize(cut.size());
  const auto numberOf = [&](int body) {
    if (body < 0) return body;
    if (place_[body] < 0) place_[body] = own.bodies++;
    return place_[body];
  };
  std::size_t disk = 0;
  for (int i = 0; i < contacts + rows; ++i) {
    const int k = first[i], from = problem.unknownOf(k), to = cut.unknownOf(i);
    const int unknowns = k < n ? 3 : 1;
    if (k < n) {
      own.contacts.push_back(space.contacts[k]);
      own.contacts.back().a = numberOf(space.contacts[k].a);
      own.contacts.back().b = numberOf(space.contacts[k].b);
      cut.friction[i] = problem.friction[k];
    } else {
      own.rows.push_back(space.rows[k - n]);
      own.rows.back().a = numberOf(space.rows[k - n].a);
      own.rows.back().b = numberOf(space.rows[k - n].b);
      cut.lower[i - contacts] = problem.lower[k - n];
      cut.upper[i - contacts] = problem.upper[k - n];
    }
    for (const BodySpace::Part& part : space.partsOf(from)) {
      own.parts.push_back(part);
      own.parts.back().at = to;
      own.parts.back().body = numberOf(part.body);
    }
    own.compliance.segment(to, unknowns) = space.compliance.segment(from, unknowns);
    cut.q.segment(to, unknowns) = u.segment(from, unknowns);
    reactions.segment(to, unknowns) = r.segment(from, unknowns);

    while (disk < problem.disks.size() && problem.disks[disk].first < from) ++disk;
    if (disk == problem.disks.size() || problem.disks[disk].first != from) continue;
    Disk law = problem.disks[disk];
    const int* governor = std::lower_bound(first, last, problem.partAt(law.governor));
    law.governor = cut.unknownOf(static_cast<int>(governor - first));
    law.first = to;
    cut.disks.push_back(law);
  }
  for (int i = 0; i < contacts + rows; ++i)
    visitBodies(problem, first[i], [&](int body) { place_[body] = -1; });
  cut.W.multiply(reactions, felt_, moved_);
  cut.q -= moved_;
}

void Patches::putBack(int patch, const Problem& problem, const VectorXd& reactions,
                      VectorXd& r) const {
  const int n = problem.contacts();
  int to = 0;
  for (int at = begin_[patch]; at < begin_[patch + 1]; ++at) {
    const int unknowns = parts_[at] < n ? 3 : 1;
    r.segment(problem.unknownOf(parts_[at]), unknowns) = reactions.segment(to, unknowns);
    to += unknowns;
  }
}

}  // namespace delassus
