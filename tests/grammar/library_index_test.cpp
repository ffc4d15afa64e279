#include "grammar/library_index.h"

#include "tests/grammar/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::grammar {
namespace {

using test::TemporaryFolder;
using testing::ElementsAre;
using testing::Eq;
using testing::IsEmpty;
using testing::Optional;

TEST(NamesDeclared, AreThoseOfDeclareAndMacro) {
  EXPECT_THAT(names_declared_in("#declare White = rgb 1; # declare Black=rgb 0;\n#macro Grey (A) rgb A #end"),
              ElementsAre("White", "Black", "Grey"));
}

TEST(NamesDeclared, AreThoseUnderConditionsToo) {
  EXPECT_THAT(
      names_declared_in("#ifndef (Seen) #declare Seen = 1; #if (1) #declare A = 1; #else #end #end #declare B = 2;"),
      ElementsAre("Seen", "A", "B"));
}

TEST(NamesDeclared, AreNotThoseThatAMacroDeclaresWhenItIsCalled) {
  EXPECT_THAT(names_declared_in("#macro M() #if (1) #declare Inner = 1; #end #end #declare Outer = 1; #local L = 1;"),
              ElementsAre("M", "Outer"));
}

TEST(NamesDeclared, AreNotThoseInCommentsAndStrings) {
  EXPECT_THAT(
      names_declared_in("// #declare A = 1;\n/* #declare B = 1; /* */ #declare C = 1; */ #debug \"\\\"#declare D\""),
      IsEmpty());
}

TEST(NamesDeclared, OfTextThatEndsTooEarlyAreWhatThereIs) {
  for (const char* const text : {"#", "#declare", "#declare ", "#macro", "\"", "/*", "/", "#end #end", "\"\\"})
    EXPECT_LE(names_declared_in(text).size(), 1u) << text;
}

TEST(LibraryIndex, NamesTheFirstFileThatDeclaresAName) {
  const TemporaryFolder first, second;
  first.write("b.inc", "#declare Both = 1; #declare Twice = 1;");
  first.write("c.inc", "#declare Twice = 1;");
  first.write("scene.pov", "#declare Scenery = 1;");
  second.write("a.inc", "#declare Both = 1; #declare Second = 1;");
  const LibraryIndex index({first.path(), second.path(), first.path() / "missing"});
  EXPECT_THAT(index.file_that_declares("Both"), Optional(Eq("b.inc")));
  EXPECT_THAT(index.file_that_declares("Twice"), Optional(Eq("b.inc")));
  EXPECT_THAT(index.file_that_declares("Second"), Optional(Eq("a.inc")));
  EXPECT_EQ(index.file_that_declares("Scenery"), std::nullopt) << "a scene is no library";
}

TEST(LibraryIndex, NamesFilesOfBothEndings) {
  const TemporaryFolder folder;
  folder.write("a.isl", "#declare Both = 1; #declare Ours = 1; #macro Grown(A) A #end");
  folder.write("b.inc", "#declare Both = 1;");
  const LibraryIndex index({folder.path()});
  EXPECT_THAT(index.file_that_declares("Ours"), Optional(Eq("a.isl")));
  EXPECT_THAT(index.file_that_declares("Grown"), Optional(Eq("a.isl")));
  EXPECT_THAT(index.file_that_declares("Both"), Optional(Eq("b.inc"))) << ".inc comes first";
}

}  // namespace
}  // namespace isl::grammar
