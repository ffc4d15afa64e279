#include "grammar/loader.h"

#include "tests/grammar/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::grammar {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;

class LoaderTest : public testing::Test {
 protected:
  /// A loader whose scene is `scene.isl` in the folder.
  Loader& loader(std::vector<fs::path> include_paths = {}) {
    folder_.write("scenes/scene.isl", "");
    loader_.emplace(map_, symbols_, arena_, sink_,
                    LoaderOptions{.folders = {.search_path = std::move(include_paths)}, .outputs = outputs_});
    scene_ = loader_->load_scene(folder_.path() / "scenes/scene.isl");
    return *loader_;
  }
  [[nodiscard]] std::string last_message() const { return sink_.diagnostics().back().message; }

  TemporaryFolder folder_;
  std::shared_ptr<OutputSet> outputs_ = std::make_shared<OutputSet>();
  SourceMap map_;
  SymbolTable symbols_;
  Arena arena_;
  DiagnosticSink sink_;
  std::optional<Loader> loader_;
  const Unit* scene_ = nullptr;
};

TEST_F(LoaderTest, ReportsASceneThatIsMissing) {
  Loader loader(map_, symbols_, arena_, sink_, {});
  EXPECT_EQ(loader.load_scene(folder_.path() / "none.isl"), nullptr);
  EXPECT_EQ(loader.last_error(), LoadError::not_found);
  EXPECT_THAT(last_message(), HasSubstr("none.isl"));
}

TEST_F(LoaderTest, TellsUnreadableFromMissing) {
  Loader loader(map_, symbols_, arena_, sink_, {});
  EXPECT_EQ(loader.load_scene(folder_.path()), nullptr);
  EXPECT_EQ(loader.last_error(), LoadError::not_readable);
}

TEST_F(LoaderTest, LooksBesideTheIncludingFileBeforeTheIncludePaths) {
  folder_.write("scenes/a.inc", "Beside");
  folder_.write("lib/a.inc", "Library");
  folder_.write("lib/b.inc", "Library B");
  folder_.write("more/b.inc", "More");
  Loader& loader = this->loader({folder_.path() / "lib", folder_.path() / "more"});
  EXPECT_EQ(map_.text(loader.load_include("a.inc", {}, *scene_)->span), "Beside");
  const Unit* const b = loader.load_include("b.inc", {}, *scene_);
  EXPECT_EQ(map_.text(b->span), "Library B");
  EXPECT_EQ(map_.text(loader.load_include("a.inc", {}, *b)->span), "Library") << "beside the library that asks";
}

TEST_F(LoaderTest, SaysWhereItLookedAndBlamesTheInclude) {
  Loader& loader = this->loader({folder_.path() / "lib"});
  EXPECT_EQ(loader.load_include("none.inc", {3, 7}, *scene_), nullptr);
  EXPECT_EQ(loader.last_error(), LoadError::not_found);
  EXPECT_EQ(sink_.diagnostics().back().span, (SourceSpan{3, 7}));
  EXPECT_THAT(sink_.diagnostics().back().hint, HasSubstr("lib"));
}

TEST_F(LoaderTest, ParsesAFileOnce) {
  folder_.write("scenes/a.inc", "A");
  Loader& loader = this->loader();
  const Unit* const first = loader.load_include("a.inc", {}, *scene_);
  EXPECT_EQ(loader.load_include("a.inc", {}, *scene_), first);
  EXPECT_EQ(loader.load_include("../scenes/a.inc", {}, *scene_), first) << "by another name";
}

TEST_F(LoaderTest, ParsesAFileAgainThatHasChanged) {
  folder_.write("scenes/a.inc", "A");
  Loader& loader = this->loader();
  static_cast<void>(loader.load_include("a.inc", {}, *scene_));
  folder_.write("scenes/a.inc", "A B");
  EXPECT_EQ(loader.load_include("a.inc", {}, *scene_)->items.size(), 2u);
}

TEST_F(LoaderTest, ParsesEveryVersionThatTheRunWrites) {
  Loader& loader = this->loader();
  for (const char* const text : {"A B", "B A"}) {
    loader.access().write(loader.access().in_memory("a.inc"), "a.inc", text, {});
    EXPECT_EQ(map_.text(loader.load_include("a.inc", {}, *scene_)->span), text) << "no clock is too coarse for that";
  }
}

