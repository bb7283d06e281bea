// What the report times: each repeat of a method solves the very step that its first run solved.
#include "demos/report/methods.h"

#include <gtest/gtest.h>

#include "bullet_ext/btDelassusConstraintSolver.h"
#include "demos/report/captured_step.h"
#include "demos/scenes/catalogue.h"
#include "tests/scenes/run_scene.h"

namespace demos::report {
namespace {

constexpr double h = 1.0 / 60;

/// Shows `look` the step after `stepsBefore` steps of a scene, as our solver gets it.
template <class Look>
void lookAtStep(const char* scene, int stepsBefore, const Look& look) {
  const std::unique_ptr<World> world = findScene(scene).build();
  NamedSolver usual("delassus");
  world->setSolver(usual.solver());
  for (int i = 0; i < stepsBefore; ++i) world->step(h);
  StepCapture capture(usual.solver());
  capture.beforeSolve = look;
  world->setSolver(capture);
  world->step(h);
  world->setSolver(usual.solver());
}

MethodRun run(const CapturedStep& step, const char* method, const StepMemory& memory, int repeats) {
  const Timing timing{10, repeats, repeats, 10};
  return runMethod(methodNamed(method), step, StepProblem(step, 0), memory, timing);
}

TEST(Method, RepeatsTheWorkOfItsFirstRun) {
  for (const char* scene : {"stack_10", "arch", "pyramid_10"})
    lookAtStep(scene, 0, [scene](const CapturedStep& step) {
      const StepMemory nothing(readMemory(step).size());
      const MethodRun once = run(step, "delassus", nothing, 0);
      const MethodRun often = run(step, "delassus", nothing, 6);
      ASSERT_EQ(once.ending, Ending::Done) << scene;
      ASSERT_EQ(often.ending, Ending::Done) << scene;
      EXPECT_EQ(often.repeats, 6) << scene;
      EXPECT_GT(once.regions, 0) << scene;
      EXPECT_EQ(often.regions, once.regions) << scene;
      EXPECT_EQ(often.factorisations, once.factorisations) << scene;
      EXPECT_EQ(often.residualMax, once.residualMax) << scene;
    });
}

TEST(Method, BeginsFromWhatThePointsCarry) {
  lookAtStep("stack_10", 30, [](const CapturedStep& step) {
    EXPECT_EQ(run(step, "delassus", readMemory(step), 3).regions, 0);
    EXPECT_GT(run(step, "delassus", StepMemory(readMemory(step).size()), 3).regions, 0);
  });
}

// Joints are recognised by the impulse with which they were left.
TEST(StepProblem, LeavesJointsAsTheyAre) {
  int joints = 0;
  lookAtStep("ragdolls", 20, [&joints](const CapturedStep& step) {
    std::vector<btScalar> before;
    const auto forEach = [&step](auto visit) {
      for (const CapturedStep::Group& group : step.groups)
        for (btTypedConstraint* joint : group.constraints)
          visit(joint->internalGetAppliedImpulse());
    };
    forEach([&before](btScalar impulse) { before.push_back(impulse); });
    const StepProblem problem(step, 0);
    std::size_t k = 0;
    forEach([&](btScalar impulse) {
      EXPECT_EQ(impulse, before[k++]);
      joints += impulse != 0;
    });
  });
  EXPECT_GT(joints, 10);
}

}  // namespace
}  // namespace demos::report
