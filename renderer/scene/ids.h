// Ids of records in the primitive database: each is an index into one column of scene::Database.
#pragma once

#include <cstdint>

namespace isl::scene {

inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;

enum class BlobId : std::uint32_t {};
enum class SolidId : std::uint32_t {};
enum class GroupId : std::uint32_t {};
enum class TextureId : std::uint32_t {};
enum class FinishId : std::uint32_t {};
enum class PigmentId : std::uint32_t {};
enum class NormalId : std::uint32_t {};
enum class TexturePatternId : std::uint32_t {};
enum class PigmentMapId : std::uint32_t {};
enum class NormalMapId : std::uint32_t {};
enum class SlopeMapId : std::uint32_t {};
enum class TextureMapId : std::uint32_t {};
enum class ImageId : std::uint32_t {};
enum class InteriorId : std::uint32_t {};
enum class TransformId : std::uint32_t {};
enum class FunctionId : std::uint32_t {};
#define ISL_SOLID_DETAIL(word, Type, column) enum class Type##Id : std::uint32_t{};
#include "renderer/scene/solids.def"
enum class PatternObjectId : std::uint32_t {};
enum class KernelId : std::uint16_t {};

inline constexpr TextureId kNoTexture{kNone};
inline constexpr GroupId kNoGroup{kNone};
inline constexpr FinishId kDefaultFinish{kNone};
inline constexpr PigmentId kPlainColour{kNone};
inline constexpr NormalId kNoNormal{kNone};
inline constexpr TexturePatternId kNoTexturePattern{kNone};
inline constexpr PigmentMapId kNoPigmentMap{kNone};
inline constexpr NormalMapId kNoNormalMap{kNone};
inline constexpr SlopeMapId kNoSlopeMap{kNone};
inline constexpr TextureMapId kNoTextureMap{kNone};
inline constexpr ImageId kNoImage{kNone};
inline constexpr InteriorId kNoInterior{kNone};
inline constexpr FunctionId kNoFunction{kNone};
inline constexpr TransformId kIdentity{kNone};

template <class Id>
[[nodiscard]] constexpr std::uint32_t index(Id id) {
  return static_cast<std::uint32_t>(id);
}

}  // namespace isl::scene
