// The swap that README shows: a box comes to rest on the ground, and the ground carries its weight.
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdlib>

#include "bullet_ext/btDelassusConstraintSolver.h"

int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btDelassusConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, -10, 0));

  btStaticPlaneShape plane(btVector3(0, 1, 0), 0);
  btRigidBody ground(0, nullptr, &plane);
  world.addRigidBody(&ground);

  btBoxShape cube(btVector3(0.5, 0.5, 0.5));
  btVector3 inertia;
  cube.calculateLocalInertia(1, inertia);
  btDefaultMotionState start(btTransform(btQuaternion::getIdentity(), btVector3(0, 0.5, 0)));
  btRigidBody box(1, &start, &cube, inertia);
  world.addRigidBody(&box);

  for (int step = 0; step < 60; ++step) world.stepSimulation(btScalar(1) / 60, 0);

  const bool rests = std::abs(box.getWorldTransform().getOrigin().y() - 0.5) < 1e-3 &&
                     box.getLinearVelocity().length() < 1e-4;
  world.removeRigidBody(&box);
  world.removeRigidBody(&ground);
  return rests && solver.report().contacts > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
