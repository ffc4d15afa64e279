// A scene may not write anything without --allow-write. With it, it may not write outside the folder named, to a link,
// or to a file that it is read from.
#include "tests/limits/attack_fixture.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>

namespace isl::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Writing : public AttackTest {
 protected:
  Writing() {
    write("scenes/near.inc", "#declare Near = 1;");
    write("scenes/data.txt", "1, 2");
    write("precious.txt", "precious");
    fs::create_directory(folder() / "out");
    fs::create_symlink("../precious.txt", folder() / "out/link.txt");
    fs::create_symlink("../nothing.txt", folder() / "out/dangling.txt");
    fs::create_directory_symlink("..", folder() / "out/up");
    fs::create_directory(folder() / "out/inner");
  }

  /// The result of a scene in scenes/ that writes to a file of that name.
  ProcessResult try_writing(const std::string& name, const std::string& mode, std::vector<std::string> options) {
    write("scenes/scene.isl", kScene + fmt::format("#fopen F \"{}\" {} #write (F, \"taken\") #fclose F\n", name, mode));
    return check_file("scenes/scene.isl", std::move(options));
  }

  [[nodiscard]] std::vector<std::string> tree() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder())) names.push_back(entry.path());
    std::sort(names.begin(), names.end());
    return names;
  }

  const std::string kScene = "#include \"near.inc\" #fopen In \"data.txt\" read #read (In, A)\n";
};

TEST_F(Writing, NothingUnlessItIsAllowed) {
  const std::vector<std::string> before = tree();
  for (const std::string mode : {"write", "append"}) {
    const ProcessResult result = try_writing("x.txt", mode, {});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("`--allow-write DIR` lets it write below DIR"));
    EXPECT_THAT(result.err, HasSubstr("scene.isl:2:10"));
  }
  EXPECT_EQ(tree().size(), before.size() + 1) << "only the scene is new";
}

