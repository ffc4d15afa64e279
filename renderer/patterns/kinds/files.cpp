// Patterns of files that are no images: densities. They are not evaluated yet.
#include "renderer/patterns/kinds/pattern_kind.h"

namespace isl::render {
namespace {

struct DensityFile {
  std::string file;
  int interpolate = 0;
};
constexpr scene::OperandField kDensityFile[] = {scene::operand<&DensityFile::file>("file"),
                                                scene::modifier<&DensityFile::interpolate>("interpolate").within(0, 2)};

void read_density_file(scene::OperandReader& reader, DensityFile& density, std::string_view /*word*/) noexcept {
  if (!reader.accept_word("df3")) reader.expected("`df3` after `density_file`");
  density.file = reader.file_name("the name of a file");
}

}  // namespace

constinit const PatternInfo pattern_kinds::density_file{.operands = operands_of<DensityFile, kDensityFile>,
                                                        .read = read_operands<DensityFile, read_density_file>,
                                                        .lack = PatternLack::file};

}  // namespace isl::render
