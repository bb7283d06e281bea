/// Ways through large mechanisms.
#include <algorithm>
#include <numeric>

#include "bullet_ext/held_contacts.h"

namespace delassus::bullet {

/// Makes ready for wayBetween, once the holds are sorted.
void HeldContacts::findWays() {
  const auto bodies = static_cast<int>(numberOf_.size());
  const auto count = static_cast<int>(holds_.size());
  paths_.reset(bodies);
  for (const Hold& hold : holds_)
    if (hold.a != BodyPaths::none && hold.b != BodyPaths::none) paths_.link(hold.a, hold.b);
  paths_.close();
  const auto linkOf = [&](const Hold& hold) {
    if (hold.a == BodyPaths::none || hold.b == BodyPaths::none) return BodyPaths::none;
    return paths_.next(hold.a) == hold.b   ? hold.a
           : paths_.next(hold.b) == hold.a ? hold.b
                                           : BodyPaths::none;
  };
  firstOnLink_.assign(bodies + 1, 0);
  for (const Hold& hold : holds_)
    if (const int link = linkOf(hold); link != BodyPaths::none) ++firstOnLink_[link];
  std::partial_sum(firstOnLink_.begin(), firstOnLink_.end(), firstOnLink_.begin());
  onLink_.resize(firstOnLink_.back());
  for (int k = count; k-- > 0;)
    if (const int link = linkOf(holds_[k]); link != BodyPaths::none)
      onLink_[--firstOnLink_[link]] = k;
  hasWays_ = true;
  from_ = to_ = BodyPaths::none;
}

/// The rows on a way between two bodies of one mechanism, as a mechanism of their own; none if they
/// are too many, or leave six motions and more, as those of a rope do: then nothing is held.
int HeldContacts::wayBetween(int a, int b) {
  if (!hasWays_) findWays();
  if (a == from_ && b == to_) return way_;
  from_ = a, to_ = b, way_ = BodyPaths::none;
  constexpr int motions = 6;
  const std::vector<int>& bodies = paths_.between(a, b, mostRows);
  const auto eachHold = [&](std::size_t i, const auto& use) {
    const bool isOfFirst = paths_.next(bodies[i - 1]) == bodies[i];
    const int link = bodies[isOfFirst ? i - 1 : i];
    for (int k = firstOnLink_[link]; k < firstOnLink_[link + 1]; ++k) use(onLink_[k]);
  };
  int rows = 0, left = 0;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    int leftHere = motions;
    eachHold(i, [&](int k) {
      ++rows;
      leftHere -= !holds_[k].isWeak();
    });
    left += std::max(leftHere, 0);
  }
  if (rows == 0 || rows > mostRows || left >= motions) return way_;
  Mechanism way;
  way.rows = rows;
  way.begin = static_cast<int>(holds_.size());
  for (const bool areWeak : {false, true})
    for (std::size_t i = 1; i < bodies.size(); ++i)
      eachHold(i, [&](int k) {
        if (const Hold hold = holds_[k]; hold.isWeak() == areWeak) holds_.push_back(hold);
      });
  way.end = static_cast<int>(holds_.size());
  way_ = static_cast<int>(mechanisms_.size());
  mechanisms_.push_back(way);
  return way_;
}

}  // namespace delassus::bullet