TEST_F(LoaderTest, RefusesAFileThatTheRunWillReplace) {
  const fs::path file = folder_.write("scenes/a.inc", "A");
  fs::create_hard_link(file, folder_.path() / "scenes/other.inc");
  Loader& loader = this->loader();
  ASSERT_EQ(outputs_->files().add_output(identity_of(file), "-o a.inc"), nullptr);
  for (const char* const name : {"a.inc", "../scenes/a.inc", "other.inc"}) {
    EXPECT_EQ(loader.load_include(name, {}, *scene_), nullptr) << name;
    EXPECT_THAT(last_message(), HasSubstr("this run will replace it (-o a.inc)")) << name;
    AccessProblem problem;
    EXPECT_EQ(loader.open_data(name, *scene_, problem), nullptr) << name;
    EXPECT_THAT(problem.message, HasSubstr("this run will replace it")) << name;
    EXPECT_FALSE(loader.use_file(name, *scene_, problem)) << name;
    EXPECT_THAT(problem.message, HasSubstr("this run will replace it")) << name;
  }
}

TEST_F(LoaderTest, RemembersThatAFileHasErrors) {
  folder_.write("scenes/a.inc", "A )");
  Loader& loader = this->loader();
  for (int i = 0; i < 2; ++i) {
    EXPECT_NE(loader.load_include("a.inc", {}, *scene_), nullptr);
    EXPECT_EQ(loader.last_error(), LoadError::syntax);
  }
  EXPECT_EQ(loader.complaints().size(), 1u);
  EXPECT_FALSE(sink_.has_errors()) << "the mistake is reported when the file is executed";
}

TEST_F(LoaderTest, ReadsNothingOutsideItsFolders) {
  const fs::path secret = folder_.write("secret/a.inc", "Secret");
  folder_.write("scenes/inner/b.inc", "");
  Loader& loader = this->loader({folder_.path() / "scenes/inner"});
  fs::create_symlink(secret, folder_.path() / "scenes/link.inc");
  fs::create_directory_symlink(folder_.path() / "secret", folder_.path() / "scenes/linked");
  for (const std::string& name : {std::string("../secret/a.inc"), secret.string(), std::string("link.inc"),
                                  std::string("linked/a.inc"), std::string("inner/../../secret/a.inc")}) {
    EXPECT_EQ(loader.load_include(name, {}, *scene_), nullptr) << name;
    EXPECT_EQ(loader.last_error(), LoadError::not_readable) << name;
    EXPECT_THAT(last_message(), HasSubstr("outside")) << name;
  }
}

TEST_F(LoaderTest, ReadsWithinItsFoldersByAnyPath) {
  const fs::path inner = folder_.write("scenes/inner/b.inc", "B");
  Loader& loader = this->loader();
  EXPECT_NE(loader.load_include("inner/b.inc", {}, *scene_), nullptr);
  EXPECT_NE(loader.load_include(inner.string(), {}, *scene_), nullptr);
  EXPECT_NE(loader.load_include("inner/../inner/b.inc", {}, *scene_), nullptr);
}

TEST_F(LoaderTest, DoesNotTakeAFolderForOneThatBeginsWithItsName) {
  folder_.write("scenes_secret/a.inc", "Secret");
  EXPECT_EQ(loader().load_include("../scenes_secret/a.inc", {}, *scene_), nullptr);
}

TEST_F(LoaderTest, RefusesAnEmptyNameAndAFolder) {
  Loader& loader = this->loader();
  EXPECT_EQ(loader.load_include("", {}, *scene_), nullptr);
  EXPECT_EQ(loader.load_include(".", {}, *scene_), nullptr);
  EXPECT_EQ(loader.last_error(), LoadError::not_readable);
}

TEST_F(LoaderTest, GivesEachFileItsName) {
  folder_.write("scenes/a.inc", "A");
  const Unit* const unit = loader().load_include("a.inc", {}, *scene_);
  EXPECT_EQ(map_.position(unit->span.begin).file, (folder_.path() / "scenes/a.inc").string());
}

}  // namespace
}  // namespace isl::grammar
