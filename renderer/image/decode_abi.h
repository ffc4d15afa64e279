// The C interface by which image modules decode files, beside that of image_abi.h by which they encode. A file is
// opened for its header first, so that the program can count the memory of the pixels before anything takes it.
#pragma once

#include "renderer/image/image_abi.h"

#ifdef __cplusplus
extern "C" {
#endif

/// How a file's codes from 0 to 1 mean light.
enum IslTransfer { ISL_LINEAR, ISL_SRGB, ISL_GAMMA };

struct IslPicture {
  int width, height;
  int channels;             ///< 1 grey, or the number of a palette's colour; 2 grey, alpha; 3 colour; 4 colour, alpha
  enum IslSampleType type;  ///< ISL_UINT8, ISL_UINT16 or ISL_FLOAT
  int palette_size;         ///< 0: there is no palette
  unsigned char palette[256][4];  ///< red, green, blue, alpha
  int hides_palette;              ///< the file has one, but only its colours can be told
  int states_transfer;            ///< the file itself states how its codes mean light
  enum IslTransfer transfer;
  double gamma;  ///< of ISL_GAMMA: light = code^gamma
  void* reader;  ///< null on failure; isl_image_close frees it
  char* error;   ///< null on success; isl_image_close frees it
};

/// `format` is png, or the name that OpenImageIO has for a format. The bytes must outlive the reader.
typedef void (*IslImageOpen)(const unsigned char* bytes, size_t size, const char* format, struct IslPicture*);
/// Fills `values`, row by row from the top, the channels of a pixel side by side. 0 and an error on failure.
typedef int (*IslImageRead)(struct IslPicture*, void* values);
typedef void (*IslImageClose)(struct IslPicture*);

#ifdef __cplusplus
}
#endif
