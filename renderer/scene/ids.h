// Numbers of records in the primitive database. Each is an index into one column of scene::Database.
#pragma once

#include <cstdint>

namespace isl::scene {

inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;

enum class BlobId : std::uint32_t {};
enum class SolidId : std::uint32_t {};
enum class GroupId : std::uint32_t {};
enum class TextureId : std::uint32_t {};
enum class TransformId : std::uint32_t {};
enum class FunctionId : std::uint32_t {};
enum class KernelId : std::uint16_t {};

inline constexpr TextureId kNoTexture{kNone};
inline constexpr TransformId kIdentity{kNone};

template <class Id>
[[nodiscard]] constexpr std::uint32_t index(Id id) {
  return static_cast<std::uint32_t>(id);
}

}  // namespace isl::scene
