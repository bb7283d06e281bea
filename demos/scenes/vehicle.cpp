#include "demos/scenes/benchmarks.h"
#include "demos/scenes/builders.h"

namespace demos {

namespace {

constexpr btScalar chassisMass = 800, plankMass = 100;     // kg
constexpr btScalar engineForce = 1000, brakeImpulse = 20;  // N of a driven wheel, N·s a step of any
constexpr double drivesUntil = 5;                          // s
constexpr double startX = 20;                              // m; it drives towards -x

/// Bullet's vehicle and the parts it needs. It is an action of the world: it pushes the chassis
/// after each step.
struct Vehicle {
  Vehicle(btDynamicsWorld& in, btRigidBody& chassis)
      : world(in), raycaster(&in), vehicle(tuning, &chassis, &raycaster) {
    vehicle.setCoordinateSystem(2, 1, 0);  // right, up, forward
    world.addVehicle(&vehicle);
  }
  ~Vehicle() { world.removeVehicle(&vehicle); }
  Vehicle(const Vehicle&) = delete;
  Vehicle& operator=(const Vehicle&) = delete;

  void addWheel(const btVector3& place, bool front) {
    constexpr btScalar suspension = btScalar(0.5), radius = btScalar(0.4);  // m
    btWheelInfo& wheel =
        vehicle.addWheel(place, vec3(0, -1, 0), vec3(0, 0, -1), suspension, radius, tuning, front);
    wheel.m_suspensionStiffness = 20;
    wheel.m_wheelsDampingRelaxation = wheel.m_wheelsDampingCompression = 4;
    wheel.m_rollInfluence = btScalar(0.1);
  }

  btDynamicsWorld& world;
  btRaycastVehicle::btVehicleTuning tuning;
  btDefaultVehicleRaycaster raycaster;
  btRaycastVehicle vehicle;
};

/// Three layers, each shorter than the one below: steps of an eighth of a metre that the wheels
/// climb.
void addMound(World& world) {
  constexpr double halfThickness = 0.0625, pitch = 0.65;  // m; heights are without rounding
  const btVector3 half = vec3(0.3, halfThickness, 3);
  const int planks[] = {11, 8, 5};
  for (int layer = 0; layer < 3; ++layer)
    for (int i = 0; i < planks[layer]; ++i)
      addBox(world, half, plankMass,
             at(pitch * (i - 0.5 * (planks[layer] - 1)), halfThickness * (1 + 2 * layer), 0));
}

}  // namespace

std::unique_ptr<World> buildVehicleOnPlanks() {
  auto world = std::make_unique<World>();
  addGround(*world, usualFriction, 100);
  btRigidBody& chassis = addBox(*world, vec3(2, 0.4, 1), chassisMass, at(startX, 1.2, 0));
  addMound(*world);

  auto car = std::make_shared<Vehicle>(world->dynamics(), chassis);
  for (const bool front : {true, false})
    for (const double side : {-0.9, 0.9}) car->addWheel(vec3(front ? 1.5 : -1.5, 0, side), front);
  world->keep(car);
  world->setScript([&vehicle = car->vehicle](double time) {
    const bool drives = time < drivesUntil;
    for (int wheel = 0; wheel < vehicle.getNumWheels(); ++wheel) {
      vehicle.applyEngineForce(drives && wheel < 2 ? engineForce : 0, wheel);
      vehicle.setBrake(drives ? 0 : brakeImpulse, wheel);
    }
  });
  return world;
}

}  // namespace demos
