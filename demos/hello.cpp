// The library in one page: a world as in Bullet's own hello world, with another solver.
#include <btBulletDynamicsCommon.h>

#include <cstdio>

#include "bullet_ext/btDelassusConstraintSolver.h"

int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btDelassusConstraintSolver solver;  // the one line that changes
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, btScalar(-9.81), 0));

  // A tonne on nine boxes of a kilogram.
  const btScalar half(0.5);
  btBoxShape groundShape(btVector3(10, 1, 10)), boxShape(btVector3(half, half, half));
  btRigidBody ground(0, nullptr, &groundShape);
  ground.translate(btVector3(0, -1, 0));
  world.addRigidBody(&ground);
  btAlignedObjectArray<btRigidBody*> boxes;
  for (int i = 0; i < 10; ++i) {
    const btScalar mass(i == 9 ? 1000 : 1);
    btVector3 inertia;
    boxShape.calculateLocalInertia(mass, inertia);
    boxes.push_back(new btRigidBody(mass, nullptr, &boxShape, inertia));
    boxes[i]->translate(btVector3(0, half + btScalar(i), 0));
    boxes[i]->setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(boxes[i]);
  }

  for (int step = 0; step < 600; ++step) world.stepSimulation(btScalar(1.0 / 60), 0);
  std::printf("after 10 s the top is at %.6f m (it started at 9.5)\n",
              double(boxes[9]->getWorldTransform().getOrigin().y()));
  std::printf("%d contacts, residual %.1e m/s\n", solver.report().contacts,
              solver.report().residualMax);

  for (int i = 0; i < boxes.size(); ++i) {
    world.removeRigidBody(boxes[i]);
    delete boxes[i];
  }
  world.removeRigidBody(&ground);
}
