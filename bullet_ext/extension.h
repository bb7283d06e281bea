#pragma once

#include <cstddef>

struct btContactSolverInfo;

namespace delassus {
struct StepReport;
}

namespace delassus::bullet {

struct Answer;
struct Group;
struct GroupInput;

/// The parts of a group that are neither btRigidBody nor btTypedConstraint.
class Extension {
 public:
  virtual ~Extension() = default;
  /// Called after the rigid bodies are gathered: adds bodies that contacts may refer to.
  virtual void gatherBodies(Group& group, const GroupInput& input, StepReport& report) = 0;
  /// Called after contacts and joints are gathered: adds rows.
  virtual void gatherRows(Group& group, const GroupInput& input, StepReport& report) = 0;
  /// Fills the guesses of its rows.
  virtual void recall(Group& group) const = 0;
  virtual void writeBack(const Group& group, const Answer& answer,
                         const btContactSolverInfo& info) = 0;
  /// Frees all storage.
  virtual void release() = 0;
  virtual std::size_t bytes() const = 0;
};

}  // namespace delassus::bullet
