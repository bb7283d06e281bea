#include "demos/scenes/bullet_file.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "demos/scenes/builders.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

/// Each test has a folder of its own, which is removed after it.
class BulletFile : public testing::Test {
 protected:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() /
      ("delassus_bullet_file_" + std::string(byPrecision(1, 0) > 0 ? "d" : "f") +
       std::to_string(getpid()) + testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& bytes) const {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
    return path;
  }

  static std::string serialised(World& world) {
    btDefaultSerializer serializer;
    world.dynamics().serialize(&serializer);
    return {reinterpret_cast<const char*>(serializer.getBufferPointer()),
            std::size_t(serializer.getCurrentBufferSize())};
  }

  static std::string complaintAbout(const std::string& path) {
    try {
      loadBulletFile(path);
    } catch (const BulletFileError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(BulletFile, BringsBackAWorldAsItWas) {
  const auto original = buildStack(3, 7);
  original->dynamics().setGravity(vec3(0, -5, 1));
  original->dynamics().getSolverInfo().m_erp2 = btScalar(0.8);
  const LoadedFile loaded = loadBulletFile(write("stack.bullet", serialised(*original)));

  EXPECT_EQ(loaded.world->dynamics().getGravity(), original->dynamics().getGravity());
  EXPECT_EQ(loaded.world->movableBodies().size(), 3U);
  EXPECT_EQ(stateOf(*loaded.world), stateOf(*original));
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(loaded.world->movableBodies()[i]->getInvMass(),
                original->movableBodies()[i]->getInvMass(), 1e-6);
}

TEST_F(BulletFile, KeepsGravityButNotTheSolverSettingsAndSaysSo) {
  const auto original = buildStack(1, 1);
  original->dynamics().getSolverInfo().m_erp2 = btScalar(0.8);
  const LoadedFile loaded = loadBulletFile(write("box.bullet", serialised(*original)));
  EXPECT_EQ(loaded.world->dynamics().getSolverInfo().m_erp2, btContactSolverInfo().m_erp2);
  std::string notes;
  for (const std::string& note : loaded.notes) notes += note + "\n";
  EXPECT_NE(notes.find("kept from the file: gravity"), std::string::npos) << notes;
  EXPECT_NE(notes.find("not kept: its solver settings"), std::string::npos) << notes;
  EXPECT_NE(notes.find("erp2 0.8"), std::string::npos) << notes;
}

// Found by fuzzing: some steps later, when something comes near such a shape, Bullet reads from
// nowhere.
TEST_F(BulletFile, RefusesShapesWithoutPoints) {
  btConvexHullShape hull;
  btCompoundShape compound;
  compound.addChildShape(btTransform::getIdentity(), &hull);
  for (btCollisionShape* shape : std::initializer_list<btCollisionShape*>{&hull, &compound}) {
    btRigidBody body(1, nullptr, shape, btVector3(1, 1, 1));
    const auto original = buildStack(1, 1);
    original->dynamics().addRigidBody(&body);
    const std::string path = write("hollow.bullet", serialised(*original));
    original->dynamics().removeRigidBody(&body);
    const std::string complaint = complaintAbout(path);
    EXPECT_NE(complaint.find("has no points"), std::string::npos) << complaint;
    EXPECT_NE(complaint.find("hollow.bullet"), std::string::npos) << complaint;
  }
}

TEST_F(BulletFile, NamesWhatCannotBeRead) {
  const std::string missing = (folder_ / "no" / "such.bullet").string();
  EXPECT_NE(complaintAbout(missing).find(missing), std::string::npos);
  EXPECT_NE(complaintAbout(folder_.string()).find("directory"), std::string::npos);
  EXPECT_NE(complaintAbout(write("empty.bullet", "")).find("empty.bullet"), std::string::npos);
  EXPECT_NE(complaintAbout(write("text.bullet", "this is not a world")).find("'BULLET'"),
            std::string::npos);
}

TEST_F(BulletFile, RefusesATruncatedFileOfAnyLength) {
  const std::string whole = serialised(*buildStack(2, 1));
  for (std::size_t length = 6; length < whole.size(); length += 1 + whole.size() / 97) {
    const std::string complaint = complaintAbout(write("part.bullet", whole.substr(0, length)));
    EXPECT_NE(complaint.find("part.bullet"), std::string::npos)
        << length << " bytes of " << whole.size();
    EXPECT_EQ(complaint.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace demos
