// Patterns of files: pictures and densities. None is evaluated yet.
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

constexpr PatternHosts kPigments{.normal = false, .texture = false, .function = false};

}  // namespace

constinit const PatternInfo pattern_kinds::bump_map{
    .block = PatternBlock::of_host, .hosts = kNormalsOnly, .choice = PatternChoice::own, .lack = PatternLack::file};
constinit const PatternInfo pattern_kinds::density_file{.operands = operands_of<DensityFile, kDensityFile>,
                                                        .read = read_operands<DensityFile, read_density_file>,
                                                        .lack = PatternLack::file};
constinit const PatternInfo pattern_kinds::image_map{.block = PatternBlock::image,
                                                     .hosts = kPigments,
                                                     .instead = "image_pattern",
                                                     .choice = PatternChoice::own,
                                                     .lack = PatternLack::file};
constinit const PatternInfo pattern_kinds::image_pattern{.block = PatternBlock::image, .lack = PatternLack::file};
/// A material_map replaces a texture and is read by the reader of textures.
constinit const PatternInfo pattern_kinds::material_map{.block = PatternBlock::of_host,
                                                        .hosts = {.pigment = false, .normal = false, .function = false},
                                                        .choice = PatternChoice::own,
                                                        .lack = PatternLack::file};

}  // namespace isl::render
