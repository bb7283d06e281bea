#pragma once

namespace delassus {

/// What a step leaves out where its scene does not need it. Each can be switched off, to see what it is worth: the
/// motion stays the same to within the tolerance.
struct Economies {
  /// A contact without friction has one unknown, not three.
  bool tangents = true;
  /// No W for an island whose contacts do not approach.
  bool freeIslands = true;
  /// Reactions of the last step that still keep the law are checked, no more.
  bool keptIslands = true;
  /// A single contact or row is answered by a formula, and a problem file by a few sweeps of it where these suffice.
  bool closedForms = true;
  /// No search where there is one region: joints without limits, motors and contacts.
  bool oneRegion = true;
  /// No factorisation where the region and W stand.
  bool factors = true;
  /// No push problem where no penetration splits.
  bool pushes = true;
  /// No contact events where nobody listens.
  bool events = true;
  /// Memory is kept from step to step.
  bool storage = true;
};

}  // namespace delassus
