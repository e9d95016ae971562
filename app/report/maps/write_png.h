#pragma once

#include <QIODevice>
#include <QImage>

#include "core/io/files/write_text.h"

namespace noonmark {

/// Writes a picture, without its transparency, with its tags as text chunks: UTF-8 where a text needs it.
/// False if the write failed. A map of 3 megapixels takes 40 ms. Backend: write_png_libpng.cpp.
bool writePng(const QImage& picture, const FileTags& tags, QIODevice& device);

}  // namespace noonmark
