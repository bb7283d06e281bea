#pragma once

namespace delassus {

/// Work that a step saves where its scene does not need it. Each economy can be switched off
/// (false) to measure its worth: reactions keep the law to within the same tolerance.
struct Economies {
  /// A contact without friction has one unknown, not three.
  bool tangents = true;
  /// An island whose contacts do not approach needs no W.
  bool freeIslands = true;
  /// Reactions of the last step that still keep the law are only checked.
  bool keptIslands = true;
  /// A formula answers a lone contact or row. Problem files are also answered by a few sweeps of
  /// that formula, where these suffice.
  bool closedForms = true;
  /// There is no search where there is one region: joints without limits, motors and contacts.
  bool oneRegion = true;
  /// Joints are eliminated once, and not swept over, where few contacts are left then.
  bool joints = true;
  /// Nothing is factored again while the region and W stay the same.
  bool factors = true;
  /// Contacts between bodies that welds make one take no part, unless a weld may break that does
  /// not link the two themselves.
  bool weldedContacts = true;
  /// Without split penetration there is no push problem.
  bool pushes = true;
  /// Contact events are made only where somebody listens; if false, they are made anyway.
  bool events = true;
  /// Storage is kept from step to step.
  bool storage = true;
};

}  // namespace delassus
