#pragma once

namespace delassus {

/// What a step leaves out where its scene does not need it. Each can be switched off (false), to
/// see what it is worth: reactions keep the law to within the same tolerance.
struct Economies {
  /// A contact without friction has one unknown, not three.
  bool tangents = true;
  /// No W for an island whose contacts do not approach.
  bool freeIslands = true;
  /// Reactions of the last step that still keep the law are checked, no more.
  bool keptIslands = true;
  /// A contact or a row that is alone is answered by a formula. Problem files also by a few sweeps
  /// of that formula, where these suffice.
  bool closedForms = true;
  /// No search where there is one region: joints without limits, motors and contacts.
  bool oneRegion = true;
  /// Joints that leave few contacts are eliminated once, and not swept over.
  bool joints = true;
  /// No factorisation where the region and W stand.
  bool factors = true;
  /// No push problem where no penetration splits.
  bool pushes = true;
  /// No contact events where nobody listens; if false they are made, and nobody is called.
  bool events = true;
  /// Memory is kept from step to step.
  bool storage = true;
};

}  // namespace delassus