TEST_F(Writing, NotEvenLeniently) {
  const ProcessResult result = try_writing("x.txt", "write", {"--lenient"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("warning: `x.txt` is kept in memory only"));
  EXPECT_FALSE(exists("scenes/x.txt"));
  EXPECT_FALSE(exists("x.txt"));
}

TEST_F(Writing, NothingOutsideTheFolderNamed) {
  for (const std::string& name :
       {std::string("../precious.txt"), (folder() / "precious.txt").string(), std::string("link.txt"),
        std::string("dangling.txt"), std::string("up/precious.txt"), std::string("inner/../../precious.txt"),
        std::string("inner/../up/precious.txt"), std::string("/tmp/isl_attack.txt"), std::string("/dev/null"),
        std::string("inner"), std::string("."), std::string(".."), std::string("inner/"), std::string(""),
        std::string("missing/x.txt")}) {
    for (const std::string mode : {"write", "append"}) {
      const ProcessResult result = try_writing(name, mode, {"--allow-write", "out"});
      EXPECT_EQ(result.exit_code, 1) << name << "\n" << result.err;
      EXPECT_THAT(result.err, HasSubstr("scene.isl:2:10: error:")) << name;
    }
  }
  EXPECT_EQ(read("precious.txt"), "precious");
  EXPECT_FALSE(exists("nothing.txt"));
  EXPECT_FALSE(fs::exists("/tmp/isl_attack.txt"));
}

TEST_F(Writing, NoPipe) {
  ASSERT_EQ(mkfifo((folder() / "out/pipe.txt").c_str(), 0600), 0);
  EXPECT_THAT(try_writing("pipe.txt", "write", {"--allow-write", "out"}).err, HasSubstr("it is not a regular file"));
}

TEST_F(Writing, NeverTheFilesThatTheSceneIsReadFrom) {
  for (const std::string name : {"scene.isl", "near.inc", "data.txt"}) {
    for (const std::string mode : {"write", "append"}) {
      const ProcessResult result = try_writing(name, mode, {"--allow-write", "scenes"});
      EXPECT_EQ(result.exit_code, 1) << name;
      EXPECT_THAT(result.err, HasSubstr(name == "scene.isl" ? "it is the scene" : "it is an input of the scene"))
          << name;
    }
  }
  EXPECT_THAT(read("scenes/scene.isl"), testing::StartsWith(kScene));
  EXPECT_EQ(read("scenes/near.inc"), "#declare Near = 1;");
  EXPECT_EQ(read("scenes/data.txt"), "1, 2");
}

TEST_F(Writing, AnotherNameOfAFileOutsideLeavesThatFileAlone) {
  fs::create_hard_link(folder() / "precious.txt", folder() / "out/hard.txt");
  EXPECT_EQ(try_writing("hard.txt", "write", {"--allow-write", "out"}).exit_code, 0);
  EXPECT_EQ(read("precious.txt"), "precious");
  EXPECT_EQ(read("out/hard.txt"), "taken");
}

TEST_F(Writing, WhatIsAllowedIsWrittenAndLeavesNothingElse) {
  const std::vector<std::string> before = tree();
  EXPECT_EQ(try_writing("x.txt", "write", {"--allow-write", "out"}).exit_code, 0);
  EXPECT_EQ(read("out/x.txt"), "taken");
  EXPECT_EQ(try_writing("x.txt", "append", {"--allow-write", "out"}).exit_code, 0);
  EXPECT_EQ(read("out/x.txt"), "takentaken");
  EXPECT_EQ(try_writing("x.txt", "write", {"--allow-write", "scenes"}).exit_code, 0);
  EXPECT_EQ(read("scenes/x.txt"), "taken");
  EXPECT_EQ(tree().size(), before.size() + 3);
}

TEST_F(Writing, ReadsBackWhatItWrote) {
  write("scenes/scene.isl",
        "#fopen F \"made.inc\" write #write (F, \"#declare Made = \", 6*7, \";\") #fclose F\n"
        "#include \"made.inc\" #debug str(Made, 0, 0)\n"
        "#fopen F \"made.inc\" write #write (F, \"#declare Made = 43;\") #fclose F\n"
        "#include \"made.inc\" #debug str(Made, 0, 0)\n");
  EXPECT_THAT(check_file("scenes/scene.isl", {"--allow-write", "out"}).err, HasSubstr("4243"));
}

TEST_F(Writing, ASceneThatFailsLeavesWhatWasThere) {
  write("out/x.txt", "old");
  const std::string writes =
      "#fopen F \"x.txt\" write #write (F, \"new\") #fclose F\n"
      "#fopen F \"x.txt\" append #write (F, \"er\") #fclose F\n"
      "#fopen G \"y.txt\" write #write (G, \"new\")\n";
  const std::vector<std::string> before = tree();
  for (const std::string failure : {"#error \"over\"", "sphere { 0, 1, 2, 3 }", "#declare A = B;", "#while (1) #end"}) {
    write("scenes/scene.isl", writes + failure);
    EXPECT_EQ(check_file("scenes/scene.isl", {"--allow-write", "out", "--max-turns", "1e4"}).exit_code, 1) << failure;
    EXPECT_EQ(read("out/x.txt"), "old") << failure;
    EXPECT_EQ(tree().size(), before.size() + 1) << "only the scene is new: " << failure;
  }
  write("scenes/scene.isl", writes);
  EXPECT_EQ(check_file("scenes/scene.isl", {"--allow-write", "out"}).exit_code, 0);
  EXPECT_EQ(read("out/x.txt"), "newer");
  EXPECT_EQ(read("out/y.txt"), "new");
  EXPECT_EQ(tree().size(), before.size() + 2);
}

TEST_F(Writing, ASceneReadsWhatItWroteBeforeItIsOnTheDisk) {
  write("scenes/x.inc", "#declare Made = 1;");
  write("scenes/scene.isl",
        "#fopen F \"x.inc\" write #write (F, \"#declare Made = 2;\") #fclose F\n"
        "#include \"./x.inc\" #debug str(Made, 0, 0)\n"
        "#fopen F \"x.inc\" append #write (F, \" #declare Made = 3;\") #fclose F\n"
        "#include \"../scenes/x.inc\" #debug str(Made, 0, 0) #debug str(file_exists(\"x.inc\"), 0, 0)\n"
        "#fopen F \"new\" write #write (F, \"4\") #fclose F #fopen F \"./new\" read #read (F, A) #debug str(A, 0, 0)");
  EXPECT_THAT(check_file("scenes/scene.isl", {"--allow-write", "scenes"}).err, HasSubstr("2314"));
  EXPECT_EQ(read("scenes/x.inc"), "#declare Made = 2; #declare Made = 3;");
}

TEST_F(Writing, AFileThatIsReadAndWrittenIsRefused) {
  write("out/x.inc", "#declare X = 1;");
  fs::create_hard_link(folder() / "out/x.inc", folder() / "out/y.inc");
  const std::string writes = "#fopen F \"y.inc\" write #write (F, \"new\")\n", reads = "#include \"x.inc\"\n";
  for (const std::string& text : {writes + reads, reads + writes}) {
    write("scenes/scene.isl", text);
    const ProcessResult result = check_file("scenes/scene.isl", {"--allow-write", "out", "-I", "out"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, testing::AnyOf(HasSubstr("this run will replace it (#fopen)"),
                                           HasSubstr("it is an input of the scene")));
  }
  EXPECT_EQ(read("out/x.inc"), "#declare X = 1;");
}

TEST_F(Writing, BinaryFormsAreThoseOfPovRay) {
  write("scenes/scene.isl",
        "#fopen F \"b\" write #write (F, uint8 65.7, uint8 300, uint8 -1, sint8 -5, sint8 200, uint16le 65536, "
        "uint16be 2.5, sint16be -1.5, sint16be <1, 2, 3>, sint32le 3e9, sint32be -2, uint8 65, 66) #fclose F");
  EXPECT_EQ(check_file("scenes/scene.isl", {"--allow-write", "out"}).exit_code, 0);
  constexpr std::string_view kExpected(
      "B\xFF\0\xFB\x7F\xFF\xFF\0\x03\xFF\xFF\0\x01\0\x02\0\x03\xFF\xFF\xFF\x7F\xFF\xFF\xFF\xFE"
      "A66",
      28);
  EXPECT_EQ(read("out/b"), kExpected);
}

TEST_F(Writing, EndlessWritingEndsAtTheMemoryLimit) {
  EXPECT_THAT(refusal("#declare S = \"0123456789\"; #for (I, 1, 10) #declare S = concat(S, S); #end\n"
                      "#fopen F \"x\" write #while (1) #write (F, S) #end",
                      {"--allow-write", "out"}),
              HasSubstr("`--max-memory` raises the limit"));
  EXPECT_THAT(refusal("#declare S = \"0123456789\"; #for (I, 1, 15) #declare S = concat(S, S); #end\n"
                      "#while (1) #fopen F \"x\" write #write (F, S) #fclose F #end",
                      {"--allow-write", "out"}),
              HasSubstr("`--max-memory` raises the limit"));
}

TEST_F(Writing, EndlessWritingAndIncludingEndsAtTheMemoryLimit) {
  EXPECT_THAT(refusal("#declare S = \"//34567890\"; #for (I, 1, 18) #declare S = concat(S, S); #end\n"
                      "#while (1) #fopen F \"x.inc\" write #write (F, S) #fclose F #include \"x.inc\" #end",
                      {"--allow-write", "out"}),
              HasSubstr("`--max-memory` raises the limit"));
}

TEST_F(Writing, TooManyOpenFilesAreRefused) {
  std::string text;
  for (int i = 0; i < 65; ++i) text += fmt::format("#fopen F{0} \"{0}\" write\n", i);
  EXPECT_THAT(refusal(text, {"--allow-write", "out"}), HasSubstr("more than 64 files are open at once"));
}

TEST_F(Writing, EndlessMakingOfFilesEndsAtTheirNumber) {
  const std::string text =
      "#declare I = 0; #while (1) #declare I = I + 1;\n"
      "#fopen F concat(\"f\", str(I, 0, 0)) write #write (F, \"x\") #fclose F #end";
  for (const std::string& limit : {std::string(), std::string("20")}) {
    std::vector<std::string> options{"--allow-write", "out"};
    if (!limit.empty()) options.insert(options.end(), {"--max-files", limit});
    const std::string said = refusal(text, options);
    EXPECT_THAT(said, HasSubstr(fmt::format("scene.isl:2:1: error: the scene writes more than {} files",
                                            limit.empty() ? "1000" : limit)));
    EXPECT_THAT(said, HasSubstr("`--max-files` raises the limit"));
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder() / "out"), fs::directory_iterator()), 4)
      << "the folder and the links that were there";
  EXPECT_THAT(refusal(text, {"--lenient"}), HasSubstr("the scene writes more than 1000 files")) << "in memory, too";
}

