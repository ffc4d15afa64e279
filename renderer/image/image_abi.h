// The C interface between the program and its image modules (png_plugin.cpp, exr_plugin.cpp, image_plugin.cpp). They
// are loaded only when a file of their formats is written, since most commands need none. Only plain C types are used,
// because the two sides may be built with different runtimes.
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The type of a plane's values, and how the file keeps them. Halfs are given as floats and kept in 16 bits.
enum IslSampleType { ISL_UINT8, ISL_UINT16, ISL_UINT32, ISL_HALF, ISL_FLOAT };

/// One channel: width × height values, row by row from the top.
struct IslPlane {
  const char* name;  ///< "R", "depth.Z", …, in the order in which they are given
  enum IslSampleType type;
  const void* values;
};

struct IslText {
  const char* name;
  const char* value;
};

struct IslImage {
  const char* format;  ///< png, exr, tif, jpg, ppm or hdr
  int width, height;   ///< size of the planes
  int x, y;            ///< position in the whole picture
  int full_width, full_height;
  int is_srgb;      ///< integer planes hold sRGB code values; otherwise all is linear
  int alpha_plane;  ///< index of the alpha plane, or −1. In sRGB files colour is not multiplied by it.
  int plane_count;
  const struct IslPlane* planes;
  int threads;     ///< most threads that may work on it at the same time, at least 1
  int text_count;  ///< metadata
  const struct IslText* texts;
};

/// A file in memory, or the reason why there is none. isl_image_release frees it.
struct IslEncoded {
  unsigned char* bytes;  ///< null on failure
  size_t size;
  char* error;  ///< null on success
};

/// Raise this whenever anything above changes, or which module writes which format.
#define ISL_IMAGE_ABI 3

typedef int (*IslImageAbi)(void);
typedef void (*IslImageEncode)(const struct IslImage*, struct IslEncoded*);
typedef void (*IslImageRelease)(struct IslEncoded*);

#ifdef __cplusplus
}
#endif
