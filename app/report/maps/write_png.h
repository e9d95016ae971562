#pragma once

#include <QIODevice>
#include <QImage>

#include "core/io/files/file_tags.h"

namespace noonmark {

/// Writes a picture with its tags as text chunks. False if the write failed.
bool writePng(QImage picture, const FileTags& tags, QIODevice& device);

}  // namespace noonmark