TEST_F(Writing, AsManyFilesAsAreAllowedAreMade) {
  write("scenes/scene.isl",
        "#for (I, 1, 1500) #fopen F concat(\"f\", str(I, 0, 0)) write #write (F, I) #fclose F #end");
  EXPECT_EQ(check_file("scenes/scene.isl", {"--allow-write", "out/inner", "--max-files", "1500"}).exit_code, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder() / "out/inner"), fs::directory_iterator()), 1500);
  EXPECT_EQ(read("out/inner/f1500"), "1500");
}

TEST_F(Writing, OneFileMayBeWrittenAgainAndAgain) {
  write("scenes/scene.isl", "#for (I, 1, 3000) #fopen F \"x\" write #write (F, I) #fclose F #end");
  EXPECT_EQ(check_file("scenes/scene.isl", {"--allow-write", "out"}).exit_code, 0);
  EXPECT_EQ(read("out/x"), "3000");
}

TEST_F(Writing, EndlessTextOfDebugEndsAtItsLength) {
  const std::string said = refusal("#while (1)\n  #debug \"0123456789\\n\" #end", {"--max-debug", "20K"});
  EXPECT_THAT(said, HasSubstr("scene.isl:2:3: error: the scene prints more than 20480 bytes with `#debug`"));
  EXPECT_THAT(said, HasSubstr("`--max-debug` raises the limit"));
  const auto lines = std::count(said.begin(), said.end(), '\n');
  EXPECT_GE(lines, 20480 / 11);
  EXPECT_LE(lines, 20480 / 11 + 10);
}

TEST_F(Writing, AFolderThatIsNoneIsSaid) {
  const ProcessResult result = try_writing("x.txt", "write", {"--allow-write", "none"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("--allow-write: `none` is not a folder"));
}

}  // namespace
}  // namespace isl::test
